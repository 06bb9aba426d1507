// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/SplitSeams.h"

#include "Common/DisjointSets.h"
#include "Common/LoopProgress.h"
#include "Common/Vectors.h"
#include "Resolve/Interpolation.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace insideout
{
namespace
{
/** A corner of a boundary triangle. */
struct Corner
{
  Id Place;
  Id Source;
  Id Triangle;
  int Which;
};

std::vector<Corner> SortedCorners(const std::vector<BoundaryTriangle>& triangles)
{
  std::vector<Corner> corners;
  for (Id t = 0; t < static_cast<Id>(triangles.size()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners.push_back({ triangles[t].Corners[k], triangles[t].Source, t, k });
    }
  }
  std::sort(corners.begin(), corners.end(),
    [](const Corner& a, const Corner& b)
    { return std::tie(a.Place, a.Source, a.Triangle) < std::tie(b.Place, b.Source, b.Triangle); });
  return corners;
}

int IndexIn(const Triangle& triangle, Id point)
{
  return static_cast<int>(
    std::find(triangle.begin(), triangle.end(), point) - triangle.begin()); // 3 for none
}

class Splitter
{
public:
  Splitter(const TriangleSoup& soup, const std::vector<Triangle>& given,
    const std::vector<Id>& alike, const TetrahedralMesh& mesh)
    : Soup(soup)
    , Given(given)
    , Alike(alike)
    , Mesh(mesh)
  {
  }

  SeamedSurface Split(const std::vector<BoundaryTriangle>& triangles, Monitor& monitor,
    const ProgressRange& progress);

private:
  std::vector<Id> Groups(Id place, const std::vector<Id>& sources) const;
  bool ShareEdge(Id first, Id second) const;
  PointOrigin OriginIn(Id source, Id place) const;

  const TriangleSoup& Soup;
  const std::vector<Triangle>& Given;
  const std::vector<Id>& Alike;
  const TetrahedralMesh& Mesh;
};

/** Whether two input triangles share two corners with the same data. */
bool Splitter::ShareEdge(Id first, Id second) const
{
  int common = 0;
  for (int k = 0; k < 3; ++k)
  {
    const int other = IndexIn(this->Given[second], this->Given[first][k]);
    common += other < 3 &&
      this->Alike[this->Soup.Triangles[first][k]] ==
        this->Alike[this->Soup.Triangles[second][other]];
  }
  return common >= 2;
}

/** For each input triangle around a place, the lowest one (by its index in `sources`) with which it
 * shares a point. */
std::vector<Id> Splitter::Groups(Id place, const std::vector<Id>& sources) const
{
  const Id count = static_cast<Id>(sources.size());
  DisjointSets sets(count);
  std::map<Id, Id> firstWithCorner;
  std::vector<Id> between; // triangles with the place on an edge or in the interior
  for (Id i = 0; i < count; ++i)
  {
    const int corner = IndexIn(this->Given[sources[i]], place);
    if (corner < 3)
    {
      const Id own = this->Alike[this->Soup.Triangles[sources[i]][corner]];
      sets.Join(firstWithCorner.insert({ own, i }).first->second, i);
      continue;
    }
    for (const Id other : between)
    {
      if (this->ShareEdge(sources[other], sources[i]))
      {
        sets.Join(other, i);
      }
    }
    between.push_back(i);
  }
  std::vector<Id> groups(count);
  for (Id i = 0; i < count; ++i)
  {
    groups[i] = sets.Find(i);
  }
  return groups;
}

/** The source of a place's data, seen from an input triangle that it lies on. */
PointOrigin Splitter::OriginIn(Id source, Id place) const
{
  const Triangle& own = this->Soup.Triangles[source];
  const Triangle& corners = this->Given[source];
  const int corner = IndexIn(corners, place);
  if (corner < 3)
  {
    return PointOrigin::Input(own[corner]);
  }
  return { own,
    BarycentricWeights(CornersOf(this->Mesh.Points, corners), this->Mesh.Points[place]) };
}

SeamedSurface Splitter::Split(
  const std::vector<BoundaryTriangle>& triangles, Monitor& monitor, const ProgressRange& progress)
{
  monitor.Check(progress.Stage, progress.Begin);
  SeamedSurface result;
  result.Triangles.resize(triangles.size());
  const std::vector<Corner> corners = SortedCorners(triangles);
  // A closed surface has about half as many points as triangles.
  const LoopProgress places(monitor, progress, triangles.size() / 2);
  std::size_t number = 0;
  for (std::size_t first = 0, last = 0; first < corners.size(); first = last)
  {
    places.Check(number++);
    const Id place = corners[first].Place;
    std::vector<Id> sources; // ascending; None comes first and is left out
    for (; last < corners.size() && corners[last].Place == place; ++last)
    {
      const Id source = corners[last].Source;
      if (source != None && (sources.empty() || sources.back() != source))
      {
        sources.push_back(source);
      }
    }
    const std::vector<Id> groups = this->Groups(place, sources);
    std::vector<Id> pointOf(std::max<std::size_t>(sources.size(), 1));
    for (std::size_t i = 0; i < pointOf.size(); ++i)
    {
      const bool isNew = sources.empty() || groups[i] == static_cast<Id>(i);
      pointOf[i] = isNew ? static_cast<Id>(result.Places.size()) : pointOf[groups[i]];
      if (isNew)
      {
        result.Places.push_back(place);
        result.Origins.push_back(
          sources.empty() ? this->Mesh.Origins[place] : this->OriginIn(sources[i], place));
      }
    }
    for (std::size_t c = first; c < last; ++c)
    {
      const auto at = corners[c].Source == None
        ? 0
        : std::lower_bound(sources.begin(), sources.end(), corners[c].Source) - sources.begin();
      result.Triangles[corners[c].Triangle][corners[c].Which] = pointOf[at];
    }
  }
  return result;
}
} // namespace

SeamedSurface SplitSeams(const std::vector<BoundaryTriangle>& triangles, const TriangleSoup& soup,
  const std::vector<Triangle>& given, const std::vector<Id>& alike, const TetrahedralMesh& mesh,
  Monitor& monitor, const ProgressRange& progress)
{
  return Splitter(soup, given, alike, mesh).Split(triangles, monitor, progress);
}
} // namespace insideout
