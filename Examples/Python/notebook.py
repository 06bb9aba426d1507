# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # From a dirty mesh to pictures
#
# Run it cell by cell in an editor that knows `# %%`, turn it into a notebook with `jupytext --to notebook`,
# or run it whole: `python3 notebook.py SURFACE FOLDER`.

# %%
import sys
from pathlib import Path

import insideout
import numpy as np

surface = sys.argv[1] if len(sys.argv) > 2 else "broken.ply"
folder = Path(sys.argv[2] if len(sys.argv) > 2 else ".")

# %% [markdown]
# ## What is wrong with it?

# %%
check = insideout.check(surface)
print(check.verdict)
for finding in check.findings:
    print(f"- {finding.text}: {finding.consequence}")

# %% [markdown]
# ## The solid that it means

# %%
result = insideout.tetrahedralize(surface, gamma=1.0)
solid, hull = result.solid, result.hull
print(len(solid.cells), "tetrahedra inside, of", len(hull.cells), "in the convex hull")
for warning in result.warnings:
    print("Warning:", warning)

# %% [markdown]
# Points, cells and arrays are numpy views of VTK's memory.

# %%
a, b, c, d = (solid.points[solid.cells[:, k]] for k in range(4))
volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
print(f"volume {volumes.sum():.6g}, w inside from {solid.w.min():.3f} to {solid.w.max():.3f}")

# %% [markdown]
# ## Is a point inside? No mesh is needed for that

# %%
low, high = hull.points.min(axis=0), hull.points.max(axis=0)
points = np.random.default_rng(1).uniform(low, high, (100_000, 3))
inside = insideout.inside(surface, points)
print(f"volume by counting points: {inside.mean() * np.prod(high - low):.4g}")

# %% [markdown]
# ## Files and pictures

# %%
insideout.write(solid, folder / "solid.vtu")
insideout.write(result.boundary, folder / "boundary.stl")
insideout.draw(surface, hull, folder / "picture.png")
print("written to", folder)

# %% [markdown]
# A histogram of the winding number, where matplotlib is installed: two peaks, at 0 and 1, with little
# between them is a surface that hardly leaves doubt.

# %%
try:
    import matplotlib
except ImportError:
    print("no matplotlib, no histogram")
else:
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6, 3), layout="constrained")
    axes.hist(hull.w, bins=60)
    axes.set(xlabel="winding number w", ylabel="tetrahedra of the hull", yscale="log")
    figure.savefig(folder / "histogram.png")
