// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/BestPlace.h"

#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ShortestInHull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insideout
{
namespace
{
/** Limit of uphill steps: later steps gain little. */
constexpr int MostSteps = 8;
constexpr int MostHalvings = 5;
constexpr int StepsOfHull = 12;

/** Cells whose shape is this close to the worst one are improved together with it. */
constexpr double NearWorst = 1.2;
constexpr std::size_t MostActive = 6;

/** The least gain for which another step is taken. */
constexpr double LeastGain = 1.002;

Point Along(const Point& from, const Point& direction, double t)
{
  return { { from[0] + t * direction[0], from[1] + t * direction[1], from[2] + t * direction[2] } };
}

/** The cells between a moving place and walls. */
class Climb
{
public:
  Climb(const std::vector<Point>& points, const std::vector<Triangle>& walls, const Point& place)
    : Place(place)
  {
    this->Bases.reserve(walls.size());
    for (const Triangle& wall : walls)
    {
      const auto [a, b, c] = CornersOf(points, wall);
      this->Bases.emplace_back(a, b, c);
      this->Length =
        std::min({ this->Length, Distance(a, place), Distance(b, place), Distance(c, place) });
    }
    this->Shapes.resize(walls.size());
    this->Order.resize(walls.size());
    std::iota(this->Order.begin(), this->Order.end(), 0);
    this->Worst = this->ShapesAt(place, this->Shapes, -std::numeric_limits<double>::infinity());
  }

  /** Move while the shape improves. @param[in] normal as for FindBestPlace */
  void Rise(const Point* normal)
  {
    double step = 0.3 * this->Length;
    std::vector<double> shapes(this->Shapes.size());
    for (int taken = 0; taken < MostSteps; ++taken)
    {
      const Point uphill = this->Uphill(normal);
      const double norm = insideout::Length(uphill);
      if (!(norm > 0))
      {
        return;
      }
      const double wanted = this->Worst > 0 ? this->Worst * LeastGain : this->Worst;
      int halving = 0;
      for (; halving < MostHalvings; ++halving)
      {
        const Point there = Along(this->Place, uphill, step / norm);
        const double worst = this->ShapesAt(there, shapes, wanted);
        if (worst > wanted)
        {
          this->Place = there;
          this->Worst = worst;
          this->Shapes.swap(shapes);
          break;
        }
        step /= 2.5;
      }
      if (halving == MostHalvings)
      {
        return;
      }
      step *= 1.5;
    }
  }

  Point Place;
  double Worst; ///< worst shape there

private:
  /** The shapes at a place, in order of the currently worst; stops at the first that is not above
   * `wanted`.
   * @return the worst of these
   */
  double ShapesAt(const Point& place, std::vector<double>& shapes, double wanted) const
  {
    double worst = 1;
    for (const std::size_t i : this->Order)
    {
      shapes[i] = this->Bases[i].ShapeWith(place);
      worst = std::min(worst, shapes[i]);
      if (!(worst > wanted))
      {
        break;
      }
    }
    return worst;
  }

  /** The direction of a step that improves the worst cells; none if there is none. */
  Point Uphill(const Point* normal)
  {
    const double most = this->Worst > 0 ? NearWorst * this->Worst : 0.0;
    const auto begin = this->Order.begin();
    const auto end = std::partition(
      begin, this->Order.end(), [&](std::size_t i) { return this->Shapes[i] <= most; });
    std::sort(begin, end,
      [this](std::size_t i, std::size_t j)
      { return this->Shapes[i] != this->Shapes[j] ? this->Shapes[i] < this->Shapes[j] : i < j; });
    const std::size_t active = std::min(static_cast<std::size_t>(end - begin), MostActive);
    const double h = 1e-5 * this->Length;
    std::vector<Point> gradients;
    for (std::size_t k = 0; k < active; ++k)
    {
      const std::size_t i = this->Order[k];
      Point gradient;
      for (int axis = 0; axis < 3; ++axis)
      {
        Point there = this->Place;
        there[axis] += h;
        gradient[axis] = (this->Bases[i].ShapeWith(there) - this->Shapes[i]) / h;
      }
      if (normal)
      {
        gradient = Along(gradient, *normal, -Dot(gradient, *normal));
      }
      if (this->Worst <= 0)
      {
        // Beyond a wall only the way back matters, equally for all cells.
        const double norm = insideout::Length(gradient);
        gradient = norm > 0 ? Along({ { 0, 0, 0 } }, gradient, 1 / norm) : gradient;
      }
      gradients.push_back(gradient);
    }
    return gradients.empty() ? Point{ { 0, 0, 0 } } : ShortestInHull(gradients, StepsOfHull);
  }

  std::vector<BaseOfCells> Bases;
  std::vector<double> Shapes;
  std::vector<std::size_t> Order; ///< order in which cells are evaluated
  /// distance to the nearest corner, at first
  double Length = std::numeric_limits<double>::infinity();
};
} // namespace

double WorstShapeAt(const std::vector<Point>& points, const std::vector<Triangle>& walls,
  const Point& place, double enough)
{
  double worst = 1;
  for (const Triangle& wall : walls)
  {
    worst = std::min(worst, ShapeOf(points[wall[0]], points[wall[1]], points[wall[2]], place));
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
  Climb climb(points, walls, place);
  climb.Rise(normal);
  place = climb.Place;
  return climb.Worst;
}
} // namespace insideout
