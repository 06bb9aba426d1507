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
 * For the estimate, cells are halved until their longest edge is at most this multiple of the
 * length there. The second limits the number of parts in all, to bound the work.
 */
constexpr double LongestPart = 4;
constexpr double MostParts = 1 << 20;

double VolumeOf(const std::array<Point, 4>& c)
{
  return Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0])) / 6;
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

/** Call visit(corner) for the corners of the cells around a point. */
template <class Visit>
void VisitCorners(const RefinableMesh& mesh, Id point, const Visit& visit)
{
  std::vector<Id> star;
  mesh.Star(point, star);
  for (const Id cell : star)
  {
    const Tetrahedron& corners = mesh.Cell(cell).Corners;
    std::for_each(corners.begin(), corners.end(), visit);
  }
}
} // namespace

/**
 * At each point of a facet the mean length of the facets' edges there. Where the visited triangles
 * have limits above 0, the least of these times the distance to the opposite edge, but at least a
 * fraction of the mean.
 * @param[in] visitTriangles calls visit(corners, limit)
 */
template <class VisitTriangles>
void SizingField::SetLengthsOfSurface(const VisitTriangles& visitTriangles)
{
  std::vector<int> counts(this->AtPoints.size(), 0);
  std::vector<double> sums(this->AtPoints.size(), 0);
  std::vector<double> limits(this->AtPoints.size(), Infinite);
  visitTriangles(
    [&](const Triangle& f, double heights)
    {
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
        if (heights > 0)
        {
          double& limit = limits[f[(i + 2) % 3]];
          limit = std::min(limit, heights * Distance(apex, across));
        }
      }
    });
  for (std::size_t p = 0; p < sums.size(); ++p)
  {
    const double mean = counts[p] > 0 ? sums[p] / counts[p] : Infinite;
    this->AtPoints[p].Surface =
      limits[p] < Infinite ? std::max(limits[p], LeastShare * mean) : mean;
  }
}

/** Extend the lengths inward from the surface along edges, with limited growth (Dijkstra 1959). */
template <class VisitNeighbors>
void SizingField::Grow(const VisitNeighbors& visitNeighbors)
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
  while (!queue.empty())
  {
    const auto [length, point] = queue.top();
    queue.pop();
    if (length > this->AtPoints[point].Surface)
    {
      continue;
    }
    visitNeighbors(point,
      [&, from = point, before = length](Id other)
      {
        const double grown = before +
          this->Parameters.Grading * Distance(this->Mesh.Points[from], this->Mesh.Points[other]);
        if (grown < this->AtPoints[other].Surface)
        {
          this->AtPoints[other].Surface = grown;
          queue.push({ grown, other });
        }
      });
  }
}

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
    const double given = p < parameters.Lengths.size() ? parameters.Lengths[p] : Infinite;
    this->AtPoints[p] = { Infinite, this->WantedAt(mesh.Points[p], given), given, Infinite };
  }
  for (Id c = 0; c < mesh.NumberOfCells() && !parameters.LengthOfRegion.empty(); ++c)
  {
    if (mesh.IsDead(c))
    {
      continue;
    }
    for (const Id p : mesh.Cell(c).Corners)
    {
      Lengths& there = this->AtPoints[p];
      there.Region = std::min(there.Region, this->LengthOfRegion(mesh.Cell(c).Region));
      there.Wanted = std::min(there.Wanted, there.Region);
    }
  }
  this->FollowSurface();
}

bool SizingField::IsAskedFor() const
{
  return this->Everywhere < Infinite || !this->Parameters.Lengths.empty() ||
    !this->Parameters.LengthOfRegion.empty() || this->Parameters.LengthAt;
}

void SizingField::SetSizes()
{
  for (std::size_t p = 0; p < this->AtPoints.size(); ++p)
  {
    this->Mesh.Sizes[p] = this->AtPoints[p].Both();
  }
}

void SizingField::FollowSurface(double heights)
{
  this->SetLengthsOfSurface(
    [&](const auto& visit)
    {
      this->Mesh.VisitFacets(
        [&](Id c, int k) { visit(FaceAcross(this->Mesh.Cell(c).Corners, k), heights); });
    });
  this->Grow([this](Id point, const auto& visit) { VisitCorners(this->Mesh, point, visit); });
  this->SetSizes();
}

void SizingField::ShortenAtThinTriangles(
  const std::vector<SurfacePiece>& pieces, const std::vector<double>& heights, double least)
{
  const std::vector<Lengths> before = this->AtPoints;
  std::vector<std::vector<Id>> neighbors(before.size());
  this->SetLengthsOfSurface(
    [&](const auto& visit)
    {
      for (std::size_t i = 0; i < pieces.size(); ++i)
      {
        visit(pieces[i].Corners, heights[i]);
      }
    });
  for (const SurfacePiece& piece : pieces)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Id p = piece.Corners[i];
      double& length = this->AtPoints[p].Surface;
      length = std::min(std::max(length, least), before[p].Surface);
      neighbors[p].insert(
        neighbors[p].end(), { piece.Corners[(i + 1) % 3], piece.Corners[(i + 2) % 3] });
    }
  }
  this->Grow([&](Id point, const auto& visit)
    { std::for_each(neighbors[point].begin(), neighbors[point].end(), visit); });
  this->SetSizes();
}

void SizingField::FollowWishes()
{
  for (Lengths& there : this->AtPoints)
  {
    const bool isReplaced = there.Wanted < Infinite && this->ReplacesSurface();
    there.Surface = isReplaced ? Infinite : there.Surface;
  }
  this->SetSizes();
}

double SizingField::WantedAt(const Point& place, double otherwise) const
{
  const double there = this->Parameters.LengthAt ? this->Parameters.LengthAt(place) : Infinite;
  return std::min({ this->Everywhere, otherwise, there });
}

double SizingField::LengthOfRegion(Id region) const
{
  const std::vector<double>& lengths = this->Parameters.LengthOfRegion;
  return lengths.empty() ? Infinite : lengths[region];
}

SizingField::Lengths SizingField::LengthsAt(Id cell, const Point& place) const
{
  const Tetrahedron& corners = this->Mesh.Cell(cell).Corners;
  Lengths result = { Infinite, 0, 0, this->LengthOfRegion(this->Mesh.Cell(cell).Region) };
  double weights = 0;
  bool isGiven = false;
  for (int k = 0; k < 4; ++k)
  {
    const Lengths& there = this->AtPoints[corners[k]];
    isGiven = isGiven || there.Array < Infinite;
    result.Surface = std::min(result.Surface,
      there.Surface + this->Parameters.Grading * Distance(this->Mesh.Points[corners[k]], place));
    // The weight of a corner is the volume between the place and the opposite face.
    const Triangle f = FaceAcross(corners, k);
    const double weight = std::max(0.0,
      Determinant(Difference(this->Mesh.Points[f[1]], place),
        Difference(this->Mesh.Points[f[0]], place), Difference(this->Mesh.Points[f[2]], place)));
    weights += weight;
    result.Array += weight * std::min(there.Array, std::numeric_limits<double>::max());
  }
  result.Array = isGiven && weights > 0 ? result.Array / weights : Infinite;
  result.Wanted = std::min(this->WantedAt(place, result.Array), result.Region);
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

double SizingField::AppendBetween(Id u, Id v, const Point& place)
{
  Lengths result = { Infinite, 0, 0, 0 };
  for (const Id end : { u, v })
  {
    const Lengths& there = this->AtPoints[end];
    result.Surface = std::min(result.Surface,
      there.Surface + this->Parameters.Grading * Distance(this->Mesh.Points[end], place));
    result.Array += there.Array / 2;
    result.Region = std::max(result.Region, there.Region);
  }
  result.Wanted = std::min(this->WantedAt(place, result.Array), result.Region);
  this->AtPoints.push_back(result);
  return result.Both();
}

double SizingField::AppendIn(Id region, const Point& place)
{
  const double length = this->LengthOfRegion(region);
  this->AtPoints.push_back(
    { Infinite, std::min(this->WantedAt(place, Infinite), length), Infinite, length });
  return this->AtPoints.back().Both();
}

double SizingField::EstimatedCells() const
{
  double cells = 0;
  const int halvings =
    std::max(0, std::ilogb(MostParts / std::max<Id>(this->Mesh.NumberOfCells(), 1)));
  for (Id c = 0; c < this->Mesh.NumberOfCells(); ++c)
  {
    if (!this->Mesh.IsDead(c))
    {
      const auto corners = CornersOf(this->Mesh.Points, this->Mesh.Cell(c).Corners);
      cells += 1 + this->CellsIn(c, corners, halvings);
    }
  }
  return cells;
}

/** The estimated number in a part of a cell, which is halved where lengths may differ within it. */
double SizingField::CellsIn(Id cell, const std::array<Point, 4>& corners, int halvings) const
{
  // Lengths grow from the corners, so that small ones act only near these.
  const Point middle = Midpoint(Midpoint(corners[0], corners[1]), Midpoint(corners[2], corners[3]));
  const double size = this->At(cell, middle);
  if (this->Parameters.LengthAt && halvings > 0)
  {
    std::array<int, 2> longest = { { 0, 1 } };
    for (const auto& [i, j] : TetrahedronEdges)
    {
      const bool isLonger =
        Distance(corners[i], corners[j]) > Distance(corners[longest[0]], corners[longest[1]]);
      longest = isLonger ? std::array<int, 2>{ { i, j } } : longest;
    }
    if (Distance(corners[longest[0]], corners[longest[1]]) > LongestPart * size)
    {
      double sum = 0;
      for (const int end : longest)
      {
        std::array<Point, 4> half = corners;
        half[end] = Midpoint(corners[longest[0]], corners[longest[1]]);
        sum += this->CellsIn(cell, half, halvings - 1);
      }
      return sum;
    }
  }
  return VolumeOf(corners) / VolumeOfEdge(size);
}
} // namespace insideout
