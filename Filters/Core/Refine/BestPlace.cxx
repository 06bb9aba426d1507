// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/BestPlace.h"

#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
/** Uphill steps are few: what is left to gain after these is small. */
constexpr int MostSteps = 8;
constexpr int MostHalvings = 5;

/** Cells whose shape is so near the worst one's go uphill with it. */
constexpr double NearWorst = 1.2;
constexpr std::size_t MostActive = 6;

/** A step is worth its while that gains so much. */
constexpr double LeastGain = 1.002;

Point Along(const Point& from, const Point& direction, double t)
{
  return { { from[0] + t * direction[0], from[1] + t * direction[1], from[2] + t * direction[2] } };
}

double ShapeAt(const std::vector<Point>& points, const Triangle& wall, const Point& place)
{
  return ShapeOf(points[wall[0]], points[wall[1]], points[wall[2]], place);
}

/** The point nearest to the origin in the convex hull of some vectors, by Wolfe's way for few. */
Point ShortestIn(const std::vector<Point>& vectors)
{
  Point shortest = vectors.front();
  for (int step = 0; step < 12; ++step)
  {
    const Point* least = &vectors.front();
    for (const Point& vector : vectors)
    {
      if (Dot(vector, shortest) < Dot(*least, shortest))
      {
        least = &vector;
      }
    }
    const Point towards = Difference(*least, shortest);
    const double squared = Dot(towards, towards);
    const double gain = -Dot(towards, shortest);
    if (!(gain > 1e-3 * Dot(shortest, shortest)))
    {
      break;
    }
    shortest = Along(shortest, towards, std::min(1.0, gain / squared));
  }
  return shortest;
}

/** How the place is to be moved to make the worst cells better; none if it cannot be. */
Point Uphill(const std::vector<Point>& points, const std::vector<Triangle>& walls,
  const Point& place, double worst, double length, const Point* normal)
{
  std::vector<std::pair<double, const Triangle*>> active;
  for (const Triangle& wall : walls)
  {
    const double shape = ShapeAt(points, wall, place);
    if (shape <= (worst > 0 ? NearWorst * worst : 0.0))
    {
      active.push_back({ shape, &wall });
    }
  }
  std::sort(
    active.begin(), active.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  active.resize(std::min(active.size(), MostActive));
  const double h = 1e-5 * length;
  std::vector<Point> gradients;
  for (const auto& [shape, wall] : active)
  {
    Point gradient;
    for (int k = 0; k < 3; ++k)
    {
      Point there = place;
      there[k] += h;
      gradient[k] = (ShapeAt(points, *wall, there) - shape) / h;
    }
    if (normal)
    {
      gradient = Along(gradient, *normal, -Dot(gradient, *normal));
    }
    if (worst <= 0)
    {
      // Beyond a wall the way back is what counts, for all alike.
      const double norm = Length(gradient);
      gradient = norm > 0 ? Along({ { 0, 0, 0 } }, gradient, 1 / norm) : gradient;
    }
    gradients.push_back(gradient);
  }
  return gradients.empty() ? Point{ { 0, 0, 0 } } : ShortestIn(gradients);
}
} // namespace

double WorstShapeAt(const std::vector<Point>& points, const std::vector<Triangle>& walls,
  const Point& place, double enough)
{
  double worst = 1;
  for (const Triangle& wall : walls)
  {
    worst = std::min(worst, ShapeAt(points, wall, place));
    if (worst < enough)
    {
      break;
    }
  }
  return worst;
}

double FindBestPlace(const std::vector<Point>& points, const std::vector<Triangle>& walls,
  Point& place, const Point* normal)
{
  constexpr double any = -std::numeric_limits<double>::infinity();
  double worst = WorstShapeAt(points, walls, place, any);
  double length = std::numeric_limits<double>::infinity();
  for (const Triangle& wall : walls)
  {
    for (const Id corner : wall)
    {
      length = std::min(length, Distance(points[corner], place));
    }
  }
  double step = 0.3 * length;
  for (int taken = 0; taken < MostSteps; ++taken)
  {
    const Point uphill = Uphill(points, walls, place, worst, length, normal);
    const double norm = Length(uphill);
    if (!(norm > 0))
    {
      break;
    }
    bool isBetter = false;
    for (int halving = 0; halving < MostHalvings && !isBetter; ++halving)
    {
      const Point there = Along(place, uphill, step / norm);
      const double wanted = worst > 0 ? worst * LeastGain : worst;
      const double shape = WorstShapeAt(points, walls, there, wanted);
      isBetter = shape > wanted;
      if (isBetter)
      {
        place = there;
        worst = shape;
      }
      else
      {
        step /= 2.5;
      }
    }
    if (!isBetter)
    {
      break;
    }
    step *= 1.5;
  }
  return worst;
}
} // namespace insideout
