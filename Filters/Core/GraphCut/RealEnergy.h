// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/RawVector.h"
#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/**
 * The weight of a cell's data term.
 *
 * Uniform is the default for two reasons. On closed surfaces it gives exactly the cells with w = 1
 * (see GraphCutParameters); the small weights of slivers do not. Around details there are many
 * small cells, which keep thin features and close holes where the detail ends: with four large
 * holes in Debian's blobby.off 2.4 % of the solid's volume is wrong, and 14.3 % when weighted; in
 * cow.off 2.8 and 6.2 %, in femur.off 2.1 and 5.6 %. VolumeWeighted is better for many small
 * errors, such as single facets that face the wrong way: 0.30 % against 0.36 % in hand.off.
 */
enum class DataTerm
{
  Uniform,       ///< every cell the same (thesis)
  VolumeWeighted ///< by the cell's volume over the mean volume
};

/**
 * The defaults come from 15 of Debian's closed surfaces (armadillo, bear, camel, cow, man, ...),
 * each damaged in four ways: small holes, four large ones, every fifth facet away, every twelfth
 * turned over. JudgeSegmentation measures the volume that is labelled differently than with the
 * undamaged surface, in percent of the solid's, the mean over the surfaces:
 *
 *   gamma  sigma   small holes   large holes   facets away   turned over
 *     0     any       1.38          24.5          0.209         0.573
 *     1     0.1       1.02          21.9          0.136         0.469
 *     2     0.15      0.98          21.8          0.077         0.342
 *     5     0.2       0.88          22.3          0.081         0.221
 *    10     0.3       0.95          31.6          0.245         0.142
 *
 * Larger values smooth better and better until they cut limbs off, all at once. And sigma has a
 * bound: a face between w = 0 and w = 1 costs gamma exp(-1 / (2 sigma^2)) times its area over the
 * mean. With the defaults that stays below the data terms for fewer than 2^31 faces: closed
 * surfaces then give exactly the cells with w = 1. With sigma = 0.2 that needs fewer than 130,000
 * faces.
 */
struct GraphCutParameters
{
  double Gamma = 2;    ///< weight of smoothness against data, at least 0; 0 thresholds at w > 1/2
  double Sigma = 0.15; ///< above 0, noise in w: steps much larger than this cost nothing
  insideout::DataTerm DataTerm = insideout::DataTerm::Uniform;
};

/**
 * Whether a cut with these weights is proved to take the cells with w of 1 or more, if w is a whole
 * number in each cell: no weight exceeds the defaults', for which the proof is above.
 */
bool IsCutByWholeNumbers(const GraphCutParameters& cut);

/** A face between two cells. */
struct InteriorFace
{
  Id First;
  Id Second;
  double Area; ///< length in 2D
};

/** The cut's view of a mesh. */
struct CellGraph
{
  std::vector<double> W;            ///< one finite value per cell
  std::vector<InteriorFace> Faces;  ///< every face between two cells, once
  std::vector<double> Volumes = {}; ///< one per cell, areas in 2D; only VolumeWeighted needs them
  std::vector<std::int8_t>
    Demands = {}; ///< per cell 1 to be inside, -1 outside, 0 either; or empty
};

/**
 * The energy of a labelling of cells,
 *
 *   E(x) = sum_i u_i(x_i) + gamma * sum_{faces ij} v_ij(x_i, x_j)           (thesis, 8.8)
 *   u_i(outside) = max(w_i, 0),  u_i(inside) = max(1 - w_i, 0)              (8.9)
 *   v_ij = 0 where x_i = x_j, else a_ij exp(-|w_i - w_j|^2 / (2 sigma^2))   (8.10)
 *
 * with a_ij the face's area over the mean area of all faces, so that gamma means the same at every
 * size. VolumeWeighted multiplies u_i by the cell's volume over the mean volume of all cells.
 */
class RealEnergy
{
public:
  /**
   * @param[in] graph must live on
   * @throws Error InvalidParameter, TooLarge
   */
  RealEnergy(const CellGraph& graph, const GraphCutParameters& parameters);

  const CellGraph& Cells() const { return this->Graph; }
  double Gamma() const { return this->SmoothnessWeight; }

  /** u_i of the cell outside less that inside. */
  double Gain(Id cell) const;

  /** v_ij of a face whose cells have different labels. */
  double Smoothness(std::size_t face) const { return this->OfFaces[face]; }

  /** E of a labelling, without demands. */
  double Of(const std::vector<unsigned char>& inside) const;

private:
  double Weight(Id cell) const { return this->Weights.empty() ? 1 : this->Weights[cell]; }

  const CellGraph& Graph;
  const double SmoothnessWeight;
  RawVector<double> Weights; ///< of data terms, one per cell; empty for 1
  RawVector<double> OfFaces;
};
} // namespace insideout
