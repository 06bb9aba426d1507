# SPDX-License-Identifier: GPL-3.0-or-later
"""Outliers (the thesis's figure 8.13): the facets of real models that are no part of the solid, for what they mean is ambiguous.

    xvfb-run -a python3 outliers.py PICTURE.png

Blue, and seen through, the solid's boundary, red the outliers: sheets without thickness, and parts within others. The models
are of Debian's packages libcgal-demo and openfoam-examples.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402

MODELS = {"stirrer.stl": (0.5, -0.3, 1), "mannequin-devil.off": (0.5, -1, 0.2), "b9_mesh.off": (0.4, -1, 0.5)}
"""And from where each is seen."""


def main(picture: Path, folder: Path) -> None:
    panels = []
    for name, seen_from in MODELS.items():
        result = insideout.tetrahedralize(models.unpacked(name, folder))
        counts = result.statistics
        outliers, segmented = counts["OutlierFacets"], counts["OutliersByEnergy"]
        print(f"{name}: {outliers} of {counts['Facets']} facets are outliers, {segmented} segmented as outside")
        seen = [drawing.actor(result.boundary, drawing.BLUE, opacity=0.4), drawing.actor(result.outliers, drawing.RED)]
        panels.append(drawing.Panel(name, f"{outliers:,} outliers, {100 * outliers / counts['Facets']:.2g} % of the facets", seen, seen_from))
    drawing.save(panels, picture)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(sys.argv[1]), Path(temporary))
    except (insideout.Error, OSError) as error:
        sys.exit(f"outliers.py: {error}")
