// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HullMesh.h"

#include <string>

namespace insideout
{
/**
 * Why no cell is inside, in a line for a user: the range of w, the likely cause (the surface is
 * two-sided, does not participate, is inside out, faces both ways, is too open, or Gamma is too
 * large), and what to set.
 */
std::string NothingInside(const HullMesh& hull);
} // namespace insideout
