// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terrain/TerrainProof.h"

#include "Common/DisjointSets.h"
#include "Common/PointPredicates.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** An edge of the border in the projection. */
struct SeenEdge
{
  BorderEdge Ids;
  PlanarPoint From;
  PlanarPoint To;
  PlanarPoint Low;
  PlanarPoint High;
};

std::vector<SeenEdge> See(
  const std::vector<Point>& points, const AxisView& view, const std::vector<BorderEdge>& border)
{
  std::vector<SeenEdge> seen;
  seen.reserve(border.size());
  for (const BorderEdge& edge : border)
  {
    const PlanarPoint from = view.Image(points[edge.From]);
    const PlanarPoint to = view.Image(points[edge.To]);
    seen.push_back({ edge, from, to, { std::min(from[0], to[0]), std::min(from[1], to[1]) },
      { std::max(from[0], to[0]), std::max(from[1], to[1]) } });
  }
  return seen;
}

/** Whether q and r lie in the same direction from p. */
bool AreInOneDirection(const PlanarPoint& p, const PlanarPoint& q, const PlanarPoint& r)
{
  const int axis = q[0] == p[0] ? 1 : 0;
  return Orient2D(p, q, r) == 0 && (q[axis] > p[axis] ? r[axis] > p[axis] : r[axis] < p[axis]);
}

/** Whether edges whose boxes meet have more in common than shared ends. */
bool MeetBeyondEnds(const SeenEdge& a, const SeenEdge& b)
{
  for (const bool atFrom : { true, false })
  {
    const Id end = atFrom ? a.Ids.From : a.Ids.To;
    if (end == b.Ids.From || end == b.Ids.To)
    {
      return AreInOneDirection(
        atFrom ? a.From : a.To, atFrom ? a.To : a.From, end == b.Ids.From ? b.To : b.From);
    }
  }
  return Orient2D(a.From, a.To, b.From) * Orient2D(a.From, a.To, b.To) <= 0 &&
    Orient2D(b.From, b.To, a.From) * Orient2D(b.From, b.To, a.To) <= 0;
}

bool MeetInSharedEndsOnly(std::vector<SeenEdge> edges)
{
  std::sort(edges.begin(), edges.end(),
    [](const SeenEdge& a, const SeenEdge& b) { return a.Low[0] < b.Low[0]; });
  for (auto a = edges.begin(); a != edges.end(); ++a)
  {
    for (auto b = a + 1; b != edges.end() && b->Low[0] <= a->High[0]; ++b)
    {
      if (a->Low[1] <= b->High[1] && b->Low[1] <= a->High[1] && MeetBeyondEnds(*a, *b))
      {
        return false;
      }
    }
  }
  return true;
}

/** An edge of the border at one of its ends. */
struct EdgeAtEnd
{
  Id End;
  Id Edge;
  bool Leaves;
};

std::vector<EdgeAtEnd> SortedByEnd(const std::vector<BorderEdge>& border)
{
  std::vector<EdgeAtEnd> ends;
  ends.reserve(2 * border.size());
  for (Id edge = 0; edge < static_cast<Id>(border.size()); ++edge)
  {
    ends.push_back({ border[edge].From, edge, true });
    ends.push_back({ border[edge].To, edge, false });
  }
  std::sort(
    ends.begin(), ends.end(), [](const EdgeAtEnd& a, const EdgeAtEnd& b) { return a.End < b.End; });
  return ends;
}

/**
 * Whether edges at one end, no two of which overlap, alternate around it between arriving and
 * leaving.
 */
bool TakeTurns(const std::vector<SeenEdge>& edges, EdgeAtEnd* first, EdgeAtEnd* last)
{
  if (last - first == 2)
  {
    return first[0].Leaves != first[1].Leaves;
  }
  const PlanarPoint centre = first->Leaves ? edges[first->Edge].From : edges[first->Edge].To;
  const auto isLower = [&](const PlanarPoint& p)
  { return p[1] < centre[1] || (p[1] == centre[1] && p[0] < centre[0]); };
  std::sort(first, last,
    [&](const EdgeAtEnd& a, const EdgeAtEnd& b)
    {
      const PlanarPoint& p = a.Leaves ? edges[a.Edge].To : edges[a.Edge].From;
      const PlanarPoint& q = b.Leaves ? edges[b.Edge].To : edges[b.Edge].From;
      return isLower(p) != isLower(q) ? isLower(q) : Orient2D(centre, p, q) > 0;
    });
  bool before = last[-1].Leaves;
  for (const EdgeAtEnd* at = first; at != last; ++at)
  {
    if (at->Leaves == before)
    {
      return false;
    }
    before = at->Leaves;
  }
  return true;
}

/** Whether all edges are connected through ends, and alternate there. */
bool IsOnePieceByTurns(const std::vector<BorderEdge>& border, const std::vector<SeenEdge>& edges)
{
  std::vector<EdgeAtEnd> ends = SortedByEnd(border);
  DisjointSets pieces(border.size());
  std::size_t count = border.size();
  EdgeAtEnd* const end = ends.data() + ends.size();
  for (EdgeAtEnd* first = ends.data(); first != end;)
  {
    EdgeAtEnd* last = first + 1;
    for (; last != end && last->End == first->End; ++last)
    {
      if (pieces.Find(last->Edge) != pieces.Find(first->Edge))
      {
        pieces.Join(last->Edge, first->Edge);
        --count;
      }
    }
    if (!TakeTurns(edges, first, last))
    {
      return false;
    }
    first = last;
  }
  return count == 1;
}
} // namespace

bool AxisView::ShowsFront(const std::vector<Point>& points, const Triangle& facet) const
{
  return Orient2D(this->Image(points[facet[0]]), this->Image(points[facet[1]]),
           this->Image(points[facet[2]])) > 0;
}

bool IsTerrain(
  const std::vector<Point>& points, const AxisView& view, const std::vector<BorderEdge>& border)
{
  const std::vector<SeenEdge> edges = See(points, view, border);
  return MeetInSharedEndsOnly(edges) && IsOnePieceByTurns(border, edges);
}
} // namespace insideout
