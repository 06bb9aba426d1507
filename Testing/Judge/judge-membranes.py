# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges whether sheets leave the solid of closed surfaces as it is, and whether open limbs count.

    python3 judge-membranes.py [--cases N] [--seed N] [--only LAW] SURFACE...

Closed surfaces of at most 6,000 triangles are drawn from those given and from made ones, and turned at random.

- sheets: 1 to 40 sheets, flat or bent, of random size and place, within, outside and across, some with corners of the
  surface. The solid's volume stays.
- limbs: an open tube, or a dome without a bottom, is set on the surface or into it. The volume is that of its closed twin,
  within half a ball on each of its caps that is outside.
- layers: a box, closed or without its top, is divided by sheets from wall to wall. Its volume stays.
- probe: half of the sheets' cases. The probe says of 500 places what the solid of the surface alone says.

A line for each failure says how to make it again. Exit status 0 if each law holds in at least 98 % of its cases.
"""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path
from typing import Callable

import insideout
import numpy as np

Surface = tuple[np.ndarray, np.ndarray]


def box() -> Surface:
    points = np.array([[i >> k & 1 for k in range(3)] for i in range(8)], float)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return points, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def grid(place: Callable[[np.ndarray, np.ndarray], np.ndarray], rows: int, columns: int, closed: bool = False) -> Surface:
    """A sheet of rows x columns squares, by parameters from 0 to 1; closed where its first column is its last."""
    u, v = (part.ravel() for part in np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij"))
    points = place(u, v)
    index = np.arange((rows + 1) * (columns + 1)).reshape(rows + 1, columns + 1)
    if closed:
        index[:, -1] = index[:, 0]
    a, b, c, d = index[:-1, :-1].ravel(), index[1:, :-1].ravel(), index[1:, 1:].ravel(), index[:-1, 1:].ravel()
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    used, numbers = np.unique(triangles, return_inverse=True)
    return points[used], numbers.reshape(-1, 3)


def ball(rows: int = 8, columns: int = 12) -> Surface:
    def place(u, v):
        return np.column_stack([np.sin(np.pi * u) * np.cos(2 * np.pi * v), np.sin(np.pi * u) * np.sin(2 * np.pi * v), np.cos(np.pi * u)])

    points, triangles = grid(place, rows, columns, closed=True)
    points, numbers = np.unique(points.round(12), axis=0, return_inverse=True)
    triangles = numbers.ravel()[triangles]
    return points, triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]


def tube(length: float, columns: int = 16) -> Surface:
    """A tube of radius 1 along z, open at both ends, facing outward."""
    return grid(lambda u, v: np.column_stack([np.cos(2 * np.pi * v), np.sin(2 * np.pi * v), length * u]), 6, columns, closed=True)


def with_lids(surface: Surface) -> Surface:
    """The same with a fan on each hole."""
    points, triangles = surface
    directed = {(t[k], t[(k + 1) % 3]) for t in triangles.tolist() for k in range(3)}
    following = {b: a for a, b in directed if (b, a) not in directed}
    lids = []
    while following:
        start, point = following.popitem()
        loop = [start]
        while point != start:
            loop.append(point)
            point = following.pop(point)
        middle = len(points)
        points = np.vstack([points, points[loop].mean(axis=0)])
        lids += [(loop[i], loop[(i + 1) % len(loop)], middle) for i in range(len(loop))]
    return points, np.array([*triangles.tolist(), *lids])


def turn_of(random) -> np.ndarray:
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return turn * np.sign(np.linalg.det(turn))


def together(*surfaces: Surface) -> Surface:
    offsets = np.cumsum([0, *(len(points) for points, _ in surfaces)])
    return np.vstack([points for points, _ in surfaces]), np.vstack([triangles + offset for (_, triangles), offset in zip(surfaces, offsets)])


def sheet(surface: Surface, random) -> Surface:
    """Flat or bent, anywhere about the surface; one in three hangs on a corner of it."""
    points, _ = surface
    low, high = points.min(axis=0), points.max(axis=0)
    size = np.linalg.norm(high - low)
    width, length = size * 10 ** random.uniform(-1.3, 0, 2)
    bend = random.choice([0, random.uniform(0, 0.3)])
    rows = int(random.integers(1, 7)) if bend else 1

    def place(u, v):
        return np.column_stack([width * (u - 0.5), length * (v - 0.5), bend * min(width, length) * np.cos(np.pi * (u - 0.5))])

    corners, triangles = grid(place, rows, rows)
    corners = corners @ turn_of(random).T
    if random.integers(3) == 0:
        corners += points[random.integers(len(points))] - corners[random.integers(len(corners))]
    else:
        corners += random.uniform(low - 0.3 * size, high + 0.3 * size)
    return corners, triangles[:, ::-1] if random.integers(2) else triangles


def volume(surface: Surface) -> float:
    return insideout.tetrahedralize(surface).volume


def sheets(surface: Surface, random) -> str:
    count = int(random.integers(1, 41))
    alone = volume(surface)
    found = volume(together(surface, *(sheet(surface, random) for _ in range(count))))
    return "" if abs(found - alone) <= 1e-6 * alone else f"{count} sheets: {found / alone:.4f} of the volume"


def probe(surface: Surface, random) -> str:
    added = together(surface, *(sheet(surface, random) for _ in range(int(random.integers(1, 41)))))
    low, high = surface[0].min(axis=0), surface[0].max(axis=0)
    places = random.uniform(low - 0.1 * (high - low), high + 0.1 * (high - low), (500, 3))
    wrong = int((insideout.inside(surface, places) != insideout.inside(added, places)).sum())
    return "" if wrong == 0 else f"{wrong} of 500 places"


def limbs(surface: Surface, random) -> str:
    points, triangles = surface
    size = np.linalg.norm(np.ptp(points, axis=0))
    facet = triangles[random.integers(len(triangles))]
    a, b, c = points[facet]
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal)
    radius = size * random.uniform(0.02, 0.12)
    is_tube = random.integers(2)
    length = random.uniform(2, 8)
    limb = tube(length) if is_tube else grid(
        lambda u, v: np.column_stack([np.sin(0.5 * np.pi * u) * np.cos(2 * np.pi * v), np.sin(0.5 * np.pi * u) * np.sin(2 * np.pi * v), np.cos(0.5 * np.pi * u)]), 6, 16, closed=True
    )
    if not is_tube:
        corners, numbers = np.unique(limb[0].round(12), axis=0, return_inverse=True)
        dome = numbers.ravel()[limb[1]]
        limb = corners, dome[(dome != np.roll(dome, 1, axis=1)).all(axis=1)]
    depth = random.choice([0, random.uniform(0, 0.4)]) * (length if is_tube else 1)
    across = np.linalg.svd(normal[None, :])[2]
    frame = np.column_stack([across[1], across[2], normal])
    frame[:, 0] *= np.sign(np.linalg.det(frame))

    def placed(part: Surface) -> Surface:
        return radius * (part[0] - [0, 0, depth]) @ frame.T + (a + b + c) / 3, part[1]

    open_one, twin = placed(limb), placed(with_lids(limb))
    expected = volume(together(surface, twin))
    found = volume(together(surface, open_one))
    allowed = 2 / 3 * np.pi * radius**3 * (2 if is_tube else 1)
    kind = f"{'tube' if is_tube else 'dome'} of radius {radius / size:.3f}, length {length if is_tube else 1:.2f} radii, {depth:.2f} deep"
    return "" if abs(found - expected) <= allowed else f"{kind}: {found - expected:.4g} too much, {allowed:.4g} allowed"


def layers(surface: Surface, random) -> str:
    """The surface given is not used."""
    points, triangles = box()
    is_open = random.integers(2)
    if is_open:
        triangles = triangles[~(points[triangles][:, :, 2] == 1).all(axis=1)]
    heights = np.sort(random.uniform(0.05, 0.9, random.integers(1, 8)))
    walls = [grid(lambda u, v, z=z: np.column_stack([u, v, np.full_like(u, z)]), 1, 1) for z in heights]
    walls = [(corners, faces[:, ::-1] if random.integers(2) else faces) for corners, faces in walls]
    stretched = random.uniform(0.5, 2, 3)
    turn = turn_of(random)
    found = [volume((part[0] * stretched @ turn.T, part[1])) / np.prod(stretched) for part in ((points, triangles), together((points, triangles), *walls))]
    return "" if abs(found[1] - found[0]) < 1e-6 else f"{'open' if is_open else 'closed'}, {len(heights)} layers: {found[1]:.4f} of {found[0]:.4f}"


LAWS = {"sheets": (sheets, 1.0), "limbs": (limbs, 1.0), "layers": (layers, 0.5), "probe": (probe, 0.5)}


def closed_ones(files: list[str]) -> dict[str, Surface]:
    """Those whose facets run through each edge as often one way as the other, and mean a solid."""
    found = {"box": box(), "ball": ball(), "long tube": with_lids(tube(8)), "disc": with_lids(tube(0.3))}
    for file in sorted(files):
        try:
            surface = insideout.read(file)
            points, numbers = np.unique(np.asarray(surface.points, float), axis=0, return_inverse=True)
            triangles = numbers.ravel()[np.asarray(surface.triangles)]
            triangles = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
            if not 4 <= len(triangles) <= 6000:
                continue
            edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)
            keys = edges[:, 0] * len(points) + edges[:, 1]
            opposite = edges[:, 1] * len(points) + edges[:, 0]
            if (np.sort(keys) == np.sort(opposite)).all() and volume((points, triangles)) > 0:
                found[Path(file).name] = points, triangles
        except Exception as error:  # what cannot be read or meshed is for other judges
            print(f"{file}: {error}", file=sys.stderr)
    return found


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=LAWS)
    parser.add_argument("surfaces", nargs="*")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    surfaces = closed_ones(options.surfaces)
    names = list(surfaces)
    print(f"{len(names)} closed surfaces, seed {options.seed}", flush=True)
    all_hold = True
    for law in [options.only] if options.only else LAWS:
        function, share = LAWS[law]
        cases, held = int(options.cases * share), 0
        for case in range(cases):
            random = np.random.default_rng([options.seed, list(LAWS).index(law), case])
            name = names[random.integers(len(names))]
            points, triangles = surfaces[name]
            what = function((points @ turn_of(random).T, triangles), random)
            held += not what
            if what:
                print(f"  {law}, case {case}, {name}: {what}", flush=True)
        print(f"{law}: {held} of {cases}", flush=True)
        all_hold &= held >= 0.98 * cases
    return 0 if all_hold else 1


if __name__ == "__main__":
    sys.exit(main())
