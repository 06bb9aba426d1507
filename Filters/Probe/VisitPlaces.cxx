// SPDX-License-Identifier: GPL-3.0-or-later
#include "Probe/VisitPlaces.h"

#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <array>
#include <limits>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
// Places per block: few enough for the cache and for little memory, enough for many threads.
constexpr vtkIdType PlacesAtOnce = 1 << 16;
// Places per box of a grid.
constexpr Id BoxOfPlaces[3] = { 64, 32, 32 };

void GetPoints(vtkDataSet* input, vtkIdType first, std::vector<Point>& points)
{
  for (Point& point : points)
  {
    input->GetPoint(first++, point.data());
  }
}

void GetCentres(vtkDataSet* input, vtkIdType first, std::vector<Point>& centres)
{
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(input->GetMaxCellSize());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (Point& centre : centres)
  {
    input->GetCell(first++, cell);
    centre = { nan, nan, nan };
    if (cell->GetNumberOfPoints() > 0)
    {
      double parametric[3];
      int part = cell->GetParametricCenter(parametric);
      cell->EvaluateLocation(part, parametric, centre.data(), weights.data());
    }
  }
}

/** The next places from `first` on, as many as fit in `places`; NaN for empty cells. */
void ReadPlaces(vtkDataSet* input, bool atPoints, vtkIdType first, std::vector<Point>& places)
{
  (atPoints ? GetPoints : GetCentres)(input, first, places);
}

/** The numbers of points of an image or grid with axes along those of space; false for others. */
bool GetDimensions(vtkDataSet* input, int dimensions[3])
{
  if (auto* image = vtkImageData::SafeDownCast(input))
  {
    image->GetDimensions(dimensions);
    return image->GetDirectionMatrix()->IsIdentity();
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(input))
  {
    grid->GetDimensions(dimensions);
    return true;
  }
  return false;
}
} // namespace

vtkIdType NumberOfPlaces(vtkDataSet* input, bool atPoints)
{
  return atPoints ? input->GetNumberOfPoints() : input->GetNumberOfCells();
}

bool ReadAxes(vtkDataSet* input, bool atPoints, GridPlaces& grid)
{
  int dimensions[3];
  if (!GetDimensions(input, dimensions) || NumberOfPlaces(input, atPoints) == 0 ||
    (!atPoints && input->HasAnyBlankCells()))
  {
    return false;
  }
  vtkIdType stride = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = atPoints ? dimensions[axis] : std::max(dimensions[axis] - 1, 1);
    // One by one, so that they equal the results of GetPoints and GetCentres bit for bit.
    std::vector<Point> place(1);
    for (int i = 0; i < size; ++i)
    {
      ReadPlaces(input, atPoints, i * stride, place);
      grid.Axes[axis].push_back(place.front()[axis]);
    }
    stride *= size;
  }
  return true;
}

namespace
{
/** Call work(first, places, progress) for one block of places after the other. */
template <typename Work>
void ForEachPart(vtkDataSet* input, bool atPoints, const ProgressRange& progress, const Work& work)
{
  const vtkIdType size = NumberOfPlaces(input, atPoints);
  const double all = static_cast<double>(size);
  std::vector<Point> places;
  for (vtkIdType first = 0; first < size; first += PlacesAtOnce)
  {
    const vtkIdType last = std::min(size, first + PlacesAtOnce);
    places.resize(last - first);
    ReadPlaces(input, atPoints, first, places);
    work(first, places,
      { progress.Stage, progress.At(static_cast<double>(first) / all),
        progress.At(static_cast<double>(last) / all) });
  }
}
} // namespace

void VisitPlaces(vtkDataSet* input, bool atPoints, const InputWindingNumber& windingNumber,
  std::optional<double> sideOf, Monitor& monitor, const ProgressRange& progress,
  const std::function<void(vtkIdType first, const std::vector<double>& values)>& visit)
{
  GridPlaces grid;
  if (ReadAxes(input, atPoints, grid))
  {
    const vtkIdType slice = static_cast<vtkIdType>(grid.SizeOfSlice());
    const auto visitSlice = [&](Id k, const std::vector<double>& w) { visit(k * slice, w); };
    if (windingNumber.InGrid(grid, sideOf, visitSlice, monitor, progress))
    {
      return;
    }
  }
  ForEachPart(input, atPoints, progress,
    [&](vtkIdType first, const std::vector<Point>& places, const ProgressRange& part)
    { visit(first, windingNumber.At(places, monitor, part)); });
}

namespace
{
using Index = std::array<Id, 3>;

/** The places in a box of the grid, and their numbers. */
void ReadBox(const GridPlaces& grid, const Index& low, std::vector<vtkIdType>& numbers,
  std::vector<Point>& places)
{
  Index high;
  for (int axis = 0; axis < 3; ++axis)
  {
    high[axis] = std::min(grid.Size(axis), low[axis] + BoxOfPlaces[axis]);
  }
  const vtkIdType slice = static_cast<vtkIdType>(grid.SizeOfSlice());
  numbers.clear();
  places.clear();
  for (Id k = low[2]; k < high[2]; ++k)
  {
    for (Id j = low[1]; j < high[1]; ++j)
    {
      for (Id i = low[0]; i < high[0]; ++i)
      {
        numbers.push_back(k * slice + j * static_cast<vtkIdType>(grid.Size(0)) + i);
        places.push_back({ grid.Axes[0][i], grid.Axes[1][j], grid.Axes[2][k] });
      }
    }
  }
}

/** Call work(numbers, places, progress) for one box of a grid after the other: neighbors share
 * searches. */
template <typename Work>
void ForEachBox(const GridPlaces& grid, const ProgressRange& progress, const Work& work)
{
  const double all = static_cast<double>(grid.SizeOfSlice()) * grid.Size(2);
  double done = 0;
  std::vector<vtkIdType> numbers;
  std::vector<Point> places;
  Index low;
  for (low[2] = 0; low[2] < grid.Size(2); low[2] += BoxOfPlaces[2])
  {
    for (low[1] = 0; low[1] < grid.Size(1); low[1] += BoxOfPlaces[1])
    {
      for (low[0] = 0; low[0] < grid.Size(0); low[0] += BoxOfPlaces[0])
      {
        ReadBox(grid, low, numbers, places);
        const double begin = progress.At(done / all);
        done += static_cast<double>(places.size());
        work(numbers, places, { progress.Stage, begin, progress.At(done / all) });
      }
    }
  }
}
} // namespace

void VisitNearest(vtkDataSet* input, bool atPoints, const InputWindingNumber& windingNumber,
  Monitor& monitor, const ProgressRange& progress,
  const std::function<void(vtkIdType place, const NearestPoint& nearest)>& visit)
{
  GridPlaces grid;
  if (ReadAxes(input, atPoints, grid))
  {
    ForEachBox(grid, progress,
      [&](const std::vector<vtkIdType>& numbers, const std::vector<Point>& places,
        const ProgressRange& part)
      {
        const std::vector<NearestPoint> nearest = windingNumber.NearestTo(places, monitor, part);
        for (std::size_t i = 0; i < numbers.size(); ++i)
        {
          visit(numbers[i], nearest[i]);
        }
      });
    return;
  }
  ForEachPart(input, atPoints, progress,
    [&](vtkIdType first, const std::vector<Point>& places, const ProgressRange& part)
    {
      vtkIdType place = first;
      for (const NearestPoint& nearest : windingNumber.NearestTo(places, monitor, part))
      {
        visit(place++, nearest);
      }
    });
}
} // namespace vtkInsideOut
