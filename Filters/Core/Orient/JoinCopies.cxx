// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/JoinCopies.h"

#include "Common/FacetComplex.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace insideout
{
namespace
{
/** Up to this number, each chosen pair is followed from seam to seam before the next is chosen. */
constexpr std::size_t MostSeamsToFollow = 256;

/** A copy at a seam; it runs along (1) or against it (-1). */
struct CopyAtSeam
{
  Id Copy;
  int Direction;
  Id Patch;
};

/** The given surface of each copy (FacetComplex::SourceSurfaces), None if it is unknown. */
std::vector<Id> SurfacesOfCopies(
  const FacetComplex& surface, const SeamedPatches& patches, const PatchCopies& copies)
{
  std::vector<Id> surfaces(copies.Count(), None);
  std::vector<char> isSeen(patches.Count.size(), 0);
  for (Id f = 0; !surface.SourceSurfaces.empty() && f < surface.NumberOfFacets(); ++f)
  {
    const Id patch = patches.Patches.Patch[f];
    if (isSeen[patch])
    {
      continue;
    }
    isSeen[patch] = 1;
    // index of the copy along the patch, and of that against it
    std::array<std::vector<Id>, 2> given;
    for (Id s = surface.SourceOffsets[f]; s < surface.SourceOffsets[f + 1]; ++s)
    {
      const bool against =
        surface.Sources[s].Reversed != (SignOfCount(surface.Multiplicity[f]) < 0);
      given[against].push_back(surface.SourceSurfaces[s]);
    }
    const std::array<Id, 2> sizes = { { copies.Along(patch), copies.Against(patch) } };
    Id copy = copies.First(patch);
    for (const int side : { 0, 1 })
    {
      std::sort(given[side].begin(), given[side].end());
      const std::size_t known = std::min(given[side].size(), static_cast<std::size_t>(sizes[side]));
      std::copy_n(given[side].begin(), known, surfaces.begin() + copy);
      copy += sizes[side];
    }
  }
  return surfaces;
}

/** The angle of each facet around an edge, counterclockwise seen against the edge's direction. */
class AnglesAround
{
public:
  AnglesAround(
    const std::vector<Point>& points, const std::vector<Triangle>& facets, const FacetEdge& edge)
    : Points(points)
    , Facets(facets)
    , Low(edge.Low)
    , High(edge.High)
  {
    const Point axis = Difference(points[edge.High], points[edge.Low]);
    int least = 0;
    for (int i = 1; i < 3; ++i)
    {
      least = std::abs(axis[i]) < std::abs(axis[least]) ? i : least;
    }
    Point unit = { 0, 0, 0 };
    unit[least] = 1;
    this->X = Cross(unit, axis);
    this->Y = Cross(axis, this->X);
    const double length = Length(axis);
    for (double& y : this->Y)
    {
      y /= length > 0 ? length : 1;
    }
  }

  double Of(Id facet) const
  {
    for (const Id p : this->Facets[facet])
    {
      if (p != this->Low && p != this->High)
      {
        const Point to = Difference(this->Points[p], this->Points[this->Low]);
        return std::atan2(Dot(to, this->Y), Dot(to, this->X));
      }
    }
    return 0;
  }

private:
  const std::vector<Point>& Points;
  const std::vector<Triangle>& Facets;
  Id Low;
  Id High;
  Point X;
  Point Y;
};

class CopyJoiner
{
public:
  CopyJoiner(const FacetComplex& surface, const FacetEdges& edges, const SeamedPatches& patches,
    const PatchCopies& copies, TurnedSets& sets)
    : Surface(surface)
    , Edges(edges)
    , Patches(patches)
    , Copies(copies)
    , Surfaces(SurfacesOfCopies(surface, patches, copies))
    , Sets(sets)
  {
  }

  /** The copies at a seam, without pairs in one set. */
  std::vector<CopyAtSeam> LeftAt(const PatchSeam& seam)
  {
    struct InSet
    {
      Id Set;
      CopyAtSeam At;
    };
    std::vector<InSet> all;
    for (const PatchAtSeam& at : seam.Patches)
    {
      const Id first = this->Copies.First(at.Patch);
      for (Id i = 0; i < this->Copies.Size(at.Patch); ++i)
      {
        const bool along = (i < this->Copies.Along(at.Patch)) == (at.Direction > 0);
        for (int n = 0; n < std::abs(at.Direction); ++n)
        {
          all.push_back(
            { this->Sets.Find(first + i).Set, { first + i, along ? 1 : -1, at.Patch } });
        }
      }
    }
    std::sort(all.begin(), all.end(),
      [](const InSet& a, const InSet& b)
      {
        return std::make_tuple(a.Set, a.At.Direction, a.At.Copy) <
          std::make_tuple(b.Set, b.At.Direction, b.At.Copy);
      });
    std::vector<CopyAtSeam> left;
    for (std::size_t i = 0; i < all.size();)
    {
      std::size_t end = i;
      std::size_t against = i;
      for (; end < all.size() && all[end].Set == all[i].Set; ++end)
      {
        against += all[end].At.Direction < 0;
      }
      const std::size_t pairs = std::min(against - i, end - against);
      for (std::size_t k = i + pairs; k < against; ++k)
      {
        left.push_back(all[k].At);
      }
      for (std::size_t k = against + pairs; k < end; ++k)
      {
        left.push_back(all[k].At);
      }
      i = end;
    }
    return left;
  }

  /** Join the copies of one given surface at a seam that copies of other surfaces share. */
  void JoinWithinSurfaces(const PatchSeam& seam)
  {
    std::vector<CopyAtSeam> left = this->LeftAt(seam);
    const auto surfaceOf = [&](const CopyAtSeam& at) { return this->Surfaces[at.Copy]; };
    std::stable_sort(left.begin(), left.end(),
      [&](const CopyAtSeam& a, const CopyAtSeam& b) { return surfaceOf(a) < surfaceOf(b); });
    for (std::size_t i = 0; i < left.size();)
    {
      std::vector<CopyAtSeam> ofSurface;
      int sum = 0;
      const Id given = surfaceOf(left[i]);
      for (; i < left.size() && surfaceOf(left[i]) == given; ++i)
      {
        ofSurface.push_back(left[i]);
        sum += left[i].Direction;
      }
      if (given != None && sum == 0 && ofSurface.size() < left.size())
      {
        this->JoinByWedges(seam, ofSurface);
      }
    }
  }

  void JoinPair(const CopyAtSeam& a, const CopyAtSeam& b)
  {
    this->Sets.Join(std::min(a.Copy, b.Copy), std::max(a.Copy, b.Copy), false);
  }

  /** Join copies that bound the same wedges. A facet that runs along the edge has the solid
   * clockwise of it, one that runs against it counterclockwise. */
  void JoinByWedges(const PatchSeam& seam, const std::vector<CopyAtSeam>& left)
  {
    const FacetEdge* const first = this->Edges.data() + seam.Longest[0];
    const FacetEdge* const last = this->Edges.data() + seam.Longest[1];
    const AnglesAround angles(this->Patches.Points, this->Surface.Facets, *first);
    std::vector<std::tuple<double, int, std::size_t>> around;
    for (std::size_t i = 0; i < left.size(); ++i)
    {
      const FacetEdge* const edge = std::find_if(first, last,
        [&](const FacetEdge& e) { return this->Patches.Patches.Patch[e.Facet] == left[i].Patch; });
      const auto at = std::find_if(seam.Patches.begin(), seam.Patches.end(),
        [&](const PatchAtSeam& a) { return a.Patch == left[i].Patch; });
      const int run = edge->Direction * SignOfCount(this->Surface.Multiplicity[edge->Facet]);
      const bool sameWay = (run > 0) == (at->Direction > 0);
      const int direction = sameWay ? left[i].Direction : -left[i].Direction;
      around.push_back({ angles.Of(edge->Facet), -direction, i });
    }
    std::sort(around.begin(), around.end());
    // Twice around, so that each open wedge is closed.
    std::vector<std::size_t> begun;
    std::vector<char> joined(left.size(), 0);
    for (int round = 0; round < 2; ++round)
    {
      for (const auto& [angle, begins, i] : around)
      {
        if (joined[i])
        {
          continue;
        }
        if (begins > 0 && round == 0)
        {
          begun.push_back(i);
        }
        else if (begins < 0 && !begun.empty())
        {
          this->JoinPair(left[begun.back()], left[i]);
          joined[i] = joined[begun.back()] = 1;
          begun.pop_back();
        }
      }
    }
  }

private:
  const FacetComplex& Surface;
  const FacetEdges& Edges;
  const SeamedPatches& Patches;
  const PatchCopies& Copies;
  const std::vector<Id> Surfaces; // per copy
  TurnedSets& Sets;
};
} // namespace

PatchCopies::PatchCopies(const SeamedPatches& patches)
  : Firsts(1, 0)
{
  for (std::size_t p = 0; p < patches.Count.size(); ++p)
  {
    this->Alongs.push_back(patches.Count[p] + patches.Opposed[p]);
    this->Firsts.push_back(this->Firsts.back() + this->Alongs.back() + patches.Opposed[p]);
  }
}

void JoinCopies(const FacetComplex& surface, const FacetEdges& edges,
  const std::vector<PatchSeam>& seams, const SeamedPatches& patches, const PatchCopies& copies,
  TurnedSets& sets)
{
  CopyJoiner joiner(surface, edges, patches, copies, sets);
  std::vector<const PatchSeam*> open;
  for (const PatchSeam& seam : seams)
  {
    open.push_back(&seam);
  }
  std::stable_sort(open.begin(), open.end(),
    [](const PatchSeam* a, const PatchSeam* b) { return a->Length > b->Length; });
  for (const PatchSeam* seam : open)
  {
    joiner.JoinWithinSurfaces(*seam);
  }
  const bool follows = open.size() <= MostSeamsToFollow;
  const auto joinLastTwo = [&]()
  {
    bool joined = false;
    for (const PatchSeam*& seam : open)
    {
      const std::vector<CopyAtSeam> left = seam ? joiner.LeftAt(*seam) : std::vector<CopyAtSeam>();
      if (left.size() == 2)
      {
        joiner.JoinPair(left[0], left[1]);
        joined = true;
      }
      seam = left.size() > 2 ? seam : nullptr;
    }
    return joined;
  };
  while (joinLastTwo() && follows)
  {
  }
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    if (open[i])
    {
      joiner.JoinByWedges(*open[i], joiner.LeftAt(*open[i]));
      open[i] = nullptr;
      while (follows && joinLastTwo())
      {
      }
    }
  }
}
} // namespace insideout
