// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace insideout
{
/**
 * From now on GMP, with which exact numbers are made, throws std::bad_alloc where it gets no
 * memory. By itself it ends the program. Where somebody has given GMP functions of their own for
 * memory, nothing changes.
 *
 * @return whether GMP throws
 */
bool ThrowWhereGmpGetsNoMemory();

/** Whoever includes this, above all by way of exact numbers, may count on it. */
inline const bool GmpThrows = ThrowWhereGmpGetsNoMemory();
} // namespace insideout
