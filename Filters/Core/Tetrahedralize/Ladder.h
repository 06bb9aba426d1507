// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Tetrahedralize/TetrahedralizerBudget.h"

#include <vector>

namespace insideout
{
/** The name of a rung, counted from 1, for users; nullptr if there is none. */
const char* RungName(int rung);

/** The numbers of an engine's rungs, in the order in which they are tried. */
std::vector<int> RungsOf(TetrahedralizationEngine engine);

/**
 * Tetrahedralize by one rung, and check the result (AssembleMesh).
 *
 * @param[in] surface as for ConstrainedDelaunay
 * @throws Error TetrahedralizerDied, TetrahedralizerFailed, Inconsistent or TooLarge if another
 * rung may succeed; Stopped
 */
TetrahedralMesh TryRung(
  int rung, const FacetComplex& surface, const TetrahedralizerBudget& budget, Monitor& monitor);
} // namespace insideout
