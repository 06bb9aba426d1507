// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/GmpMemory.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

/** Numbers with more precision than a double; a faster one is in DoubleDouble.h. */
namespace insideout
{
/** An integer times a power of two: exact sums, differences and products of doubles. */
using DyadicNumber = CGAL::Mpzf;

/** Interval bounds of a number. They hold only while an IntervalRounding lives. */
using Interval = CGAL::Interval_nt<false>;
using IntervalRounding = CGAL::Protect_FPU_rounding<true>;
} // namespace insideout
