// SPDX-License-Identifier: GPL-3.0-or-later
/** @file The query points of a data set: its points, or the centers of its cells. */
#pragma once

#include "Data/VtkClasses.h"
#include "Probe/InputWindingNumber.h"

#include <functional>
#include <vector>

namespace vtkInsideOut
{
/** The number of query points. */
vtkIdType NumberOfPlaces(vtkDataSet* input, bool atPoints);

/** Read the query points as an image or rectilinear grid, if possible. @return whether it is */
bool ReadAxes(vtkDataSet* input, bool atPoints, insideout::GridPlaces& grid);

/**
 * Call visit(first, values) with the winding numbers at all places, block by block: slice by slice
 * for images and rectilinear grids, concurrently; in blocks of any size for lines and for other
 * data sets.
 *
 * @param sideOf if given, values only tell on which side of it the winding number is
 * @throws insideout::Error (Stopped)
 */
void VisitPlaces(vtkDataSet* input, bool atPoints, const InputWindingNumber& windingNumber,
  std::optional<double> sideOf, insideout::Monitor& monitor,
  const insideout::ProgressRange& progress,
  const std::function<void(vtkIdType first, const std::vector<double>& values)>& visit);

/** Call visit(place, nearest) with the nearest point of the surface to each place, one by one; for
 * images and rectilinear grids box by box.
 *
 * @throws insideout::Error (Stopped)
 */
void VisitNearest(vtkDataSet* input, bool atPoints, const InputWindingNumber& windingNumber,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress,
  const std::function<void(vtkIdType place, const NearestPoint& nearest)>& visit);
} // namespace vtkInsideOut
