// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HullMesh.h"

#include <string>

namespace insideout
{
/**
 * A message why no cell is inside: the range of w, the likely cause, and the option to set. The
 * surface may be two-sided, not participating, inside out, facing both ways, or too open; or Gamma
 * is too large.
 */
std::string NothingInside(const HullMesh& hull);
} // namespace insideout
