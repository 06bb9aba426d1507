// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distance/StaysNear.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
// Limit of pieces. A tetrahedron in a gap lies over some tens of facets. It takes milliseconds if
// undecided.
constexpr int MostPieces = 4096;

// Corners nearer to a wall than this fraction of the limit count as on it: cutting off less costs
// pieces, and brings the corners nearer to the facet only by its square.
constexpr double InWall = 0x1p-10;

// After this many cuts of a piece, one is at the midpoint of its longest edge: pieces become
// smaller even between walls of needles.
constexpr int CutsPerHalving = 8;

using Piece = std::array<Point, 4>;
struct CutPiece
{
  Piece Corners;
  int Cuts;
};

/** The position of a cut on a piece's edge, as a fraction from one corner to the other. */
struct EdgeCut
{
  int From = 0;
  int To = 1;
  double Part = 0.5;
};

template <typename Visitor>
void ForEachCellEdge(const Visitor& visit)
{
  for (int i = 0; i < 4; ++i)
  {
    for (int k = i + 1; k < 4; ++k)
    {
      visit(i, k);
    }
  }
}

EdgeCut CutInTheMiddle(const Piece& piece)
{
  EdgeCut cut;
  double longest = 0;
  ForEachCellEdge(
    [&](int i, int k)
    {
      const double length = Distance(piece[i], piece[k]);
      cut = length > longest ? EdgeCut{ i, k, 0.5 } : cut;
      longest = std::max(length, longest);
    });
  return cut;
}

/** The cut at a wall on an edge of the facet that separates corners farthest; at the midpoint if
 * none does. */
EdgeCut CutAtWall(const Piece& piece, const std::array<Point, 3>& facet, double inWall)
{
  EdgeCut cut = CutInTheMiddle(piece);
  const Point normal = NormalOf(facet[0], facet[1], facet[2]);
  double farthest = inWall;
  for (int side = 0; side < 3; ++side)
  {
    const Point inwards = Cross(normal, Difference(facet[(side + 1) % 3], facet[side]));
    const double length = Length(inwards);
    std::array<double, 4> beyond;
    for (int i = 0; i < 4; ++i)
    {
      beyond[i] = Dot(inwards, Difference(piece[i], facet[side])) / length; // NaN cuts nothing
    }
    ForEachCellEdge(
      [&](int i, int k)
      {
        const double nearer = std::min(std::abs(beyond[i]), std::abs(beyond[k]));
        if (beyond[i] * beyond[k] < 0 && nearer > farthest)
        {
          farthest = nearer;
          cut = { i, k, beyond[i] / (beyond[i] - beyond[k]) };
        }
      });
  }
  return cut;
}

Point Between(const Point& a, const Point& b, double part)
{
  return { a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2]) };
}

Point CentreOf(const Piece& piece)
{
  return Between(Between(piece[0], piece[1], 0.5), Between(piece[2], piece[3], 0.5), 0.5);
}
} // namespace

bool StaysNear(const std::array<Point, 4>& tetrahedron, const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const SurfaceDistance& distances, double most)
{
  std::vector<CutPiece> pieces = { { tetrahedron, 0 } };
  for (int seen = 0; !pieces.empty(); ++seen)
  {
    CutPiece piece = pieces.back();
    pieces.pop_back();
    const SurfaceDistance::Nearest nearest = distances.At(CentreOf(piece.Corners));
    if (!(nearest.Distance <= most) || seen == MostPieces)
    {
      return false;
    }
    const std::array<Point, 3> facet = CornersOf(points, facets[nearest.Facet]);
    bool areNear = true;
    for (const Point& corner : piece.Corners)
    {
      if (!(Distance(NearestPointOf(facet, corner), corner) <= most))
      {
        if (!(distances.At(corner).Distance <= most))
        {
          return false;
        }
        areNear = false;
      }
    }
    if (!areNear)
    {
      const EdgeCut cut = ++piece.Cuts % CutsPerHalving == 0
        ? CutInTheMiddle(piece.Corners)
        : CutAtWall(piece.Corners, facet, InWall * most);
      const Point there = Between(piece.Corners[cut.From], piece.Corners[cut.To], cut.Part);
      pieces.insert(pieces.end(), 2, piece);
      pieces[pieces.size() - 2].Corners[cut.From] = there;
      pieces[pieces.size() - 1].Corners[cut.To] = there;
    }
  }
  return true;
}
} // namespace insideout
