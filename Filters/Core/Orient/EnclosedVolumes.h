// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/Membranes.h"

namespace insideout
{
/** What shells enclose, holes capped. */
struct EnclosedVolumes
{
  Id ClosedShells = 0;
  Id HoledShells = 0;
  Id SheetShells = 0; ///< which enclose nothing and are no membranes
  Id Cavities = 0;    ///< shells that are no sheet and face inward
  double Solid = 0;   ///< where w is at least 1
  double Overlap = 0; ///< where w is at least 2
};

/**
 * The volumes that shells enclose together. Where they neither overlap nor lie the wrong way round
 * the sum is right to rounding; what overlap changes is as good as the samples.
 *
 * @param[in] turned one per shell
 * @param[in] roles one per shell: those that do not count enclose nothing
 * @param[in] regions of the shells before they are turned
 */
EnclosedVolumes MeasureShells(const std::vector<ShellChain>& chains,
  const std::vector<char>& turned, const std::vector<ShellRole>& roles,
  const std::vector<ShellRegion>& regions);
} // namespace insideout
