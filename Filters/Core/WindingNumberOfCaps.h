// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BoundaryProduct.h"
#include "ParallelLoop.h"
#include "SolidAngleTiles.h"

namespace insideout
{
/**
 * The winding number of a chain of triangles that is small against the region where it is wanted:
 * the caps that close the holes of a surface.
 *
 * The chain is given in parts, its caps. A site that is so far from some caps that their winding
 * numbers together are below 1/2 by their areas gets these from the boundaries alone
 * (BoundaryProduct.h), which say it modulo 1. The other caps are summed, triangle by triangle, with
 * exact decisions on which side of a triangle the site lies (SolidAngleProduct.h). Either way the
 * value is right to rounding and never off by one.
 */
class WindingNumberOfCaps
{
public:
  /**
   * @param[in] points of the caps, below 1 in each coordinate; has to live as long as this object
   * @param[in] caps each a chain of triangles that are not degenerate; connected ones serve best
   */
  WindingNumberOfCaps(
    const std::vector<Point>& points, const std::vector<std::vector<CountedTriangle>>& caps);

  /**
   * Add the winding number at site order[i] to w[order[i]], for all i, on all threads. Fastest
   * where neighbours in `order` are neighbours in space; the values do not depend on the number of
   * threads.
   *
   * @param[in] sites below 2^100 in each coordinate
   * @throws Error (Stopped)
   */
  void Add(const Sites& sites, const std::vector<Id>& order, std::vector<double>& w,
    Monitor& monitor, const ProgressRange& progress) const;

  /** The winding number at one point. Safe to call from several threads. */
  double At(const Point& point) const;

  bool IsEmpty() const { return this->Caps.empty(); }

  struct Ball
  {
    Point Centre;
    double Radius;
  };

private:
  struct Cap
  {
    Ball Around;
    double Area; ///< counted as often as the triangles
    TileRange Triangles;
    TileRange Edges;
  };
  struct EdgeTile
  {
    std::size_t FirstPoint, LastPoint;
    std::size_t FirstEdge, LastEdge;
  };

  void SetBall(const std::vector<CountedTriangle>& triangles, Cap& cap) const;
  TileRange AddEdges(const std::vector<CountedTriangle>& triangles);
  void AddLoop(const Loop& loop, EdgeTile& tile);
  void CloseTile(EdgeTile& tile);
  double FindLargestFar(const Ball& sites, std::vector<double>& bounds) const;
  void AddBlock(const Sites& sites, const std::vector<Id>& order, std::size_t first,
    std::vector<double>& bounds, std::vector<double>& w) const;

  const std::vector<Point>& Points;
  SolidAngleTiles Triangles;
  std::vector<Cap> Caps;
  std::vector<EdgeTile> EdgeTiles;
  std::vector<Point> EdgePoints; // of tile after tile
  std::vector<TileEdge> Edges;
};
} // namespace insideout
