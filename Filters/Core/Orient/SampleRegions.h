// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Orient/RandomNumbers.h"
#include "Orient/ShellChains.h"

#include <memory>

namespace insideout
{
/** The winding number of a shell at a point. */
struct ShellWinding
{
  Id Shell;
  int W; ///< not 0

  bool operator<(const ShellWinding& other) const
  {
    return this->Shell != other.Shell ? this->Shell < other.Shell : this->W < other.W;
  }
};

/** All points with the same winding numbers of all shells. */
struct ShellRegion
{
  std::vector<ShellWinding> Windings; ///< by shell; not empty
  double Volume;
};

/** A line, and its crossings with triangles of shells. */
struct CrossedLine
{
  struct Crossing
  {
    double At;    ///< along the line
    double Error; ///< error bound of At, by rounding
    Id Shell;
    int Rise; ///< jump of the shell's winding number
  };

  Point Direction = { 0, 0, 0 }; ///< of length 1
  std::vector<Crossing> Crossings;
};

/**
 * The regions into which shells cut space, and their volumes, found along random straight lines.
 *
 * Between two crossings along a line the winding numbers of all shells are known, however they
 * cross. The lines go through random points of each shell, in directions about its normal by the
 * cosine law. So they are uniform among those that meet the shell, and thin shells are met as often
 * as thick ones (Santalo, Integral Geometry and Geometric Probability, 1976). A line may come from
 * any shell that it meets, so it is weighted by the sum of those densities (the balance heuristic
 * of Veach and Guibas 1995). The volumes are unbiased, and the same for any number of threads.
 */
class RegionSampler
{
public:
  /**
   * @param[in] points that the chains refer to, below 1 in each coordinate; must live on
   * @param[in] chains sheets are skipped
   */
  RegionSampler(const std::vector<Point>& points, const std::vector<ShellChain>& chains);
  ~RegionSampler();

  /**
   * @param[in] linesPerShell at least 1
   * @return sorted by windings
   * @throws Error (Stopped)
   */
  std::vector<ShellRegion> Sample(
    Id linesPerShell, Monitor& monitor, const ProgressRange& progress) const;

  /** A random line through a point, at which Crossing::At is 0. It has no crossings if several
   * lines in turn meet an edge. */
  CrossedLine Through(const Point& point, RandomNumbers& random) const;

  /** The winding numbers of shells around a point, by a random line through it. */
  std::vector<ShellWinding> At(const Point& point, RandomNumbers& random) const;

private:
  class Scene;
  const std::unique_ptr<const Scene> Shells;
};
} // namespace insideout
