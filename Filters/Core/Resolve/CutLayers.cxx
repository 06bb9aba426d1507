// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/CutLayers.h"

#include "Common/BoxTree.h"
#include "Common/DisjointSets.h"
#include "Common/RawVector.h"
#include "Common/TrianglePredicates.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace insideout
{
namespace
{
/**
 * A facet defines its plane if its height is at least this multiple of the layers' thickness:
 * snapping then tilts it by less than 1/100.
 */
constexpr double LeastHeight = 256;

/**
 * Facets of a group are seen along one axis: least cosine of the angle between the axis and their
 * normals.
 */
constexpr double LeastAlongAxis = 0.3;

/** A facet and its unit normal, in doubles. */
struct Slab
{
  Slab() = default;

  Slab(const FacetList& surface, Id facet)
  {
    this->Corners = CornersOf(surface.Points, surface.Facets[facet]);
    const auto& [a, b, c] = this->Corners;
    const double longest = std::max({ Distance(a, b), Distance(a, c), Distance(b, c) });
    this->Normal = NormalOf(a, b, c);
    const double doubleArea = Length(this->Normal);
    for (double& x : this->Normal)
    {
      x /= doubleArea;
    }
    this->Height = doubleArea / longest;
    this->Area = doubleArea / 2;
  }

  /** Whether all corners of the other facet lie within `radius` of this one's plane. */
  bool Holds(const Slab& other, double radius) const
  {
    return std::all_of(other.Corners.begin(), other.Corners.end(),
      [&](const Point& p)
      { return std::abs(Dot(this->Normal, Difference(p, this->Corners[0]))) <= radius; });
  }

  std::array<Point, 3> Corners;
  Point Normal;
  double Height;
  double Area;
};

/** Whether facets of these slabs are layers if they overlap. */
bool AreInOneSlab(const Slab& first, const Slab& last, double radius)
{
  return first.Height >= LeastHeight * radius && last.Height >= LeastHeight * radius &&
    (first.Holds(last, radius) || last.Holds(first, radius));
}

bool AreLayers(const FacetList& surface, Id a, Id b, double radius)
{
  return AreInOneSlab({ surface, a }, { surface, b }, radius) &&
    OverlapInPlane(CornersOf(surface, a), CornersOf(surface, b));
}

bool AreInOnePlane(const FacetList& surface, Id a, Id b)
{
  const std::array<int, 3> sides = SidesOfPlane(CornersOf(surface, a), CornersOf(surface, b));
  return sides[0] == 0 && sides[1] == 0 && sides[2] == 0;
}

/** Whether all facets are visible along the axis that suits the first one (LeastAlongAxis). */
bool ShareAnAxis(const FacetList& surface, const std::vector<Id>& facets)
{
  const int axis = ProjectionAxis(CornersOf(surface, facets[0]));
  return std::all_of(facets.begin(), facets.end(),
    [&](Id f) { return std::abs(Slab(surface, f).Normal[axis]) >= LeastAlongAxis; });
}

Box Around(const FacetList& surface, Id facet, double radius)
{
  return BoundingBox(surface.Points, surface.Facets[facet]).Widened(radius);
}

/** Facets of the pairs that cross although they should coincide: not exactly in one plane. */
std::vector<Id> FacetsOfLayers(
  const FacetList& surface, const std::vector<std::array<Id, 2>>& pairs, double radius)
{
  std::vector<Id> facets;
  for (const auto& pair : pairs)
  {
    if (AreLayers(surface, pair[0], pair[1], radius) && !AreInOnePlane(surface, pair[0], pair[1]))
    {
      facets.push_back(pair[0]);
    }
  }
  return facets;
}

/**
 * The full layers of these facets. If only the facets that cross were merged, those beside them
 * would cross next.
 */
std::vector<std::vector<Id>> SpreadOverLayers(const FacetList& surface, std::vector<Id> front,
  double radius, Monitor& monitor, const ProgressRange& progress)
{
  const Id count = static_cast<Id>(surface.Facets.size());
  std::vector<Box> boxes;
  for (Id f = 0; f < count; ++f)
  {
    boxes.push_back(Around(surface, f, radius));
  }
  const BoxTree tree(boxes);
  DisjointSets sets(count);
  std::vector<char> isReached(count, 0);
  for (const Id f : front)
  {
    isReached[f] = 1;
  }
  while (!front.empty())
  {
    monitor.Check(progress.Stage, progress.Begin);
    const Id f = front.back();
    front.pop_back();
    tree.Visit(boxes[f],
      [&](Id other)
      {
        if (other != f && AreLayers(surface, f, other, radius))
        {
          sets.Join(f, other);
          if (!isReached[other])
          {
            isReached[other] = 1;
            front.push_back(other);
          }
        }
      });
  }
  std::map<Id, std::vector<Id>> byLowest;
  for (Id f = 0; f < count; ++f)
  {
    if (isReached[f])
    {
      byLowest[sets.Find(f)].push_back(f);
    }
  }
  std::vector<std::vector<Id>> groups;
  for (auto& group : byLowest)
  {
    if (ShareAnAxis(surface, group.second))
    {
      groups.push_back(std::move(group.second));
    }
  }
  return groups;
}

/** Facets that are meant to coincide, and an axis along which all are visible. */
struct TouchingGroup
{
  int Axis;
  std::vector<Id> Facets;
};

/**
 * Groups of facets connected by pairs. The largest facet of a group determines its axis. Facets
 * seen edge-on along that axis, as one too thin to have a plane may be, are left with their pairs
 * for later groups.
 */
std::vector<TouchingGroup> GroupTouching(
  const FacetList& surface, std::vector<std::array<Id, 2>> pairs)
{
  std::vector<TouchingGroup> groups;
  while (!pairs.empty())
  {
    DisjointSets sets(surface.Facets.size());
    std::map<Id, Slab> slabs;
    for (const auto& [f, g] : pairs)
    {
      sets.Join(f, g);
      slabs.emplace(f, Slab(surface, f));
      slabs.emplace(g, Slab(surface, g));
    }
    std::map<Id, std::vector<Id>> byLowest;
    for (const auto& facet : slabs)
    {
      byLowest[sets.Find(facet.first)].push_back(facet.first);
    }
    std::vector<char> isLeft(surface.Facets.size(), 0);
    for (auto& group : byLowest)
    {
      std::vector<Id>& facets = group.second;
      const Id largest = *std::max_element(facets.begin(), facets.end(),
        [&](Id f, Id g) { return slabs.at(f).Area < slabs.at(g).Area; });
      const int axis = ProjectionAxis(CornersOf(surface, largest));
      const auto turned = std::stable_partition(facets.begin(), facets.end(),
        [&](Id f) { return std::abs(slabs.at(f).Normal[axis]) >= LeastAlongAxis; });
      std::for_each(turned, facets.end(), [&](Id f) { isLeft[f] = 1; });
      facets.erase(turned, facets.end());
      isLeft[largest] = 0; // even if doubles do not define its plane: then nothing touches it
      if (facets.size() > 1)
      {
        groups.push_back({ axis, std::move(facets) });
      }
    }
    pairs.erase(
      std::remove_if(pairs.begin(), pairs.end(),
        [&](const std::array<Id, 2>& pair) { return !isLeft[pair[0]] || !isLeft[pair[1]]; }),
      pairs.end());
  }
  return groups;
}
} // namespace

std::vector<std::array<Id, 2>> FindLayers(const FacetList& surface, const std::vector<Id>& among,
  double radius, Monitor& monitor, const ProgressRange& progress, const std::vector<Id>& bodies)
{
  const double nanosecondsPerFacet = 150;
  RawVector<Slab> slabs(among.size());
  std::vector<Box> boxes(among.size());
  ParallelLoop(among.size(), nanosecondsPerFacet,
    [&](std::size_t i)
    {
      slabs[i] = Slab(surface, among[i]);
      boxes[i] = Around(surface, among[i], radius);
    });
  const std::vector<Id>& bodyOf = bodies.empty() ? among : bodies;
  const BoxTree tree(boxes);
  const std::vector<Id> bodyOfParts = tree.SetsOfParts(bodyOf);
  std::vector<std::vector<std::array<Id, 2>>> found(static_cast<std::size_t>(tree.NumberOfParts()));
  ParallelLoop(tree.NumberOfParts(), nanosecondsPerFacet, monitor, progress,
    [&](Id part)
    {
      tree.VisitPairsBetween(part, bodyOf, bodyOfParts,
        [&](Id a, Id b)
        {
          if (AreInOneSlab(slabs[a], slabs[b], radius) &&
            OverlapInPlane(CornersOf(surface, among[a]), CornersOf(surface, among[b])))
          {
            found[part].push_back({ among[a], among[b] });
          }
        });
    });
  std::vector<std::array<Id, 2>> layers;
  for (const std::vector<std::array<Id, 2>>& some : found)
  {
    layers.insert(layers.end(), some.begin(), some.end());
  }
  return layers;
}

std::vector<PlanarSubdivision> CutLayers(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, double radius, Monitor& monitor,
  const ProgressRange& progress)
{
  const std::vector<Id> facets = FacetsOfLayers(surface, pairs, radius);
  if (facets.empty())
  {
    return {};
  }
  const std::vector<std::vector<Id>> groups =
    SpreadOverLayers(surface, facets, radius, monitor, progress);
  std::vector<PlanarSubdivision> subdivisions(groups.size());
  const double nanosecondsPerGroup = 8000;
  ParallelLoop(static_cast<Id>(groups.size()), nanosecondsPerGroup, monitor, progress,
    [&](Id i) { subdivisions[i] = SubdividePlane(surface, groups[i], {}); });
  return subdivisions;
}

std::vector<PlanarSubdivision> CutTouching(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<TouchingGroup> groups = GroupTouching(surface, pairs);
  std::vector<PlanarSubdivision> subdivisions(groups.size());
  const double nanosecondsPerGroup = 8000;
  ParallelLoop(static_cast<Id>(groups.size()), nanosecondsPerGroup, monitor, progress,
    [&](Id i) { subdivisions[i] = SubdivideAlong(groups[i].Axis, surface, groups[i].Facets); });
  return subdivisions;
}
} // namespace insideout
