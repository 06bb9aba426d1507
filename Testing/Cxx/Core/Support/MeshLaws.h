// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

namespace testmeshes
{
/**
 * Expect everything that TetrahedralMesh.h promises: the complex's points bit by bit, exact
 * positive volumes that sum exactly to the convex hull's, neighbors that agree, a closed hull,
 * facets on faces of the right side, and each constraint that is not lost a union of faces.
 */
void ExpectMeshLaws(const insideout::FacetComplex& surface, const insideout::TetrahedralMesh& mesh);
} // namespace testmeshes
