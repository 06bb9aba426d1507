// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/CutEnergy.h"

namespace insideout
{
struct Segmentation
{
  std::vector<unsigned char> Inside; ///< 1 or 0 per cell
  double Energy = 0;                 ///< E of the labelling, without demands
};

/**
 * Stage cut: the labelling of the cells that minimizes the energy (RealEnergy.h) and meets the
 * demands, as a minimum cut (Boykov and Kolmogorov 2004). Among several minima the one with the
 * fewest inside cells is taken. The same for any number of threads.
 *
 * The monitor is asked before and after the flow, which itself cannot be interrupted.
 *
 * @throws Error InvalidParameter, TooLarge, Stopped
 */
Segmentation GraphCutSegmentation(
  const CellGraph& graph, const GraphCutParameters& parameters, Monitor& monitor);

/** The labels alone. */
std::vector<unsigned char> MinimumCut(const CutEnergy& energy);
} // namespace insideout
