// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/InteriorFaces.h"

#include "Common/ParallelLoop.h"
#include "Common/ScaledPoints.h"

#include <Eigen/Geometry>

#include <cmath>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerElement = 10; // per face or cell, its corners in both numberings

/** The points scaled below 1: only ratios count, and products of very large or small coordinates
 * overflow or underflow. */
std::vector<Point> PointsBelowOne(const TetrahedralMesh& mesh)
{
  return ScaledPoints(mesh.Points, -LargestExponent(mesh.Points));
}

Eigen::Vector3d Edge(const Point& from, const Point& to)
{
  return { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
}

/** Safe also if the squares of the edges overflow or underflow. */
double AreaOf(const Point& a, const Point& b, const Point& c)
{
  const Eigen::Vector3d cross = Edge(a, b).cross(Edge(a, c));
  const double largest = cross.cwiseAbs().maxCoeff();
  return largest > 0 ? 0.5 * largest * (cross / largest).norm() : 0;
}
} // namespace

std::vector<InteriorFace> InteriorFaces(const TetrahedralMesh& mesh)
{
  const std::vector<Point> points = PointsBelowOne(mesh);
  const auto isFirst = [&mesh](Id cell, int k) { return mesh.Neighbors[cell][k] > cell; };
  std::vector<std::size_t> begin(mesh.Cells.size() + 1, 0); // of the faces that a cell is first at
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    begin[cell + 1] = begin[cell];
    for (int k = 0; k < 4; ++k)
    {
      begin[cell + 1] += isFirst(cell, k);
    }
  }
  std::vector<InteriorFace> faces(begin.back());
  ParallelLoop(mesh.NumberOfCells(), 2 * NanosecondsPerElement,
    [&](Id cell)
    {
      InteriorFace* face = faces.data() + begin[cell];
      for (int k = 0; k < 4; ++k)
      {
        if (isFirst(cell, k))
        {
          const Triangle t = FaceOf(mesh.Cells[cell], k);
          *face++ = { cell, mesh.Neighbors[cell][k],
            AreaOf(points[t[0]], points[t[1]], points[t[2]]) };
        }
      }
    });
  return faces;
}

std::vector<double> CellVolumes(const TetrahedralMesh& mesh)
{
  const std::vector<Point> points = PointsBelowOne(mesh);
  std::vector<double> volumes(mesh.Cells.size());
  ParallelLoop(volumes.size(), NanosecondsPerElement,
    [&](std::size_t c)
    {
      const Tetrahedron& t = mesh.Cells[c];
      const Point& apex = points[t[0]];
      const double product =
        Edge(apex, points[t[1]]).cross(Edge(apex, points[t[2]])).dot(Edge(apex, points[t[3]]));
      volumes[c] = std::abs(product) / 6; // a sliver's may round below 0
    });
  return volumes;
}
} // namespace insideout
