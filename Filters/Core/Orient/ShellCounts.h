// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/Membranes.h"

namespace insideout
{
/** How many shells of each kind there are. Membranes are none of these. */
struct ShellCounts
{
  Id Closed = 0;
  Id Holed = 0;
  Id Sheets = 0;   ///< which enclose nothing
  Id Cavities = 0; ///< shells that are no sheet and face inward
};

/**
 * @param[in] turned one per shell
 * @param[in] roles one per shell: those that do not count are left out
 */
ShellCounts CountShells(const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const std::vector<ShellRole>& roles);
} // namespace insideout
