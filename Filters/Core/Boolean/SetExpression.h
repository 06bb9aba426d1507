// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <string>
#include <vector>

namespace insideout
{
/** A set expression of several bodies. */
enum class SetOperation
{
  Union,              ///< points in at least one body
  Intersection,       ///< points in all bodies
  Difference,         ///< points in the first and in no other
  SymmetricDifference ///< points in an odd number of bodies
};

/**
 * A set expression, such as `A - (B | C) ^ D`: it decides from the bodies that contain a point
 * whether the point is in the result.
 *
 * Operators are `|` or `+` (union), `&` (intersection), `-` (difference) and `^` (symmetric
 * difference). Their precedence is that of Python and C++: `+` and `-`, then `&`, then `^`, then
 * `|`; equal ones from left to right. Parentheses override it.
 *
 * A body is called by its name, by its number (#1 for the first), or by a letter (A for the first
 * of 26) unless a body has that name. A name stands in quotes ('left lung' or "left lung") if it
 * begins with a digit or has other characters than letters, digits and underscores.
 */
class SetExpression
{
public:
  /**
   * @param[in] names of the bodies
   * @throws Error InvalidParameter naming the column of the mistake, counted from 1
   */
  SetExpression(const std::string& text, const std::vector<std::string>& names);

  /** The same operation on a number of bodies. */
  SetExpression(SetOperation operation, Id numberOfBodies);

  /** The bodies that the expression names, ascending. The result depends on no other body. */
  const std::vector<Id>& Bodies() const { return this->Named; }

  /** @param[in] isIn one per body of Bodies(): not 0 if the point is in it */
  bool Holds(const std::vector<char>& isIn) const;

private:
  friend class SetExpressionParser;
  void NumberBodies();

  /** A body, or the operation on the last two results. */
  struct Step
  {
    Id Body; ///< index into Named; None for an operation
    SetOperation Operation;
  };
  std::vector<Step> Steps; ///< in reverse Polish notation
  std::vector<Id> Named;
};
} // namespace insideout
