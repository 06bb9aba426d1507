// SPDX-License-Identifier: GPL-3.0-or-later
#include "InteriorFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** The power of two that no coordinate exceeds. */
int LargestExponent(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& p : points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return largest > 0 ? std::ilogb(largest) + 1 : 0;
}

Eigen::Vector3d Scaled(const Point& p, int exponent)
{
  return { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
}
} // namespace

std::vector<InteriorFace> InteriorFaces(const TetrahedralMesh& mesh)
{
  // Only ratios of areas count, and products of very large or small coordinates leave the range.
  const int exponent = -LargestExponent(mesh.Points);
  std::vector<InteriorFace> faces;
  faces.reserve(2 * mesh.Cells.size());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[cell][k];
      if (neighbor > cell)
      {
        const auto corner = [&](int i)
        { return Scaled(mesh.Points[mesh.Cells[cell][TetrahedronFaces[k][i]]], exponent); };
        const Eigen::Vector3d origin = corner(0);
        const double area = 0.5 * (corner(1) - origin).cross(corner(2) - origin).stableNorm();
        faces.push_back({ cell, neighbor, area });
      }
    }
  }
  return faces;
}
} // namespace insideout
