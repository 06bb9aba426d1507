// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace benchmark
{
/** A closed sphere with bumps, without crossings, of about this many triangles, turned and moved.
 */
insideout::TriangleSoup BumpySphere(int triangles, double angle, double offset);
} // namespace benchmark
