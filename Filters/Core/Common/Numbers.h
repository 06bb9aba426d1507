// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/GmpMemory.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

/** Numbers that tell more than a double does; a cheap one more is in DoubleDouble.h. */
namespace insideout
{
/** A whole number times a power of two: sums, differences and products of doubles, exactly. */
using DyadicNumber = CGAL::Mpzf;

/** Bounds of a number. They hold only while an IntervalRounding lives. */
using Interval = CGAL::Interval_nt<false>;
using IntervalRounding = CGAL::Protect_FPU_rounding<true>;
} // namespace insideout
