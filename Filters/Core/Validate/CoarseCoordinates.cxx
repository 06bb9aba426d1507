// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/CoarseCoordinates.h"

#include "Common/Floats.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace insideout
{
namespace
{
/** The difference of a float to the next one away from zero. */
double StepAt(double x)
{
  const auto single = static_cast<float>(std::abs(x));
  return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity())) -
    static_cast<double>(single);
}

/**
 * The step at the largest coordinate along an axis, if some coordinate is an odd multiple of it;
 * else 0.
 */
double StepAlong(int axis, const std::vector<Point>& points)
{
  const auto [least, most] = std::minmax_element(points.begin(), points.end(),
    [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
  if ((*least)[axis] == (*most)[axis])
  {
    return 0; // the shape has no extent along this axis
  }
  const double step = StepAt(std::max(std::abs((*least)[axis]), std::abs((*most)[axis])));
  const bool isOdd = std::any_of(points.begin(), points.end(),
    [&](const Point& p) { return std::fmod(p[axis], 2 * step) != 0; });
  return isOdd ? step : 0;
}

double MedianLength(const std::vector<Point>& points, const FacetEdges& edges)
{
  std::vector<double> lengths(edges.size());
  std::transform(edges.begin(), edges.end(), lengths.begin(),
    [&](const FacetEdge& edge) { return Distance(points[edge.Low], points[edge.High]); });
  const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), median, lengths.end());
  return *median;
}
} // namespace

CoarseCoordinates FindCoarseCoordinates(const std::vector<Point>& points, const FacetEdges& edges)
{
  CoarseCoordinates found;
  const bool areFloats = std::all_of(points.begin(), points.end(),
    [](const Point& p) { return std::all_of(p.begin(), p.end(), IsFloat); });
  if (!areFloats || edges.empty())
  {
    return found;
  }
  found.Step = std::max({ StepAlong(0, points), StepAlong(1, points), StepAlong(2, points) });
  found.Edge = MedianLength(points, edges);
  return found;
}

std::string WarningAbout(const CoarseCoordinates& coordinates)
{
  std::ostringstream words;
  words.precision(2);
  words << "single precision has rounded the coordinates to steps of " << coordinates.Step
        << ", and the median edge is only " << coordinates.Edge
        << " long: subtract the origin before the surface is saved in single precision, as STL "
           "always is, or save it in double precision, as PLY, OBJ or OFF";
  return words.str();
}
} // namespace insideout
