// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/TetrahedralMesh.h"

#include <array>
#include <functional>
#include <vector>

namespace insideout
{
/** The reason why a facet is not part of the solid. */
enum class OutlierReason : unsigned char
{
  Energy,    ///< the segmentation put the cells on both sides outside
  Lost,      ///< the tetrahedra do not follow the facet
  LeftOut,   ///< it still crossed others when the resolver stopped
  Degenerate ///< the input triangle has no area
};

/** By OutlierReason. */
constexpr std::array<const char*, 4> OutlierReasonNames = { { "segmented as outside",
  "lost in the tetrahedralization", "left out by the resolver", "degenerate" } };

/** A piece of a facet that is not a face of an inside cell. */
struct OutlierPiece
{
  Triangle Corners; ///< points of the mesh, in the facet's orientation
  Id Facet;
  OutlierReason Reason;
};

/**
 * Parts of the surface that the solid leaves out (thesis, section 8.5): pieces of facets (faces of
 * the mesh on them) without an inside cell on either side, and whole facets without pieces: those
 * that the mesh lost and those behind NumberOfConstraints. Facets of multiplicity 0 are treated
 * like the others. The thesis's figure 8.13 shows such facets.
 *
 * @param[in] surface the complex that `mesh` was made of
 * @param[in] inside one value per cell, 0 for outside
 * @return sorted by facet, pieces of one facet in the order of their cells
 * @throws Error InvalidParameter if there is not one label per cell; Stopped
 */
std::vector<OutlierPiece> OutlierPieces(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);

/**
 * The same with inside depending on the facet, as for several bodies.
 *
 * @param[in] isInside called with (facet, cell)
 */
std::vector<OutlierPiece> OutlierPieces(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::function<bool(Id, Id)>& isInside, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
