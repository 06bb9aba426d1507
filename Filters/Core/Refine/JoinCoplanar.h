// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"
#include "Refine/RefinableSurface.h"

#include <vector>

namespace insideout
{
/**
 * Join facets to planar patches: those of one label that share an edge with no third one and lie in
 * one plane, up to the rounding of coordinates. That is a millionth of the longest edge of the
 * bounding box if most coordinates have few digits, as those of files, and normals differ by at
 * most 0.1 degrees. Each facet's label becomes the largest facet of its patch.
 *
 * @param[in,out] facets of the mesh (FacetsOf)
 * @param[in] locked per facet whether it stays alone
 */
void JoinCoplanar(
  const TetrahedralMesh& mesh, const std::vector<char>& locked, std::vector<FacetOfInput>& facets);
} // namespace insideout
