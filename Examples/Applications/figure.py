# SPDX-License-Identifier: GPL-3.0-or-later
"""A dirty figure with a skeleton: limbs that overlap, open where they are hidden in others. In metres; z is up, -y the front.

    python3 figure.py FIGURE.obj
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np


class Bone(NamedTuple):
    start: tuple[float, float, float]
    end: tuple[float, float, float]
    radii: tuple[float, float]
    """Widths of the limb around it, at both ends"""
    parent: str = ""


def _sides(name: str, start, end, radii, parent: str) -> dict[str, Bone]:
    """The same left and right; the parent is of the same side if there is one of that name."""
    bones = {}
    for side, sign in (("left", 1), ("right", -1)):
        ends = tuple((sign * x, y, z) for x, y, z in (start, end))
        bones[f"{side} {name}"] = Bone(*ends, radii, parent if parent == "spine" else f"{side} {parent}")
    return bones


SKELETON = {
    "spine": Bone((0, 0, 0.97), (0, 0, 1.36), (0.165, 0.17)),
    "head": Bone((0, 0, 1.50), (0, -0.01, 1.68), (0.075, 0.11), "spine"),
    **_sides("upper arm", (0.11, 0, 1.42), (0.44, 0, 1.42), (0.07, 0.052), "spine"),
    **_sides("forearm", (0.44, 0, 1.42), (0.70, 0, 1.42), (0.052, 0.04), "upper arm"),
    **_sides("hand", (0.72, 0, 1.42), (0.82, -0.01, 1.42), (0.042, 0.045), "forearm"),
    **_sides("thigh", (0.085, 0, 0.91), (0.11, 0, 0.50), (0.09, 0.065), "spine"),
    **_sides("shin", (0.11, 0, 0.50), (0.12, 0.01, 0.10), (0.065, 0.05), "thigh"),
    **_sides("foot", (0.12, 0.01, 0.06), (0.13, -0.15, 0.045), (0.055, 0.045), "shin"),
}

AROUND, RINGS_OF_CAP = 24, 5
LEFT_OPEN = ("upper arm", "forearm", "thigh", "shin")  # at their start


def limb(bone: Bone, is_open: bool, around: int = AROUND) -> tuple[np.ndarray, list[list[int]]]:
    """A round limb about a bone, outward; without its first cap if it is open there."""
    start, end = np.array(bone.start, float), np.array(bone.end, float)
    along = (end - start) / np.linalg.norm(end - start)
    u = np.cross(along, (0, 1, 0))
    u /= np.linalg.norm(u)
    v = np.cross(along, u)
    angles = 2 * np.pi * np.arange(around) / around
    ring = np.cos(angles)[:, None] * u + np.sin(angles)[:, None] * v
    steps = max(3, round(float(np.linalg.norm(end - start)) / (2 * np.pi * max(bone.radii) / around)))
    rings = [(start + (end - start) * t, (1 - t) * bone.radii[0] + t * bone.radii[1]) for t in np.linspace(0, 1, steps + 1)]
    for k in range(1, RINGS_OF_CAP):
        angle = np.pi / 2 * k / RINGS_OF_CAP
        rings.append((end + along * bone.radii[1] * np.sin(angle), bone.radii[1] * np.cos(angle)))
        if not is_open:
            rings.insert(0, (start - along * bone.radii[0] * np.sin(angle), bone.radii[0] * np.cos(angle)))
    points = [centre + radius * ring for centre, radius in rings]
    k = np.arange(around)
    polygons = [
        [r * around + a, r * around + b, (r + 1) * around + b, (r + 1) * around + a]
        for r in range(len(rings) - 1)
        for a, b in zip(k, (k + 1) % around)
    ]
    last, tip = (len(rings) - 1) * around, len(rings) * around
    points.append((end + along * bone.radii[1])[None])
    polygons += [[last + a, last + b, tip] for a, b in zip(k, (k + 1) % around)]
    if not is_open:
        points.append((start - along * bone.radii[0])[None])
        polygons += [[b, a, tip + 1] for a, b in zip(k, (k + 1) % around)]
    return np.concatenate(points), polygons


def is_open(name: str) -> bool:
    return name.split(" ", 1)[-1] in LEFT_OPEN


def write_figure(path: Path, names=tuple(SKELETON), around: int = AROUND) -> None:
    """As an .obj file with a group for each limb, and six decimals, as most programs write it; around: facets around a limb."""
    first = 1
    with Path(path).open("w") as file:
        for name in names:
            points, polygons = limb(SKELETON[name], is_open(name), around)
            file.write(f"g {name.replace(' ', '_')}\n")
            file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in points.tolist())
            file.writelines("f " + " ".join(str(first + corner) for corner in polygon) + "\n" for polygon in polygons)
            first += len(points)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    write_figure(Path(sys.argv[1]))
