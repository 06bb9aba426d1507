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

/** Cap the holes of a shell whose triangles and area are set. */
void Close(ShellChain& shell, PointsInUse& points)
{
  shell.Triangles = points.Renumber(std::move(shell.Triangles));
  const std::vector<CountedEdge> boundary =
    CountedBoundary(shell.Triangles, static_cast<Id>(points.Points.size()));
  shell.Kind = boundary.empty() ? ShellKind::Closed : ShellKind::Holed;
  if (!boundary.empty())
  {
    const auto caps = CapHoles(points.Points, boundary);
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
  }
  shell.Volume = VolumeOf(points.Points, shell.Triangles);
  points.Restore(shell.Triangles);
  points.Restore(shell.Caps);
}
} // namespace

std::vector<ShellChain> CloseShells(
  const FacetComplex& surface, const Shells& shells, const std::vector<Point>& points)
{
  struct Copy
  {
    Id Facet;
    int Count;
  };
  const Buckets<Copy> copies(static_cast<std::size_t>(shells.Count),
    [&](auto visit)
    {
      std::size_t more = 0;
      for (Id f = 0; f < surface.NumberOfFacets(); ++f)
      {
        if (shells.Shell[f] != None)
        {
          visit(static_cast<std::size_t>(shells.Shell[f]),
            Copy{ f, shells.Turned[f] ? -shells.Multiplicity[f] : shells.Multiplicity[f] });
        }
        for (; more < shells.MoreCopies.size() && shells.MoreCopies[more].Facet == f; ++more)
        {
          const ShellCopy& copy = shells.MoreCopies[more];
          visit(static_cast<std::size_t>(copy.Shell),
            Copy{ f, copy.Turned ? -copy.Multiplicity : copy.Multiplicity });
        }
      }
    });
  PointsInUse inUse(points);
  std::vector<ShellChain> chains(static_cast<std::size_t>(shells.Count));
  for (std::size_t shell = 0; shell < chains.size(); ++shell)
  {
    ShellChain& chain = chains[shell];
    chain.IsLoose = shells.IsLoose[shell] != 0;
    chain.Facets.reserve(copies[shell].Size());
    for (const Copy& copy : copies[shell])
    {
      chain.Facets.push_back({ surface.Facets[copy.Facet], copy.Count });
      chain.Area += AreaOf(points, surface.Facets[copy.Facet]);
    }
    chain.Triangles = chain.Facets;
    Close(chain, inUse);
  }
  return chains;
}
} // namespace insideout
