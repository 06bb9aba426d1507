# SPDX-License-Identifier: GPL-3.0-or-later
"""A scan with holes in PyVista (0.48 or later): which voxels are inside, and its tetrahedra.

    python3 with_pyvista.py scan.ply [FOLDER]

Writes voxels.vti and solid.vtu into the folder, by default this one.
"""

import os
import sys

import numpy as np
import pyvista

import insideout.accessors  # noqa: F401 - a wheel makes it known to PyVista; other ways of installing do not

VOXELS = 40  # along the longest side

scan = pyvista.read(sys.argv[1])
folder = sys.argv[2] if len(sys.argv) > 2 else "."
print(scan.insideout.check().field_data["Verdict"][0])

# The winding number closes holes, which a test by rays or normals needs closed.
low, high = np.reshape(scan.bounds, (3, 2)).T
spacing = max(high - low) / VOXELS
image = pyvista.ImageData(dimensions=np.ceil((high - low) / spacing).astype(int) + 1, spacing=[spacing] * 3, origin=low)
image["Inside"] = scan.insideout.inside(image)
print(f"{image['Inside'].sum():,} of {image.n_points:,} voxels are inside")
image.save(os.path.join(folder, "voxels.vti"))

solid = scan.insideout.tetrahedralize().insideout.refine(edge_length="5%", surface_treatment="kept")
print(f"{solid.n_cells:,} tetrahedra")
solid.save(os.path.join(folder, "solid.vtu"))
