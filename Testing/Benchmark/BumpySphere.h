// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace benchmark
{
/** A sphere with bumps, of about so many triangles, turned and moved: closed and without crossings.
 */
insideout::TriangleSoup BumpySphere(int triangles, double angle, double offset);
} // namespace benchmark
