// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/LayerHeights.h"

#include "Common/Vectors.h"
#include "Refine/FacetAhead.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace insideout
{
namespace
{
/** Shares from here on count as full height. */
constexpr double FullShare = 0.999;

/** Least share of a wall edge behind the layers. */
constexpr double LeastShareOfEdge = 0.25;

/** The cell around a point that its direction leads into; None if rounding obscures it. */
Id CellAhead(
  const RefinableMesh& mesh, Id point, const std::vector<Id>& star, const Point& direction)
{
  const Point& from = mesh.Points[point];
  Id ahead = None;
  double best = 0;
  for (const Id cell : star)
  {
    const Triangle face = mesh.FaceCorners(cell, mesh.CornerIndex(cell, point));
    const auto corners = CornersOf(mesh.Points, face);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
    {
      const Point u = Difference(corners[k], from);
      const Point v = Difference(corners[(k + 1) % 3], from);
      const Point normal = Cross(v, u);
      const double length = Length(normal);
      least = std::min(least, length > 0 ? Dot(normal, direction) / length : -1.0);
    }
    if (ahead == None || least > best)
    {
      ahead = cell;
      best = least;
    }
  }
  return ahead;
}

/** The distance along a direction to a facet; any value above `enough` if it is larger. */
double WayToFacet(const RefinableMesh& mesh, Id point, const std::vector<Id>& star,
  const Point& direction, double enough)
{
  const Id cell = CellAhead(mesh, point, star, direction);
  const int exit = cell == None ? -1 : mesh.CornerIndex(cell, point);
  return FindFacetAhead(mesh, { mesh.Points[point], cell, -1, exit }, direction, enough).Way;
}

/** Lower heights that would make edges of the wall too short, or reverse them. */
void KeepEdges(const std::vector<Point>& points, const WallPoints& wall,
  const std::vector<WallDirection>& directions, std::vector<double>& heights)
{
  for (const Id p : wall.Points)
  {
    for (const Id q : wall.NeighborsOf[p])
    {
      const Point edge = Difference(points[q], points[p]);
      const double squared = Dot(edge, edge);
      const double loss =
        heights[p] * directions[p].WayAlong(edge) - heights[q] * directions[q].WayAlong(edge);
      const double most = (1 - LeastShareOfEdge) * squared;
      if (p < q && loss > most)
      {
        heights[p] *= most / loss;
        heights[q] *= most / loss;
      }
    }
  }
}

} // namespace

void GradeHeights(
  const std::vector<Point>& points, const WallPoints& wall, std::vector<double>& heights)
{
  using Entry = std::pair<double, Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Id p : wall.Points)
  {
    queue.push({ heights[p], p });
  }
  while (!queue.empty())
  {
    const auto [height, p] = queue.top();
    queue.pop();
    if (height > heights[p])
    {
      continue;
    }
    for (const Id q : wall.NeighborsOf[p])
    {
      const double most = height + GradingOfHeights * Distance(points[p], points[q]);
      if (heights[q] > most)
      {
        heights[q] = most;
        queue.push({ most, q });
      }
    }
  }
}

std::vector<double> WaysToFacets(const RefinableMesh& mesh, const WallPoints& wall,
  const std::vector<WallDirection>& directions, double height)
{
  std::vector<double> ways(mesh.Points.size(), 0);
  std::vector<Id> star;
  for (const Id p : wall.Points)
  {
    if (directions[p].Cosine > 0)
    {
      star.clear();
      mesh.Star(p, star);
      ways[p] = WayToFacet(mesh, p, star, directions[p].Inward, directions[p].EnoughWay(height));
    }
  }
  return ways;
}

std::vector<double> LimitHeights(const std::vector<Point>& points, const WallPoints& wall,
  const std::vector<WallDirection>& directions, const std::vector<double>& ways, double height,
  Id& narrow)
{
  std::vector<double> heights(points.size(), 0);
  for (const Id p : wall.Points)
  {
    if (directions[p].Cosine > 0)
    {
      heights[p] = std::min(height, directions[p].HeightBefore(ways[p]));
      narrow += heights[p] < height ? 1 : 0;
    }
  }
  KeepEdges(points, wall, directions, heights);
  GradeHeights(points, wall, heights);
  return heights;
}

std::vector<double> SharesOfHeight(const WallPoints& wall,
  const std::vector<WallDirection>& directions, const std::vector<double>& heights, double height)
{
  std::vector<double> shares(heights.size(), 0);
  for (const Id p : wall.Points)
  {
    shares[p] =
      std::min(1.0, heights[p] * directions[p].LengthPerHeight() * directions[p].Cosine / height);
    shares[p] = shares[p] >= FullShare ? 1 : shares[p];
  }
  return shares;
}
} // namespace insideout
