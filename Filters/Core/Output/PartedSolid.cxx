// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/PartedSolid.h"

#include "Output/InsideBoundary.h"
#include "Output/PartCells.h"

#include <numeric>

namespace insideout
{
PartedSolid UnpartedSolid(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  CheckLabels(mesh, inside);
  PartedSolid solid = { mesh, inside, std::vector<Id>(mesh.Points.size()),
    std::vector<Id>(mesh.Cells.size()) };
  std::iota(solid.Places.begin(), solid.Places.end(), 0);
  std::iota(solid.Originals.begin(), solid.Originals.end(), 0);
  return solid;
}

void PartPoints(PartedSolid& solid, const std::vector<unsigned char>& parted, Monitor& monitor,
  const ProgressRange& progress)
{
  TetrahedralMesh& mesh = solid.Mesh;
  PartedCells<4> cells =
    PartCells(mesh.Cells, mesh.Neighbors, solid.Inside, parted, monitor, progress);
  mesh.Cells = std::move(cells.Cells);
  for (std::size_t p = mesh.Points.size(); p < cells.Places.size(); ++p)
  {
    const Id place = cells.Places[p];
    mesh.Points.push_back(Point(mesh.Points[place]));
    if (!mesh.Origins.empty())
    {
      mesh.Origins.push_back(PointOrigin(mesh.Origins[place]));
    }
    solid.Places.push_back(Id(solid.Places[place]));
  }
}
} // namespace insideout
