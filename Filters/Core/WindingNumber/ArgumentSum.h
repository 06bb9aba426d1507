// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"
#include "WindingNumber/Pi.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace insideout
{
/** A point and its count. */
struct CountedPlace
{
  PlanarPoint Place;
  double Count;
};

/**
 * Heights, with the counts summed at and above each: for rays to the left, which pass between them.
 */
class CountsAbove
{
public:
  CountsAbove() = default;

  /** @param[in] counted heights and counts */
  explicit CountsAbove(std::vector<std::pair<double, double>> counted);

  /** The count at or above a point, by place.IsAtOrAbove(height), exactly. */
  template <typename Place>
  double At(const Place& place) const
  {
    const auto first = std::partition_point(this->Counted.begin(), this->Counted.end(),
      [&](const std::pair<double, double>& one) { return !place.IsAtOrAbove(one.first); });
    return first == this->Counted.end() ? 0 : first->second;
  }

private:
  std::vector<std::pair<double, double>> Counted; ///< ascending, with the sum from there on
};

/**
 * The sum of counted arguments of the directions to places, each in (-pi, pi] and 0 where the two
 * coincide, over 2 pi.
 *
 * The argument is the imaginary part of the logarithm, whose far field is a series in the inverse
 * of the distance (Greengard and Rokhlin 1987). A tree node that is far from the point is such a
 * series, truncated below a double's last digit. If the node meets the ray to the left, on which
 * the argument jumps, the places on one side of the ray are off by a whole turn; their number
 * follows from their heights. Near nodes are summed place by place.
 */
class ArgumentSum
{
public:
  /** Nothing to sum. */
  ArgumentSum() = default;
  ArgumentSum(std::vector<CountedPlace> places, const PlanarMetric& metric);

  /**
   * Safe to call from several threads.
   *
   * @param[in] from the point: from.Offset(p) is the vector from it to p with rounded coordinates,
   * from.IsAtOrAbove(y) compares heights exactly
   */
  template <typename From>
  double At(const From& from) const
  {
    double sum = 0;
    double turns = 0;
    for (std::size_t n = 0; n < this->Nodes.size();)
    {
      const Node& node = this->Nodes[n];
      const Complex center = this->Direction(from.Offset(node.Center));
      if (const int terms = TermsFor(node, center); terms > 0)
      {
        sum += this->FarField(node, center, terms);
        turns += IsBesideRay(node, center) ? 0
          : center.imag() >= 0             ? node.Above.At(from) - node.Count
                                           : node.Above.At(from);
        n = node.Next;
        continue;
      }
      if (node.Next == n + 1) // a leaf
      {
        for (std::size_t i = node.Begin; i < node.End; ++i)
        {
          const Complex direction = this->Direction(from.Offset(this->Places[i].Place));
          sum += this->Places[i].Count * std::atan2(direction.imag(), direction.real());
        }
      }
      ++n;
    }
    return sum / (2 * Pi) + turns;
  }

private:
  using Complex = std::complex<double>;

  struct Node
  {
    PlanarPoint Center;
    double Radius;     ///< by the metric, around the center
    double Count;      ///< of all places
    std::size_t Begin; ///< of its places
    std::size_t End;
    std::size_t Next;    ///< the next node when this one is skipped
    std::size_t Moments; ///< start of the series
    CountsAbove Above;   ///< of all places
  };

  void Build(std::size_t begin, std::size_t end);
  Complex Direction(const PlanarPoint& offset) const;
  static int TermsFor(const Node& node, const Complex& center);
  static bool IsBesideRay(const Node& node, const Complex& center);
  double FarField(const Node& node, const Complex& center, int terms) const;

  std::vector<CountedPlace> Places;
  PlanarMetric Metric;
  std::vector<Node> Nodes; ///< depth first
  std::vector<Complex> Moments;
};
} // namespace insideout
