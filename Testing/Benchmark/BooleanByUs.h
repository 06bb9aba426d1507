// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/SetExpression.h"
#include "Common/FacetComplex.h"

namespace benchmark
{
/** What a set operation of two surfaces made. */
struct Made
{
  double Seconds;              ///< of the operation alone
  std::size_t Facets;          ///< of the result; 0 where it could not be made
  double Volume = 0;           ///< that the result encloses, where it is asked for
  double ProcessorSeconds = 0; ///< the same of all threads
};

/** From triangles as they come, without tetrahedra. Nothing is made of what is open. */
Made BooleanByUs(const insideout::TriangleSoup& a, const insideout::TriangleSoup& b,
  insideout::SetOperation operation);
} // namespace benchmark
