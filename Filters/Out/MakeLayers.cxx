// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeLayers.h"

#include "Common/Error.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "GraphCut/ConnectCells.h"
#include "In/ReadSolid.h"
#include "Out/BoundaryWithLayers.h"
#include "Out/MakeLayersInPlane.h"
#include "Out/MakeOutputs.h"
#include "Out/MixInCells.h"
#include "Out/TransferLayers.h"
#include "Quality/QualityOfMesh.h"
#include "Quality/SolverFitness.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** The faces of a solid in a mesh whose cells may be turned, 4 * cell + face. */
std::vector<Id> FacesIn(const TetrahedralMesh& mesh, const SolidMesh& solid)
{
  std::vector<Id> faces;
  for (const auto& [cell, k] : solid.Faces)
  {
    // ConnectCells says which faces of turned cells change places.
    const int face = mesh.Cells[cell] != solid.Cells[cell] && (k == 0 || k == 3) ? 3 - k : k;
    faces.push_back(4 * cell + face);
  }
  return faces;
}

/** The tag of each face of each cell, from 1; 0 without one. */
std::vector<std::array<Id, 4>> TagsOfFaces(
  const TetrahedralMesh& mesh, const SolidMesh& solid, const std::vector<Id>& faces)
{
  std::vector<std::array<Id, 4>> tags(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    tags[faces[f] / 4][faces[f] % 4] = 1 + solid.TagOfFace[f];
  }
  return tags;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const LayeredMesh& mesh)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  AddCells(mesh.Tetrahedra, VTK_TETRA, cells, types);
  AddCells(mesh.Pyramids, VTK_PYRAMID, cells, types);
  AddCells(mesh.Prisms, VTK_WEDGE, cells, types);
  grid->SetPoints(MakePoints(mesh.Points));
  grid->SetCells(types, cells);
  return grid;
}
} // namespace

Layering MakeLayers(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  const std::vector<std::string>& tags, const LayerParameters& parameters, Monitor& monitor)
{
  Stopwatch stopwatch;
  if (!boundary && !tags.empty())
  {
    throw Error(ErrorCode::InvalidParameter,
      "LayerTags names tags, and there is no boundary with tags: it is the second input");
  }
  if (!(parameters.FirstHeight > 0))
  {
    throw Error(ErrorCode::InvalidParameter,
      "FirstHeight is 0; layers need the height of the first one, above 0");
  }
  if (grid->GetNumberOfCells() == 0)
  {
    throw Error(ErrorCode::InvalidParameter, "the grid has no cells");
  }
  if (boundary && boundary->GetNumberOfCells() == 0)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the boundary, which is the second input, has no triangles; without it layers are made at "
      "all faces of one cell");
  }
  if (grid->GetCellType(0) == VTK_TRIANGLE)
  {
    Layering flat = MakeLayersInPlane(grid, boundary, tags, parameters, monitor);
    flat.Statistics.emplace_back("SecondsLayers", stopwatch.Lap());
    return flat;
  }
  const SolidMesh solid = ReadSolid(grid, boundary);
  if (!solid.Midpoints.empty())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the cells are of second order; layers are made of linear tetrahedra");
  }
  if (solid.HasLayers())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the grid has pyramids or prisms; layers are made of linear tetrahedra alone");
  }
  const TetrahedralMesh mesh = ConnectCells(solid.Points, solid.Cells);
  Layering result;
  const std::vector<Id> faces = FacesIn(mesh, solid);
  std::vector<std::string> names;
  for (const SolidGroup& tag : solid.Tags)
  {
    names.push_back(tag.Name);
  }
  const std::vector<bool> isWall = WallTags(names, tags);
  std::vector<char> isLayered(faces.size(), 0);
  std::vector<Id> wall;
  std::size_t between = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const bool isOuter = mesh.Neighbors[faces[f] / 4][faces[f] % 4] == None;
    if (isWall[solid.TagOfFace[f]] && isOuter)
    {
      isLayered[f] = 1;
      wall.push_back(faces[f]);
    }
    between += isWall[solid.TagOfFace[f]] && !isOuter ? 1 : 0;
  }
  SortUniquely(wall);
  if (between > 0)
  {
    result.Warnings.push_back(
      std::to_string(between) + " triangles of the wall are between regions and get no layers");
  }
  const LayeredMesh made = MakeBoundaryLayers(
    mesh, solid.RegionOfCell, wall, TagsOfFaces(mesh, solid, faces), parameters, monitor);
  result.Grid = MakeGrid(made);
  result.Boundary = boundary ? BoundaryWithLayers(boundary, { mesh, faces, isLayered, made })
                             : vtkSmartPointer<vtkPolyData>::New();
  TransferLayers(grid, MixInCells(mesh, made.Points, made.OriginalPoints, made.CellsOfPoints),
    made.OriginalCells, made.Layers, result);
  result.Statistics = made.Statistics;
  const ProgressRange end = { Stages::Layering, 1, 1 };
  const std::vector<Tetrahedron> behind(made.Tetrahedra.begin(),
    made.Tetrahedra.begin() + static_cast<std::ptrdiff_t>(made.NumberOfCellsBehind));
  AppendQuality(QualityOfMesh(made.Points, behind, monitor, end), result.Statistics);
  AppendFitness(
    FitnessForSolver(made.Points, made.Tetrahedra, {}, made, {}, monitor, end), result.Statistics);
  WarnOfHeights(result);
  result.Statistics.emplace_back("SecondsLayers", stopwatch.Lap());
  return result;
}
} // namespace vtkInsideOut
