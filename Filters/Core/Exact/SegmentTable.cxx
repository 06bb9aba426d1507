// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SegmentTable.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <tuple>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerSide = 10;   ///< for entering an edge of a facet
constexpr double NanosecondsPerVertex = 60; ///< for sorting the edges whose lower end it is
} // namespace

SegmentTable::SegmentTable(const std::vector<Triangle>& facets)
{
  const auto given = std::make_shared<GivenEdges>();
  const auto endsOf = [&facets](std::size_t side)
  {
    const Triangle& facet = facets[side / 3];
    const auto ends = std::minmax(facet[side % 3], facet[(side + 1) % 3]);
    return std::array<Id, 2>{ { ends.first, ends.second } };
  };
  std::size_t vertices = 0;
  for (const Triangle& facet : facets)
  {
    for (const Id corner : facet)
    {
      vertices = std::max(vertices, static_cast<std::size_t>(corner) + 1);
    }
  }
  struct Side
  {
    Id HigherEnd;
    std::size_t Number;
  };
  Buckets<Side> sides = Buckets<Side>::Unordered(vertices, 3 * facets.size(), NanosecondsPerSide,
    [&](std::size_t number, const auto& visit)
    {
      const std::array<Id, 2> ends = endsOf(number);
      visit(static_cast<std::size_t>(ends[0]), Side{ ends[1], number });
    });
  // The first edge between two vertices determines the segment's number.
  std::vector<std::size_t> first(3 * facets.size()); // per side, the first side of the same edge
  ParallelLoop(vertices, NanosecondsPerVertex,
    [&](std::size_t vertex)
    {
      sides.Sort(vertex,
        [](const Side& a, const Side& b)
        { return std::tie(a.HigherEnd, a.Number) < std::tie(b.HigherEnd, b.Number); });
      Side last = { None, 0 };
      for (const Side& side : sides[vertex])
      {
        last = side.HigherEnd == last.HigherEnd ? last : side;
        first[side.Number] = last.Number;
      }
    });
  given->OfFacets.resize(facets.size());
  const auto segmentOf = [&given](std::size_t side) -> Id&
  { return given->OfFacets[side / 3][side % 3]; };
  for (std::size_t number = 0; number < first.size(); ++number)
  {
    if (first[number] == number)
    {
      segmentOf(number) = static_cast<Id>(given->Ends.size());
      given->Ends.push_back(endsOf(number));
    }
    segmentOf(number) = segmentOf(first[number]);
  }
  given->ByLowerEnd = Buckets<HigherEnd>::Unordered(vertices, vertices, NanosecondsPerVertex,
    [&](std::size_t vertex, const auto& visit)
    {
      for (const Side& side : sides[vertex])
      {
        if (first[side.Number] == side.Number)
        {
          visit(vertex, HigherEnd{ side.HigherEnd, segmentOf(side.Number) });
        }
      }
    });
  this->IsWhole.assign(given->Ends.size(), 1);
  this->Given = given;
}

std::uint64_t SegmentTable::Key(Id u, Id v)
{
  return static_cast<std::uint64_t>(std::min(u, v)) << 32 |
    static_cast<std::uint64_t>(std::max(u, v));
}

Id SegmentTable::Find(Id u, Id v) const
{
  const Id vertices = static_cast<Id>(this->Given->ByLowerEnd.Size());
  if (u >= vertices || v >= vertices)
  {
    const auto piece = this->OfPiece.find(Key(u, v));
    return piece == this->OfPiece.end() ? None : piece->second;
  }
  const auto ends = this->Given->ByLowerEnd[static_cast<std::size_t>(std::min(u, v))];
  const HigherEnd* const found = std::lower_bound(ends.begin(), ends.end(), std::max(u, v),
    [](const HigherEnd& end, Id vertex) { return end.Vertex < vertex; });
  return found != ends.end() && found->Vertex == std::max(u, v) && this->IsWhole[found->Segment]
    ? found->Segment
    : None;
}

Id SegmentTable::Around(Id steiner) const
{
  const auto found = this->OfPoint.find(steiner);
  return found == this->OfPoint.end() ? None : found->second;
}

std::vector<Id> SegmentTable::Path(Id segment) const
{
  std::vector<Id> path(1, this->EndsOf(segment)[0]);
  const auto inner = this->Inner.find(segment);
  if (inner != this->Inner.end())
  {
    path.insert(path.end(), inner->second.begin(), inner->second.end());
  }
  path.push_back(this->EndsOf(segment)[1]);
  return path;
}

void SegmentTable::Split(Id segment, Id u, Id v, Id steiner)
{
  const std::vector<Id> path = this->Path(segment);
  const auto at =
    std::min(std::find(path.begin(), path.end(), u), std::find(path.begin(), path.end(), v));
  std::vector<Id>& inner = this->Inner[segment];
  inner.insert(inner.begin() + (at - path.begin()), steiner);
  this->OfPoint[steiner] = segment;
  this->IsWhole[segment] = 0;
  this->OfPiece.erase(Key(u, v));
  this->OfPiece[Key(u, steiner)] = segment;
  this->OfPiece[Key(steiner, v)] = segment;
}

void SegmentTable::Join(Id segment, Id steiner)
{
  const std::array<Id, 2> ends = this->NeighborsOnPath(segment, steiner);
  std::vector<Id>& inner = this->Inner[segment];
  inner.erase(std::find(inner.begin(), inner.end(), steiner));
  this->OfPoint.erase(steiner);
  this->OfPiece.erase(Key(ends[0], steiner));
  this->OfPiece.erase(Key(steiner, ends[1]));
  if (!inner.empty())
  {
    this->OfPiece[Key(ends[0], ends[1])] = segment;
    return;
  }
  this->Inner.erase(segment);
  this->IsWhole[segment] = 1;
}

void SegmentTable::Release(Id segment)
{
  this->IsWhole[segment] = 0;
  const auto inner = this->Inner.find(segment);
  if (inner == this->Inner.end())
  {
    return;
  }
  const std::vector<Id> path = this->Path(segment);
  for (std::size_t k = 1; k < path.size(); ++k)
  {
    this->OfPiece.erase(Key(path[k - 1], path[k]));
    this->OfPoint.erase(path[k]);
  }
  this->Inner.erase(inner);
}

void SegmentTable::Restore(Id segment)
{
  this->IsWhole[segment] = this->Inner.count(segment) == 0 ? 1 : 0;
}

std::array<Id, 2> SegmentTable::NeighborsOnPath(Id segment, Id steiner) const
{
  const std::vector<Id> path = this->Path(segment);
  const auto at = std::find(path.begin(), path.end(), steiner);
  return { { *(at - 1), *(at + 1) } };
}
} // namespace insideout
