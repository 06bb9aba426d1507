// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SurfacePiece.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/**
 * Limit of the angle between a piece and those it replaces: beyond it the surface would fold over.
 */
constexpr double LeastCosine = 0.4;

/** Least height over longest edge: thinner pieces of a surface may fold over by rounding. */
constexpr double LeastHeight = 1e-6;

/** The same for pieces with an area of their own: cuts that are rounded err by some 1e-16. */
constexpr double LeastHeightWithArea = 1e-12;

/** Whether a triangle's height over its longest edge is at most this. */
bool IsThinner(const std::array<Point, 3>& t, double height)
{
  const double longest = LongestEdgeOf(t);
  return !(Length(NormalOf(t[0], t[1], t[2])) > height * longest * longest);
}

/** Whether a piece's normal roughly follows a direction, and the piece is thick enough to tell. */
bool LooksWhere(const SurfacePiece& piece, const Point& normal)
{
  const Point own = NormalOf(piece);
  return !IsThin(piece.Places) && Dot(own, normal) > LeastCosine * Length(own) * Length(normal);
}

/** Whether needles replace needles, whose normals are rounding errors, with a larger least height.
 */
bool AreLessThin(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh)
{
  const auto leastHeight = [](const std::vector<SurfacePiece>& pieces)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const SurfacePiece& piece : pieces)
    {
      const double height = Length(NormalOf(piece)) / LongestEdgeOf(piece.Places);
      least = height > 0 ? std::min(least, height) : 0; // three equal points have none
    }
    return least;
  };
  return std::all_of(gone.begin(), gone.end(),
           [](const SurfacePiece& piece) { return IsThin(piece.Places); }) &&
    leastHeight(fresh) > leastHeight(gone);
}
} // namespace

double LongestEdgeOf(const std::array<Point, 3>& t)
{
  return std::max({ Distance(t[0], t[1]), Distance(t[1], t[2]), Distance(t[2], t[0]) });
}

Point NormalOf(const SurfacePiece& piece)
{
  return insideout::NormalOf(piece.Places[0], piece.Places[1], piece.Places[2]);
}

Point CentreOf(const std::array<Point, 3>& t)
{
  Point centre;
  for (int k = 0; k < 3; ++k)
  {
    centre[k] = t[0][k] / 3 + t[1][k] / 3 + t[2][k] / 3;
  }
  return centre;
}

bool FindCenter(const std::vector<SurfacePiece>& pieces, Point& center)
{
  Point sum = { { 0, 0, 0 } };
  double areas = 0;
  for (const auto& [corners, places, facet] : pieces)
  {
    const double area = Length(insideout::NormalOf(places[0], places[1], places[2]));
    areas += area;
    for (int k = 0; k < 3; ++k)
    {
      sum[k] += area * (places[0][k] + places[1][k] + places[2][k]) / 3;
    }
  }
  center = { { sum[0] / areas, sum[1] / areas, sum[2] / areas } };
  return areas > 0;
}

double LowestOf(const std::vector<SurfacePiece>& pieces)
{
  double lowest = 1;
  for (const SurfacePiece& piece : pieces)
  {
    const double longest = LongestEdgeOf(piece.Places);
    lowest = std::min(lowest, Length(NormalOf(piece)) / (longest * longest));
  }
  return lowest;
}

bool IsThin(const std::array<Point, 3>& triangle)
{
  return IsThinner(triangle, LeastHeight);
}

bool HasNoArea(const std::array<Point, 3>& triangle)
{
  return IsThinner(triangle, LeastHeightWithArea);
}

bool AreUnfolded(const std::vector<SurfacePiece>& pieces, const Point& normal)
{
  return std::all_of(pieces.begin(), pieces.end(),
    [&](const SurfacePiece& piece)
    { return !IsThin(piece.Places) && Dot(NormalOf(piece), normal) > 0; });
}

bool LookAlike(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh)
{
  Point sum = { { 0, 0, 0 } };
  for (const SurfacePiece& piece : gone)
  {
    const Point normal = NormalOf(piece);
    sum = { { sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2] } };
  }
  return AreLessThin(gone, fresh) ||
    std::all_of(fresh.begin(), fresh.end(),
      [&](const SurfacePiece& piece) { return LooksWhere(piece, sum); });
}

bool EachLooksAlike(
  const std::vector<SurfacePiece>& before, const std::vector<SurfacePiece>& fresh, double low)
{
  const auto isLow = [low](const SurfacePiece& piece)
  { return Length(NormalOf(piece)) <= low * LongestEdgeOf(piece.Places); };
  return std::equal(fresh.begin(), fresh.end(), before.begin(),
    [&](const SurfacePiece& now, const SurfacePiece& then)
    {
      return LooksWhere(now, NormalOf(then)) || (IsThin(then.Places) && IsThin(now.Places)) ||
        (isLow(then) && isLow(now));
    });
}

SurfacePiece PieceAt(const RefinableMesh& mesh, Id cell, int k)
{
  const Triangle face = mesh.FaceCorners(cell, k);
  return { face, CornersOf(mesh.Points, face), mesh.Cell(cell).Facets[k] };
}

void ExchangePieces(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh,
  CellExchange& exchange)
{
  for (const SurfacePiece& piece : gone)
  {
    exchange.Gone.push_back(SortedTriangle(piece.Corners).Points);
  }
  for (const SurfacePiece& piece : fresh)
  {
    exchange.Facets.push_back({ piece.Corners, piece.Facet });
  }
}

std::vector<SurfacePiece> PiecesOf(const RefinableMesh& mesh)
{
  std::vector<SurfacePiece> pieces;
  mesh.VisitFacets(
    [&](Id c, int k)
    {
      if (mesh.HasPiece(c, k))
      {
        pieces.push_back(PieceAt(mesh, c, k));
      }
    });
  return pieces;
}
} // namespace insideout
