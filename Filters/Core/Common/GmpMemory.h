// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace insideout
{
/**
 * Make GMP, which exact numbers use, throw std::bad_alloc when it gets no memory, instead of ending
 * the program. If someone has set allocation functions of GMP, nothing changes.
 *
 * @return whether GMP throws
 */
bool ThrowWhereGmpGetsNoMemory();

/** Ensures that for every file that includes this header, above all through exact numbers. */
inline const bool GmpThrows = ThrowWhereGmpGetsNoMemory();
} // namespace insideout
