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

/** Rounds of smoothing, and how much of the best cosine a smoothed direction keeps. */
constexpr int Rounds = 5;
constexpr double LeastShareOfCosine = 0.9;

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

  /** Turn each direction towards those of the neighbors. */
  void Smooth()
  {
    const std::vector<WallDirection> before = this->All;
    for (const Id p : this->Wall.Points)
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
      if (cosine >= std::max(LeastCosine, LeastShareOfCosine * this->Best[p]))
      {
        this->All[p] = { way, cosine };
      }
    }
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

std::vector<WallDirection> FindWallDirections(
  const std::vector<Point>& points, const LayerWall& wall, const std::vector<WallRim>& rims)
{
  Directions directions(points, wall, rims);
  for (int round = 0; round < Rounds; ++round)
  {
    directions.Smooth();
  }
  return directions.Take();
}
} // namespace insideout
