# SPDX-License-Identifier: GPL-3.0-or-later
"""Tetrahedra of the solid that a broken triangle surface means.

The defects of a surface, and whether they matter::

    import insideout
    print(insideout.check("broken.ply").verdict)
    insideout.draw("broken.ply", None, "wrong.png")

The solid, its boundary and the whole hull, as VTK data sets with numpy views::

    result = insideout.tetrahedralize("broken.ply")
    print(len(result.solid.cells), "tetrahedra,", result.statistics["OpenEdges"], "open edges closed")
    result.hull.points, result.hull.cells, result.hull.w
    insideout.write(result, "solid.msh")
    insideout.draw("broken.ply", result.hull, "picture.png")
    insideout.draw("broken.ply", result.hull, "page.html")

The same solid in better cells, with edges of about this length::

    insideout.refine(result.solid, edge_length=0.05).solid

The content of a file: a surface, or tetrahedra of gmsh, CalculiX, Abaqus or Medit::

    insideout.read("solid.msh").cell_arrays["RegionId"]

The defects of tetrahedra, and their quality::

    print(insideout.check_solid(result.solid).verdict)
    insideout.draw_quality(result.solid, "angles.png")

Set operations of bodies, however broken their surfaces are::

    insideout.boolean({"liver": "liver.stl", "tumor": "tumor.ply"}, "liver - tumor").surface

Without a mesh: the surface cut where it crosses itself, its winding number at any points, and which of
them are inside::

    insideout.resolve("broken.ply").surface
    insideout.winding_number("broken.ply", points)
    insideout.inside("broken.ply", points)

The winding number of a surface that does not fit in memory, whose pieces are read one after the other::

    insideout.winding_number_of_pieces(["left.stl", "right.stl"], points)

The signed distance to the surface, negative inside; and the voxels inside, as an array, with the position of the
first::

    insideout.distance("broken.ply", points)
    inside, origin = insideout.voxels("broken.ply", spacing=0.01)

For machine learning: distances to the solid, without the inner walls of overlapping parts, on a grid of 128^3 points::

    grid = insideout.sdf_grid("broken.ply", shape=128)
    grid.distance, grid.inside, grid.origin, grid.spacing
    insideout.write(grid, "distances.npz")

Measures of surfaces and solids, and their parts::

    solid = insideout.tetrahedralize("broken.ply").solid
    solid.volume, solid.components, [part.volume for part in solid.split()]

The same queries, except for distances, on a scan: points with normals, without triangles::

    insideout.inside(insideout.point_cloud(points, normals=points), points)

SURFACES
    Each function accepts these types of surface:

    - a vtkPolyData of polygons or strips
    - the name of a .ply, .obj, .off, .stl, .vtp, .glb or .3mf file, or of one compressed as .gz
    - a pair (points, triangles) of arrays with three columns each
    - a meshio.Mesh, a TriangleMesh of Open3D, or a mesh.Mesh of numpy-stl
    - an object with arrays `vertices` and `faces`, such as a trimesh.Trimesh
    - a VTK algorithm, or an output port of one, that makes a vtkPolyData; it is updated

    The results do not depend on the type. Faces should run counterclockwise seen from outside. `scale` multiplies the
    coordinates first, because files have no unit. Solids are accepted likewise: a vtkUnstructuredGrid of tetrahedra,
    the name of a .vtu, .msh, .inp or .mesh file, a pair (points, cells), and so on. Points are one point (3,), or an
    array of points (..., 3), with results of the shape (...); or the points of a VTK data set.

RESULTS
    check           Check: findings, verdict, statistics, surface and lines with what is wrong marked
    resolve         Resolution: surface, statistics
    boolean         Boolean: surface, solid where tetrahedra were made, names, statistics
    check_solid     SolidCheck: findings, verdict, statistics, histogram, the solid with the quality of each cell
    tetrahedralize  Tetrahedralization: solid, boundary, outliers, hull, regions, tags, verdict, statistics
    read            a vtkPolyData or a vtkUnstructuredGrid
    refine          Refinement: solid, statistics
    winding_number  an array of float64, one value per point; winding_number_of_pieces likewise
    inside          an array of bool, one value per point
    distance        an array of float64, one value per point
    voxels          an array of bool with three indices, and a point
    sdf_grid        DistanceGrid: distance and inside with three indices, origin, spacing
    point_cloud     a vtkPolyData

    They can be pickled, and so sent to other processes, and copied. A notebook shows them as a table, with a
    picture where one can be drawn, and `plot()` shows this alone, in a window where there is no notebook. They, and
    the surfaces and tetrahedra in them, have `volume`, `is_watertight`, `components` and `split()`. `statistics` is a
    dict that is printed by groups, and `statistics.to_pandas()` a column of a table.
    `write` puts them into files, for VTK, gmsh, CalculiX and others; `to_meshio()`, `to_pyvista()`,
    `to_trimesh()`, `to_open3d()` and `to_stl()` (numpy-stl) make what these packages have. PyVista's own data sets have the functions, too, as
    `mesh.insideout.tetrahedralize()`: see `insideout.accessors`.

ERRORS
    A failure is an `Error` with one line that names the culprit and, if there is one, the remedy; an unknown argument
    is an `Error`, too. Circumstances that may change an answer are Python warnings of the category `Warning`. They
    point at the line of the call, and are also in the result's `warnings`. To switch them off:
    warnings.simplefilter("ignore", insideout.Warning).

STOPPING
    Ctrl-C stops the work within a second and raises KeyboardInterrupt. `progress`, a function that is called with the
    stage and the fraction done, may raise any exception to stop the work, too. Other threads run meanwhile, and several
    may work at once, and so may processes that are forked or spawned.

PIPELINES
    The VTK filters, for pipelines::

        from insideout import vtkSurfaceReader, vtkRobustTetrahedralize

COMMAND
    insideout mesh broken.ply solid.vtu
    insideout --help

    `python3 -m insideout` is the same. There is a subcommand for each job: mesh, repair, check, refine, boolean, query, draw, demo.

MODULES
    - functions: `booleans`, `checking`, `quality`, `resolving`, `queries`, `grids`, `clouds`, `refinement` and
      `tetrahedralization`
    - options: `options`; stages reported to `progress`: `stages`
    - inputs: `data` has the types of surfaces and tetrahedra, `surfaces`, `solids`, `pieces` and `inputs` make them
    - files: `files` and `reading` read, `writing` and `exporting` write
    - running VTK: `pipeline` runs any algorithm with its errors as exceptions; `calling` and `errors`
    - results: `results`, `statistics`, `plotting` and `serializing`; `measures` and `parts`
    - the command: `command_line` with `arguments`, `usage` and `help`; `commands` has a module per subcommand
"""

# The wrapped classes derive from VTK's, which Python has to know first.
import vtkmodules.vtkCommonCore
import vtkmodules.vtkCommonDataModel
import vtkmodules.vtkCommonExecutionModel
import vtkmodules.vtkImagingCore
import vtkmodules.vtkIOCore  # noqa: F401

from . import vtkFiltersInsideOut as _classes
from .booleans import Boolean, boolean
from .checking import Check, Finding, check
from .clouds import point_cloud
from .data import LayeredCells, Polylines, Tetrahedra, Triangles, TriangleSurface
from .drawing import draw, draw_quality
from .errors import Error, Warning
from .grids import DistanceGrid, sdf_grid
from .quality import SolidCheck, check_solid
from .queries import distance, inside, voxels, winding_number, winding_number_of_pieces
from .reading import read
from .refinement import Refinement, refine
from .resolving import Resolution, resolve
from .statistics import Statistics
from .tetrahedralization import Region, Tetrahedralization, tetrahedralize
from .version import __version__
from .vtkFiltersInsideOut import *  # noqa: F403
from .writing import write

_class_names = [name for name in dir(_classes) if name.startswith("vtk")]

__all__ = [
    *_class_names,
    "Boolean",
    "Check",
    "DistanceGrid",
    "Error",
    "Finding",
    "LayeredCells",
    "Polylines",
    "Refinement",
    "Region",
    "Resolution",
    "SolidCheck",
    "Statistics",
    "Tetrahedra",
    "Tetrahedralization",
    "TriangleSurface",
    "Triangles",
    "Warning",
    "__version__",
    "boolean",
    "check",
    "check_solid",
    "distance",
    "draw",
    "draw_quality",
    "inside",
    "point_cloud",
    "read",
    "refine",
    "resolve",
    "sdf_grid",
    "tetrahedralize",
    "voxels",
    "winding_number",
    "winding_number_of_pieces",
    "write",
]
