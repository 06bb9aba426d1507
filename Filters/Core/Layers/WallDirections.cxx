// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/WallDirections.h"

#include "Common/Vectors.h"
#include "Refine/ShortestInHull.h"

#include <algorithm>

namespace insideout
{
namespace
{
/**
 * Limit of iterations: more change the direction at a ridge of three planes by less than a degree.
 */
constexpr int StepsOfHull = 50;

/** Share of the way to the facet ahead: layers of both sides take two thirds. */
constexpr double ShareOfGap = 1.0 / 3;

/** Directions with a smaller cosine run along a triangle: layers there would be nearly flat. */
constexpr double LeastCosine = 0.1;

/**
 * Limit of the length of an edge relative to the layers' height, as in a corner of 60 degrees;
 * sharper corners get lower layers.
 */
constexpr double MostTimesHeight = 2;

/**
 * Number of rounds of smoothing, and the share of the best cosine that a smoothed direction keeps.
 */
constexpr int Rounds = 5;
constexpr double LeastShareOfCosine = 0.9;

/**
 * Layers may be higher than edges are long. Then the moved points of a ridge would overtake others:
 * directions there turn by up to 45 degrees, until edges keep this share of their length.
 */
constexpr double ShareOfEdge = 0.5;
constexpr double LeastShareAtShortEdges = 0.7;
constexpr int MostRoundsAtShortEdges = 100;

Point Unit(const Point& vector)
{
  const double length = Length(vector);
  return length > 0 ? Point{ { vector[0] / length, vector[1] / length, vector[2] / length } }
                    : Point{ { 0, 0, 0 } };
}

/**
 * The unit vector; 0 for a vector so short that its direction may be a rounding error. The best
 * cosine is the length of the shortest vector in a hull of normals.
 */
Point UnitUnlessShort(const Point& vector)
{
  return Length(vector) > LeastCosine ? Unit(vector) : Point{ { 0, 0, 0 } };
}

class Directions
{
public:
  Directions(
    const WallPoints& wall, const std::vector<Point>& normals, const std::vector<WallRim>& rims)
    : Wall(wall)
    , Normals(normals)
    , Rims(rims)
    , All(rims.size())
    , Best(rims.size(), 0)
  {
    for (const Id p : wall.Points)
    {
      std::vector<Point> around;
      for (const Id f : wall.FacetsAt[p])
      {
        around.push_back(rims[p].Along(normals[f]));
      }
      const Point way = UnitUnlessShort(ShortestInHull(around, StepsOfHull));
      this->Best[p] = this->CosineAt(p, way);
      if (this->Best[p] > LeastCosine)
      {
        this->All[p] = { way, this->Best[p] };
      }
    }
  }

  /**
   * Turn the directions of points towards those of their neighbors, as far as the cosine allows.
   */
  void Smooth(const std::vector<Id>& chosen, double leastShare)
  {
    const std::vector<WallDirection> before = this->All;
    for (const Id p : chosen)
    {
      Point sum = before[p].Inward;
      if (before[p].Cosine == 0)
      {
        continue;
      }
      const auto neighbors = this->Wall.NeighborsOf[p];
      for (const Id neighbor : neighbors)
      {
        for (int k = 0; k < 3; ++k)
        {
          sum[k] += before[neighbor].Inward[k] / static_cast<double>(neighbors.Size());
        }
      }
      const Point way = UnitUnlessShort(this->Rims[p].Along(sum));
      const double cosine = this->CosineAt(p, way);
      if (cosine >= std::max(LeastCosine, leastShare * this->Best[p]))
      {
        this->All[p] = { way, cosine };
      }
    }
  }

  /** The ends of edges that become too short behind layers of a height. */
  std::vector<Id> EndsOfShortEdges(const std::vector<Point>& points, double height) const
  {
    std::vector<Id> ends;
    for (const Id p : this->Wall.Points)
    {
      const auto neighbors = this->Wall.NeighborsOf[p];
      const bool isEnd = std::any_of(neighbors.begin(), neighbors.end(),
        [&](Id q)
        {
          const Point edge = Difference(points[q], points[p]);
          return height * (this->All[p].WayAlong(edge) - this->All[q].WayAlong(edge)) >
            (1 - ShareOfEdge) * Dot(edge, edge);
        });
      if (isEnd)
      {
        ends.push_back(p);
      }
    }
    return ends;
  }

  std::vector<WallDirection> Take() { return std::move(this->All); }

private:
  double CosineAt(Id point, const Point& way) const
  {
    double least = 1;
    for (const Id f : this->Wall.FacetsAt[point])
    {
      least = std::min(least, Dot(this->Normals[f], way));
    }
    return least;
  }

  const WallPoints& Wall;
  const std::vector<Point>& Normals;
  const std::vector<WallRim>& Rims;
  std::vector<WallDirection> All;
  std::vector<double> Best; ///< cosine
};
} // namespace

double WallDirection::WayAlong(const Point& vector) const
{
  return this->LengthPerHeight() * Dot(this->Inward, vector);
}

double WallDirection::EnoughWay(double height) const
{
  return this->LengthPerHeight() * height / ShareOfGap;
}

double WallDirection::HeightBefore(double way) const
{
  return ShareOfGap * way / this->LengthPerHeight();
}

double WallDirection::LengthPerHeight() const
{
  return this->Cosine > 0 ? std::min(MostTimesHeight, 1 / this->Cosine) : 0;
}

std::vector<Point> InwardNormals(const std::vector<Point>& points, const LayerWall& wall)
{
  std::vector<Point> normals;
  normals.reserve(wall.Triangles.size());
  for (const Triangle& t : wall.Triangles)
  {
    normals.push_back(Unit(NormalOf(points[t[0]], points[t[2]], points[t[1]])));
  }
  return normals;
}

std::vector<WallDirection> FindWallDirections(const std::vector<Point>& points,
  const WallPoints& wall, const std::vector<Point>& normals, const std::vector<WallRim>& rims,
  double height)
{
  Directions directions(wall, normals, rims);
  for (int round = 0; round < Rounds; ++round)
  {
    directions.Smooth(wall.Points, LeastShareOfCosine);
  }
  std::vector<Id> ends = directions.EndsOfShortEdges(points, height);
  for (int round = 0; round < MostRoundsAtShortEdges && !ends.empty(); ++round)
  {
    directions.Smooth(ends, LeastShareAtShortEdges);
    ends = directions.EndsOfShortEdges(points, height);
  }
  return directions.Take();
}
} // namespace insideout
