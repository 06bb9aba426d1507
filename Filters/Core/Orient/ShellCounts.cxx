// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/ShellCounts.h"

namespace insideout
{
ShellCounts CountShells(const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const std::vector<ShellRole>& roles)
{
  ShellCounts counts;
  for (std::size_t shell = 0; shell < chains.size(); ++shell)
  {
    const ShellChain& chain = chains[shell];
    counts.Sheets += roles[shell] == ShellRole::Sheet;
    if (roles[shell] == ShellRole::Counts)
    {
      counts.Closed += chain.Kind == ShellKind::Closed;
      counts.Holed += chain.Kind == ShellKind::Holed;
      counts.Sheets += chain.Kind == ShellKind::Sheet;
      const double volume = turned[shell] ? -chain.Volume : chain.Volume;
      counts.Cavities += chain.Kind != ShellKind::Sheet && volume < 0;
    }
  }
  return counts;
}
} // namespace insideout
