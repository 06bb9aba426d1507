// SPDX-License-Identifier: GPL-3.0-or-later
#include "CutFacets.h"

#include "TrianglePredicates.h"

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
/** What two facets have in common: an area of their plane, or a segment. */
struct Meeting
{
  bool Overlap = false;
  ConstructedPoint First;
  ConstructedPoint Last;
  bool InPlane = false; ///< whether both lie in one plane
};

/** The pair of facets whose meeting is looked for. */
class Pair
{
public:
  Pair(const FacetList& surface, const std::array<Id, 2>& facets)
    : Surface(surface)
    , Facets(facets)
  {
    for (int i = 0; i < 2; ++i)
    {
      const Triangle& corners = surface.Facets[facets[i]];
      for (int k = 0; k < 3; ++k)
      {
        const Point& p = surface.Points[corners[k]];
        this->Corners[i][k] = FilteredPoint(p[0], p[1], p[2]);
      }
    }
  }

  Meeting Meet() const;

private:
  using Ends = std::array<LazyPoint, 2>;

  Ends Span(const std::vector<ConstructedPoint>& points) const;
  Ends SectionWithOther(int which, const std::array<int, 3>& sides) const;
  Ends TouchInPlane() const;

  const FacetList& Surface;
  std::array<Id, 2> Facets;
  std::array<FilteredTriangle, 2> Corners;
};

/** The first and the last of points on a line. */
Pair::Ends Pair::Span(const std::vector<ConstructedPoint>& points) const
{
  const Point& origin = this->Surface.Points[this->Surface.Facets[this->Facets[0]][0]];
  const LazyPoint point(points[0], this->Surface, origin);
  Ends ends{ { point, point } };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const LazyPoint next(points[i], this->Surface, origin);
    if (Compare(next, ends[0]) < 0)
    {
      ends[0] = next;
    }
    else if (Compare(next, ends[1]) > 0)
    {
      ends[1] = next;
    }
  }
  return ends;
}

/** The part of one facet in the plane of the other, which is not its own; its corners lie on these
 * sides of that plane. */
Pair::Ends Pair::SectionWithOther(int which, const std::array<int, 3>& sides) const
{
  const Triangle& corners = this->Surface.Facets[this->Facets[which]];
  std::vector<ConstructedPoint> section;
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (sides[k] == 0)
    {
      section.push_back(ConstructedPoint::Corner(corners[k]));
    }
    else if (sides[k] * sides[next] < 0)
    {
      section.push_back(
        ConstructedPoint::EdgeOnFacet({ { corners[k], corners[next] } }, this->Facets[1 - which]));
    }
  }
  return this->Span(section);
}

/** The contact of two facets of one plane that have no area in common: it lies on an edge of each,
 * so its ends are corners. */
Pair::Ends Pair::TouchInPlane() const
{
  std::vector<ConstructedPoint> common;
  for (int i = 0; i < 2; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (ContainsInPlane(this->Corners[1 - i], this->Corners[i][k]))
      {
        common.push_back(ConstructedPoint::Corner(this->Surface.Facets[this->Facets[i]][k]));
      }
    }
  }
  return this->Span(common);
}

Meeting Pair::Meet() const
{
  const std::array<int, 3> sides = SidesOfPlane(this->Corners[0], this->Corners[1]);
  Meeting meeting;
  meeting.InPlane = sides[0] == 0 && sides[1] == 0 && sides[2] == 0;
  if (!meeting.InPlane)
  {
    const Ends p = this->SectionWithOther(0, SidesOfPlane(this->Corners[1], this->Corners[0]));
    const Ends q = this->SectionWithOther(1, sides);
    meeting.First = (Compare(p[0], q[0]) < 0 ? q[0] : p[0]).Name();
    meeting.Last = (Compare(p[1], q[1]) < 0 ? p[1] : q[1]).Name();
  }
  else if (OverlapInPlane(this->Corners[0], this->Corners[1]))
  {
    meeting.Overlap = true;
  }
  else
  {
    const Ends touch = this->TouchInPlane();
    meeting.First = touch[0].Name();
    meeting.Last = touch[1].Name();
  }
  return meeting;
}

/** Union-find in which the lowest member represents its group. */
class Groups
{
public:
  explicit Groups(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  Id Find(Id i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }

  void Join(Id i, Id j)
  {
    const Id a = this->Find(i);
    const Id b = this->Find(j);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<Id> Parents;
};

/** Facets of one plane and where others meet them. */
struct Group
{
  std::vector<Id> Facets;
  std::vector<Cut> Cuts;
};

std::vector<Group> MakeGroups(std::size_t numberOfFacets,
  const std::vector<std::array<Id, 2>>& pairs, const std::vector<Meeting>& meetings)
{
  Groups groups(numberOfFacets);
  std::vector<char> involved(numberOfFacets, 0);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    involved[pairs[i][0]] = involved[pairs[i][1]] = 1;
    if (meetings[i].Overlap)
    {
      groups.Join(pairs[i][0], pairs[i][1]);
    }
  }

  std::vector<Group> result;
  std::vector<Id> groupOf(numberOfFacets, None);
  for (Id f = 0; f < static_cast<Id>(numberOfFacets); ++f)
  {
    if (involved[f])
    {
      const Id root = groups.Find(f);
      if (root == f)
      {
        groupOf[f] = static_cast<Id>(result.size());
        result.emplace_back();
      }
      groupOf[f] = groupOf[root];
      result[groupOf[f]].Facets.push_back(f);
    }
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const Meeting& meeting = meetings[i];
    if (!meeting.Overlap)
    {
      for (int k = 0; k < 2; ++k)
      {
        const Id other = meeting.InPlane ? None : pairs[i][1 - k];
        result[groupOf[pairs[i][k]]].Cuts.push_back({ meeting.First, meeting.Last, other });
      }
    }
  }
  return result;
}
} // namespace

std::vector<PlanarSubdivision> CutFacets(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress)
{
  const double middle = (progress.Begin + progress.End) / 2;
  std::vector<Meeting> meetings(pairs.size());
  ParallelLoop(static_cast<Id>(pairs.size()), monitor, { progress.Stage, progress.Begin, middle },
    [&](Id i) { meetings[i] = Pair(surface, pairs[i]).Meet(); });

  const std::vector<Group> groups = MakeGroups(surface.Facets.size(), pairs, meetings);
  std::vector<PlanarSubdivision> subdivisions(groups.size());
  ParallelLoop(static_cast<Id>(groups.size()), monitor, { progress.Stage, middle, progress.End },
    [&](Id i) { subdivisions[i] = SubdividePlane(surface, groups[i].Facets, groups[i].Cuts); });
  return subdivisions;
}
} // namespace insideout
