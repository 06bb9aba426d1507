# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact sheets (the thesis's figures 8.22 to 8.25): twelve real models, a row each.

    xvfb-run -a python3 contact_sheets.py FOLDER [SURFACE...]

`insideout.draw` draws a row for any surface: its defects, a slice of the winding number w, the tetrahedra inside, cut open, the
solid's boundary, and its tetrahedra in slices. Beside that stand the counts of the model's row in table 8.1. Four rows are a sheet:
sheet-1.png and so on, in the folder. Models of Debian's packages libcgal-demo and openfoam-examples, or the surfaces given.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout
from matplotlib import image, pyplot

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import models  # noqa: E402  of the folder above

MODELS = (
    *("mannequin-devil.off", "man.off", "pig.stl", "elephant-with-holes.off", "diplodocus.off", "bones.off"),
    *("camel.off", "mushroom.off", "lion.off", "blobby_3cc.off", "propellerTip.obj", "motorBike-passenger-helmet.obj"),
)
ROWS = 4  # of a sheet
SIZE = (20, 3.75)  # inches of a row
FIGURES = (
    ("Points", "vertices"),
    ("Facets", "facets"),
    ("OpenEdges", "open edges"),
    ("IntersectingPairs", "pairs that cross"),
    ("Components", "components"),
    ("NonManifoldEdges", "non-manifold edges"),
    ("InsideCells", "tetrahedra"),
    ("OutlierFacets", "outliers"),
)


def row_of(surface: Path, folder: Path) -> tuple[str, str, object]:
    """A name, what there is to say, and a picture."""
    result = insideout.tetrahedralize(surface)
    insideout.draw(surface, result.hull, folder / "row.png", row=True)
    counts = result.statistics
    lines = [f"{int(counts[statistic]):,} {what}" for statistic, what in FIGURES]
    return surface.name, "\n".join(lines), image.imread(folder / "row.png")[..., :3]


def write_sheet(rows: list[tuple[str, str, object]], file: Path) -> None:
    figure, axes = pyplot.subplots(len(rows), 1, figsize=(SIZE[0], SIZE[1] * len(rows)), squeeze=False)
    figure.subplots_adjust(left=0.13, right=1, top=1, bottom=0, hspace=0.02)
    for (name, text, picture), place in zip(rows, axes[:, 0]):
        place.imshow(picture)
        place.axis("off")
        place.text(-0.14, 0.82, name, transform=place.transAxes, fontsize=13, weight="bold")
        place.text(-0.14, 0.78, text, transform=place.transAxes, fontsize=11, verticalalignment="top", linespacing=1.5)
    figure.savefig(file, dpi=80)
    pyplot.close(figure)
    print(f"written: {file}", flush=True)


def main(folder: Path, surfaces: list[Path]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        chosen = surfaces or [models.unpacked(name, Path(temporary)) for name in MODELS]
        for sheet, first in enumerate(range(0, len(chosen), ROWS), 1):
            rows = [row_of(surface, Path(temporary)) for surface in chosen[first : first + ROWS]]
            write_sheet(rows, folder / f"sheet-{sheet}.png")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    try:
        main(Path(sys.argv[1]), [Path(name) for name in sys.argv[2:]])
    except (insideout.Error, OSError) as error:
        sys.exit(f"contact_sheets.py: {error}")
