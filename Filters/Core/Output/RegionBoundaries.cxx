// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/RegionBoundaries.h"

namespace insideout
{
RegionBoundaries FindRegionBoundaries(const TetrahedralMesh& mesh, const SolidRegions& regions,
  Monitor& monitor, const ProgressRange& progress)
{
  std::vector<unsigned char> inside;
  for (const Id region : regions.OfCell)
  {
    inside.push_back(region != None);
  }
  RegionBoundaries result;
  result.Faces =
    BoundaryFaces(mesh, inside, monitor, { progress.Stage, progress.Begin, progress.At(0.5) });
  for (const BoundaryFace& face : result.Faces)
  {
    result.Regions.push_back({ { regions.OfCell[face.Cell], None } });
  }
  const LoopProgress cells(
    monitor, { progress.Stage, progress.At(0.5), progress.End }, mesh.Cells.size());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    cells.Check(static_cast<std::size_t>(cell));
    const Id region = regions.OfCell[cell];
    for (int k = 0; region != None && k < 4; ++k)
    {
      const Id beyond = mesh.Neighbors[cell][k];
      if (beyond != None && region < regions.OfCell[beyond])
      {
        result.Faces.push_back({ FaceOf(mesh.Cells[cell], k), cell, k, mesh.Facets[cell][k] });
        result.Regions.push_back({ { region, regions.OfCell[beyond] } });
      }
    }
  }
  return result;
}
} // namespace insideout
