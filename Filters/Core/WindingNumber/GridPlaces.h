// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <functional>
#include <vector>

namespace insideout
{
/**
 * The points of an image or of a rectilinear grid: one for each x, y and z of three lists. Those of
 * one z are a slice, those of one y and z a row; x runs fastest, then y.
 */
struct GridPlaces
{
  std::array<std::vector<double>, 3> Axes; ///< at least one place in each

  Id Size(int axis) const { return static_cast<Id>(this->Axes[axis].size()); }
  std::size_t SizeOfSlice() const { return this->Axes[0].size() * this->Axes[1].size(); }

  /** A grid point by its number in a slice. */
  Point InSlice(Id slice, std::size_t place) const
  {
    return { this->Axes[0][place % this->Axes[0].size()],
      this->Axes[1][place / this->Axes[0].size()], this->Axes[2][slice] };
  }
};

/** Receives the winding numbers of a slice, one per place; called concurrently, in any order. */
using SliceVisitor = std::function<void(Id slice, const std::vector<double>& w)>;
} // namespace insideout
