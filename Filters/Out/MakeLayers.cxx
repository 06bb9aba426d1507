// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeLayers.h"

#include "Common/Error.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "GraphCut/ConnectCells.h"
#include "In/ReadSolid.h"
#include "Out/BoundaryWithLayers.h"
#include "Out/MakeOutputs.h"
#include "Out/MixInCells.h"
#include "Quality/QualityOfMesh.h"
#include "Quality/SolverFitness.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** Whether each tag of a solid is of the wall. @throws Error that names a tag which is not there */
std::vector<bool> WallTags(const SolidMesh& solid, const std::vector<std::string>& tags)
{
  std::vector<bool> isWall(solid.Tags.size(), tags.empty());
  for (const std::string& tag : tags)
  {
    bool isThere = false;
    std::string all;
    for (std::size_t t = 0; t < solid.Tags.size(); ++t)
    {
      all += (t > 0 ? ", " : "") + solid.Tags[t].Name;
      if (solid.Tags[t].Name == tag)
      {
        isWall[t] = true;
        isThere = true;
      }
    }
    if (!isThere)
    {
      throw Error(ErrorCode::InvalidParameter,
        "LayerTags names " + tag + ", which is not a tag of the boundary; its tags are " + all);
    }
  }
  return isWall;
}

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

template <std::size_t Size>
void AddCells(const std::vector<std::array<Id, Size>>& cells, int type, vtkCellArray* output,
  vtkUnsignedCharArray* types)
{
  for (const auto& cell : cells)
  {
    std::array<vtkIdType, Size> ids;
    std::copy(cell.begin(), cell.end(), ids.begin());
    output->InsertNextCell(static_cast<vtkIdType>(Size), ids.data());
    types->InsertNextValue(static_cast<unsigned char>(type));
  }
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

std::string WordsOfHeights(const Statistics& statistics)
{
  std::ostringstream words;
  const auto valueOf = [&](const std::string& wanted)
  {
    const auto found = std::find_if(
      statistics.begin(), statistics.end(), [&](const auto& one) { return one.first == wanted; });
    return found->second;
  };
  const double share = valueOf("FullHeightShare");
  words << std::floor(1000 * share) / 10 << " % of the wall have layers of full height; "
        << std::setprecision(9) << valueOf("ReducedPoints") << " of its " << valueOf("WallPoints")
        << " points have lower ones, and " << valueOf("BarePoints") << " have none";
  if (valueOf("NarrowPoints") > 0)
  {
    words << "; at " << valueOf("NarrowPoints")
          << " points the solid is narrower than three times the layers";
  }
  if (valueOf("EndPoints") > 0)
  {
    words << "; at " << valueOf("EndPoints") << " points no direction leads inward";
  }
  return share < 1 ? words.str() : std::string();
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
  const std::vector<bool> isWall = WallTags(solid, tags);
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
  Attributes::MixPointData(grid,
    MixInCells(mesh, made.Points, made.OriginalPoints, made.CellsOfPoints), {},
    result.Grid->GetPointData(), result.Warnings);
  vtkCellData* cellData = result.Grid->GetCellData();
  Attributes::CopyCellData(grid, made.OriginalCells, cellData, result.Warnings);
  cellData->RemoveArray("FacetIds");
  cellData->RemoveArray("FacetMultiplicity");
  Attributes::RenameArrays(cellData, Attributes::AreMadeHere(grid), { "Layer" }, result.Warnings);
  cellData->AddArray(
    MakeArray<vtkIntArray>("Layer", std::vector<int>(made.Layers.begin(), made.Layers.end())));
  result.Grid->GetFieldData()->ShallowCopy(grid->GetFieldData());
  result.Statistics = made.Statistics;
  const ProgressRange end = { Stages::Layering, 1, 1 };
  const std::vector<Tetrahedron> behind(made.Tetrahedra.begin(),
    made.Tetrahedra.begin() + static_cast<std::ptrdiff_t>(made.NumberOfCellsBehind));
  AppendQuality(QualityOfMesh(made.Points, behind, monitor, end), result.Statistics);
  AppendFitness(
    FitnessForSolver(made.Points, made.Tetrahedra, {}, made, {}, monitor, end), result.Statistics);
  if (const std::string words = WordsOfHeights(made.Statistics); !words.empty())
  {
    result.Warnings.push_back(words);
  }
  result.Statistics.emplace_back("SecondsLayers", stopwatch.Lap());
  return result;
}
} // namespace vtkInsideOut
