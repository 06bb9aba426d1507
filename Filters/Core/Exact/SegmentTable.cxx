// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SegmentTable.h"

#include <algorithm>

namespace insideout
{
SegmentTable::SegmentTable(const std::vector<Triangle>& facets)
{
  this->OfEdge.reserve(2 * facets.size());
  this->Segments.reserve(facets.size());
  for (const Triangle& facet : facets)
  {
    std::array<Id, 3> segments;
    for (int k = 0; k < 3; ++k)
    {
      const Id u = facet[k];
      const Id v = facet[(k + 1) % 3];
      const std::array<Id, 2> ends = { { std::min(u, v), std::max(u, v) } };
      const auto inserted = this->OfEdge.insert({ Key(ends[0], ends[1]), this->Size() });
      if (inserted.second)
      {
        this->Ends.push_back(ends);
      }
      segments[k] = inserted.first->second;
    }
    this->Segments.push_back(segments);
  }
}

std::uint64_t SegmentTable::Key(Id u, Id v)
{
  return static_cast<std::uint64_t>(std::min(u, v)) << 32 |
    static_cast<std::uint64_t>(std::max(u, v));
}

Id SegmentTable::Find(Id u, Id v) const
{
  const auto found = this->OfEdge.find(Key(u, v));
  return found == this->OfEdge.end() ? None : found->second;
}

std::vector<Id> SegmentTable::Path(Id segment) const
{
  std::vector<Id> path(1, this->Ends[segment][0]);
  const auto inner = this->Inner.find(segment);
  if (inner != this->Inner.end())
  {
    path.insert(path.end(), inner->second.begin(), inner->second.end());
  }
  path.push_back(this->Ends[segment][1]);
  return path;
}

void SegmentTable::Split(Id segment, Id u, Id v, Id steiner)
{
  const std::vector<Id> path = this->Path(segment);
  const auto at =
    std::min(std::find(path.begin(), path.end(), u), std::find(path.begin(), path.end(), v));
  std::vector<Id>& inner = this->Inner[segment];
  inner.insert(inner.begin() + (at - path.begin()), steiner);
  this->OfEdge.erase(Key(u, v));
  this->OfEdge[Key(u, steiner)] = segment;
  this->OfEdge[Key(steiner, v)] = segment;
}

void SegmentTable::Join(Id segment, Id steiner)
{
  const std::array<Id, 2> ends = this->NeighborsOnPath(segment, steiner);
  std::vector<Id>& inner = this->Inner[segment];
  inner.erase(std::find(inner.begin(), inner.end(), steiner));
  if (inner.empty())
  {
    this->Inner.erase(segment);
  }
  this->OfEdge.erase(Key(ends[0], steiner));
  this->OfEdge.erase(Key(steiner, ends[1]));
  this->OfEdge[Key(ends[0], ends[1])] = segment;
}

void SegmentTable::Release(Id segment)
{
  const std::vector<Id> path = this->Path(segment);
  for (std::size_t k = 1; k < path.size(); ++k)
  {
    this->OfEdge.erase(Key(path[k - 1], path[k]));
  }
  this->Inner.erase(segment);
}

void SegmentTable::Restore(Id segment)
{
  const std::array<Id, 2>& ends = this->Ends[segment];
  if (this->Inner.count(segment) == 0)
  {
    this->OfEdge[Key(ends[0], ends[1])] = segment;
  }
}

std::array<Id, 2> SegmentTable::NeighborsOnPath(Id segment, Id steiner) const
{
  const std::vector<Id> path = this->Path(segment);
  const auto at = std::find(path.begin(), path.end(), steiner);
  return { { *(at - 1), *(at + 1) } };
}
} // namespace insideout
