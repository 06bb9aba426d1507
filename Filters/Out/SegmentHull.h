// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The cells of a hull that are inside, and their regions: of one body, or of several that each have
 * a cut.
 */
#pragma once

#include "Boolean/BodyRegions.h"
#include "GraphCut/SegmentMesh.h"
#include "Out/KeptHull.h"

class vtkPointSet;

namespace vtkInsideOut
{
/** What the cut goes by. */
struct SegmentOptions
{
  insideout::SegmentMeshParameters Parameters;
  std::string ConstrainedArray; ///< the cell array that chooses which facets are kept
  insideout::RegionRule Rule;   ///< of several bodies, as all below
  std::string Priority;
  double MergeTolerance;         ///< narrower gaps between them are filled
  bool MembranesSeparateRegions; ///< of one body
};

/** The cells inside, and their regions. */
struct SegmentedHull
{
  insideout::MeshSegmentation All;                  ///< inside any body
  std::vector<std::vector<unsigned char>> InBodies; ///< where bodies are named
  insideout::BodyRegions Regions;
  bool HasInterfaces; ///< whether regions may have faces in common
};

/**
 * Stage cut.
 *
 * @param[in] points that the seeds were read from, or null
 * @throws insideout::Error that names the seed or array at fault; Stopped
 */
SegmentedHull SegmentHull(const KeptHull& kept, const std::vector<insideout::Seed>& given,
  vtkPointSet* points, const SegmentOptions& options, insideout::Monitor& monitor);
} // namespace vtkInsideOut
