// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"

#include <array>
#include <vector>

namespace insideout
{
/** A length asked for on a triangle, which may be a segment or a point, and within its reach. */
struct SizeSource
{
  std::array<Point, 3> Corners;
  double Length;
  double Reach = 0;
};

/** Lengths anywhere: those of sources, growing with the distance, so that neighbors are alike. */
class SizeSources
{
public:
  /** @param[in] grading growth per unit of distance, positive */
  SizeSources(const std::vector<SizeSource>& sources, double grading);

  /** The least length; infinite without sources. */
  double LengthAt(const Point& place) const;

private:
  /** Sources whose lengths differ by a factor of two at most. */
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
