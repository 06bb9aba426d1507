// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/Membranes.h"

namespace insideout
{
/** The number of shells of each kind, without membranes. */
struct ShellCounts
{
  Id Closed = 0;
  Id Holed = 0;
  Id Sheets = 0;   ///< which enclose nothing
  Id Cavities = 0; ///< closed or holed shells that face inward
};

/**
 * Count shells by kind.
 *
 * @param[in] turned one per shell
 * @param[in] roles one per shell: membranes are left out; ShellRole::Sheet counts as a sheet
 */
ShellCounts CountShells(const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const std::vector<ShellRole>& roles);
} // namespace insideout
