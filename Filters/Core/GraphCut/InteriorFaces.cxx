// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/InteriorFaces.h"

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

/** The points below 1: only ratios count, and products of very large or small coordinates leave the
 * range. */
std::vector<Eigen::Vector3d> ScaledPoints(const TetrahedralMesh& mesh)
{
  const int exponent = -LargestExponent(mesh.Points);
  std::vector<Eigen::Vector3d> points(mesh.Points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      points[i][axis] = std::ldexp(mesh.Points[i][axis], exponent);
    }
  }
  return points;
}

/** Also where the squares of the edges leave the range. */
double AreaOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d cross = (b - a).cross(c - a);
  const double largest = cross.cwiseAbs().maxCoeff();
  return largest > 0 ? 0.5 * largest * (cross / largest).norm() : 0;
}
} // namespace

std::vector<InteriorFace> InteriorFaces(const TetrahedralMesh& mesh)
{
  const std::vector<Eigen::Vector3d> points = ScaledPoints(mesh);
  std::vector<InteriorFace> faces;
  std::vector<Triangle> corners;
  faces.reserve(2 * mesh.Cells.size());
  corners.reserve(2 * mesh.Cells.size());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    const Tetrahedron& t = mesh.Cells[cell];
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[cell][k] > cell)
      {
        const std::array<int, 3>& face = TetrahedronFaces[k];
        faces.push_back({ cell, mesh.Neighbors[cell][k], 0 });
        corners.push_back({ t[face[0]], t[face[1]], t[face[2]] });
      }
    }
  }
#pragma omp parallel for schedule(static)
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    faces[f].Area = AreaOf(points[corners[f][0]], points[corners[f][1]], points[corners[f][2]]);
  }
  return faces;
}

std::vector<double> CellVolumes(const TetrahedralMesh& mesh)
{
  const std::vector<Eigen::Vector3d> points = ScaledPoints(mesh);
  std::vector<double> volumes(mesh.Cells.size());
#pragma omp parallel for schedule(static)
  for (std::size_t c = 0; c < volumes.size(); ++c)
  {
    const Tetrahedron& t = mesh.Cells[c];
    const Eigen::Vector3d& apex = points[t[0]];
    const double product =
      (points[t[1]] - apex).cross(points[t[2]] - apex).dot(points[t[3]] - apex);
    volumes[c] = std::abs(product) / 6; // a sliver's may round below 0
  }
  return volumes;
}
} // namespace insideout
