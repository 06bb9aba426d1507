// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Work of several processes (ranks) together: if it fails on one it fails on all, because the
 * others would wait for ever.
 */
#pragma once

#include "Data/VtkClasses.h"

#include <functional>
#include <string>

namespace vtkInsideOut
{
/** The ranks with a true value, as words: "0, 2". All ranks have to call it. */
std::string RanksThat(bool say, vtkMultiProcessController* controller);

/**
 * Do something that may throw, on each rank. All ranks have to call it. Without a controller it is
 * simply done.
 *
 * @throws its exception, if it throws here; else, if it throws on another rank, insideout::Error of
 * the same code, naming the rank
 */
void DoTogether(vtkMultiProcessController* controller, const std::function<void()>& work);
} // namespace vtkInsideOut
