// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/EnclosedVolumes.h"

#include <algorithm>

namespace insideout
{
EnclosedVolumes MeasureShells(const std::vector<ShellChain>& chains,
  const std::vector<char>& turned, const std::vector<ShellRole>& roles,
  const std::vector<ShellRegion>& regions)
{
  EnclosedVolumes volumes;
  for (std::size_t shell = 0; shell < chains.size(); ++shell)
  {
    const ShellChain& chain = chains[shell];
    volumes.SheetShells += roles[shell] == ShellRole::Sheet;
    if (roles[shell] != ShellRole::Counts)
    {
      continue;
    }
    volumes.ClosedShells += chain.Kind == ShellKind::Closed;
    volumes.HoledShells += chain.Kind == ShellKind::Holed;
    volumes.SheetShells += chain.Kind == ShellKind::Sheet;
    if (chain.Kind != ShellKind::Sheet)
    {
      const double volume = turned[shell] ? -chain.Volume : chain.Volume;
      volumes.Cavities += volume < 0;
      volumes.Solid += volume; // the integral of w in the end
    }
  }
  for (const ShellRegion& region : regions)
  {
    int w = 0;
    for (const ShellWinding& winding : region.Windings)
    {
      const int turn = turned[winding.Shell] ? -1 : 1;
      w += roles[winding.Shell] == ShellRole::Counts ? turn * winding.W : 0;
    }
    volumes.Solid += (std::clamp(w, 0, 1) - w) * region.Volume;
    volumes.Overlap += w > 1 ? region.Volume : 0;
  }
  volumes.Solid = std::max(volumes.Solid, 0.0);
  return volumes;
}
} // namespace insideout
