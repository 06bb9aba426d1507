// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Tetrahedralize/TetrahedralizerBudget.h"

#include <vector>

namespace insideout
{
/** What tetrahedralizes in rung 1, 2 ... as words for a user; nullptr where there is none. */
const char* RungName(int rung);

/** The rungs that an engine has, in the order in which they are tried, counted from 1. */
std::vector<int> RungsOf(TetrahedralizationEngine engine);

/**
 * Tetrahedralize in one way, and check what comes of it (AssembleMesh).
 *
 * @param[in] surface as for ConstrainedDelaunay
 * @throws Error TetrahedralizerDied, TetrahedralizerFailed, Inconsistent or TooLarge where another
 *         rung may do better; Stopped
 */
TetrahedralMesh TryRung(
  int rung, const FacetComplex& surface, const TetrahedralizerBudget& budget, Monitor& monitor);
} // namespace insideout
