// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The places where a data set is asked something: its points, or the centers of its cells.
 */
#pragma once

#include "Probe/InputWindingNumber.h"

#include <functional>
#include <vector>

class vtkDataSet;

namespace vtkInsideOut
{
/** How many places there are. */
vtkIdType NumberOfPlaces(vtkDataSet* input, bool atPoints);

/** Read the places as those of an image or rectilinear grid, if they are. @return whether they are
 */
bool ReadAxes(vtkDataSet* input, bool atPoints, insideout::GridPlaces& grid);

/**
 * Call visit(first, values) with the winding numbers at all places, part by part: those of images
 * and rectilinear grids slice by slice, by several threads at once; but for a surface of lines, and
 * all other data sets, in parts of any size.
 *
 * @param sideOf where given, values only tell on which side of it the winding number is
 * @throws insideout::Error (Stopped)
 */
void VisitPlaces(vtkDataSet* input, bool atPoints, const InputWindingNumber& windingNumber,
  std::optional<double> sideOf, insideout::Monitor& monitor,
  const insideout::ProgressRange& progress,
  const std::function<void(vtkIdType first, const std::vector<double>& values)>& visit);

/** Call visit(place, nearest) with what of the surface is nearest to each place, one after the
 * other: those of images and rectilinear grids box by box.
 *
 * @throws insideout::Error (Stopped)
 */
void VisitNearest(vtkDataSet* input, bool atPoints, const InputWindingNumber& windingNumber,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress,
  const std::function<void(vtkIdType place, const NearestPoint& nearest)>& visit);
} // namespace vtkInsideOut
