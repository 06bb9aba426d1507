// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutRefine.h"

#include "Common/Error.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Refine/QuadraticCells.h"
#include "Refine/RefineTetrahedra.h"
#include "vtkInsideOutArrays.h"
#include "vtkInsideOutAttributes.h"
#include "vtkInsideOutReadGrid.h"

#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <numeric>
#include <sstream>

using namespace insideout;

namespace
{
/** What would lead a stage astray: VTK checks none of it. */
void CheckGrid(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfCells() == 0)
  {
    throw Error(ErrorCode::EmptySurface, "the grid has no cells");
  }
  if (const vtkIdType other = vtkInsideOutFindOtherCell(grid); other >= 0)
  {
    throw Error(ErrorCode::InvalidParameter,
      "cell " + std::to_string(other) + " is a " +
        vtkCellTypes::GetClassNameFromTypeId(grid->GetCellType(other)) +
        "; only tetrahedra (vtkTetra) can be refined");
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCellPoints(c, corners);
    for (const vtkIdType p : *corners)
    {
      if (p < 0 || p >= grid->GetNumberOfPoints())
      {
        throw Error(ErrorCode::InvalidParameter,
          "cell " + std::to_string(c) + " has the point " + std::to_string(p) +
            ", which is not there");
      }
      Point place;
      grid->GetPoint(p, place.data());
      if (!IsFinite(place))
      {
        throw Error(ErrorCode::InvalidParameter, "point " + std::to_string(p) + " is not finite");
      }
    }
  }
}

/** The cells' RegionId, numbered anew; empty where there is none. */
std::vector<Id> ReadRegions(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetCellData()->GetArray("RegionId");
  if (!array)
  {
    return {};
  }
  const bool isReal = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
  if (isReal || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    throw Error(ErrorCode::InvalidParameter, "the cell array RegionId is not one integer per cell");
  }
  std::vector<double> values(grid->GetNumberOfCells());
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    values[c] = array->GetComponent(static_cast<vtkIdType>(c), 0);
  }
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<Id> regions(values.size());
  std::transform(values.begin(), values.end(), regions.begin(),
    [&](double value)
    {
      return static_cast<Id>(
        std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
    });
  return regions;
}

/** The face of a cell of the grid that is face k of the mesh's: one that is inside out was turned.
 */
int FaceInGrid(vtkUnstructuredGrid* grid, const TetrahedralMesh& mesh, Id cell, int k)
{
  vtkNew<vtkIdList> given;
  grid->GetCellPoints(cell, given);
  const bool turned = !std::equal(given->begin(), given->end(), mesh.Cells[cell].begin());
  // ConnectCells says which faces of turned cells change places.
  return turned && (k == 0 || k == 3) ? 3 - k : k;
}

/** Arrays of four values per cell, one per face: those of facets stay, others are `otherwise`. */
void CarryFaces(const TetrahedralMesh& mesh, const RefinedMesh& refined, const char* name,
  double otherwise, vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  vtkDataArray* source = input->GetCellData()->GetArray(name);
  vtkDataArray* array = output->GetCellData()->GetArray(name);
  if (!array || !source || source->GetNumberOfComponents() != 4)
  {
    return;
  }
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id face = refined.OriginalFaces[c][k];
      array->SetComponent(static_cast<vtkIdType>(c), k,
        face == None ? otherwise
                     : source->GetComponent(face / 4, FaceInGrid(input, mesh, face / 4, face % 4)));
    }
  }
}

/** The faces of a mesh that have no cell behind them, 4 * cell + face: as a boundary has them. */
std::vector<Id> FacesOnBoundary(const TetrahedralMesh& mesh)
{
  std::vector<Id> faces;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[c][k] == None)
      {
        faces.push_back(4 * c + k);
      }
    }
  }
  return faces;
}

/** The tag of each face on the boundary. */
std::vector<std::array<Id, 4>> LabelsOf(const TetrahedralMesh& mesh, vtkPolyData* boundary)
{
  vtkDataArray* tags = boundary->GetCellData()->GetArray("BoundaryTag");
  std::vector<std::array<Id, 4>> labels(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  const std::vector<Id> faces = FacesOnBoundary(mesh);
  for (std::size_t i = 0; i < faces.size() && tags; ++i)
  {
    labels[faces[i] / 4][faces[i] % 4] =
      static_cast<Id>(tags->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return labels;
}

/** The weights of a triangle's corners at a place in it or near it: none is negative. */
std::array<double, 4> WeightsAt(const std::array<Point, 3>& t, const Point& place)
{
  std::array<double, 4> weights = { { 0, 0, 0, 0 } };
  const Point normal = NormalOf(t[0], t[1], t[2]);
  double sum = 0;
  for (int k = 0; k < 3; ++k)
  {
    weights[k] = std::max(0.0, Dot(NormalOf(place, t[(k + 1) % 3], t[(k + 2) % 3]), normal));
    sum += weights[k];
  }
  for (int k = 0; k < 3; ++k)
  {
    weights[k] = sum > 0 ? weights[k] / sum : 1.0 / 3;
  }
  return weights;
}

/** The boundary of a refined mesh, with the data of the one before. */
vtkSmartPointer<vtkPolyData> MakeBoundary(const TetrahedralMesh& mesh, const RefinedMesh& refined,
  vtkPolyData* before, std::vector<std::string>& warnings)
{
  const std::vector<Id> faces = FacesOnBoundary(mesh);
  std::vector<Id> numbers(refined.Points.size(), None);
  std::vector<Point> points;
  std::vector<vtkInsideOutAttributes::Mixture> mixtures;
  std::vector<Triangle> triangles;
  std::vector<Id> sources;
  vtkNew<vtkIdList> given;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (refined.OriginalFaces[c][k] == None)
      {
        continue;
      }
      sources.push_back(IndexIn(faces, refined.OriginalFaces[c][k]));
      before->GetCellPoints(sources.back(), given);
      std::array<Point, 3> corners;
      for (int i = 0; i < 3; ++i)
      {
        before->GetPoint(given->GetId(i), corners[i].data());
      }
      triangles.push_back(FaceOf(refined.Cells[c], k));
      for (Id& corner : triangles.back())
      {
        if (numbers[corner] == None)
        {
          numbers[corner] = static_cast<Id>(points.size());
          const Point& place = refined.Points[corner];
          points.push_back(place);
          const auto at = std::find(corners.begin(), corners.end(), place) - corners.begin();
          const auto id = [&](std::ptrdiff_t i) { return static_cast<Id>(given->GetId(i)); };
          mixtures.push_back(at < 3
              ? vtkInsideOutAttributes::Mixture{ { { id(at), 0, 0, 0 } }, { { 1, 0, 0, 0 } },
                  false }
              : vtkInsideOutAttributes::Mixture{
                  { { id(0), id(1), id(2), 0 } }, WeightsAt(corners, place), true });
        }
        corner = numbers[corner];
      }
    }
  }
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  boundary->SetPoints(vtkInsideOutMakePoints(points));
  boundary->SetPolys(vtkInsideOutMakeCells(triangles));
  vtkInsideOutAttributes::MixPointData(before, mixtures, {}, boundary->GetPointData(), warnings);
  vtkInsideOutAttributes::CopyCellData(before, sources, boundary->GetCellData(), warnings);
  boundary->GetFieldData()->ShallowCopy(before->GetFieldData());
  return boundary;
}

/** The weights of a cell's corners at a place in it: none is negative, however thin the cell. */
std::array<double, 4> WeightsAt(
  const std::vector<Point>& points, const Tetrahedron& cell, const Point& place)
{
  std::array<double, 4> weights;
  for (int k = 0; k < 4; ++k)
  {
    std::array<Point, 4> corners = CornersOf(points, cell);
    corners[k] = place;
    weights[k] = std::max(0.0,
      Determinant(Difference(corners[1], corners[0]), Difference(corners[2], corners[0]),
        Difference(corners[3], corners[0])));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights)
  {
    weight = sum > 0 ? weight / sum : 0.25;
  }
  return weights;
}

std::vector<vtkInsideOutAttributes::Mixture> MixturesOf(
  const TetrahedralMesh& mesh, const RefinedMesh& refined)
{
  std::vector<vtkInsideOutAttributes::Mixture> mixtures(refined.Points.size());
  for (std::size_t p = 0; p < mixtures.size(); ++p)
  {
    const Id original = refined.OriginalPoints[p];
    const Tetrahedron& cell = mesh.Cells[refined.CellsOfPoints[p]];
    mixtures[p].IsNew = original == None;
    mixtures[p].Points = original == None ? cell : Tetrahedron{ { original, 0, 0, 0 } };
    mixtures[p].Weights = original == None ? WeightsAt(mesh.Points, cell, refined.Points[p])
                                           : std::array<double, 4>{ { 1, 0, 0, 0 } };
  }
  return mixtures;
}

/** Points and cells of a result, where wanted with points amid the edges. */
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
  const RefinedMesh& refined, const QuadraticCells* quadratic)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (!quadratic)
  {
    grid->SetPoints(vtkInsideOutMakePoints(refined.Points));
    grid->SetCells(VTK_TETRA, vtkInsideOutMakeCells(refined.Cells));
    return grid;
  }
  std::vector<Point> points = refined.Points;
  points.reserve(points.size() + quadratic->Edges.size());
  for (const Edge& edge : quadratic->Edges)
  {
    points.push_back(Midpoint(refined.Points[edge[0]], refined.Points[edge[1]]));
  }
  grid->SetPoints(vtkInsideOutMakePoints(points));
  grid->SetCells(VTK_QUADRATIC_TETRA, vtkInsideOutMakeCells(quadratic->Cells));
  return grid;
}

std::string TooLargeCells(double count, std::size_t cells, double maximumVolume)
{
  std::ostringstream words;
  words << static_cast<Id>(count) << " of " << cells << " cells are larger than MaximumVolume, "
        << maximumVolume << ": faces that stay as they are may allow no smaller ones";
  return words.str();
}
} // namespace

vtkInsideOutRefinement vtkInsideOutRefine(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  const RefinementParameters& given, bool quadratic, Monitor& monitor)
{
  Stopwatch stopwatch;
  CheckGrid(grid);
  const std::vector<Id> regions = ReadRegions(grid);
  const TetrahedralMesh mesh = vtkInsideOutReadTetrahedra(grid);
  RefinementParameters parameters = given;
  if (boundary && parameters.Surface == SurfaceTreatment::Remeshed)
  {
    parameters.Labels = LabelsOf(mesh, boundary);
  }
  const RefinedMesh refined = RefineTetrahedra(mesh, regions, parameters, monitor);
  QuadraticCells secondOrder;
  if (quadratic)
  {
    secondOrder = MakeQuadraticCells(static_cast<Id>(refined.Points.size()), refined.Cells);
  }

  vtkInsideOutRefinement result;
  result.Grid = MakeGrid(refined, quadratic ? &secondOrder : nullptr);
  vtkInsideOutAttributes::MixPointData(grid, MixturesOf(mesh, refined), secondOrder.Edges,
    result.Grid->GetPointData(), result.Warnings);
  vtkInsideOutAttributes::CopyCellData(
    grid, refined.OriginalCells, result.Grid->GetCellData(), result.Warnings);
  CarryFaces(mesh, refined, "FacetIds", -1, grid, result.Grid);
  CarryFaces(mesh, refined, "FacetMultiplicity", 0, grid, result.Grid);
  result.Grid->GetFieldData()->ShallowCopy(grid->GetFieldData());
  result.Boundary = boundary;
  if (boundary && parameters.Surface != SurfaceTreatment::Kept)
  {
    result.Boundary = MakeBoundary(mesh, refined, boundary, result.Warnings);
  }

  result.Statistics = refined.Statistics;
  result.Statistics.emplace_back("RefinedCells", refined.Cells.size());
  for (const auto& [name, value] : refined.Statistics)
  {
    if (name == "CellsAboveMaximumVolume" && value > 0)
    {
      result.Warnings.push_back(
        TooLargeCells(value, refined.Cells.size(), parameters.Sizes.MaximumVolume));
    }
  }
  result.Statistics.emplace_back("SecondsRefine", stopwatch.Lap());
  return result;
}
