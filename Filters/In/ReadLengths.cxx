// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadLengths.h"

#include "Common/Error.h"

#include <vtkCellLocator.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>
#include <memory>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/** @param[in] owner name of the data set, for the error */
std::vector<double> ReadLengths(vtkDataSet* data, const std::string& name, const std::string& owner)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    return {};
  }
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    throw Error(ErrorCode::InvalidParameter,
      owner + "'s point array " + name + " is not one edge length per point");
  }
  std::vector<double> lengths(data->GetNumberOfPoints());
  for (std::size_t p = 0; p < lengths.size(); ++p)
  {
    const double length = array->GetComponent(static_cast<vtkIdType>(p), 0);
    if (length <= 0)
    {
      throw Error(ErrorCode::InvalidParameter,
        owner + "'s point array " + name + " is not positive at point " + std::to_string(p));
    }
    lengths[p] = std::isnan(length) ? Infinite : length;
  }
  return lengths;
}

/** Interpolates values at places in a data set. */
class Background
{
public:
  Background(vtkDataSet* data, std::vector<double> lengths)
    : Lengths(std::move(lengths))
    , Weights(data->GetMaxCellSize())
    , Reach(data->GetLength() * ReachOfRounding)
  {
    this->Locator->SetDataSet(data);
    this->Locator->BuildLocator();
  }

  double At(const Point& place)
  {
    Point there = place;
    double coordinates[3];
    vtkIdType cell =
      this->Locator->FindCell(there.data(), 0, this->Cell, coordinates, this->Weights.data());
    if (cell < 0 && !this->FindBeside(place))
    {
      return Infinite;
    }
    double sum = 0;
    for (vtkIdType k = 0; k < this->Cell->GetNumberOfPoints(); ++k)
    {
      const double length = this->Lengths[this->Cell->GetPointId(static_cast<int>(k))];
      sum += this->Weights[k] == 0 ? 0 : this->Weights[k] * length;
    }
    return sum > 0 ? sum : Infinite;
  }

private:
  /**
   * Limit of the distance between a cell and a place that rounding put between cells, in cell
   * diagonals.
   */
  static constexpr double ReachOfRounding = 1e-9;

  bool FindBeside(const Point& place)
  {
    Point there = place;
    Point nearest;
    vtkIdType cell = -1;
    int part = 0;
    double distance = 0;
    if (this->Locator->FindClosestPointWithinRadius(
          there.data(), this->Reach, nearest.data(), this->Cell, cell, part, distance) == 0)
    {
      return false;
    }
    double coordinates[3];
    double closest[3];
    return this->Cell->EvaluatePosition(
             nearest.data(), closest, part, coordinates, distance, this->Weights.data()) >= 0;
  }

  vtkNew<vtkCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Lengths;
  std::vector<double> Weights;
  double Reach;
};
} // namespace

std::vector<double> ReadLengths(vtkDataSet* grid, const std::string& name)
{
  return ReadLengths(grid, name, "the grid");
}

std::function<double(const Point&)> LengthsWithin(vtkDataSet* background, const std::string& name)
{
  std::vector<double> lengths = ReadLengths(background, name, "the background");
  if (lengths.empty())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the background has no point array " + name + " of edge lengths");
  }
  if (background->GetNumberOfCells() == 0)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the background has no cells, between whose points its edge lengths would hold");
  }
  const auto field = std::make_shared<Background>(background, std::move(lengths));
  return [field](const Point& place) { return field->At(place); };
}
} // namespace vtkInsideOut
