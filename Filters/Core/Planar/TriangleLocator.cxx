// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/TriangleLocator.h"

namespace insideout
{
namespace
{
std::vector<Box> BoxesOf(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh)
{
  std::vector<Box> boxes;
  boxes.reserve(mesh.Cells.size());
  for (const Triangle& cell : mesh.Cells)
  {
    Box box = Box::Empty();
    for (const Id p : cell)
    {
      box.Add(Point{ { points[p][0], points[p][1], 0 } });
    }
    boxes.push_back(box);
  }
  return boxes;
}
} // namespace

TriangleLocator::TriangleLocator(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh)
  : Points(points)
  , Mesh(mesh)
  , Tree(BoxesOf(points, mesh))
{
}

bool TriangleLocator::Contains(Id cell, const PlanarPoint& place) const
{
  const auto& [a, b, c] = this->Mesh.Cells[cell];
  return Orient2D(this->Points[a], this->Points[b], place) >= 0 &&
    Orient2D(this->Points[b], this->Points[c], place) >= 0 &&
    Orient2D(this->Points[c], this->Points[a], place) >= 0;
}
} // namespace insideout
