// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Regions.h"

#include "Common/LoopProgress.h"
#include "Output/InsideBoundary.h"

namespace insideout
{
SolidRegions FindRegions(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  CheckLabels(mesh, inside);
  const LoopProgress visits(monitor, progress, mesh.Cells.size());
  SolidRegions regions;
  regions.OfCell.assign(mesh.Cells.size(), None);
  std::vector<Id> reached; // cells whose neighbours are still to be looked at
  std::size_t visited = 0;
  const auto reach = [&](Id cell)
  {
    if (cell != None && inside[cell] != 0 && regions.OfCell[cell] == None)
    {
      regions.OfCell[cell] = regions.Count;
      reached.push_back(cell);
    }
  };
  for (Id first = 0; first < mesh.NumberOfCells(); ++first)
  {
    reach(first);
    const bool isNew = !reached.empty();
    while (!reached.empty())
    {
      visits.Check(visited++);
      const Id cell = reached.back();
      reached.pop_back();
      for (const Id neighbor : mesh.Neighbors[cell])
      {
        reach(neighbor);
      }
    }
    regions.Count += isNew;
  }
  return regions;
}
} // namespace insideout
