// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"

#include <array>
#include <vector>

namespace insideout
{
/** A length asked for on a triangle, a segment or a point, and within a distance of it. */
struct SizeSource
{
  std::array<Point, 3> Corners;
  double Length;
  double Reach = 0;
};

/** Lengths at any place: the least over the sources, each growing with distance. */
class SizeSources
{
public:
  /** @param[in] grading growth per unit of distance, positive */
  SizeSources(const std::vector<SizeSource>& sources, double grading);

  /** The least length; infinite without sources. */
  double LengthAt(const Point& place) const;

private:
  /** Sources whose lengths differ at most by a factor of two. */
  struct Octave
  {
    double Shortest;
    std::vector<SizeSource> Sources;
    BoxTree Tree;
  };
  std::vector<Octave> Octaves; ///< the shortest lengths first
  double Grading;
};
} // namespace insideout
