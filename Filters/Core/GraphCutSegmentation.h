// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Monitor.h"
#include "Types.h"

#include <vector>

namespace insideout
{
struct GraphCutParameters
{
  double Gamma = 1;   ///< weight of smoothness against data, at least 0; 0 thresholds at w > 1/2
  double Sigma = 0.1; ///< noise in w: steps much larger than this cost nothing, above 0
};

/** A face between two cells. */
struct InteriorFace
{
  Id First;
  Id Second;
  double Area; ///< length in 2D
};

struct Segmentation
{
  std::vector<unsigned char> Inside; ///< 1 or 0 per cell
  double Energy = 0;                 ///< E of the labelling
};

/**
 * Stage cut: the labelling of the cells that minimizes the energy
 *
 *   E(x) = sum_i u_i(x_i) + gamma * sum_{faces ij} v_ij(x_i, x_j)           (thesis, 8.8)
 *   u_i(outside) = max(w_i, 0),  u_i(inside) = max(1 - w_i, 0)              (8.9)
 *   v_ij = 0 where x_i = x_j, else a_ij exp(-|w_i - w_j|^2 / (2 sigma^2))   (8.10)
 *
 * with a_ij the face's area over the mean area of all faces, so that gamma means the same at every
 * size. Found as a minimum cut (Boykov and Kolmogorov 2004); of several minima, the one with the
 * fewest inside cells.
 *
 * @param[in] w one finite value per cell
 * @param[in] faces every face between two cells, once
 * @throws Error InvalidParameter, TooLarge, Stopped
 */
Segmentation GraphCutSegmentation(const std::vector<double>& w,
  const std::vector<InteriorFace>& faces, const GraphCutParameters& parameters, Monitor& monitor);
} // namespace insideout
