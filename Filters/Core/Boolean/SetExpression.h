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
 * A set expression, such as `A - (B | C) ^ D`: whether a point is in the result, from the bodies
 * that it is in.
 *
 * Operators are `|` or `+` (union), `&` (intersection), `-` (difference) and `^` (symmetric
 * difference), with the precedence that they have in Python and C++: `+` and `-` first, then `&`,
 * then `^`, then `|`; of equal ones the left first. Parentheses go before all. A body is called by
 * its name, in quotes ('left lung' or "left lung") where that is more than letters, digits and
 * underscores, or begins with a digit; by its number, #1 for the first; or by a letter, A for the
 * first of 26, where no body has that name.
 */
class SetExpression
{
public:
  /**
   * @param[in] names of the bodies
   * @throws Error InvalidParameter that names the column of the mistake, counted from 1
   */
  SetExpression(const std::string& text, const std::vector<std::string>& names);

  /** The same operation for a number of bodies. */
  SetExpression(SetOperation operation, Id numberOfBodies);

  /** The bodies that it names, ascending. The result depends on no other body. */
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
