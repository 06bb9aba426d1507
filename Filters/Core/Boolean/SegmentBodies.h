// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/SegmentMesh.h"

namespace insideout
{
/** The input of a body's cut, besides the common parameters. */
struct BodyToSegment
{
  std::string Name;               ///< for messages
  std::vector<double> W;          ///< one finite value per cell
  std::vector<FacetPiece> Pieces; ///< pieces of the body to keep, for ConstrainFacets
  std::vector<Seed> Seeds;
};

/** Where each body is. */
struct BodySegmentation
{
  std::vector<std::vector<unsigned char>> Inside; ///< per body and cell, 1 or 0
  insideout::Statistics Statistics;               ///< SegmentMesh's, summed over the bodies
  std::vector<std::string> Warnings;              ///< prefixed with the body's name
};

/**
 * Stage cut for several bodies on one mesh: each is segmented as if it were alone (SegmentMesh), so
 * a cell may belong to several.
 *
 * @throws Error as SegmentMesh does, prefixed with the body's name; Stopped
 */
BodySegmentation SegmentBodies(const TetrahedralMesh& mesh,
  const std::vector<BodyToSegment>& bodies, const SegmentMeshParameters& parameters,
  Monitor& monitor);
} // namespace insideout
