// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SurfacePieces.h"

#include "Common/Box.h"
#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "WindingNumber/HoleCaps.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace insideout
{
namespace
{
/** A facet of the surface, or a triangle of a cap. */
struct Part
{
  CountedTriangle Triangle;
  Id Facet; ///< of the surface; else one of those below
};
constexpr Id CapOfCut = -1;
// These close the surface, so that the edges of any part of it are whole loops. No piece keeps
// them.
constexpr Id CapOfHole = -2;

using FacetCount = std::numeric_limits<std::int16_t>;

class Cutter
{
public:
  Cutter(const FacetComplex& surface, Monitor& monitor)
    : Surface(surface)
    , Points(ScaledPoints(surface.Points, -LargestExponent(surface.Points)))
    , Progress(monitor)
    , Local(surface.Points.size(), None)
  {
  }

  std::vector<CountedPiece> Cut(Id pieces)
  {
    std::vector<Part> parts;
    for (Id f = 0; f < this->Surface.NumberOfFacets(); ++f)
    {
      parts.push_back({ { this->Surface.Facets[f], this->Surface.Multiplicity[f] }, f });
    }
    if (pieces > 1)
    {
      this->AddCaps(this->CapsToClose(parts), 1, CapOfHole, parts);
    }
    this->Cut(std::move(parts), pieces);
    return std::move(this->Pieces);
  }

private:
  using Key = std::pair<double, Id>; // no two facets have the same

  /** Three times the center. */
  Point CentreOf(const Part& part) const
  {
    Point centre = { 0, 0, 0 };
    for (const Id p : part.Triangle.Corners)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] += this->Points[p][axis];
      }
    }
    return centre;
  }

  Key KeyOf(const Part& part, int axis) const { return { this->CentreOf(part)[axis], part.Facet }; }

  /** The axis along which the facets' centers lie farthest apart. */
  int LongestAxis(const std::vector<Part>& parts) const
  {
    Box box = Box::Empty();
    for (const Part& part : parts)
    {
      if (part.Facet >= 0)
      {
        box.Add(this->CentreOf(part));
      }
    }
    return box.LongestAxis();
  }

  /** The key of the first facet of the second half, with `share` of all facets in the first. */
  Key Middle(const std::vector<Part>& parts, int axis, Id pieces, Id share) const
  {
    std::vector<Key> keys;
    for (const Part& part : parts)
    {
      if (part.Facet >= 0)
      {
        keys.push_back(this->KeyOf(part, axis));
      }
    }
    const auto middle = keys.begin() +
      static_cast<std::ptrdiff_t>(
        keys.size() * static_cast<std::size_t>(share) / static_cast<std::size_t>(pieces));
    std::nth_element(keys.begin(), middle, keys.end());
    return *middle;
  }

  void Cut(std::vector<Part> parts, Id pieces)
  {
    this->Progress.Check(Stages::WindingNumbers, 0);
    if (pieces == 1)
    {
      this->Pieces.push_back(this->PieceOf(std::move(parts)));
      return;
    }
    const Id share = pieces / 2;
    const int axis = this->LongestAxis(parts);
    const Key middle = this->Middle(parts, axis, pieces, share);
    const auto second = std::stable_partition(parts.begin(), parts.end(),
      [&](const Part& part) { return this->KeyOf(part, axis) < middle; });
    std::vector<Part> rest(second, parts.end());
    parts.erase(second, parts.end());
    const std::vector<CountedTriangle> caps = this->CapsToClose(parts);
    this->AddCaps(caps, 1, CapOfCut, parts);
    this->AddCaps(caps, -1, CapOfCut, rest);
    this->Cut(std::move(parts), share);
    this->Cut(std::move(rest), pieces - share);
  }

  /** Number the points of parts from 0, in `Local`. @return the ids of these points */
  std::vector<Id> NumberPoints(const std::vector<Part>& parts)
  {
    std::vector<Id> used;
    for (const Part& part : parts)
    {
      for (const Id p : part.Triangle.Corners)
      {
        if (this->Local[p] == None)
        {
          this->Local[p] = static_cast<Id>(used.size());
          used.push_back(p);
        }
      }
    }
    return used;
  }

  void ForgetNumbers(const std::vector<Id>& used)
  {
    for (const Id p : used)
    {
      this->Local[p] = None;
    }
  }

  Triangle LocalCorners(const Part& part) const
  {
    const Triangle& t = part.Triangle.Corners;
    return { { this->Local[t[0]], this->Local[t[1]], this->Local[t[2]] } };
  }

  /** The caps that leave the parts no boundary; each triangle once, with its count. */
  std::vector<CountedTriangle> CapsToClose(const std::vector<Part>& parts)
  {
    const std::vector<Id> used = this->NumberPoints(parts);
    std::vector<Point> points;
    points.reserve(used.size());
    for (const Id p : used)
    {
      points.push_back(this->Points[p]);
    }
    std::vector<CountedTriangle> triangles;
    for (const Part& part : parts)
    {
      if (part.Triangle.Count != 0)
      {
        triangles.push_back({ this->LocalCorners(part), part.Triangle.Count });
      }
    }
    this->ForgetNumbers(used);
    std::vector<CountedTriangle> caps =
      CloseChain({}, CapHoles(points, CountedBoundary(triangles, static_cast<Id>(points.size()))));
    for (CountedTriangle& cap : caps)
    {
      for (Id& p : cap.Corners)
      {
        p = used[p];
      }
    }
    return caps;
  }

  void AddCaps(
    const std::vector<CountedTriangle>& caps, int sign, Id what, std::vector<Part>& parts) const
  {
    for (const CountedTriangle& cap : caps)
    {
      parts.push_back({ { cap.Corners, sign * cap.Count }, what });
    }
  }

  /** @param[in] parts facets first, ascending, then caps */
  CountedPiece PieceOf(std::vector<Part> parts)
  {
    parts.erase(std::remove_if(parts.begin(), parts.end(),
                  [](const Part& part) { return part.Facet == CapOfHole; }),
      parts.end());
    CountedPiece piece;
    FacetComplex& surface = piece.Surface;
    const std::vector<Id> used = this->NumberPoints(parts);
    for (const Id p : used)
    {
      surface.Points.push_back(this->Surface.Points[p]);
    }
    for (const Part& part : parts)
    {
      int left = part.Triangle.Count; // for a cap, where many facets end, it may be any number
      do
      {
        const int count = std::clamp<int>(left, FacetCount::min(), FacetCount::max());
        surface.Facets.push_back(this->LocalCorners(part));
        surface.Multiplicity.push_back(static_cast<std::int16_t>(count));
        left -= count;
      } while (left != 0);
      if (part.Facet >= 0)
      {
        piece.WholeFacets.push_back(part.Facet);
      }
    }
    this->ForgetNumbers(used);
    return piece;
  }

  const FacetComplex& Surface;
  const std::vector<Point> Points; // scaled to below 1
  Monitor& Progress;
  std::vector<Id> Local; // per point; used for one set of parts at a time
  std::vector<CountedPiece> Pieces;
};
} // namespace

std::vector<CountedPiece> CutIntoPieces(
  const FacetComplex& surface, Id facetsPerPiece, Monitor& monitor)
{
  const Id full = surface.NumberOfFacets() / facetsPerPiece;
  const bool isMore = surface.NumberOfFacets() % facetsPerPiece > 0;
  return Cutter(surface, monitor).Cut(std::max(full + (isMore ? 1 : 0), 1));
}
} // namespace insideout
