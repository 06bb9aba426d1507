// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace insideout
{
/** Begin to bring what is at an address into the cache: for reads that jump about in memory. */
inline void Prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}
} // namespace insideout
