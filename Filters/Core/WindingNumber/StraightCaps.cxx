// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/StraightCaps.h"

#include "Common/Buckets.h"
#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace insideout
{
namespace
{
// A double's or long double's rounding error times this bounds that of the height of a point over a
// triangle, against its edges and its distance from them.
constexpr long double RoundingErrors = 16;

/** Larger counts get no cap: a triangle is multiplied as often as its count. */
constexpr int MostCount = 4;

/** Input triangles that may get a cap, numbered from 0. */
struct Candidates
{
  std::vector<Id> OfFacet;   ///< per facet; None for none
  std::vector<Id> OpenEdges; ///< per candidate, of its facets
};

bool IsEdgeOf(const std::vector<CountedEdge>& boundary, Id from, Id to)
{
  const CountedEdge edge = { std::min(from, to), std::max(from, to), 0 };
  return std::binary_search(boundary.begin(), boundary.end(), edge,
    [](const CountedEdge& a, const CountedEdge& b)
    { return a.From != b.From ? a.From < b.From : a.To < b.To; });
}

/** How many edges of each facet are on the boundary. */
std::vector<char> OpenEdgesOf(const FacetComplex& surface, const std::vector<CountedEdge>& boundary)
{
  std::vector<char> isOpen(surface.Points.size(), 0);
  for (const CountedEdge& edge : boundary)
  {
    isOpen[edge.From] = isOpen[edge.To] = 1;
  }
  std::vector<char> open(surface.Facets.size(), 0);
  const double nanosecondsPerFacet = 100;
  ParallelLoop(open.size(), nanosecondsPerFacet,
    [&](std::size_t f)
    {
      const Triangle& corners = surface.Facets[f];
      for (int k = 0; k < 3; ++k)
      {
        const Id from = corners[k];
        const Id to = corners[(k + 1) % 3];
        open[f] += isOpen[from] && isOpen[to] && IsEdgeOf(boundary, from, to);
      }
    });
  return open;
}

/**
 * A triangle may get a cap if its facets belong to it alone and have one count, and at least two of
 * their edges are open: the least that a cap could save.
 */
Candidates FindCandidates(const FacetComplex& surface, const std::vector<CountedEdge>& boundary)
{
  Candidates found;
  found.OfFacet.assign(surface.Facets.size(), None);
  if (surface.Sources.empty())
  {
    return found;
  }
  const std::vector<char> open = OpenEdgesOf(surface, boundary);
  Id triangles = 0;
  for (const FacetSource& source : surface.Sources)
  {
    triangles = std::max(triangles, source.Triangle + 1);
  }
  struct Record
  {
    int Count = 0;
    Id OpenEdges = 0;
    bool IsOut = false;
  };
  std::vector<Record> records(static_cast<std::size_t>(triangles));
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Id first = surface.SourceOffsets[f];
    const Id last = surface.SourceOffsets[f + 1];
    for (Id s = first; s < last; ++s)
    {
      const FacetSource& source = surface.Sources[s];
      Record& record = records[source.Triangle];
      const int count = source.Reversed ? -surface.Multiplicity[f] : surface.Multiplicity[f];
      record.IsOut |= last - first > 1 || count == 0 || std::abs(count) > MostCount ||
        (record.Count != 0 && record.Count != count);
      record.Count = count;
      record.OpenEdges += open[f];
    }
  }
  std::vector<Id> number(records.size(), None);
  for (std::size_t t = 0; t < records.size(); ++t)
  {
    if (!records[t].IsOut && records[t].OpenEdges >= 2)
    {
      number[t] = static_cast<Id>(found.OpenEdges.size());
      found.OpenEdges.push_back(records[t].OpenEdges);
    }
  }
  for (Id f = 0; f < surface.NumberOfFacets() && !found.OpenEdges.empty(); ++f)
  {
    const Id first = surface.SourceOffsets[f];
    found.OfFacet[f] =
      first < surface.SourceOffsets[f + 1] ? number[surface.Sources[first].Triangle] : None;
  }
  return found;
}

/** Makes the cap of some pieces, if there is one. */
class CapMaker
{
public:
  CapMaker(const std::vector<Point>& points, Buckets<CountedTriangle>::Range pieces)
    : Points(points)
    , Pieces(pieces)
  {
  }

  /** @return whether a triangle can stand in for the pieces, with an outline mostly of open edges
   */
  bool Make(Id openEdges)
  {
    return this->FindOutline() && this->IsWorthwhile(openEdges) && this->FindCorners() &&
      this->IsClose() && this->MakeSlivers();
  }

  StraightCap Cap;
  std::vector<CountedTriangle> Slivers;

private:
  /** Whole triangles save nothing, unless nothing else remains. */
  bool IsWorthwhile(Id openEdges) const
  {
    const Id edges = static_cast<Id>(this->Outline.size());
    return this->Pieces.Size() > 1 ? 2 * openEdges >= edges : openEdges == edges;
  }

  bool FindOutline();
  bool FindCorners();
  bool IsClose();
  bool MakeSlivers();
  void FillBetween(const std::vector<Id>& line, std::size_t first, std::size_t last);

  const std::vector<Point>& Points;
  const Buckets<CountedTriangle>::Range Pieces;
  std::vector<std::pair<Id, Id>> Outline; ///< the next point of each point, sorted
  std::array<Point, 3> Corners;
  Point Normal;
};

/** The outline of pieces that have one orientation and one count. @return false otherwise */
bool CapMaker::FindOutline()
{
  if (this->Pieces.Size() == 0)
  {
    return false;
  }
  const int count = std::abs(this->Pieces.First->Count);
  std::vector<std::pair<Id, Id>> edges; // a half-edge and its opposite next to each other
  edges.reserve(3 * this->Pieces.Size());
  for (const CountedTriangle& piece : this->Pieces)
  {
    if (std::abs(piece.Count) != count)
    {
      return false;
    }
    for (int k = 0; k < 3; ++k)
    {
      const Id from = piece.Corners[k];
      const Id to = piece.Corners[(k + 1) % 3];
      edges.push_back(piece.Count > 0 ? std::make_pair(from, to) : std::make_pair(to, from));
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const std::pair<Id, Id>& a, const std::pair<Id, Id>& b)
    {
      const Id lowA = std::min(a.first, a.second), lowB = std::min(b.first, b.second);
      return lowA != lowB ? lowA < lowB : a.first + a.second - lowA < b.first + b.second - lowB;
    });
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next)
  {
    const auto [from, to] = edges[first];
    int sum = 0;
    for (; next < edges.size() &&
         std::minmax(edges[next].first, edges[next].second) == std::minmax(from, to);
         ++next)
    {
      sum += edges[next].first == from ? 1 : -1;
    }
    if (std::abs(sum) > 1)
    {
      return false;
    }
    if (sum != 0)
    {
      this->Outline.push_back(sum > 0 ? std::make_pair(from, to) : std::make_pair(to, from));
    }
  }
  std::sort(this->Outline.begin(), this->Outline.end());
  this->Cap.Whole.Count = count;
  return this->Outline.size() >= 3;
}

/** The outline's point that maximizes some measure. */
template <typename Edges, typename Measure>
Id Farthest(const Edges& outline, const Measure& measure)
{
  Id farthest = outline.front().first;
  double most = -1;
  for (const auto& edge : outline)
  {
    const double here = measure(edge.first);
    if (here > most)
    {
      most = here;
      farthest = edge.first;
    }
  }
  return farthest;
}

/** The corners of the outline, taken as a triangle. */
bool CapMaker::FindCorners()
{
  const auto from = [this](const Point& p)
  {
    return [this, p](Id i)
    {
      const Point d = Difference(this->Points[i], p);
      return Dot(d, d);
    };
  };
  const Id a = Farthest(this->Outline, from(this->Points[this->Outline.front().first]));
  const Id b = Farthest(this->Outline, from(this->Points[a]));
  const Id c = Farthest(this->Outline,
    [&](Id i)
    {
      const Point normal = NormalOf(this->Points[a], this->Points[b], this->Points[i]);
      return Dot(normal, normal);
    });
  Point sum = { 0, 0, 0 };
  for (const CountedTriangle& piece : this->Pieces)
  {
    const auto [p, q, r] = CornersOf(this->Points, piece.Corners);
    const Point normal = NormalOf(p, q, r);
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += piece.Count > 0 ? normal[axis] : -normal[axis];
    }
  }
  Triangle& corners = this->Cap.Whole.Corners;
  corners = { a, b, c };
  if (Dot(sum, NormalOf(this->Points[a], this->Points[b], this->Points[c])) < 0)
  {
    corners = { a, c, b };
  }
  this->Corners = CornersOf(this->Points, corners);
  this->Normal = NormalOf(this->Corners[0], this->Corners[1], this->Corners[2]);
  return !IsDegenerate(this->Points, corners);
}

/** Whether all pieces are near the triangle; sets their height above it. */
bool CapMaker::IsClose()
{
  const double area = Length(this->Normal);
  std::array<Point, 3> inward;
  double leastSine = 1;
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    const Point edge = Difference(this->Corners[(k + 1) % 3], this->Corners[k]);
    const Point other = Difference(this->Corners[(k + 2) % 3], this->Corners[k]);
    inward[k] = Cross(this->Normal, edge);
    for (double& x : inward[k])
    {
      x /= area * Length(edge);
    }
    leastSine = std::min(leastSine, area / (Length(edge) * Length(other)));
    longest = std::max(longest, Length(edge));
  }
  Vector<long double> unit;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    const auto& [a, b, c] = this->Corners;
    unit[axis] =
      ((static_cast<long double>(b[j]) - a[j]) * (static_cast<long double>(c[k]) - a[k]) -
        (static_cast<long double>(b[k]) - a[k]) * (static_cast<long double>(c[j]) - a[j])) /
      area;
  }
  long double height = 0;
  double outside = 0;
  for (const CountedTriangle& piece : this->Pieces)
  {
    for (const Id p : piece.Corners)
    {
      const Point& point = this->Points[p];
      long double above = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        above += unit[axis] * (static_cast<long double>(point[axis]) - this->Corners[0][axis]);
      }
      height = std::max(height, std::abs(above));
      for (int k = 0; k < 3; ++k)
      {
        outside = std::max(outside, Dot(inward[k], Difference(this->Corners[k], point)));
      }
    }
  }
  height += RoundingErrors * std::numeric_limits<long double>::epsilon() * longest / leastSine;
  this->Cap.Height = static_cast<double>(height) * (1 + 0x1p-40);
  // At a corner the distance may exceed the distances from both sides.
  return 4 * (this->Cap.Height + outside) < ReachOfStraightCap * leastSine;
}

/** Add slivers between the sides and the outline, which has to run along them. */
bool CapMaker::MakeSlivers()
{
  std::vector<char> isUsed(this->Outline.size(), 0);
  std::size_t used = 0;
  for (int k = 0; k < 3; ++k)
  {
    const Id end = this->Cap.Whole.Corners[(k + 1) % 3];
    const Point& origin = this->Corners[k];
    const Point side = Difference(this->Corners[(k + 1) % 3], origin);
    std::vector<Id> line = { this->Cap.Whole.Corners[k] };
    while (line.back() != end)
    {
      const auto edge = std::lower_bound(
        this->Outline.begin(), this->Outline.end(), std::make_pair(line.back(), None));
      const std::size_t i = static_cast<std::size_t>(edge - this->Outline.begin());
      if (edge == this->Outline.end() || edge->first != line.back() || isUsed[i] ||
        Length(Cross(side, Difference(this->Points[edge->second], origin))) >
          ReachOfStraightCap * Length(side))
      {
        return false;
      }
      isUsed[i] = 1;
      ++used;
      line.push_back(edge->second);
    }
    this->FillBetween(line, 0, line.size() - 1);
  }
  return used == this->Outline.size();
}

/** Add slivers between a polyline and its chord, by recursive bisection, so that most slivers are
 * short. */
void CapMaker::FillBetween(const std::vector<Id>& line, std::size_t first, std::size_t last)
{
  if (last - first < 2)
  {
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  const Triangle sliver = { line[first], line[middle], line[last] };
  if (!IsDegenerate(this->Points, sliver))
  {
    this->Slivers.push_back({ sliver, this->Cap.Whole.Count });
  }
  this->FillBetween(line, first, middle);
  this->FillBetween(line, middle, last);
}
} // namespace

StraightCaps FindStraightCaps(const FacetComplex& surface, const std::vector<Point>& points,
  const ChainOfFacets& chain, const std::vector<CountedEdge>& boundary)
{
  StraightCaps result;
  const Candidates candidates = FindCandidates(surface, boundary);
  const std::size_t number = candidates.OpenEdges.size();
  result.HasCap.assign(surface.Facets.size(), 0);
  const Buckets<CountedTriangle> pieces(number,
    [&](auto visit)
    {
      for (std::size_t i = 0; i < chain.Triangles.size(); ++i)
      {
        const Id candidate = candidates.OfFacet[chain.Facets[i]];
        if (candidate != None)
        {
          visit(static_cast<std::size_t>(candidate), chain.Triangles[i]);
        }
      }
    });
  struct Made
  {
    bool IsTaken;
    StraightCap Cap;
    std::vector<CountedTriangle> Slivers;
  };
  std::vector<Made> made(number);
  const double nanosecondsPerPiece = 1000;
  ParallelLoop(number,
    nanosecondsPerPiece * static_cast<double>(chain.Triangles.size()) /
      static_cast<double>(std::max<std::size_t>(number, 1)),
    [&](std::size_t i)
    {
      CapMaker maker(points, pieces[i]);
      const bool isTaken = maker.Make(candidates.OpenEdges[i]);
      made[i] = { isTaken, maker.Cap, std::move(maker.Slivers) };
    });
  for (std::size_t i = 0; i < number; ++i)
  {
    if (!made[i].IsTaken)
    {
      continue;
    }
    StraightCap cap = made[i].Cap;
    cap.FirstPiece = result.Pieces.size();
    cap.FirstSliver = result.Slivers.size();
    result.Pieces.insert(result.Pieces.end(), pieces[i].begin(), pieces[i].end());
    result.Slivers.insert(result.Slivers.end(), made[i].Slivers.begin(), made[i].Slivers.end());
    cap.LastPiece = result.Pieces.size();
    cap.LastSliver = result.Slivers.size();
    result.Caps.push_back(cap);
  }
  const auto hasCap = [&](Id facet)
  { return candidates.OfFacet[facet] != None && made[candidates.OfFacet[facet]].IsTaken; };
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    result.HasCap[f] = hasCap(f);
  }
  for (std::size_t i = 0; i < chain.Triangles.size(); ++i)
  {
    if (!result.HasCap[chain.Facets[i]])
    {
      result.Rest.push_back(chain.Triangles[i]);
    }
  }
  return result;
}
} // namespace insideout
