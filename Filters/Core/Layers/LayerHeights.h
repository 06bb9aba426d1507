// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Layers/LayerWall.h"
#include "Layers/WallDirections.h"

#include <algorithm>
#include <vector>

namespace insideout
{
/** Limit on the difference of heights of neighbors, per length of their edge. */
constexpr double GradingOfHeights = 1;

/** Per point of the mesh, the way along its direction to the facet ahead: any value above
 * EnoughWay if it is longer. */
std::vector<double> WaysToFacets(const RefinableMesh& mesh, const WallPoints& wall,
  const std::vector<WallDirection>& directions, double height);

/**
 * The largest heights of layers at each point of a wall: the height asked for, but at most a third
 * of the way to the facet ahead. Edges keep a quarter of their length, and neighbors are graded.
 * Counts the points in gaps that are too narrow. One value per point of the mesh, 0 where there is
 * no direction.
 */
std::vector<double> LimitHeights(const std::vector<Point>& points, const WallPoints& wall,
  const std::vector<WallDirection>& directions, const std::vector<double>& ways, double height,
  Id& narrow);

/** Lower heights that differ by more from those of neighbors. */
void GradeHeights(
  const std::vector<Point>& points, const WallPoints& wall, std::vector<double>& heights);

/** The share of the full height that layers have at each point of the mesh; 1 up to rounding. */
std::vector<double> SharesOfHeight(const WallPoints& wall,
  const std::vector<WallDirection>& directions, const std::vector<double>& heights, double height);

/**
 * Append ReducedPoints, BarePoints, FullHeightShare and MeanHeightShare.
 *
 * @param[in] sizes per facet, its area or length
 */
template <std::size_t Corners>
void AppendHeights(const std::vector<double>& shares, const WallPoints& wall,
  const std::vector<std::array<Id, Corners>>& facets, const std::vector<double>& sizes,
  Statistics& statistics)
{
  double all = 0;
  double full = 0;
  double mean = 0;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    bool isFull = true;
    double sum = 0;
    for (const Id p : facets[f])
    {
      isFull = isFull && shares[p] == 1;
      sum += shares[p];
    }
    all += sizes[f];
    full += isFull ? sizes[f] : 0;
    mean += sizes[f] * sum / Corners;
  }
  const auto count = [&](const auto& isCounted)
  {
    return static_cast<double>(std::count_if(
      wall.Points.begin(), wall.Points.end(), [&](Id p) { return isCounted(shares[p]); }));
  };
  statistics.emplace_back("WallPoints", wall.Points.size());
  statistics.emplace_back("ReducedPoints", count([](double x) { return x > 0 && x < 1; }));
  statistics.emplace_back("BarePoints", count([](double x) { return x == 0; }));
  statistics.emplace_back("FullHeightShare", all > 0 ? full / all : 0);
  statistics.emplace_back("MeanHeightShare", all > 0 ? mean / all : 0);
}
} // namespace insideout
