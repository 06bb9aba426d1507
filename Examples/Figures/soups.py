# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality of a solid made from a soup: facets turned over at random, and torn apart.

    python3 soups.py PLOT.png [STEPS [FACETS]]

The model is a cow of Debian's package libcgal-demo, with fewer facets (vtkQuadricDecimation). Some of its triangles are
turned over, and each is moved by a random vector of TORN mean edge lengths. The table and the plot show the
error of the solid's volume, with and without the repair of orientation. Its steps range from none to half of the
triangles turned. Triangles that are not torn share their points, and the repair makes adjacent ones agree; torn ones
are isolated.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  the backend has to be chosen first

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import models  # noqa: E402  of the folder above
from torn_apart import corners_of  # noqa: E402

MODEL, FACETS = "cow.off", 1500
TORN = (0, 0.05, 0.2)  # mean lengths of an edge
ORIENTATIONS = ("as-given", "automatic")


def soup(corners: np.ndarray, turned: float, torn: float, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles, so large a share of which is turned over, each moved by so much."""
    random = np.random.default_rng(seed)
    flipped = corners.copy()
    chosen = random.permutation(len(corners))[: round(turned * len(corners))]
    flipped[chosen] = flipped[chosen][:, ::-1]
    ways = random.normal(size=(len(corners), 1, 3))
    ways /= np.linalg.norm(ways, axis=2, keepdims=True)
    edge = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean()
    return (flipped + torn * edge * ways).reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)


def error(corners: np.ndarray, volume: float, turned: float, torn: float, orientation: str) -> float:
    """In percent of the volume of the whole model."""
    found = insideout.tetrahedralize(soup(corners, turned, torn, 1), orientation=orientation)
    return 100 * (found.statistics["Volume"] / volume - 1)


def main(plotted: Path, steps: int, facets: int, folder: Path) -> None:
    corners = corners_of(models.unpacked(MODEL, folder), facets)
    volume = insideout.tetrahedralize(soup(corners, 0, 0, 1)).statistics["Volume"]
    shares = np.linspace(0, 0.5, steps)
    print("volume, error in %    " + "".join(f"torn {torn:4g}: as given automatic   " for torn in TORN))
    errors = np.array(
        [[[error(corners, volume, share, torn, way) for way in ORIENTATIONS] for torn in TORN] for share in shares]
    )
    for share, row in zip(shares, errors):
        print(f"{100 * share:4.0f} % turned over    " + "".join(f"{given:19.1f} {repaired:9.1f}   " for given, repaired in row))
    figure, axes = pyplot.subplots(figsize=(6, 4), constrained_layout=True)
    for k, (torn, colour) in enumerate(zip(TORN, ("tab:blue", "tab:orange", "tab:red"))):
        axes.plot(100 * shares, errors[:, k, 0], "o--", color=colour, label=f"torn by {torn:g} edges, as given")
        axes.plot(100 * shares, errors[:, k, 1], "s-", color=colour, label=f"torn by {torn:g} edges, automatic")
    axes.set_xlabel("% of the triangles turned over")
    axes.set_ylabel("volume, error in %")
    axes.grid(True, alpha=0.3)
    axes.legend(fontsize="small")
    figure.savefig(plotted, dpi=150)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    given_steps, given_facets = map(int, [*sys.argv[2:], *("6", str(FACETS))[len(sys.argv) - 2 :]])
    try:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(sys.argv[1]), given_steps, given_facets, Path(temporary))
    except (insideout.Error, OSError) as error_:
        sys.exit(f"soups.py: {error_}")
