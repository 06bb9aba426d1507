// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"

#include <complex>
#include <vector>

namespace insideout
{
/** A place, and how often it counts. */
struct CountedPlace
{
  PlanarPoint Place;
  double Count;
};

/**
 * The sum of counted arguments of the directions to places, each in (-pi, pi] and 0 where the place
 * is the point itself, over 2 pi.
 *
 * The argument is the imaginary part of the logarithm, whose far field is a series in the inverse
 * of the distance (Greengard and Rokhlin 1987). In a tree of places, one that is far from the point
 * and does not meet the ray to its left, where the argument jumps, is such a series, cut off behind
 * a double's last digit. What is near is summed place by place.
 */
class ArgumentSum
{
public:
  /** Nothing to sum. */
  ArgumentSum() = default;
  ArgumentSum(std::vector<CountedPlace> places, const PlanarMetric& metric);

  /** Safe to call from several threads. */
  double At(const PlanarPoint& p) const;

private:
  using Complex = std::complex<double>;

  struct Node
  {
    PlanarPoint Center;
    double Radius;     ///< by the metric, around the center
    double Count;      ///< of all places
    std::size_t Begin; ///< of its places
    std::size_t End;
    std::size_t Next;    ///< the node to go on with where this one is passed over
    std::size_t Moments; ///< of the series, where they begin
  };

  void Build(std::size_t begin, std::size_t end);
  Complex Direction(const PlanarPoint& to, const PlanarPoint& from) const;
  double FarField(const Node& node, const Complex& center, int terms) const;

  std::vector<CountedPlace> Places;
  PlanarMetric Metric;
  std::vector<Node> Nodes; ///< depth first
  std::vector<Complex> Moments;
};
} // namespace insideout
