// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "GraphCut/FacetConstraint.h"
#include "GraphCut/GraphCutSegmentation.h"
#include "GraphCut/ManifoldConstraint.h"
#include "GraphCut/Seeds.h"

#include <functional>

namespace insideout
{
struct SegmentMeshParameters
{
  GraphCutParameters Cut;
  bool ConstrainFacets = false;
  bool FillNonManifold = false;
};

struct MeshSegmentation
{
  std::vector<unsigned char> Inside; ///< 1 or 0 per cell
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Stage cut on tetrahedra, with all that may be asked of it: the minimum cut that puts the seeds'
 * cells where they are to be, then the constraints on facets, then those on manifoldness. Seeds win
 * over constraints; what they make impossible is counted and warned about.
 *
 * Statistics: Energy of the result, EnergyOfCut before the constraints, ForcedFacets (pieces of
 * facets that a cell was labelled inside for), ForcedCells (cells labelled inside for a
 * constraint), ChangedCells (labels that differ from the cut's), UnsatisfiedFacets (pieces that
 * seeds keep outside), NonManifoldPoints (that could not be helped), SeedConflicts (seeds that do
 * not count, pieces and points that seeds keep from being satisfied).
 *
 * @param[in] w one finite value per cell
 * @param[in] pieces those that have to be kept, only for ConstrainFacets
 * @throws Error InvalidParameter, PointNotFinite, TooLarge, Stopped
 */
MeshSegmentation SegmentMesh(const TetrahedralMesh& mesh, const std::vector<double>& w,
  const std::vector<FacetPiece>& pieces, const std::vector<Seed>& seeds,
  const SegmentMeshParameters& parameters, Monitor& monitor);

/** Makes the boundary of labels a manifold, and reports from one fraction to another. */
using MakeManifold = std::function<ManifoldConstraint::Outcome(
  GreedyLabels& labels, Monitor& monitor, double begin, double end)>;

/**
 * The same on cells of any kind.
 *
 * @param[in] graph without demands, which are those of the seeds
 * @param[in] makeManifold only for FillNonManifold
 */
MeshSegmentation SegmentCells(CellGraph graph, SeededCells seeded,
  const std::vector<FacetPiece>& pieces, const SegmentMeshParameters& parameters,
  const MakeManifold& makeManifold, Monitor& monitor);
} // namespace insideout
