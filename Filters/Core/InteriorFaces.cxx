// SPDX-License-Identifier: GPL-3.0-or-later
#include "InteriorFaces.h"

#include <Eigen/Geometry>

namespace insideout
{
namespace
{
double TriangleArea(const Point& a, const Point& b, const Point& c)
{
  const Eigen::Map<const Eigen::Vector3d> p(a.data());
  const Eigen::Map<const Eigen::Vector3d> q(b.data());
  const Eigen::Map<const Eigen::Vector3d> r(c.data());
  // stableNorm, for the square of a small surface's area underflows
  return 0.5 * (q - p).cross(r - p).stableNorm();
}
} // namespace

std::vector<InteriorFace> InteriorFaces(const TetrahedralMesh& mesh)
{
  std::vector<InteriorFace> faces;
  faces.reserve(2 * mesh.Cells.size());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    const Tetrahedron& corners = mesh.Cells[cell];
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[cell][k];
      if (neighbor > cell)
      {
        const auto& face = TetrahedronFaces[k];
        faces.push_back({ cell, neighbor,
          TriangleArea(mesh.Points[corners[face[0]]], mesh.Points[corners[face[1]]],
            mesh.Points[corners[face[2]]]) });
      }
    }
  }
  return faces;
}
} // namespace insideout
