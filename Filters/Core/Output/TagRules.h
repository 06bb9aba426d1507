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
    Normal, ///< direction, degrees: the normal points there
    Box,    ///< two corners: the center is in the box
    Sphere, ///< center, radius: the center is in the ball
    Plane,  ///< point, normal, distance: all corners lie in the plane
    Face,  ///< point, degrees: on the face nearest to the point, bounded by edges of a larger angle
    Faces, ///< degrees: on any such face; faces are numbered
    Nearest, ///< point: no point of another such condition is nearer to the center
    Array    ///< the name of an array that is not 0 at the triangle
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

/** The rule that names a triangle, and the number of its face among the rule's faces. */
struct TagMatch
{
  Id Rule = None;
  Id Face = None; ///< from 0 on, in the order of their first triangles; None: no number
};

/** For each triangle the last rule that it satisfies. */
std::vector<TagMatch> MatchTagRules(
  const std::vector<TagRule>& rules, const TaggedSurface& surface);
} // namespace insideout
