// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SizingField.h"

#include "Common/Edge.h"
#include "Common/NearestPoint.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace insideout
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/**
 * Relative to the mean edge at a point: a thinner triangle is not split into equilateral pieces.
 */
constexpr double LeastShare = 1.0 / 4;

/**
 * Bound of the longest edge over the least height of a triangle that is not thin; 1.2 for an
 * equilateral one.
 */
constexpr double MostHeights = 2;

double VolumeOf(const std::vector<Point>& points, const Tetrahedron& c)
{
  return Determinant(Difference(points[c[1]], points[c[0]]), Difference(points[c[2]], points[c[0]]),
           Difference(points[c[3]], points[c[0]])) /
    6;
}

/** Volume of a regular tetrahedron with edges of length 1. */
double EdgeOfVolume(double volume)
{
  return std::cbrt(6 * std::sqrt(2.0) * volume);
}

double VolumeOfEdge(double edge)
{
  return edge * edge * edge / (6 * std::sqrt(2.0));
}
} // namespace

SizingField::SizingField(RefinableMesh& mesh, const SizingParameters& parameters)
  : Mesh(mesh)
  , Parameters(parameters)
  , Everywhere(parameters.EdgeLength > 0 ? parameters.EdgeLength : Infinite)
{
  if (parameters.MaximumVolume > 0)
  {
    this->Everywhere = std::min(this->Everywhere, EdgeOfVolume(parameters.MaximumVolume));
  }
  this->AtPoints.resize(mesh.Points.size());
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    const double wanted = parameters.Lengths.empty() ? Infinite : parameters.Lengths[p];
    this->AtPoints[p] = { Infinite, this->WantedAt(mesh.Points[p], wanted) };
  }
  this->FollowSurface();
}

bool SizingField::IsAskedFor() const
{
  return this->Everywhere < Infinite || !this->Parameters.Lengths.empty() ||
    this->Parameters.LengthAt;
}

void SizingField::SetSizes()
{
  for (std::size_t p = 0; p < this->AtPoints.size(); ++p)
  {
    this->Mesh.Sizes[p] = this->AtPoints[p].Both();
  }
}

void SizingField::FollowSurface()
{
  this->SetLengthsOfSurface(0);
  this->Grow();
  this->SetSizes();
}

void SizingField::FollowThinTriangles()
{
  this->SetLengthsOfSurface(1);
  this->Grow();
  this->SetSizes();
}

void SizingField::ShortenAtThinTriangles()
{
  const std::vector<Lengths> before = this->AtPoints;
  this->SetLengthsOfSurface(MostHeights);
  for (std::size_t p = 0; p < before.size(); ++p)
  {
    if (this->Mesh.CellAt(static_cast<Id>(p)) != None)
    {
      this->AtPoints[p].Surface = std::min(this->AtPoints[p].Surface, before[p].Surface);
    }
  }
  this->Grow();
  this->SetSizes();
}

void SizingField::FollowWishes()
{
  for (Lengths& there : this->AtPoints)
  {
    there.Surface = there.Wanted < Infinite ? Infinite : there.Surface;
  }
  this->SetSizes();
}

double SizingField::WantedAt(const Point& place, double otherwise) const
{
  const double there = this->Parameters.LengthAt ? this->Parameters.LengthAt(place) : Infinite;
  return std::min({ this->Everywhere, otherwise, there });
}

/**
 * At each point of a facet the mean length of the facets' edges there. If `heights` is not 0, at
 * most `heights` times the distance to the opposite edges, but at least a fraction of the mean.
 */
void SizingField::SetLengthsOfSurface(double heights)
{
  std::vector<int> counts(this->AtPoints.size(), 0);
  std::vector<double> sums(this->AtPoints.size(), 0);
  std::vector<double> shortest(this->AtPoints.size(), Infinite);
  for (Id c = 0; c < this->Mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4 && !this->Mesh.IsDead(c); ++k)
    {
      if (this->Mesh.Cell(c).Facets[k] == None)
      {
        continue;
      }
      const Triangle f = FaceAcross(this->Mesh.Cell(c).Corners, k);
      const std::array<Point, 3> t = CornersOf(this->Mesh.Points, f);
      for (int i = 0; i < 3; ++i)
      {
        const double length = Distance(t[i], t[(i + 1) % 3]);
        for (const Id p : { f[i], f[(i + 1) % 3] })
        {
          sums[p] += length;
          ++counts[p];
        }
        const Point& apex = t[(i + 2) % 3];
        const Point across = NearestPointOf({ { t[i], t[(i + 1) % 3], t[i] } }, apex);
        shortest[f[(i + 2) % 3]] = std::min(shortest[f[(i + 2) % 3]], Distance(apex, across));
      }
    }
  }
  for (std::size_t p = 0; p < sums.size(); ++p)
  {
    const double mean = counts[p] > 0 ? sums[p] / counts[p] : Infinite;
    this->AtPoints[p].Surface =
      heights > 0 ? std::max(heights * shortest[p], LeastShare * mean) : mean;
  }
}

/** Extend the lengths inward from the surface along edges, with limited growth (Dijkstra 1959). */
void SizingField::Grow()
{
  using Entry = std::pair<double, Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (std::size_t p = 0; p < this->AtPoints.size(); ++p)
  {
    if (this->AtPoints[p].Surface < Infinite)
    {
      queue.push({ this->AtPoints[p].Surface, static_cast<Id>(p) });
    }
  }
  std::vector<Id> star;
  while (!queue.empty())
  {
    const auto [length, point] = queue.top();
    queue.pop();
    if (length > this->AtPoints[point].Surface)
    {
      continue;
    }
    star.clear();
    this->Mesh.Star(point, star);
    for (const Id cell : star)
    {
      for (const Id other : this->Mesh.Cell(cell).Corners)
      {
        const double grown = length +
          this->Parameters.Grading * Distance(this->Mesh.Points[point], this->Mesh.Points[other]);
        if (grown < this->AtPoints[other].Surface)
        {
          this->AtPoints[other].Surface = grown;
          queue.push({ grown, other });
        }
      }
    }
  }
}

SizingField::Lengths SizingField::LengthsAt(Id cell, const Point& place) const
{
  const Tetrahedron& corners = this->Mesh.Cell(cell).Corners;
  Lengths result = { Infinite, 0 };
  double weights = 0;
  bool isWanted = false;
  for (int k = 0; k < 4; ++k)
  {
    const Lengths& there = this->AtPoints[corners[k]];
    isWanted = isWanted || there.Wanted < Infinite;
    result.Surface = std::min(result.Surface,
      there.Surface + this->Parameters.Grading * Distance(this->Mesh.Points[corners[k]], place));
    // The weight of a corner is the volume between the place and the opposite face.
    const Triangle f = FaceAcross(corners, k);
    const double weight = std::max(0.0,
      Determinant(Difference(this->Mesh.Points[f[1]], place),
        Difference(this->Mesh.Points[f[0]], place), Difference(this->Mesh.Points[f[2]], place)));
    weights += weight;
    result.Wanted += weight * std::min(there.Wanted, std::numeric_limits<double>::max());
  }
  result.Wanted = isWanted && weights > 0 ? result.Wanted / weights : Infinite;
  result.Wanted = this->WantedAt(place, result.Wanted);
  return result;
}

double SizingField::At(Id cell, const Point& place) const
{
  return this->LengthsAt(cell, place).Both();
}

void SizingField::Append(Id cell, const Point& place)
{
  this->AtPoints.push_back(this->LengthsAt(cell, place));
}

double SizingField::EstimatedCells() const
{
  double cells = 0;
  for (Id c = 0; c < this->Mesh.NumberOfCells(); ++c)
  {
    if (this->Mesh.IsDead(c))
    {
      continue;
    }
    // Lengths grow from the corners, so that small ones act only near these.
    const Tetrahedron& corners = this->Mesh.Cell(c).Corners;
    const double size = this->At(c, Barycentre(this->Mesh.Points, corners));
    cells += 1 + VolumeOf(this->Mesh.Points, corners) / VolumeOfEdge(size);
  }
  return cells;
}
} // namespace insideout
