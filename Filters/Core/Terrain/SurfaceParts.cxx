// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terrain/SurfaceParts.h"

#include "Common/Box.h"
#include "Common/Buckets.h"
#include "Common/DisjointSets.h"
#include "Common/Edge.h"
#include "Common/FirstOfEqual.h"
#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "Terrain/TerrainProof.h"

#include <cmath>

namespace insideout
{
namespace
{
/** Limit of facets in one part. For a uniform density a cube of the grid has half of it. */
constexpr Id MostInPart = 4096;

/**
 * Least number of cubes along a side of the grid, because a round surface is not a terrain as a
 * whole; fewer if a cube would have fewer facets than the second number.
 */
constexpr double LeastCubes = 4;
constexpr double LeastInCube = 256;

/** Limit of cubes along a side: more would take more memory than the facets. */
constexpr double MostCubes = 128;

/** Smallest terrain: proving a smaller one takes longer than comparing its facets. */
constexpr Id LeastTerrain = 16;

/** Limit of halvings of a range that is not a terrain, to separate the offending facets. */
constexpr int MostHalvings = 4;

/**
 * A view shows a facet well if the normal's component towards it exceeds this fraction of the
 * normal's largest component.
 */
constexpr double WellShown = 0.1;

/**
 * One in this number of ranges of facets is cut first, as a sample. At least this share of its
 * facets has to be in terrains, and a part has to have at least this many facets on average.
 * Otherwise searching parts takes longer than searching facets.
 */
constexpr std::size_t RangesPerSample = 16;
constexpr double LeastInTerrains = 0.87;
constexpr double LeastPerPart = 64;

/** Some facets of SurfaceParts::Facets. */
struct FacetRange
{
  Id Begin;
  Id End;
  Id Size() const { return this->End - this->Begin; }
};

/** The centers of facets, as grids and medians require them. */
class FacetCentres
{
public:
  FacetCentres(const std::vector<Point>& points, const std::vector<Triangle>& facets)
    : Points(points)
    , Facets(facets)
  {
  }

  Point operator()(Id facet) const
  {
    const auto& [a, b, c] = this->Facets[facet];
    constexpr double third = 1.0 / 3; // applied first, to prevent overflow
    Point centre;
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] = third * this->Points[a][axis] + third * this->Points[b][axis] +
        third * this->Points[c][axis];
    }
    return centre;
  }

private:
  const std::vector<Point>& Points;
  const std::vector<Triangle>& Facets;
};

/**
 * The facets, bucketed by the grid's cubes that contain their centers. A closed surface meets about
 * as many cubes as there are on the six sides of the grid.
 */
Buckets<Id> SortIntoCubes(const Box& box, const FacetCentres& centreOf, Id count)
{
  const double wanted = std::max(
    count / (0.5 * MostInPart), std::min(count / LeastInCube, 6 * LeastCubes * LeastCubes));
  const double alongSide = std::min(std::floor(std::sqrt(wanted / 6)) + 1, MostCubes);
  const double perLength = alongSide / box.Extent(box.LongestAxis());
  const std::size_t size = static_cast<std::size_t>(alongSide);
  std::vector<Id> cubes;
  cubes.reserve(static_cast<std::size_t>(count));
  for (Id f = 0; f < count; ++f)
  {
    const Point centre = centreOf(f);
    std::size_t cube = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = (centre[axis] - box.Low[axis]) * perLength;
      cube = cube * size + static_cast<std::size_t>(place > 0 ? std::min(place, alongSide - 1) : 0);
    }
    cubes.push_back(static_cast<Id>(cube));
  }
  return { size * size * size,
    [&](auto visit)
    {
      for (Id f = 0; f < count; ++f)
      {
        visit(static_cast<std::size_t>(cubes[f]), f);
      }
    } };
}

/** Partition facets into two halves at the median of their centers. */
std::array<FacetRange, 2> Halve(
  const FacetCentres& centreOf, std::vector<Id>& facets, const FacetRange& range)
{
  Box box = Box::Empty();
  for (Id i = range.Begin; i < range.End; ++i)
  {
    box.Add(centreOf(facets[i]));
  }
  const int axis = box.LongestAxis();
  std::vector<std::pair<double, Id>> places;
  places.reserve(static_cast<std::size_t>(range.Size()));
  for (Id i = range.Begin; i < range.End; ++i)
  {
    places.emplace_back(centreOf(facets[i])[axis], facets[i]);
  }
  const Id half = range.Size() / 2;
  std::nth_element(places.begin(), places.begin() + half, places.end());
  for (Id i = range.Begin; i < range.End; ++i)
  {
    facets[i] = places[i - range.Begin].second;
  }
  return { { { range.Begin, range.Begin + half }, { range.Begin + half, range.End } } };
}

/** Halve ranges of facets until none is too large. */
void Divide(const FacetCentres& centreOf, std::vector<Id>& facets, const FacetRange& range,
  std::vector<FacetRange>& ranges)
{
  if (range.Size() <= MostInPart)
  {
    ranges.push_back(range);
    return;
  }
  for (const FacetRange& half : Halve(centreOf, facets, range))
  {
    Divide(centreOf, facets, half, ranges);
  }
}

/** Cuts the facets of one range into parts. */
class RangeCutter
{
public:
  RangeCutter(const std::vector<Point>& points, const std::vector<Triangle>& facets)
    : Points(points)
    , Facets(facets)
    , CentreOf(points, facets)
  {
  }

  /**
   * @param[in,out] order the facets of the range, reordered by parts
   * @param[in] halvings limit of halvings of what is not a terrain
   */
  void Cut(
    std::vector<Id>& order, const FacetRange& range, int halvings, std::vector<SurfacePart>& parts)
  {
    const std::vector<std::size_t> viewOf = this->ChooseViews(order, range);
    const Buckets<Id> byView(AxisView::Count + 1,
      [&](auto visit)
      {
        for (Id i = range.Begin; i < range.End; ++i)
        {
          visit(viewOf[i - range.Begin], order[i]);
        }
      });
    std::vector<Id> loose(byView[AxisView::Count].begin(), byView[AxisView::Count].end());
    std::vector<FacetRange> again;
    Id next = range.Begin;
    for (std::size_t view = 0; view < AxisView::Count; ++view)
    {
      this->Join({ byView[view].begin(), byView[view].end() });
      for (std::size_t c = 0; c < this->Components.Size(); ++c)
      {
        const Buckets<Id>::Range members = this->Components[c];
        const FacetRange place = { next, next + static_cast<Id>(members.Size()) };
        const bool isTerrain = place.Size() >= LeastTerrain &&
          IsTerrain(
            this->Points, AxisView(view), { this->Borders[c].begin(), this->Borders[c].end() });
        if (!isTerrain && (halvings == 0 || place.Size() < 2 * LeastTerrain))
        {
          loose.insert(loose.end(), members.begin(), members.end());
          continue;
        }
        std::copy(members.begin(), members.end(), order.begin() + next);
        next = place.End;
        if (isTerrain)
        {
          parts.push_back({ place.Begin, place.End, true });
        }
        else
        {
          again.push_back(place);
        }
      }
    }
    if (!loose.empty())
    {
      std::copy(loose.begin(), loose.end(), order.begin() + next);
      parts.push_back({ next, range.End, false });
    }
    for (const FacetRange& part : again)
    {
      for (const FacetRange& half : Halve(this->CentreOf, order, part))
      {
        this->Cut(order, half, halvings - 1, parts);
      }
    }
  }

private:
  /**
   * Per facet a view that shows its front, or AxisView::Count. Among the views that show it well,
   * the one that suits most of the range is chosen, so that neighbors share it.
   */
  std::vector<std::size_t> ChooseViews(const std::vector<Id>& order, const FacetRange& range) const
  {
    std::vector<Point> normals;
    normals.reserve(static_cast<std::size_t>(range.End - range.Begin));
    std::array<double, AxisView::Count> shown{};
    for (Id i = range.Begin; i < range.End; ++i)
    {
      const auto& [a, b, c] = this->Facets[order[i]];
      normals.push_back(NormalOf(this->Points[a], this->Points[b], this->Points[c]));
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        shown[axis] += std::max(normals.back()[axis], 0.0);
        shown[axis + 3] += std::max(-normals.back()[axis], 0.0);
      }
    }
    std::array<std::size_t, AxisView::Count> best{ 0, 1, 2, 3, 4, 5 };
    std::stable_sort(
      best.begin(), best.end(), [&](std::size_t a, std::size_t b) { return shown[a] > shown[b]; });
    std::vector<std::size_t> views;
    views.reserve(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      const auto& [x, y, z] = normals[i];
      const double enough = WellShown * std::max({ std::abs(x), std::abs(y), std::abs(z) });
      const Triangle& facet = this->Facets[order[range.Begin + static_cast<Id>(i)]];
      const auto view = std::find_if(best.begin(), best.end(),
        [&](std::size_t v)
        {
          return AxisView(v).Towards(normals[i]) > enough &&
            AxisView(v).ShowsFront(this->Points, facet);
        });
      views.push_back(view == best.end() ? AxisView::Count : *view);
    }
    return views;
  }

  /**
   * An edge between facets of one view, and how often facets traverse it upwards minus downwards.
   */
  struct ViewedEdge
  {
    Edge Ends;
    Id Facet;
    Id Sum;
  };

  /** Find the components of facets connected through edges, and their borders. */
  void Join(const std::vector<Id>& group)
  {
    std::vector<ViewedEdge> edges;
    edges.reserve(3 * group.size());
    FirstOfEqual equal(3 * group.size());
    DisjointSets sets(group.size());
    for (Id i = 0; i < static_cast<Id>(group.size()); ++i)
    {
      const Triangle& corners = this->Facets[group[i]];
      for (int k = 0; k < 3; ++k)
      {
        const Id from = corners[k];
        const Id to = corners[(k + 1) % 3];
        const ViewedEdge edge = { EdgeBetween(from, to), i, from < to ? 1 : -1 };
        const Id next = static_cast<Id>(edges.size());
        const Id first = equal.Find(next, HashOfEdge()(edge.Ends) >> 32, // the lower bits are poor
          [&](Id other)
          { return edges[other].Ends[0] == edge.Ends[0] && edges[other].Ends[1] == edge.Ends[1]; });
        if (first == next)
        {
          edges.push_back(edge);
        }
        else
        {
          edges[first].Sum += edge.Sum;
          sets.Join(edges[first].Facet, i);
        }
      }
    }
    std::vector<std::size_t> component(group.size());
    std::size_t count = 0;
    for (Id i = 0; i < static_cast<Id>(group.size()); ++i)
    {
      const Id lowest = sets.Find(i);
      component[i] = lowest == i ? count++ : component[lowest];
    }
    this->Components = { count,
      [&](auto visit)
      {
        for (std::size_t i = 0; i < group.size(); ++i)
        {
          visit(component[i], group[i]);
        }
      } };
    this->Borders = { count,
      [&](auto visit)
      {
        for (const ViewedEdge& edge : edges)
        {
          const auto [low, high] = edge.Ends;
          for (Id n = 0; n < std::abs(edge.Sum); ++n)
          {
            visit(component[edge.Facet],
              edge.Sum > 0 ? BorderEdge{ low, high } : BorderEdge{ high, low });
          }
        }
      } };
  }

  const std::vector<Point>& Points;
  const std::vector<Triangle>& Facets;
  const FacetCentres CentreOf;
  Buckets<Id> Components;
  Buckets<BorderEdge> Borders;
};
/** The number of facets in terrains. */
Id NumberInTerrains(const std::vector<SurfacePart>& parts)
{
  Id number = 0;
  for (const SurfacePart& part : parts)
  {
    number += part.IsTerrain ? part.End - part.Begin : 0;
  }
  return number;
}
} // namespace

std::optional<SurfaceParts> CutIntoParts(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Monitor& monitor, const ProgressRange& progress)
{
  const FacetCentres centreOf(points, facets);
  const Buckets<Id> cubes =
    SortIntoCubes(BoundingBox(points), centreOf, static_cast<Id>(facets.size()));
  SurfaceParts surface;
  surface.Facets.reserve(facets.size());
  std::vector<FacetRange> ranges;
  for (std::size_t cube = 0; cube < cubes.Size(); ++cube)
  {
    const Id begin = static_cast<Id>(surface.Facets.size());
    surface.Facets.insert(surface.Facets.end(), cubes[cube].begin(), cubes[cube].end());
    const Id end = static_cast<Id>(surface.Facets.size());
    if (begin < end)
    {
      Divide(centreOf, surface.Facets, { begin, end }, ranges);
    }
  }
  std::vector<std::vector<SurfacePart>> parts(ranges.size());
  const auto cut = [&](std::size_t i)
  { RangeCutter(points, facets).Cut(surface.Facets, ranges[i], MostHalvings, parts[i]); };
  const double nanosecondsPerFacet = 100;
  const double cost = nanosecondsPerFacet * static_cast<double>(facets.size()) /
    static_cast<double>(ranges.size() + 1);

  const std::size_t samples = (ranges.size() + RangesPerSample - 1) / RangesPerSample;
  ParallelLoop(samples, cost, monitor, progress, [&](std::size_t i) { cut(RangesPerSample * i); });
  double sampled = 0;
  double inTerrains = 0;
  double partsOfSample = 0;
  for (std::size_t i = 0; i < ranges.size(); i += RangesPerSample)
  {
    sampled += ranges[i].Size();
    inTerrains += NumberInTerrains(parts[i]);
    partsOfSample += static_cast<double>(parts[i].size());
  }
  if (inTerrains < LeastInTerrains * sampled || sampled < LeastPerPart * partsOfSample)
  {
    return std::nullopt;
  }
  ParallelLoop(ranges.size(), cost, monitor, progress,
    [&](std::size_t i)
    {
      if (i % RangesPerSample != 0)
      {
        cut(i);
      }
    });
  for (const std::vector<SurfacePart>& some : parts)
  {
    surface.Parts.insert(surface.Parts.end(), some.begin(), some.end());
  }
  return surface;
}
} // namespace insideout
