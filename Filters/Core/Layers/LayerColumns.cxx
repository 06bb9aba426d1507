// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/LayerColumns.h"

namespace insideout
{
namespace
{
/** Whether a layer is positive at the corners whose edges have a length. */
bool IsLayerPositive(const std::array<Point, 3>& outer, const std::array<Point, 3>& inner,
  const std::array<bool, 3>& isLifted)
{
  for (int k = 0; k < 3; ++k)
  {
    if (isLifted[k] && OrientPrism(outer, inner, k) <= 0)
    {
      return false;
    }
  }
  return true;
}
} // namespace

bool IsPositive(const LayerColumn& column, const std::vector<double>& fractions)
{
  std::array<bool, 3> isLifted;
  for (int k = 0; k < 3; ++k)
  {
    isLifted[k] = column.Outer[k] != column.Inner[k];
  }
  std::array<Point, 3> below = column.Outer;
  for (std::size_t i = 1; i < fractions.size(); ++i)
  {
    std::array<Point, 3> above;
    for (int k = 0; k < 3; ++k)
    {
      above[k] = PlaceOnBorder(column.Outer[k], column.Inner[k], fractions[i]);
    }
    if (!IsLayerPositive(below, above, isLifted))
    {
      return false;
    }
    below = above;
  }
  return true;
}
} // namespace insideout
