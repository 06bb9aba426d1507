// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkGraphCutSegmentation.h"

#include "GraphCutSegmentation.h"
#include "vtkInsideOutConversion.h"
#include "vtkInsideOutMonitor.h"
#include "vtkInsideOutWholeInput.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace insideout;

vtkStandardNewMacro(vtkGraphCutSegmentation);

vtkGraphCutSegmentation::vtkGraphCutSegmentation() = default;

void vtkGraphCutSegmentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
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
} // namespace

int vtkGraphCutSegmentation::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOutRequestWhole(inputVector, outputVector);
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
      const Segmentation segmentation = GraphCutSegmentation(
        WindingNumbers(input), FacesBetweenCells(input), { this->Gamma, this->Sigma }, monitor);

      vtkNew<vtkUnstructuredGrid> labelled;
      labelled->ShallowCopy(input);
      vtkInsideOutAddInside(segmentation.Inside, labelled);
      output->ShallowCopy(
        this->ExtractInside ? vtkInsideOutExtractInside(labelled).Get() : labelled.Get());
      vtkInsideOutAddStatistics(
        { { "InsideCells",
            static_cast<double>(
              std::count(segmentation.Inside.begin(), segmentation.Inside.end(), 1)) },
          { "Energy", segmentation.Energy }, { "SecondsCut", stopwatch.Lap() } },
        output);
    });
}
