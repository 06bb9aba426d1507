// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * What several processes (ranks) do together: where it fails on one it fails on all, for the others
 * would wait for that one for ever.
 */
#pragma once

#include <functional>
#include <string>

class vtkMultiProcessController;

namespace vtkInsideOut
{
/** The ranks that say so, as words: "0, 2". All ranks have to call it. */
std::string RanksThat(bool say, vtkMultiProcessController* controller);

/**
 * Do what may throw, on each rank. All ranks have to call it. Without a controller it is just done.
 *
 * @throws whatever it throws here; else, where it throws on another rank, insideout::Error of the
 * same code, which says on which
 */
void DoTogether(vtkMultiProcessController* controller, const std::function<void()>& work);
} // namespace vtkInsideOut
