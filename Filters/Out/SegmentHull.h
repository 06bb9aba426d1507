// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file The inside cells of a hull, and their regions, for one body, or for several with a cut
 * each.
 */
#pragma once

#include "Boolean/BodyRegions.h"
#include "Data/VtkClasses.h"
#include "GraphCut/SegmentMesh.h"
#include "Out/KeptHull.h"

namespace vtkInsideOut
{
/** The parameters of the cut. */
struct SegmentOptions
{
  insideout::SegmentMeshParameters Parameters;
  std::string ConstrainedArray; ///< cell array that selects the facets to keep
  insideout::RegionRule Rule;   ///< for several bodies, like all below
  std::string Priority;
  double MergeTolerance;         ///< narrower gaps between bodies are filled
  bool MembranesSeparateRegions; ///< for one body
};

/** The cells inside, and their regions. */
struct SegmentedHull
{
  insideout::MeshSegmentation All;                  ///< inside any body
  std::vector<std::vector<unsigned char>> InBodies; ///< if bodies are named
  insideout::BodyRegions Regions;
  bool HasInterfaces; ///< whether regions may share faces
};

/**
 * Stage cut.
 *
 * @param[in] points from which the seeds were read, or null
 * @throws insideout::Error that names the invalid seed or array; Stopped
 */
SegmentedHull SegmentHull(const KeptHull& kept, const std::vector<insideout::Seed>& given,
  vtkPointSet* points, const SegmentOptions& options, insideout::Monitor& monitor);
} // namespace vtkInsideOut
