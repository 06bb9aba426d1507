// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkGraphCutSegmentation.h"

#include "GraphCut/ConnectCells.h"
#include "GraphCut/SegmentMesh.h"
#include "vtkInsideOutConversion.h"
#include "vtkInsideOutMonitor.h"
#include "vtkInsideOutSegmentation.h"
#include "vtkInsideOutWholeInput.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkTetra.h>
#include <vtkTriangle.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace insideout;

vtkStandardNewMacro(vtkGraphCutSegmentation);

vtkGraphCutSegmentation::vtkGraphCutSegmentation()
{
  this->SetNumberOfInputPorts(2);
}

void vtkGraphCutSegmentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "DataTerm: " << this->DataTerm << "\n";
  os << indent << "ConstrainFacets: " << this->ConstrainFacets << "\n";
  os << indent << "ConstrainManifold: " << this->ConstrainManifold << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
}

int vtkGraphCutSegmentation::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

void vtkGraphCutSegmentation::SetSeedsData(vtkPointSet* seeds)
{
  this->SetInputData(1, seeds);
}

void vtkGraphCutSegmentation::SetSeedsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

namespace
{
/** A side of a cell: a face of a volume, an edge of a polygon. Equal points, equal side. */
struct Side
{
  std::vector<vtkIdType> Points; // sorted
  Id Cell;
  double Area;
};

/** Area of a linear face by Newell's sum, or the length of an edge. */
double AreaOf(vtkCell* side)
{
  vtkNew<vtkPoints> corners;
  corners->DeepCopy(side->GetPoints());
  if (side->GetCellType() == VTK_PIXEL) // whose points do not run around it
  {
    double swapped[3];
    corners->GetPoint(2, swapped);
    corners->SetPoint(2, corners->GetPoint(3));
    corners->SetPoint(3, swapped);
  }
  double sum[3] = { 0, 0, 0 };
  double a[3];
  double b[3];
  double first[3];
  const vtkIdType size = corners->GetNumberOfPoints();
  corners->GetPoint(0, first);
  if (size == 2)
  {
    corners->GetPoint(1, b);
    return std::hypot(b[0] - first[0], b[1] - first[1], b[2] - first[2]);
  }
  for (vtkIdType k = 1; k + 1 < size; ++k)
  {
    corners->GetPoint(k, a);
    corners->GetPoint(k + 1, b);
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int l = (i + 2) % 3;
      sum[i] += ((a[j] - first[j]) * (b[l] - first[l]) - (a[l] - first[l]) * (b[j] - first[j])) / 2;
    }
  }
  return std::hypot(sum[0], sum[1], sum[2]);
}

std::vector<Side> SidesOf(vtkUnstructuredGrid* grid)
{
  std::vector<Side> sides;
  vtkNew<vtkGenericCell> cell;
  int dimension = -1;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    const int cellDimension = cell->GetCellDimension();
    dimension = dimension < 0 ? cellDimension : dimension;
    if (!cell->IsLinear())
    {
      throw Error(ErrorCode::InvalidParameter,
        "cell " + std::to_string(c) + " is curved; only linear cells can be segmented");
    }
    if (cellDimension != dimension || dimension < 2)
    {
      throw Error(ErrorCode::InvalidParameter,
        "cell " + std::to_string(c) + " has dimension " + std::to_string(cellDimension) +
          "; all cells must be volumes, or all polygons");
    }
    const int numberOfSides = dimension == 3 ? cell->GetNumberOfFaces() : cell->GetNumberOfEdges();
    for (int k = 0; k < numberOfSides; ++k)
    {
      vtkCell* side = dimension == 3 ? cell->GetFace(k) : cell->GetEdge(k);
      vtkIdList* ids = side->GetPointIds();
      std::vector<vtkIdType> points(ids->begin(), ids->end());
      std::sort(points.begin(), points.end());
      sides.push_back({ std::move(points), static_cast<Id>(c), AreaOf(side) });
    }
  }
  return sides;
}

std::vector<InteriorFace> FacesBetweenCells(vtkUnstructuredGrid* grid)
{
  std::vector<Side> sides = SidesOf(grid);
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.Points, a.Cell) < std::tie(b.Points, b.Cell); });
  std::vector<InteriorFace> faces;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    if (sides[i].Points == sides[i + 1].Points)
    {
      faces.push_back({ sides[i].Cell, sides[i + 1].Cell, sides[i].Area });
      if (i + 2 < sides.size() && sides[i].Points == sides[i + 2].Points)
      {
        throw Error(ErrorCode::InvalidParameter,
          "cells " + std::to_string(sides[i].Cell) + ", " + std::to_string(sides[i + 1].Cell) +
            " and " + std::to_string(sides[i + 2].Cell) +
            " share one face: the grid does not conform");
      }
    }
  }
  return faces;
}

std::vector<double> WindingNumbers(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetCellData()->GetArray("w");
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the grid has no cell array w of one value per cell: vtkGeneralizedWindingNumber makes it");
  }
  std::vector<double> w(grid->GetNumberOfCells());
  for (std::size_t c = 0; c < w.size(); ++c)
  {
    w[c] = array->GetComponent(static_cast<vtkIdType>(c), 0);
  }
  return w;
}
/** Volumes, or areas of polygons. */
std::vector<double> SizesOf(vtkUnstructuredGrid* grid)
{
  std::vector<double> sizes(grid->GetNumberOfCells(), 0.0);
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> corners;
  for (std::size_t c = 0; c < sizes.size(); ++c)
  {
    grid->GetCell(static_cast<vtkIdType>(c), cell);
    cell->Triangulate(0, ids, corners);
    const int step = cell->GetCellDimension() + 1;
    for (vtkIdType k = 0; k + step <= corners->GetNumberOfPoints(); k += step)
    {
      double x[4][3];
      for (int i = 0; i < step; ++i)
      {
        corners->GetPoint(k + i, x[i]);
      }
      sizes[c] += step == 4 ? std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]))
                            : vtkTriangle::TriangleArea(x[0], x[1], x[2]);
    }
  }
  return sizes;
}

/** The first cell that is no tetrahedron, -1 if all are. */
vtkIdType FindOtherCell(vtkUnstructuredGrid* grid)
{
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) != VTK_TETRA)
    {
      return c;
    }
  }
  return -1;
}

/** The array FacetIds, nullptr where there is none of four values per cell. */
vtkDataArray* FindFacetIds(vtkUnstructuredGrid* grid)
{
  vtkDataArray* facetIds = grid->GetCellData()->GetArray("FacetIds");
  const bool fits = facetIds && facetIds->GetNumberOfComponents() == 4 &&
    facetIds->GetNumberOfTuples() == grid->GetNumberOfCells();
  return fits ? facetIds : nullptr;
}

/** A face is on a facet where FacetIds is not negative; without the array, none is. */
TetrahedralMesh ReadTetrahedra(vtkUnstructuredGrid* grid)
{
  std::vector<Point> points(grid->GetNumberOfPoints());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    grid->GetPoint(static_cast<vtkIdType>(p), points[p].data());
  }
  std::vector<Tetrahedron> cells(grid->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    grid->GetCellPoints(static_cast<vtkIdType>(c), ids);
    std::copy(ids->begin(), ids->end(), cells[c].begin());
  }
  const std::vector<Tetrahedron> given = cells;
  TetrahedralMesh mesh = ConnectCells(std::move(points), std::move(cells));
  if (vtkDataArray* facetIds = FindFacetIds(grid))
  {
    for (std::size_t c = 0; c < given.size(); ++c)
    {
      const bool turned = mesh.Cells[c] != given[c];
      for (int k = 0; k < 4; ++k)
      {
        const int face = turned && (k == 0 || k == 3) ? 3 - k : k;
        mesh.Facets[c][face] = facetIds->GetComponent(static_cast<vtkIdType>(c), k) < 0 ? None : 0;
      }
    }
  }
  return mesh;
}

/** Cells of any type, without constraints. */
MeshSegmentation SegmentCells(
  vtkUnstructuredGrid* grid, const GraphCutParameters& parameters, Monitor& monitor)
{
  const bool weighted = parameters.DataTerm == DataTerm::VolumeWeighted;
  Segmentation segmentation =
    GraphCutSegmentation({ WindingNumbers(grid), FacesBetweenCells(grid),
                           weighted ? SizesOf(grid) : std::vector<double>(), {} },
      parameters, monitor);
  return { std::move(segmentation.Inside), { { "Energy", segmentation.Energy } }, {} };
}

MeshSegmentation Segment(vtkUnstructuredGrid* grid, const std::vector<Seed>& seeds,
  const SegmentMeshParameters& parameters, Monitor& monitor)
{
  const bool isPlain =
    seeds.empty() && !parameters.ConstrainFacets && !parameters.ConstrainManifold;
  const vtkIdType other = FindOtherCell(grid);
  if (other >= 0 && !isPlain)
  {
    throw Error(ErrorCode::InvalidParameter,
      "cell " + std::to_string(other) +
        " is no tetrahedron; seeds and constraints need tetrahedra alone");
  }
  if (other >= 0)
  {
    return SegmentCells(grid, parameters.Cut, monitor);
  }
  if (parameters.ConstrainFacets && !FindFacetIds(grid))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the grid has no cell array FacetIds of four values per cell, which tells the facets to "
      "keep");
  }
  const std::vector<double> w = WindingNumbers(grid);
  const TetrahedralMesh mesh = ReadTetrahedra(grid);
  return SegmentMesh(mesh, w, PiecesOfFacets(mesh), seeds, parameters, monitor);
}
} // namespace

int vtkGraphCutSegmentation::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOutRequestWhole(inputVector, outputVector, this->GetNumberOfInputPorts());
  return 1;
}

int vtkGraphCutSegmentation::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOutRunOnWhole(this, outputVector,
    [&]()
    {
      vtkInsideOutMonitor monitor(this, { "segmenting" });
      if (input->GetNumberOfCells() == 0)
      {
        throw Error(ErrorCode::EmptySurface, "the grid has no cells");
      }
      if (input->GetNumberOfCells() > std::numeric_limits<Id>::max())
      {
        throw Error(ErrorCode::TooLarge,
          "the grid has " + std::to_string(input->GetNumberOfCells()) + " cells; at most " +
            std::to_string(std::numeric_limits<Id>::max()) + " can be handled");
      }
      Stopwatch stopwatch;
      const MeshSegmentation segmentation =
        Segment(input, vtkInsideOutReadSeeds(vtkPointSet::GetData(inputVector[1])),
          { { this->Gamma, this->Sigma, static_cast<insideout::DataTerm>(this->DataTerm) },
            this->ConstrainFacets, this->ConstrainManifold },
          monitor);

      vtkNew<vtkUnstructuredGrid> labelled;
      labelled->ShallowCopy(input);
      vtkInsideOutAddInside(segmentation.Inside, labelled);
      output->ShallowCopy(this->ExtractInside
          ? vtkInsideOutExtractInside(labelled, monitor, { "segmenting", 1, 1 }).Get()
          : labelled.Get());
      Statistics statistics = segmentation.Statistics;
      statistics.emplace_back(
        "InsideCells", std::count(segmentation.Inside.begin(), segmentation.Inside.end(), 1));
      statistics.emplace_back("SecondsCut", stopwatch.Lap());
      vtkInsideOutAddStatistics(statistics, output);
      vtkInsideOutWarn(this, segmentation.Warnings);
    });
}
