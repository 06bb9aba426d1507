// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/WallDirections.h"

#include "Common/Vectors.h"
#include "Refine/ShortestInHull.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** With more the direction at a ridge of three planes gets no better by a degree. */
constexpr int StepsOfHull = 50;

/** Directions with a smaller cosine run along a triangle: layers there would be all but flat. */
constexpr double LeastCosine = 0.1;

/** In a corner of 60 degrees layers end twice their height from the point; sharper ones get less.
 */
constexpr double MostTimesHeight = 2;

/** Rounds of smoothing, and how much of the best cosine a smoothed direction keeps. */
constexpr int Rounds = 5;
constexpr double LeastShareOfCosine = 0.9;

/** Behind layers higher than edges are long the moved points of a ridge would overtake others:
 * there directions turn on, up to 45 degrees, until edges keep this share. */
constexpr double ShareOfEdge = 0.5;
constexpr double LeastShareAtShortEdges = 0.7;
constexpr int MostRoundsAtShortEdges = 100;

Point Unit(const Point& vector)
{
  const double length = Length(vector);
  return length > 0 ? Point{ { vector[0] / length, vector[1] / length, vector[2] / length } }
                    : Point{ { 0, 0, 0 } };
}

/** 0 for one so short that its direction may be rounding: as long as the best cosine is the
 * shortest in a hull of normals. */
Point UnitUnlessShort(const Point& vector)
{
  return Length(vector) > LeastCosine ? Unit(vector) : Point{ { 0, 0, 0 } };
}

class Directions
{
public:
  Directions(
    const std::vector<Point>& points, const LayerWall& wall, const std::vector<WallRim>& rims)
    : Wall(wall)
    , Rims(rims)
    , All(points.size())
    , Best(points.size(), 0)
  {
    for (const Triangle& t : wall.Triangles)
    {
      this->Normals.push_back(Unit(NormalOf(points[t[0]], points[t[2]], points[t[1]])));
    }
    for (const Id p : wall.Points)
    {
      std::vector<Point> around;
      for (const Id t : wall.TrianglesAt[p])
      {
        around.push_back(rims[p].Along(this->Normals[t]));
      }
      const Point way = UnitUnlessShort(ShortestInHull(around, StepsOfHull));
      this->Best[p] = this->CosineAt(p, way);
      if (this->Best[p] > LeastCosine)
      {
        this->All[p] = { way, this->Best[p] };
      }
    }
  }

  /** Turn directions of points towards those of the neighbors, where enough of the cosine stays. */
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

  /** The ends of edges that get too short behind layers of a height. */
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
    for (const Id t : this->Wall.TrianglesAt[point])
    {
      least = std::min(least, Dot(this->Normals[t], way));
    }
    return least;
  }

  const LayerWall& Wall;
  const std::vector<WallRim>& Rims;
  std::vector<Point> Normals; ///< of the triangles, inward
  std::vector<WallDirection> All;
  std::vector<double> Best; ///< cosine
};
} // namespace

double WallDirection::WayAlong(const Point& vector) const
{
  return this->LengthPerHeight() * Dot(this->Inward, vector);
}

double WallDirection::LengthPerHeight() const
{
  return this->Cosine > 0 ? std::min(MostTimesHeight, 1 / this->Cosine) : 0;
}

std::vector<WallDirection> FindWallDirections(const std::vector<Point>& points,
  const LayerWall& wall, const std::vector<WallRim>& rims, double height)
{
  Directions directions(points, wall, rims);
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
