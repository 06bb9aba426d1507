// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumbersAtFew.h"

#include "Common/ParallelLoop.h"
#include "WindingNumber/KnownBox.h"

namespace insideout
{
namespace
{
/**
 * Half the width of a bar, relative to the chain's size: few facets of usual surfaces are as small.
 */
constexpr double BarWidth = 0x1p-12;

/** Triangles per task of a thread. */
constexpr std::size_t BlockSize = 4096;

Box BoxAround(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
{
  const std::size_t count = (triangles.size() + BlockSize - 1) / BlockSize;
  std::vector<Box> boxes(count, Box::Empty()); // of blocks
  const double nanosecondsPerTriangle = 5;
  ParallelLoop(count, nanosecondsPerTriangle * BlockSize,
    [&](std::size_t block)
    {
      const std::size_t end = std::min((block + 1) * BlockSize, triangles.size());
      for (std::size_t t = block * BlockSize; t < end; ++t)
      {
        boxes[block].Add(BoundingBox(points, triangles[t].Corners));
      }
    });
  Box all = Box::Empty();
  for (const Box& box : boxes)
  {
    all.Add(box);
  }
  return all;
}

/** A box from the neighborhood of a site to beyond the chain, and a point in it that is beyond. */
struct Bar
{
  Box Bounds;
  Point End;
};

/** The bar that leaves the chain's box by the shortest way. */
Bar BarFrom(const Point& site, const Box& chain)
{
  int axis = 0;
  bool upward = true;
  const auto wayOut = [&](int a, bool up)
  { return up ? chain.High[a] - site[a] : site[a] - chain.Low[a]; };
  for (int a = 0; a < 3; ++a)
  {
    for (const bool up : { true, false })
    {
      if (wayOut(a, up) < wayOut(axis, upward))
      {
        axis = a;
        upward = up;
      }
    }
  }
  const double width = BarWidth * chain.Extent(chain.LongestAxis());
  const Point aside = { 0.3143, 0.4717, 0.5919 }; // off the planes that people draw
  Bar bar = { Box{ site, site }.Widened(width), site };
  for (int a = 0; a < 3; ++a)
  {
    bar.End[a] += aside[a] * width;
  }
  bar.End[axis] = upward ? chain.High[axis] + width : chain.Low[axis] - width;
  bar.Bounds.Add(Box{ bar.End, bar.End }.Widened(width / 4));
  return bar;
}

double CountAlong(const Bar& bar, const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, const Site& site)
{
  const ChainFacets facets(points, triangles);
  std::vector<SidedFacet> sided;
  for (Id f = 0; f < facets.Size(); ++f)
  {
    sided.emplace_back(f, facets.SideOf(f, bar.End));
  }
  return WindingNumberIn({ bar.Bounds, bar.End, 0, sided.data(), sided.data() + sided.size() },
    facets, PreparedSite(site));
}
} // namespace

std::vector<double> WindingNumbersAtFew(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, const Sites& sites, Monitor& monitor,
  const ProgressRange& progress)
{
  const Box box = BoxAround(points, triangles);
  const std::size_t count = sites.Cells.size();
  std::vector<Bar> bars;
  for (std::size_t i = 0; i < count; ++i)
  {
    bars.push_back(BarFrom(sites.Rounded(i).High, box));
  }
  using Met = std::vector<std::vector<CountedTriangle>>; // per bar
  std::vector<Met> met((triangles.size() + BlockSize - 1) / BlockSize, Met(count));
  const double nanoseconds = 10 + 2 * static_cast<double>(count);
  ParallelLoop(met.size(), nanoseconds * BlockSize, monitor, progress,
    [&](std::size_t block)
    {
      const std::size_t end = std::min((block + 1) * BlockSize, triangles.size());
      for (std::size_t t = block * BlockSize; t < end; ++t)
      {
        const Box around = BoundingBox(points, triangles[t].Corners);
        for (std::size_t i = 0; i < count; ++i)
        {
          if (bars[i].Bounds.Meets(around))
          {
            met[block][i].push_back(triangles[t]);
          }
        }
      }
    });
  std::vector<double> w;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::vector<CountedTriangle> along;
    for (const Met& block : met)
    {
      along.insert(along.end(), block[i].begin(), block[i].end());
    }
    w.push_back(CountAlong(bars[i], points, along, sites[i]));
  }
  return w;
}
} // namespace insideout
