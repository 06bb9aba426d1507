// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/ShellChains.h"

#include "Common/Buckets.h"
#include "Common/Vectors.h"
#include "WindingNumber/HoleCaps.h"

namespace insideout
{
namespace
{
double AreaOf(const std::vector<Point>& points, const Triangle& t)
{
  const Point normal = NormalOf(points[t[0]], points[t[1]], points[t[2]]);
  return std::sqrt(Dot(normal, normal)) / 2;
}

double VolumeOf(const std::vector<Point>& points, const std::vector<CountedTriangle>& chain)
{
  double volume = 0;
  for (const CountedTriangle& triangle : chain)
  {
    const Point& origin = points[chain.front().Corners[0]];
    const std::array<Point, 3> corners = CornersOf(points, triangle.Corners);
    volume += triangle.Count *
      Determinant(Difference(corners[0], origin), Difference(corners[1], origin),
        Difference(corners[2], origin)) /
      6;
  }
  return volume;
}

/** Renumbers the points of a shell, so that work on it does not depend on all others. */
class PointsInUse
{
public:
  explicit PointsInUse(const std::vector<Point>& points)
    : All(points)
    , Index(points.size(), None)
  {
  }

  /** The triangles in the new numbering, valid until the next call. */
  std::vector<CountedTriangle> Renumber(std::vector<CountedTriangle> triangles)
  {
    for (const Id p : this->Ids)
    {
      this->Index[p] = None;
    }
    this->Ids.clear();
    this->Points.clear();
    for (CountedTriangle& triangle : triangles)
    {
      for (Id& p : triangle.Corners)
      {
        if (this->Index[p] == None)
        {
          this->Index[p] = static_cast<Id>(this->Ids.size());
          this->Ids.push_back(p);
          this->Points.push_back(this->All[p]);
        }
        p = this->Index[p];
      }
    }
    return triangles;
  }

  void Restore(std::vector<CountedTriangle>& triangles) const
  {
    for (CountedTriangle& triangle : triangles)
    {
      for (Id& p : triangle.Corners)
      {
        p = this->Ids[p];
      }
    }
  }

  std::vector<Point> Points; ///< in the new numbering

private:
  const std::vector<Point>& All;
  std::vector<Id> Index;
  std::vector<Id> Ids;
};

/** Cap the holes of a shell whose facets and area are set. */
void CapHolesOf(ShellChain& shell, PointsInUse& points)
{
  shell.Triangles = points.Renumber(shell.Facets);
  const auto caps = CapHoles(
    points.Points, CountedBoundary(shell.Triangles, static_cast<Id>(points.Points.size())));
  double area = 0;
  for (const std::vector<CountedTriangle>& cap : caps)
  {
    for (const CountedTriangle& triangle : cap)
    {
      area += AreaOf(points.Points, triangle.Corners);
    }
    shell.Caps.insert(shell.Caps.end(), cap.begin(), cap.end());
  }
  shell.Kind = area > LargestCaps * shell.Area ? ShellKind::Sheet : ShellKind::Holed;
  shell.Triangles = CloseChain(std::move(shell.Triangles), caps);
  points.Restore(shell.Triangles);
  points.Restore(shell.Caps);
}

/** Call visit(shell, count) for the copies of facets, by facet, counted as their shells turn them.
 */
class CopiesOfFacets
{
public:
  explicit CopiesOfFacets(const Shells& shells)
    : Given(shells)
    , More(shells.MoreCopies.empty() ? 0 : shells.Shell.size(),
        [&](auto visit)
        {
          for (const ShellCopy& copy : shells.MoreCopies)
          {
            visit(static_cast<std::size_t>(copy.Facet), copy);
          }
        })
  {
  }

  template <class Visitor>
  void Visit(Id facet, const Visitor& visit) const
  {
    if (this->Given.Shell[facet] != None)
    {
      const int count = this->Given.Multiplicity[facet];
      visit(this->Given.Shell[facet], this->Given.Turned[facet] ? -count : count);
    }
    if (!this->Given.MoreCopies.empty())
    {
      for (const ShellCopy& copy : this->More[static_cast<std::size_t>(facet)])
      {
        visit(copy.Shell, copy.Turned ? -copy.Multiplicity : copy.Multiplicity);
      }
    }
  }

private:
  const Shells& Given;
  const Buckets<ShellCopy> More;
};

/** One per shell: whether its facets do not sum to 0 at each edge. */
std::vector<char> OpenShells(
  Id numberOfShells, const CopiesOfFacets& copies, const FacetEdges& edges)
{
  std::vector<char> isOpen(static_cast<std::size_t>(numberOfShells), 0);
  std::vector<std::int64_t> sums(isOpen.size(), 0);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        copies.Visit(
          edge->Facet, [&](Id shell, int count) { sums[shell] += edge->Direction * count; });
      }
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        copies.Visit(edge->Facet,
          [&](Id shell, int)
          {
            isOpen[shell] |= sums[shell] != 0;
            sums[shell] = 0;
          });
      }
    });
  return isOpen;
}
} // namespace

std::vector<ShellChain> CloseShells(const FacetComplex& surface, const FacetEdges& edges,
  const Shells& shells, const std::vector<Point>& points)
{
  const CopiesOfFacets copies(shells);
  const auto forCopies = [&](const auto& visit)
  {
    for (Id f = 0; f < surface.NumberOfFacets(); ++f)
    {
      copies.Visit(f, [&](Id shell, int count) { visit(f, shell, count); });
    }
  };
  std::vector<std::size_t> sizes(static_cast<std::size_t>(shells.Count), 0);
  forCopies([&](Id, Id shell, int) { ++sizes[shell]; });
  std::vector<ShellChain> chains(sizes.size());
  for (std::size_t shell = 0; shell < chains.size(); ++shell)
  {
    chains[shell].IsLoose = shells.IsLoose[shell] != 0;
    chains[shell].Facets.reserve(sizes[shell]);
  }
  forCopies(
    [&](Id f, Id shell, int count)
    {
      chains[shell].Facets.push_back({ surface.Facets[f], count });
      chains[shell].Area += AreaOf(points, surface.Facets[f]);
    });
  const std::vector<char> isOpen = OpenShells(shells.Count, copies, edges);
  PointsInUse inUse(points);
  for (std::size_t shell = 0; shell < chains.size(); ++shell)
  {
    ShellChain& chain = chains[shell];
    chain.Kind = ShellKind::Closed;
    chain.Triangles = chain.Facets;
    if (isOpen[shell])
    {
      CapHolesOf(chain, inUse);
    }
    chain.Volume = VolumeOf(points, chain.Triangles);
  }
  return chains;
}
} // namespace insideout
