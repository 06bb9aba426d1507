// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace insideout
{
/** Allocates as std::allocator does, but leaves new values of plain types undefined. */
template <class Value>
struct RawAllocator : std::allocator<Value>
{
  template <class Other>
  struct rebind
  {
    using other = RawAllocator<Other>;
  };

  template <class Other>
  void construct(Other* place)
  {
    ::new (static_cast<void*>(place)) Other;
  }

  template <class Other, class... Arguments>
  void construct(Other* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
  }
};

/** A vector to be resized and then filled by several threads: nothing is written before. */
template <class Value>
using RawVector = std::vector<Value, RawAllocator<Value>>;
} // namespace insideout
