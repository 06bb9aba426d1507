// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/AgreeOnSides.h"

#include "Common/DisjointSets.h"
#include "Output/BoundaryTriangles.h"
#include "Validate/FacetEdges.h"
#include "Validate/MergePoints.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace insideout
{
namespace
{
/** 1 if a region is behind a triangle, -1 if it is in front of it, 0 if it is neither. */
int SideOf(Id region, const Sides& sides)
{
  return sides[0] == region ? 1 : sides[1] == region ? -1 : 0;
}

/** The triangles that agree: the given ones, and a copy of each that represents it turned over. */
class Agreements
{
public:
  explicit Agreements(Id triangles)
    : Count(triangles)
    , Sets(2 * static_cast<std::size_t>(triangles))
  {
  }

  /** Join two triangles, unless they are known to disagree. */
  void Join(Id a, Id b, bool turned)
  {
    const Id other = turned ? b + this->Count : b;
    const Id opposite = turned ? b : b + this->Count;
    if (this->Sets.Find(a) != this->Sets.Find(opposite))
    {
      this->Sets.Join(a, other);
      this->Sets.Join(a + this->Count, opposite);
    }
  }

  /** The lowest triangle with which one agrees, as it is or turned over. */
  Id LowestOf(Id triangle)
  {
    return std::min(this->Sets.Find(triangle), this->Sets.Find(triangle + this->Count));
  }

  /** Whether it agrees with that one only when turned over. */
  bool IsTurned(Id triangle)
  {
    return this->Sets.Find(triangle) > this->Sets.Find(triangle + this->Count);
  }

private:
  Id Count;
  DisjointSets Sets;
};

/** Join the triangles at an edge that are the only two there that bound some region. */
void JoinAtEdge(const FacetEdge* first, const FacetEdge* last, const std::vector<Sides>& sides,
  Agreements& agreements)
{
  for (const FacetEdge* a = first; a != last; ++a)
  {
    for (const Id region : sides[a->Facet])
    {
      const auto isBeside = [&](const FacetEdge& edge)
      { return SideOf(region, sides[edge.Facet]) != 0; };
      const FacetEdge* b = std::find_if(a + 1, last, isBeside);
      if (b != last && std::count_if(first, last, isBeside) == 2)
      {
        // A region's triangles, turned outward, run opposite ways along an edge.
        const int ways = a->Direction * SideOf(region, sides[a->Facet]) * b->Direction *
          SideOf(region, sides[b->Facet]);
        agreements.Join(a->Facet, b->Facet, ways > 0);
      }
    }
  }
}

/** A group of agreeing triangles and its regions. */
struct Group
{
  std::vector<Id> Triangles;
  std::map<Id, std::vector<BoundaryTriangle>> Around; ///< per region, its triangles, turned outward
  Id Turned = 0;
};

/** Whether a group is to be turned over as a whole. */
bool IsInsideOut(const Group& group, const std::vector<Point>& points)
{
  if (group.Around.size() < 3)
  {
    return 2 * group.Turned > static_cast<Id>(group.Triangles.size());
  }
  double outer = 0;
  for (const auto& [region, triangles] : group.Around)
  {
    const double volume = VolumeWithin(points, triangles);
    outer = std::abs(volume) > std::abs(outer) ? volume : outer;
  }
  return outer > 0; // the outermost is as large as all others together, and negative
}
} // namespace

std::vector<unsigned char> AgreeOnSides(const TriangleSoup& soup, const std::vector<Sides>& sides)
{
  const std::vector<Id> place = MergePoints(soup.Points, 0);
  std::vector<Triangle> triangles = soup.Triangles;
  for (Triangle& triangle : triangles)
  {
    for (Id& corner : triangle)
    {
      corner = place[corner];
    }
  }
  const Id count = static_cast<Id>(triangles.size());
  Agreements agreements(count);
  const FacetEdges edges = SortedFacetEdges(triangles);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    { JoinAtEdge(first, last, sides, agreements); });

  std::map<Id, Group> groups;
  for (Id t = 0; t < count; ++t)
  {
    Group& group = groups[agreements.LowestOf(t)];
    const bool isTurned = agreements.IsTurned(t);
    group.Triangles.push_back(t);
    group.Turned += isTurned;
    const auto [a, b, c] = triangles[t];
    for (const Id region : sides[t])
    {
      const bool isReversed = isTurned != (SideOf(region, sides[t]) < 0);
      group.Around[region].push_back({ isReversed ? Triangle{ { a, c, b } } : triangles[t], t });
    }
  }
  std::vector<unsigned char> turned(triangles.size(), 0);
  for (const auto& [lowest, group] : groups)
  {
    const bool isInsideOut = IsInsideOut(group, soup.Points);
    for (const Id t : group.Triangles)
    {
      turned[t] = agreements.IsTurned(t) != isInsideOut;
    }
  }
  return turned;
}
} // namespace insideout
