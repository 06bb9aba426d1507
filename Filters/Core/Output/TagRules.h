// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <functional>
#include <string>
#include <vector>

namespace insideout
{
/** One condition on a triangle of a boundary. */
struct TagCondition
{
  enum class Kind
  {
    Normal,  ///< direction, degrees: the normal points there
    Box,     ///< two corners: the center is in the box
    Sphere,  ///< center, radius: the center is in the ball
    Plane,   ///< point, normal, distance: all corners lie in the plane
    Face,    ///< point, degrees: of the face next to the point, which edges of a larger angle bound
    Faces,   ///< degrees: of any such face; each has a number
    Nearest, ///< point: no other point of such a condition is nearer to the center
    Array    ///< the name of an array, in which it is not 0
  };
  Kind What;
  std::vector<double> Numbers;
  std::string Name;
};

/** A name for the triangles for which all conditions hold. */
struct TagRule
{
  std::string Name;
  std::string Text; ///< as it was given
  std::vector<TagCondition> Conditions;
};

/**
 * Read "inlet=normal -1 0 0 & box 0 0 0 1 1 1; top=plane 0 0 2 0 0 1". Numbers are separated by
 * blanks or commas.
 *
 * @throws Error InvalidParameter that names the rule
 */
std::vector<TagRule> ReadTagRules(const std::string& text);

/** The triangles of a closed surface, oriented outward. */
struct TaggedSurface
{
  std::vector<Point> Points;
  std::vector<Triangle> Triangles;
  std::vector<Id> Sources; ///< per triangle the facet that it is a piece of, None for none

  /** Whether an array is not 0 at a triangle. */
  std::function<bool(const std::string& array, Id triangle)> IsIn;
};

/** The rule that a triangle takes its name from, and its number among the rule's faces. */
struct TagMatch
{
  Id Rule = None;
  Id Face = None; ///< from 0 on, in the order of their first triangles; None: no number
};

/** For each triangle the last rule that it satisfies. */
std::vector<TagMatch> MatchTagRules(
  const std::vector<TagRule>& rules, const TaggedSurface& surface);
} // namespace insideout
