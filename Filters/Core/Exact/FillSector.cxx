// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FillSector.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
/**
 * Limit of steps towards a point that sees all walls of a sector from within, which is tested
 * exactly. Steps shrink to 3e-6.
 */
constexpr int StepsInward = 120;

/** A step shorter than this share of the distance to the nearest wall gains little. */
constexpr double LeastStep = 1.0 / 16;

/** Length of each step relative to the step before. */
constexpr double StepRatio = 0.9;

/** Distances to walls that take the time of one predicate. */
constexpr std::int64_t DistancesPerWork = 8;

/** Sine of the angle to the walls from which a direction out of a corner is good enough. */
constexpr double LeastRise = 0.05;

bool SeesAll(const FlippableMesh& mesh, const Sector& sector, Id apex)
{
  return std::all_of(sector.Walls.begin(), sector.Walls.end(),
    [&](const Triangle& wall)
    {
      return wall[0] == apex || wall[1] == apex || wall[2] == apex ||
        mesh.Vertices().Orient(wall[0], wall[1], wall[2], apex) > 0;
    });
}

Id FindApex(const FlippableMesh& mesh, const Sector& sector)
{
  const auto apex = std::find_if(sector.Corners.begin(), sector.Corners.end(),
    [&](Id corner) { return SeesAll(mesh, sector, corner); });
  return apex == sector.Corners.end() ? None : *apex;
}

/** The inner sides of the walls, in floating point, relative to a point. */
struct HalfSpaces
{
  std::vector<Eigen::Vector3d> Normals;
  std::vector<double> Distances; ///< of the point, negative outside
  double Size = 0;               ///< the largest distance of a corner

  /** The number of walls nearer to the point than `near`. */
  std::ptrdiff_t CountNear(double near) const
  {
    return std::count_if(this->Distances.begin(), this->Distances.end(),
      [near](double distance) { return distance < near; });
  }

  /** The distance from a place to the nearest wall, negative outside, and that wall. */
  double Clearance(const Eigen::Vector3d& x, std::size_t& nearest) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < this->Normals.size(); ++w)
    {
      const double distance = this->Distances[w] + this->Normals[w].dot(x);
      if (distance < least)
      {
        least = distance;
        nearest = w;
      }
    }
    return least;
  }
};

/** Move away from the nearest wall, in shrinking steps. */
Eigen::Vector3d WalkInward(const HalfSpaces& walls)
{
  Eigen::Vector3d x(0, 0, 0);
  Eigen::Vector3d best = x;
  double most = -std::numeric_limits<double>::infinity();
  double step = walls.Size / 4;
  for (int k = 0; k < StepsInward; ++k)
  {
    std::size_t nearest = 0;
    const double clearance = walls.Clearance(x, nearest);
    if (clearance > most)
    {
      most = clearance;
      best = x;
    }
    if (step < LeastStep * most)
    {
      break;
    }
    x += step * walls.Normals[nearest];
    step *= StepRatio;
  }
  return best;
}

/**
 * Move away from all walls nearer than `near`, half as far as the others allow. This works for a
 * point on an edge of a thin sector, where WalkInward steps over it.
 */
Eigen::Vector3d LeaveNearWalls(const HalfSpaces& walls, double near)
{
  Eigen::Vector3d direction(0, 0, 0);
  for (std::size_t w = 0; w < walls.Normals.size(); ++w)
  {
    direction += walls.Distances[w] < near ? walls.Normals[w] : Eigen::Vector3d(0, 0, 0);
  }
  for (int k = 0; k < StepsInward; ++k)
  {
    double least = std::numeric_limits<double>::infinity();
    std::size_t worst = 0;
    for (std::size_t w = 0; w < walls.Normals.size(); ++w)
    {
      const double rise = walls.Normals[w].dot(direction);
      if (walls.Distances[w] < near && rise < least)
      {
        least = rise;
        worst = w;
      }
    }
    if (least > LeastRise * direction.norm())
    {
      break;
    }
    direction += walls.Normals[worst];
  }
  direction.normalize();
  double length = walls.Size;
  for (std::size_t w = 0; w < walls.Normals.size(); ++w)
  {
    const double rise = walls.Normals[w].dot(direction);
    if (walls.Distances[w] >= near && rise < 0)
    {
      length = std::min(length, -walls.Distances[w] / rise);
    }
  }
  return length / 2 * direction;
}

/**
 * A small shift that differs between vertices, so that symmetric surfaces get no coplanar points.
 */
Eigen::Vector3d Aside(Id vertex)
{
  return { std::sin(1.0 + vertex), std::sin(2.0 + 3.0 * vertex), std::sin(3.0 + 7.0 * vertex) };
}

/**
 * A new point that sees all walls. The search is in floating point; the result is tested exactly.
 */
Id NewApex(FlippableMesh& mesh, const Sector& sector, const Point& inside)
{
  const auto at = [&mesh](Id p)
  {
    const Point x = mesh.Vertices().Nearest(p);
    return Eigen::Vector3d(x[0], x[1], x[2]);
  };
  const Eigen::Vector3d origin(inside[0], inside[1], inside[2]);
  HalfSpaces walls;
  for (const Triangle& wall : sector.Walls)
  {
    const ExactVertices::Plane plane =
      mesh.Vertices().PlaneThrough(wall[0], wall[1], wall[2], inside);
    const Eigen::Vector3d normal(plane.Normal[0], plane.Normal[1], plane.Normal[2]);
    const double length = normal.stableNorm();
    if (length > 0 && std::isfinite(length) && std::isfinite(plane.Offset))
    {
      walls.Normals.push_back(normal / length);
      walls.Distances.push_back(-plane.Offset / length);
    }
    for (const Id corner : wall)
    {
      walls.Size = std::max(walls.Size, (at(corner) - origin).norm());
    }
  }
  if (walls.Normals.empty())
  {
    return None;
  }
  std::ptrdiff_t nearBefore = -1;
  for (const double near : { -1.0, 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    const std::ptrdiff_t isNear = near < 0 ? -1 : walls.CountNear(near * walls.Size);
    if (near > 0 && isNear == nearBefore)
    {
      continue; // the same walls give the same place again
    }
    nearBefore = isNear;
    mesh.Work().Spend(
      StepsInward * static_cast<std::int64_t>(walls.Normals.size()) / DistancesPerWork);
    Eigen::Vector3d place = near < 0 ? WalkInward(walls) : LeaveNearWalls(walls, near * walls.Size);
    std::size_t nearest = 0;
    const double clearance = walls.Clearance(place, nearest);
    if (!place.allFinite() || !(clearance > 0))
    {
      continue;
    }
    place += origin + clearance / 4 * Aside(mesh.Vertices().Size());
    const Id apex = mesh.AddVertex({ { place[0], place[1], place[2] } });
    if (SeesAll(mesh, sector, apex))
    {
      return apex;
    }
    mesh.RemoveLastVertex();
  }
  return None;
}

} // namespace

bool FillSectors(FlippableMesh& mesh, const std::vector<Sector>& sectors, const Point& inside,
  VolumePoints volumePoints, std::vector<Tetrahedron>& fresh)
{
  const Id first = mesh.Vertices().Size();
  for (const Sector& sector : sectors)
  {
    Id apex = sector.IsInfinite ? mesh.Infinite() : FindApex(mesh, sector);
    if (apex == None && volumePoints == VolumePoints::AsNeeded)
    {
      apex = NewApex(mesh, sector, inside);
    }
    if (apex == None)
    {
      while (mesh.Vertices().Size() > first)
      {
        mesh.RemoveLastVertex();
      }
      return false;
    }
    for (const Triangle& wall : sector.Walls)
    {
      if (wall[0] != apex && wall[1] != apex && wall[2] != apex)
      {
        fresh.push_back({ { wall[0], wall[1], wall[2], apex } });
      }
    }
  }
  return true;
}
} // namespace insideout
