// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"

#include <string>

namespace insideout
{
/** The gaps, with the bodies that they went to. */
struct FilledGaps
{
  Id Cells = 0;
  double Volume = 0;
};

/**
 * Close narrow gaps between bodies, as between round faces with different triangulations: free
 * cells in a gap are given to an adjacent body, so that the two share faces.
 *
 * A cell lies in a gap between two bodies on two conditions. First, no point of it is farther than
 * the tolerance from the cells of either (StaysNear). Second, both bodies have faces on its part of
 * the gap: the cells of the gap connected with it through faces. So a dent of one body is not a
 * gap, however near another body is behind it. A cell that reaches out of the gap stays outside.
 *
 * A cell goes to the last of the bodies beside it; earlier bodies keep their shape.
 *
 * @param[in] tolerance above 0
 * @param[in] order indices of all bodies
 * @param[in,out] inside per body and cell, not 0 if the body has the cell; set to 1 for cells that
 * it gets
 * @throws Error Stopped
 */
FilledGaps FillGaps(const TetrahedralMesh& mesh, double tolerance, const std::vector<Id>& order,
  std::vector<std::vector<unsigned char>>& inside, Monitor& monitor);

/** The figures GapCells and GapVolume, and a message if they are not 0. */
void AddFilledGaps(
  const FilledGaps& filled, Statistics& statistics, std::vector<std::string>& warnings);
} // namespace insideout
