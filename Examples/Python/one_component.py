# SPDX-License-Identifier: GPL-3.0-or-later
"""A model of many parts: as the cut has them, the largest, and all in one piece.

    xvfb-run -a python3 one_component.py PICTURE.png [SURFACE]

By default it is a model of Debian's package libcgal-demo. Regions, which faces of cells connect, have colors; red are
cells that join regions. The script prints the energy added by joining them, and the dropped cells.
"""

import sys
import tempfile
from pathlib import Path

import insideout
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402

MODEL = "b9_mesh.off"
SEEN_FROM = (0.6, -1, 1.5)
JOINING, REST = (217, 38, 31), (115, 168, 204)


def colours_of(regions):
    """A color for each number, always the same."""
    return np.random.default_rng(3).integers(90, 230, size=(regions.max() + 1, 3))[regions]


def main(picture, surface):
    cut = insideout.tetrahedralize(surface)
    largest = insideout.tetrahedralize(surface, largest_regions=1)
    one = insideout.tetrahedralize(surface, topology="one-component")
    energy, before, joined, dropped = (one.statistics[name] for name in ("Energy", "EnergyOfCut", "JoinedRegions", "DroppedRegions"))
    print(f"{len(cut.regions)} regions; one component by {joined:.0f} ways between them and {dropped:.0f} dropped")
    print(f"the energy is {before:.6g} before, and {energy:.6g} after")
    share = 100 * largest.statistics["DroppedVolume"] / cut.statistics["Volume"]

    was_inside, is_inside = (result.hull.cell_arrays["Inside"] != 0 for result in (cut, one))
    joining = np.where(was_inside[is_inside][:, None], REST, JOINING)
    drawing.save(
        [
            drawing.Panel("As the cut has it", f"{len(cut.regions)} regions", [drawing.painted(cut.solid, colours_of(cut.solid.cell_arrays["RegionId"]), of_cells=True)]),
            drawing.Panel("largest_regions=1", f"{share:.0f} % of the volume dropped", [drawing.actor(largest.solid, drawing.BLUE)]),
            drawing.Panel('topology="one-component"', f"{joined:.0f} ways (red), {dropped:.0f} dropped", [drawing.painted(one.solid, joining, of_cells=True)]),
        ],
        picture,
        seen_from=SEEN_FROM,
    )


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as folder:
            main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else models.unpacked(MODEL, Path(folder)))
    except (insideout.Error, OSError) as error:
        sys.exit(f"one_component.py: {error}")
