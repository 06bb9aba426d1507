// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <string>
#include <vector>

namespace insideout
{
/** A length asked for in a part of a solid. */
struct SizeRule
{
  enum class Kind
  {
    Curvature, ///< edges per full turn of the surface
    Gap,       ///< cells across a wall, between facets that face each other
    Tag,       ///< length on the facets of a label
    Region,    ///< length within a region
    Point      ///< length at a point, and within the radius around it
  };
  Kind What;
  double Value;
  std::string Name; ///< of the tag or region
  std::string Text; ///< as it was given
  Point Center = { { 0, 0, 0 } };
  double Radius = 0;
  Id Label = None; ///< of the tag, which the caller sets
};

/**
 * Read "curvature=24; gap=3; tag wall=0.5; region bone=1; point 0 0 1 0.2=0.05". Numbers are
 * separated by blanks or commas.
 *
 * @throws Error InvalidParameter that names the rule
 */
std::vector<SizeRule> ReadSizeRules(const std::string& text);
} // namespace insideout
