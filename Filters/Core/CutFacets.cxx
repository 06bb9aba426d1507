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
  ExactSegment Segment;
};

/** A facet with its corners in both kernels. */
struct Facet
{
  Facet(const std::vector<Point>& points, const Triangle& triangle)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Point& p = points[triangle[k]];
      this->Corners[k] = FilteredPoint(p[0], p[1], p[2]);
      this->Exact[k] = ToExact(p);
    }
  }

  FilteredTriangle Corners;
  std::array<ExactPoint, 3> Exact;
};

/** The ends of points on a line. */
ExactSegment Span(const std::vector<ExactPoint>& points)
{
  const auto ends =
    std::minmax_element(points.begin(), points.end(), CGAL::Less<ExactPoint, ExactPoint>());
  return { *ends.first, *ends.second };
}

/** Six times the signed volume of the tetrahedron over the facet: linear in the apex. */
ExactNumber Height(const Facet& facet, const ExactPoint& apex)
{
  return CGAL::determinant(
    facet.Exact[1] - facet.Exact[0], facet.Exact[2] - facet.Exact[0], apex - facet.Exact[0]);
}

/** The part of `facet` in the plane of `other`, which is not the facet's own. */
ExactSegment SectionWithPlane(const Facet& facet, const Facet& other)
{
  const std::array<int, 3> sides = SidesOfPlane(other.Corners, facet.Corners);
  std::vector<ExactPoint> section;
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (sides[k] == 0)
    {
      section.push_back(facet.Exact[k]);
    }
    else if (sides[k] * sides[next] < 0)
    {
      const ExactPoint& p = facet.Exact[k];
      const ExactPoint& q = facet.Exact[next];
      section.push_back(ZeroBetween(p, Height(other, p), q, Height(other, q)));
    }
  }
  return Span(section);
}

ExactSegment MeetInSpace(const Facet& a, const Facet& b)
{
  const ExactSegment p = SectionWithPlane(a, b);
  const ExactSegment q = SectionWithPlane(b, a);
  return { CGAL::max(p.First, q.First), CGAL::min(p.Last, q.Last) };
}

/** The contact of two facets of one plane that have no area in common: it lies on an edge of each,
 * so its ends are corners. */
ExactSegment TouchInPlane(const Facet& a, const Facet& b)
{
  std::vector<ExactPoint> common;
  for (int k = 0; k < 3; ++k)
  {
    if (ContainsInPlane(a.Corners, b.Corners[k]))
    {
      common.push_back(b.Exact[k]);
    }
    if (ContainsInPlane(b.Corners, a.Corners[k]))
    {
      common.push_back(a.Exact[k]);
    }
  }
  return Span(common);
}

Meeting Meet(const Facet& a, const Facet& b)
{
  const std::array<int, 3> sides = SidesOfPlane(a.Corners, b.Corners);
  Meeting meeting;
  if (sides[0] != 0 || sides[1] != 0 || sides[2] != 0)
  {
    meeting.Segment = MeetInSpace(a, b);
  }
  else if (OverlapInPlane(a.Corners, b.Corners))
  {
    meeting.Overlap = true;
  }
  else
  {
    meeting.Segment = TouchInPlane(a, b);
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

/** Facets of one plane and the segments in which others meet them. */
struct Group
{
  std::vector<Id> Facets;
  std::vector<const ExactSegment*> Segments;
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
    if (!meetings[i].Overlap)
    {
      result[groupOf[pairs[i][0]]].Segments.push_back(&meetings[i].Segment);
      result[groupOf[pairs[i][1]]].Segments.push_back(&meetings[i].Segment);
    }
  }
  return result;
}

PlanarSubdivision Cut(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, const Group& group)
{
  std::vector<std::array<Point, 3>> triangles;
  for (const Id f : group.Facets)
  {
    const Triangle& corners = facets[f];
    triangles.push_back({ points[corners[0]], points[corners[1]], points[corners[2]] });
  }
  std::vector<ExactSegment> segments;
  for (const ExactSegment* segment : group.Segments)
  {
    segments.push_back(*segment);
  }
  PlanarSubdivision subdivision = SubdividePlane(triangles, segments);
  for (Piece& piece : subdivision.Pieces)
  {
    for (PieceSource& source : piece.Sources)
    {
      source.Facet = group.Facets[source.Facet];
    }
  }
  return subdivision;
}
} // namespace

std::vector<PlanarSubdivision> CutFacets(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<std::array<Id, 2>>& pairs,
  Monitor& monitor, const ProgressRange& progress)
{
  const double middle = (progress.Begin + progress.End) / 2;
  std::vector<Meeting> meetings(pairs.size());
  ParallelLoop(static_cast<Id>(pairs.size()), monitor, { progress.Stage, progress.Begin, middle },
    [&](Id i) {
      meetings[i] = Meet(Facet(points, facets[pairs[i][0]]), Facet(points, facets[pairs[i][1]]));
    });

  const std::vector<Group> groups = MakeGroups(facets.size(), pairs, meetings);
  std::vector<PlanarSubdivision> subdivisions(groups.size());
  ParallelLoop(static_cast<Id>(groups.size()), monitor, { progress.Stage, middle, progress.End },
    [&](Id i) { subdivisions[i] = Cut(points, facets, groups[i]); });
  return subdivisions;
}
} // namespace insideout
