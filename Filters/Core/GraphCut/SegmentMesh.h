// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "GraphCut/ControlTopology.h"
#include "GraphCut/GraphCutSegmentation.h"
#include "GraphCut/Seeds.h"

namespace insideout
{
struct SegmentMeshParameters
{
  GraphCutParameters Cut;
  bool ConstrainFacets = false;
  bool FillNonManifold = false;
  ControlTopologyParameters Topology;
};

struct MeshSegmentation
{
  std::vector<unsigned char> Inside; ///< 1 or 0 per cell
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Stage cut on tetrahedra, with all its options: the minimum cut with the seeds' cells fixed, then
 * the constraints on facets, on manifoldness, on regions and on topology. Seeds override
 * constraints, and the choice of regions overrides both; violated constraints are counted and
 * warned about.
 *
 * Statistics:
 * - Energy of the result, EnergyOfCut before the constraints
 * - ForcedFacets: pieces of facets that a cell was labelled inside for
 * - ForcedCells: cells labelled inside for a constraint
 * - ChangedCells: labels that differ from the cut's
 * - UnsatisfiedFacets: pieces that seeds keep outside, or that belonged to dropped regions
 * - NonManifoldPoints: points that could not be repaired
 * - SeedConflicts: seeds without effect, pieces and points that seeds keep unsatisfied, seeds
 *   dropped with their region
 * - EnergyBeforeTopology: after regions were chosen, before any were joined or dropped
 * - DroppedRegions and DroppedVolume (an area in a plane), FilledCavities and FilledVolume
 * - JoinedRegions: ways made between two regions
 *
 * @param[in] w one finite value per cell
 * @param[in] pieces those that have to be kept, only for ConstrainFacets
 * @throws Error InvalidParameter, PointNotFinite, TooLarge, Stopped
 */
MeshSegmentation SegmentMesh(const TetrahedralMesh& mesh, const std::vector<double>& w,
  const std::vector<FacetPiece>& pieces, const std::vector<Seed>& seeds,
  const SegmentMeshParameters& parameters, Monitor& monitor);

/** Whether the statistics of a segmentation report dropped regions. */
bool DropsRegions(const Statistics& statistics);

/** Supplies parts of the mesh on demand. */
struct MeshToSegment
{
  insideout::MakeManifold MakeManifold;
  std::function<SimplicialCells()> ListCells;
};

/**
 * The same on cells of any kind.
 *
 * @param[in] graph without demands; the seeds supply them
 */
MeshSegmentation SegmentCells(CellGraph graph, SeededCells seeded,
  const std::vector<FacetPiece>& pieces, const SegmentMeshParameters& parameters,
  const MeshToSegment& mesh, Monitor& monitor);
} // namespace insideout
