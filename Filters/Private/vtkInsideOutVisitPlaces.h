// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The places where a data set is asked something: its points, or the centres of its cells.
 */
#pragma once

#include "vtkInsideOutMakeWindingNumber.h"

#include <functional>
#include <vector>

class vtkDataSet;

/** How many places there are. */
vtkIdType vtkInsideOutNumberOfPlaces(vtkDataSet* input, bool atPoints);

/** Read the places as those of an image or rectilinear grid, if they are. @return whether they are
 */
bool vtkInsideOutReadAxes(vtkDataSet* input, bool atPoints, insideout::GridPlaces& grid);

/**
 * Call visit(first, values) with the winding numbers at all places, part by part: those of images
 * and rectilinear grids slice by slice, by several threads at once; but for a surface of lines, and
 * all other data sets, in parts of any size.
 *
 * @param sideOf where given, values only tell on which side of it the winding number is
 * @throws insideout::Error (Stopped)
 */
void vtkInsideOutVisitPlaces(vtkDataSet* input, bool atPoints,
  const vtkInsideOutWindingNumber& windingNumber, std::optional<double> sideOf,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress,
  const std::function<void(vtkIdType first, const std::vector<double>& values)>& visit);

/** Call visit(place, nearest) with what of the surface is nearest to each place, one after the
 * other.
 *
 * @throws insideout::Error (Stopped)
 */
void vtkInsideOutVisitNearest(vtkDataSet* input, bool atPoints,
  const vtkInsideOutWindingNumber& windingNumber, insideout::Monitor& monitor,
  const insideout::ProgressRange& progress,
  const std::function<void(vtkIdType place, const vtkInsideOutNearest& nearest)>& visit);
