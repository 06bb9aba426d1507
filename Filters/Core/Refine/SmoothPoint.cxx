// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SmoothPoint.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Refine/BestPlace.h"
#include "Refine/EdgeLengths.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
constexpr double LeastGain = 1.001;
} // namespace

bool PointSmoothing::MoveTo(Id point, const Point& place)
{
  const std::vector<Point>& points = this->Mesh.Points;
  for (const Triangle& wall : this->Walls)
  {
    if (Orient3D(points[wall[0]], points[wall[1]], points[wall[2]], place) <= 0)
    {
      return false;
    }
  }
  this->Mesh.Move(point, place, this->Walls);
  return true;
}

/** The pieces at a point, as seen from one side. */
void PointSmoothing::CollectPieces(Id point)
{
  this->Pieces.clear();
  for (const Id c : this->Cells)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (this->Mesh.Cell(c).Corners[k] != point && this->Mesh.HasPiece(c, k))
      {
        this->Pieces.push_back(PieceAt(this->Mesh, c, k));
      }
    }
  }
}

/** The normal of length 1, or 0 if there is none. */
Point PointSmoothing::NormalOfPieces() const
{
  Point sum = { { 0, 0, 0 } };
  const auto add = [&sum](const std::array<Point, 3>& t)
  {
    const Point normal = NormalOf(t[0], t[1], t[2]);
    sum = { { sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2] } };
  };
  if (this->Surface.Treatment() == SurfaceTreatment::Split)
  {
    add(this->Surface.Facet(this->Pieces.front().Facet).Corners);
  }
  else
  {
    for (const SurfacePiece& piece : this->Pieces)
    {
      add(piece.Places);
    }
  }
  const double length = Length(sum);
  return length > 0 ? Point{ { sum[0] / length, sum[1] / length, sum[2] / length } } : sum;
}

/** The nearest place in the facet's plane, or on the input's surface. */
Point PointSmoothing::PlaceOnSurface(const Point& place) const
{
  const Id facet = this->Pieces.front().Facet;
  if (this->Surface.Treatment() == SurfaceTreatment::Remeshed)
  {
    return this->Bound.PlaceOn(place, facet);
  }
  const Point normal = this->NormalOfPieces();
  const double height = Dot(Difference(place, this->Surface.Facet(facet).Corners[0]), normal);
  return { { place[0] - height * normal[0], place[1] - height * normal[1],
    place[2] - height * normal[2] } };
}

bool PointSmoothing::MoveInFacet(Id point, const Point& place)
{
  this->Moved = this->Pieces;
  for (SurfacePiece& piece : this->Moved)
  {
    for (int k = 0; k < 3; ++k)
    {
      piece.Places[k] = piece.Corners[k] == point ? place : piece.Places[k];
    }
  }
  if (!this->Bound.Allows(this->Pieces, this->Moved) || !this->MoveTo(point, place))
  {
    return false;
  }
  this->Bound.Replace();
  return true;
}

bool PointSmoothing::SmoothInFacet(Id point)
{
  const std::vector<Point>& points = this->Mesh.Points;
  this->CollectPieces(point);
  const double before = std::max(0.0,
    WorstShapeAt(points, this->Walls, points[point], -std::numeric_limits<double>::infinity()));
  Point place = points[point];
  const Point normal = this->NormalOfPieces();
  FindBestPlace(points, this->Walls, place, &normal);
  place = this->PlaceOnSurface(place);
  const double wanted = before * LeastGain;
  return WorstShapeAt(points, this->Walls, place, wanted) > wanted &&
    this->MoveInFacet(point, place);
}

bool PointSmoothing::Relax(Id point, double wanted)
{
  if (this->Mesh.Kinds[point] != PointKind::InFacet)
  {
    return false;
  }
  this->Mesh.StarWithWalls(point, this->Cells, this->Walls);
  this->CollectPieces(point);
  Point center;
  if (!FindCenter(this->Pieces, center))
  {
    return false;
  }
  const Point place = this->PlaceOnSurface(center);
  const std::vector<Point>& points = this->Mesh.Points;
  if (!(Distance(place, points[point]) > LeastMove * this->Mesh.Sizes[point]))
  {
    return false;
  }
  const double any = -std::numeric_limits<double>::infinity();
  const double before = WorstShapeAt(points, this->Walls, points[point], any);
  const double least = std::min(wanted, std::max(before, 0.0) / 2);
  return WorstShapeAt(points, this->Walls, place, least) > least && this->MoveInFacet(point, place);
}

bool PointSmoothing::Smooth(Id point)
{
  if (this->Mesh.Kinds[point] == PointKind::InFacet)
  {
    this->Mesh.StarWithWalls(point, this->Cells, this->Walls);
    return this->SmoothInFacet(point);
  }
  if (this->Mesh.Kinds[point] != PointKind::Free)
  {
    return false;
  }
  this->Mesh.StarWithWalls(point, this->Cells, this->Walls);
  const std::vector<Point>& points = this->Mesh.Points;
  Point place = points[point];
  const double before = std::max(
    0.0, WorstShapeAt(points, this->Walls, place, -std::numeric_limits<double>::infinity()));
  Point mean = { { 0, 0, 0 } };
  for (const Triangle& wall : this->Walls)
  {
    for (const Id corner : wall)
    {
      for (int k = 0; k < 3; ++k)
      {
        mean[k] += points[corner][k] / (3 * static_cast<double>(this->Walls.size()));
      }
    }
  }
  const double wanted = before * LeastGain;
  if (WorstShapeAt(points, this->Walls, mean, wanted) > wanted)
  {
    place = mean;
  }
  return FindBestPlace(points, this->Walls, place) > wanted && this->MoveTo(point, place);
}
} // namespace insideout
