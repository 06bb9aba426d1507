// SPDX-License-Identifier: GPL-3.0-or-later
#include "Probe/VisitPlaces.h"

#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <limits>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
// Few enough for the processor's cache, and for memory to matter little; enough for many threads.
constexpr vtkIdType PlacesAtOnce = 1 << 16;

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

/** From `first` on, as many as there are in `places`; NaN for empty cells. */
void ReadPlaces(vtkDataSet* input, bool atPoints, vtkIdType first, std::vector<Point>& places)
{
  (atPoints ? GetPoints : GetCentres)(input, first, places);
}

/** The numbers of points of an image or grid whose axes are those of space; false for any other. */
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
    // One by one, so that they are what GetPoints and GetCentres say, bit by bit.
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
/** Call work(first, places, progress) for some places after the other. */
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

void VisitNearest(vtkDataSet* input, bool atPoints, const InputWindingNumber& windingNumber,
  Monitor& monitor, const ProgressRange& progress,
  const std::function<void(vtkIdType place, const NearestPoint& nearest)>& visit)
{
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
