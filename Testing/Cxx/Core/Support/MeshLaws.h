// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

namespace testmeshes
{
/**
 * Expect all properties that TetrahedralMesh.h promises. The complex's points are equal bit for
 * bit; exact positive volumes sum exactly to the convex hull's; neighbors agree; the hull is
 * closed. Facets lie on faces of the right side, and each constraint that is not lost is a union of
 * faces.
 */
void ExpectMeshLaws(const insideout::FacetComplex& surface, const insideout::TetrahedralMesh& mesh);
} // namespace testmeshes
