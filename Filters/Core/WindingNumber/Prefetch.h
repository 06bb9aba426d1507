// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace insideout
{
/** Prefetch an address into the cache, for scattered reads. */
inline void Prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}
} // namespace insideout
