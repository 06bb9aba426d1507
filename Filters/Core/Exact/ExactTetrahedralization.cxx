// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactTetrahedralization.h"

#include "Common/SortedTriangle.h"
#include "Exact/PointSupport.h"
#include "Exact/RecoverFacets.h"
#include "Exact/RecoverSegments.h"
#include "Exact/RoundPoints.h"
#include "Exact/SteinerPoints.h"
#include "Resolve/FindIntersections.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <random>
#include <set>
#include <utility>

namespace insideout
{
namespace
{
/** Work (ExactVertices::Work) on lost facets that is always tolerable: a second or two. */
constexpr std::int64_t WorkOnLostFacets = 100000000;

/** Facets that are let go are at most so many cells around a lost one. */
constexpr unsigned MostRingsOfRuins = 3;

/** Nearly all facets that are lost at first are there after fewer tries, without more points. */
constexpr int TriesBeforeSplitting = 4;

/** Edges that are tried to flip a face away. */
constexpr int MostTwinFlips = 200;

/** Points are shaken so often without getting fewer. */
constexpr int ShakesWithoutGain = 12;

/** Steiner points that have places are shaken for this share of the work, and some ms. */
constexpr std::int64_t WorkPerShake = 10;
constexpr std::int64_t WorkOnShaking = 1000000;

/** Facets are given up so often before all of them are. */
constexpr int MostAttempts = 8;

/** Facets are given up in so many rings of cells around points that find no place. */
constexpr int MostRings = 5;

std::vector<Id> FacetsWithArea(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  std::vector<Id> proper;
  const auto at = [&points](Id p)
  { return ExactVertices::Kernel::Point_3(points[p][0], points[p][1], points[p][2]); };
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    if (!CGAL::collinear(at(facets[f][0]), at(facets[f][1]), at(facets[f][2])))
    {
      proper.push_back(static_cast<Id>(f));
    }
  }
  return proper;
}

/** Facets that meet others beyond shared corners: not all of these can be had. */
std::set<Id> FacetsThatCross(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor)
{
  std::set<Id> crossing;
  std::vector<Id> names;
  std::vector<Triangle> proper;
  std::set<Triangle> known;
  for (const Id facet : FacetsWithArea(points, facets))
  {
    if (known.insert(SortedTriangle(facets[facet]).Points).second)
    {
      names.push_back(facet);
      proper.push_back(facets[facet]);
    }
    else
    {
      crossing.insert(facet);
    }
  }
  for (const std::array<Id, 2>& pair : FindIntersections(points, proper, monitor))
  {
    crossing.insert({ names[pair[0]], names[pair[1]] });
  }
  return crossing;
}

/** The facets that are not among others. */
std::vector<Id> Without(const std::set<Id>& others, const std::vector<Id>& facets)
{
  std::vector<Id> rest;
  std::set_difference(
    facets.begin(), facets.end(), others.begin(), others.end(), std::back_inserter(rest));
  return rest;
}

/** The mesh of one attempt to recover facets. */
class Attempt
{
public:
  Attempt(const std::vector<Point>& points, const std::vector<Triangle>& facets,
    std::int64_t workPerElement, Monitor& monitor)
    : Points(points)
    , Mesh(points, this->Same, monitor)
    , Facets(this->Renamed(facets))
    , Segments(this->Facets)
    , Progress(monitor)
  {
    this->Mesh.Vertices.LimitWork(
      workPerElement * static_cast<std::int64_t>(points.size() + facets.size()));
  }

  /**
   * Recover all facets that can be. Facets that have to be given up, for Steiner points on them
   * find no place in doubles, get another chance when the others are done.
   * @return whether all Steiner points have places; if not, the mesh is good for nothing
   */
  bool Run(SegmentRecovery::From from)
  {
    std::vector<Id> all(this->Facets.size());
    std::iota(all.begin(), all.end(), 0);
    if (!this->RecoverAndRound(all, from))
    {
      return false;
    }
    this->TryLostFacetsAgain(from);
    this->TakeWholeTwinsAway();
    this->FindLost();
    return true;
  }

  /** The facets that were given up, ascending. */
  const std::set<Id>& FacetsGivenUp() const { return this->GivenUp; }

  /** The cells and the faces with facets; facets have the numbers that they have in `names`. */
  ExactTetrahedralization Result(const std::vector<Id>& names) const
  {
    ExactTetrahedralization result;
    result.Points = this->Points;
    std::vector<Id> renamed(static_cast<std::size_t>(this->Mesh.Vertices.Size()), None);
    std::iota(renamed.begin(), renamed.begin() + this->Mesh.Infinite(), 0);
    result.Work = this->Mesh.Vertices.Work();
    for (Id cell = 0; cell < static_cast<Id>(this->Mesh.Cells.size()); ++cell)
    {
      if (this->Mesh.IsDead(cell) || this->Mesh.IsInfinite(cell))
      {
        continue;
      }
      result.Cells.push_back(this->Mesh.Cells[cell].Corners);
      for (Id& corner : result.Cells.back())
      {
        if (renamed[corner] == None)
        {
          renamed[corner] = static_cast<Id>(result.Points.size());
          result.Points.push_back(this->Mesh.Vertices.Nearest(corner));
        }
        corner = renamed[corner];
      }
    }
    this->CollectFaces(names, renamed, result);
    return result;
  }

private:
  /** @return whether all Steiner points have places */
  bool RecoverAndRound(const std::vector<Id>& facets, SegmentRecovery::From from)
  {
    this->Recover(facets, from);
    std::vector<Id> left = this->RoundAll();
    for (int rings = 0; !left.empty() && rings < MostRings; ++rings)
    {
      const std::set<Id> around = this->FacetsAround(left, rings);
      this->GivenUp.insert(around.begin(), around.end());
      this->LetGo(around);
      left = this->RoundAll();
    }
    return left.empty();
  }

  /**
   * Ruin and recreate (Schrimpf et al. 2000): let facets around a lost one go and recover all of
   * them in another order, as long as there is work to spare. Facets that cross others stay lost.
   */
  void TryLostFacetsAgain(SegmentRecovery::From from)
  {
    const std::int64_t end = 2 * this->Mesh.Vertices.Work() + WorkOnLostFacets;
    std::vector<Id> lost = this->FindLost();
    const std::set<Id> hopeless =
      lost.empty() ? std::set<Id>() : FacetsThatCross(this->Points, this->Facets, this->Progress);
    std::vector<Id> wanted = Without(hopeless, lost);
    for (int tries = 0;
         !wanted.empty() && this->Mesh.Vertices.Work() < end && !this->Mesh.Vertices.IsWorkDone();
         ++tries)
    {
      this->MaySplitBeside = tries >= TriesBeforeSplitting;
      from = from == SegmentRecovery::From::LowerEnd ? SegmentRecovery::From::HigherEnd
                                                     : SegmentRecovery::From::LowerEnd;
      const FlippableMesh mesh = this->Mesh;
      const SegmentTable segments = this->Segments;
      const std::int64_t work = this->Mesh.Vertices.Work();
      bool isBetter = this->Recreate(this->ChooseRuins(wanted), from);
      std::vector<Id> now;
      if (isBetter)
      {
        now = this->FindLost();
        isBetter = now.size() <= lost.size();
      }
      if (isBetter)
      {
        lost = std::move(now);
        wanted = Without(hopeless, lost);
      }
      else
      {
        const std::int64_t spent = this->Mesh.Vertices.Work() - work;
        this->Mesh = mesh;
        this->Segments = segments;
        this->Mesh.Vertices.AddWork(spent);
      }
      this->Mesh.Vertices.AddWork(static_cast<std::int64_t>(this->Mesh.Cells.size()));
    }
    this->GivenUp = { lost.begin(), lost.end() };
  }

  /** The lost facets and those around one of their corners, in any order. */
  std::vector<Id> ChooseRuins(const std::vector<Id>& lost)
  {
    const Triangle& facet = this->Facets[lost[this->Random() % lost.size()]];
    std::set<Id> ruins = this->FacetsAround(
      { facet[this->Random() % 3] }, static_cast<int>(this->Random() % MostRingsOfRuins));
    ruins.insert(lost.begin(), lost.end());
    this->AddFacetsBesideSteinerPoints(ruins);
    std::vector<Id> order(ruins.begin(), ruins.end());
    for (std::size_t k = order.size() - 1; k > 0; --k)
    {
      std::swap(order[k], order[this->Random() % (k + 1)]);
    }
    return order;
  }

  /** Points on their edges are rounded: these can only go together with all facets there. */
  void AddFacetsBesideSteinerPoints(std::set<Id>& facets) const
  {
    std::set<Id> split;
    bool grows = true;
    while (grows)
    {
      for (const Id facet : facets)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Id segment = this->Segments.OfFacet(facet, k);
          if (this->Segments.Path(segment).size() > 2)
          {
            split.insert(segment);
          }
        }
      }
      const std::size_t before = facets.size();
      for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
      {
        for (int k = 0; k < 3; ++k)
        {
          if (split.count(this->Segments.OfFacet(facet, k)) > 0)
          {
            facets.insert(facet);
          }
        }
      }
      grows = facets.size() > before;
    }
  }

  bool Recreate(const std::vector<Id>& ruins, SegmentRecovery::From from)
  {
    this->LetGo({ ruins.begin(), ruins.end() });
    this->TidyUp();
    this->ShakeCorners(ruins);
    for (const Id facet : ruins)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Segments.Restore(this->Segments.OfFacet(facet, k));
      }
    }
    return this->RecoverAndRound(ruins, from);
  }

  /** Other cells around facets to begin with: else flips would go the same way again. */
  void ShakeCorners(const std::vector<Id>& facets)
  {
    std::set<Id> corners;
    for (const Id facet : facets)
    {
      corners.insert(this->Facets[facet].begin(), this->Facets[facet].end());
    }
    SteinerPoints steiner(this->Mesh, this->Segments, this->Progress);
    for (const Id corner : corners)
    {
      steiner.FlipAround(corner, this->Random);
    }
  }

  void Recover(std::vector<Id> missing, SegmentRecovery::From from)
  {
    FacetRecovery facets(this->Mesh, this->Segments, this->Facets, this->Progress);
    SegmentRecovery edges(this->Mesh, this->Segments, this->Progress);
    SteinerPoints steiner(this->Mesh, this->Segments, this->Progress);
    missing = facets.MarkWholeFacets(missing);
    const std::vector<Id> toCut =
      edges.RecoverByFlips(edges.FindMissing(this->SegmentsOf(missing)));
    edges.RecoverBySplits(toCut, from, steiner);
    missing = facets.MarkWholeFacets(missing);
    facets.RecoverBySplits(facets.RecoverByFlips(missing), steiner);
    this->TidyUp();
    this->ShakeOff(steiner);
  }

  /** Do without some of the Steiner points that cells at hand could not do without. */
  void ShakeOff(SteinerPoints& steiner)
  {
    const std::int64_t work = this->Mesh.Vertices.Work();
    const std::int64_t end = work + work / WorkPerShake + WorkOnShaking;
    std::vector<Id> left = this->SteinerPointsLeft();
    int patience = ShakesWithoutGain;
    while (!left.empty() && patience > 0 && this->Mesh.Vertices.Work() < end &&
      !this->Mesh.Vertices.IsWorkDone())
    {
      steiner.Shake(left, this->Random);
      const std::size_t before = left.size();
      left = this->SteinerPointsLeft();
      patience = left.size() < before ? ShakesWithoutGain : patience - 1;
    }
  }

  std::vector<Id> SteinerPointsLeft() const
  {
    std::vector<Id> left;
    for (Id vertex = this->Mesh.Infinite() + 1; vertex < this->Mesh.Vertices.Size(); ++vertex)
    {
      if (this->Mesh.HasVertex(vertex))
      {
        left.push_back(vertex);
      }
    }
    return left;
  }

  /** Take Steiner points away, or off the surface. */
  void TidyUp()
  {
    SteinerPoints steiner(this->Mesh, this->Segments, this->Progress);
    steiner.Tidy(this->Mesh.Infinite() + 1);
  }

  /**
   * Round points, and try to do without those that cannot be rounded, as long as that helps.
   * @return the ones that are left
   */
  std::vector<Id> RoundAll()
  {
    PointRounder rounder(this->Mesh, this->Segments, this->Progress);
    std::vector<Id> left = rounder.Round();
    std::size_t before = left.size() + 1;
    while (!left.empty() && left.size() < before)
    {
      before = left.size();
      this->TidyUp();
      left = rounder.Round();
    }
    SteinerPoints steiner(this->Mesh, this->Segments, this->Progress);
    int patience = ShakesWithoutGain;
    bool isSplit = false;
    while (!left.empty() && patience > 0 && !this->Mesh.Vertices.IsWorkDone())
    {
      before = left.size();
      if (this->MaySplitBeside && patience == ShakesWithoutGain / 2)
      {
        rounder.SplitBeside(left, this->Random);
        isSplit = true;
      }
      rounder.Stir(left, this->Random);
      steiner.Shake(left, this->Random);
      left = rounder.RoundSomehow(this->Random);
      patience = left.size() < before ? ShakesWithoutGain : patience - 1;
    }
    if (isSplit && left.empty())
    {
      this->TidyUp();
      left = rounder.Round();
    }
    return left;
  }

  /** The facets that have one of the points, or a cell so many cells away from it. */
  std::set<Id> FacetsAround(const std::vector<Id>& points, int rings) const
  {
    std::vector<Id> cells;
    std::set<Id> facets;
    for (const Id point : points)
    {
      const std::vector<Id> own = FindPointSupport(this->Mesh, this->Segments, point).Facets;
      facets.insert(own.begin(), own.end());
      this->Mesh.Star(point, cells);
    }
    for (int ring = 0; ring < rings; ++ring)
    {
      std::set<Id> known(cells.begin(), cells.end());
      for (const Id cell : std::vector<Id>(cells))
      {
        for (int k = 0; k < 4; ++k)
        {
          if (this->Mesh.Cells[cell].Facets[k] != None)
          {
            facets.insert(this->Mesh.Cells[cell].Facets[k]);
          }
          if (known.insert(this->Mesh.Cells[cell].Neighbors[k]).second)
          {
            cells.push_back(this->Mesh.Cells[cell].Neighbors[k]);
          }
        }
      }
    }
    return facets;
  }

  /** Let facets go, and the segments that no other facet has. */
  void LetGo(const std::set<Id>& facets)
  {
    for (FlippableCell& cell : this->Mesh.Cells)
    {
      for (Id& facet : cell.Facets)
      {
        facet = facets.count(facet) > 0 ? None : facet;
      }
    }
    std::vector<bool> isUsed(static_cast<std::size_t>(this->Segments.Size()), false);
    const std::vector<bool> isThere = this->AreThere();
    for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
    {
      for (int k = 0; isThere[facet] && k < 3; ++k)
      {
        isUsed[this->Segments.OfFacet(facet, k)] = true;
      }
    }
    for (Id segment = 0; segment < this->Segments.Size(); ++segment)
    {
      if (!isUsed[segment])
      {
        this->Segments.Release(segment);
      }
    }
  }

  std::vector<bool> AreThere() const
  {
    std::vector<bool> isThere(this->Facets.size(), false);
    for (const FlippableCell& cell : this->Mesh.Cells)
    {
      for (int k = 0; cell.Corners[0] != None && k < 4; ++k)
      {
        if (cell.Facets[k] != None)
        {
          isThere[cell.Facets[k]] = true;
        }
      }
    }
    return isThere;
  }

  /** The facets that are not there, after a look whether one is a face by chance. */
  std::vector<Id> FindLost()
  {
    const std::vector<bool> isThere = this->AreThere();
    std::vector<Id> lost;
    for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
    {
      if (!isThere[facet])
      {
        lost.push_back(facet);
      }
    }
    return FacetRecovery(this->Mesh, this->Segments, this->Facets, this->Progress)
      .MarkWholeFacets(lost);
  }

  std::vector<Id> SegmentsOf(const std::vector<Id>& facets) const
  {
    std::set<Id> segments;
    for (const Id facet : facets)
    {
      for (int k = 0; k < 3; ++k)
      {
        segments.insert(this->Segments.OfFacet(facet, k));
      }
    }
    return { segments.begin(), segments.end() };
  }

  /**
   * Where a Steiner point beside its exact place splits a facet, the whole facet may be a face,
   * too. Which of both is the facet, each reader of the mesh would have to guess: flip that face
   * away.
   */
  void TakeWholeTwinsAway()
  {
    FlipOperator flips(this->Mesh, this->Segments);
    const FlipTarget nothing(this->Mesh);
    constexpr FlipOperator::Limits limits = { 0, 12 };
    for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
    {
      const Triangle& corners = this->Facets[facet];
      for (int k = 0; k < 3; ++k)
      {
        const Id u = corners[k];
        const Id v = corners[(k + 1) % 3];
        Id cell;
        int face;
        if (this->Segments.Path(this->Segments.OfFacet(facet, k)).size() > 2 &&
          this->Mesh.FindFace(corners[0], corners[1], corners[2], cell, face) &&
          !flips.RemoveFace(cell, face, nothing, limits))
        {
          int budget = MostTwinFlips;
          flips.RemoveEdgeDeeply(u, v, nothing, limits, 2, budget);
        }
      }
    }
  }

  /** The facets between the vertices that stand for points. */
  std::vector<Triangle> Renamed(std::vector<Triangle> facets) const
  {
    for (Triangle& facet : facets)
    {
      for (Id& corner : facet)
      {
        corner = this->Same[corner];
      }
    }
    return facets;
  }

  /** The faces that facets lie on, each from the one of its two cells that comes first. */
  void CollectFaces(const std::vector<Id>& names, const std::vector<Id>& renamed,
    ExactTetrahedralization& result) const
  {
    for (Id id = 0; id < static_cast<Id>(this->Mesh.Cells.size()); ++id)
    {
      const FlippableCell& cell = this->Mesh.Cells[id];
      for (int k = 0; !this->Mesh.IsDead(id) && k < 4; ++k)
      {
        if (cell.Facets[k] == None || cell.Neighbors[k] < id)
        {
          continue;
        }
        Triangle face;
        for (int j = 0; j < 3; ++j)
        {
          face[j] = renamed[cell.Corners[FaceSeenFrom[k][j]]];
        }
        result.Faces.push_back(face);
        result.FacetOfFaces.push_back(names[cell.Facets[k]]);
      }
    }
  }

  const std::vector<Point>& Points;
  std::vector<Id> Same;
  FlippableMesh Mesh;
  std::vector<Triangle> Facets;
  SegmentTable Segments;
  Monitor& Progress;
  std::set<Id> GivenUp;
  std::mt19937 Random;
  bool MaySplitBeside = false;
};

/** One attempt, and more without the facets that it has to give up, of which there are fewer each
 * time. */
ExactTetrahedralization AttemptUntilPointsHavePlaces(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, SegmentRecovery::From from, std::int64_t workPerElement,
  Monitor& monitor)
{
  std::vector<Id> names = FacetsWithArea(points, facets);
  for (int attempts = 1;; ++attempts)
  {
    std::vector<Triangle> chosen;
    for (const Id name : names)
    {
      chosen.push_back(facets[name]);
    }
    Attempt attempt(points, chosen, workPerElement, monitor);
    if (attempt.Run(from))
    {
      return attempt.Result(names);
    }
    std::vector<Id> kept;
    for (Id f = 0; f < static_cast<Id>(names.size()); ++f)
    {
      if (attempt.FacetsGivenUp().count(f) == 0)
      {
        kept.push_back(names[f]);
      }
    }
    // Without facets there are no Steiner points, so this ends.
    const bool isHopeless = attempts == MostAttempts || kept.size() == names.size();
    names = isHopeless ? std::vector<Id>() : std::move(kept);
  }
}

/** Facets that no face carries, ascending. */
std::vector<Id> FacetsWithoutFaces(std::size_t numberOfFacets, const std::vector<Id>& facetOfFaces)
{
  std::vector<bool> isThere(numberOfFacets, false);
  for (const Id facet : facetOfFaces)
  {
    isThere[facet] = true;
  }
  std::vector<Id> missing;
  for (std::size_t f = 0; f < numberOfFacets; ++f)
  {
    if (!isThere[f])
    {
      missing.push_back(static_cast<Id>(f));
    }
  }
  return missing;
}
} // namespace

ExactTetrahedralization TetrahedralizeExactly(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Monitor& monitor, std::int64_t workPerElement)
{
  ExactTetrahedralization best;
  std::vector<Id> missing;
  for (const auto from : { SegmentRecovery::From::LowerEnd, SegmentRecovery::From::HigherEnd })
  {
    if (!best.Cells.empty() && Without(FacetsThatCross(points, facets, monitor), missing).empty())
    {
      break;
    }
    ExactTetrahedralization result =
      AttemptUntilPointsHavePlaces(points, facets, from, workPerElement, monitor);
    std::vector<Id> now = FacetsWithoutFaces(facets.size(), result.FacetOfFaces);
    if (best.Cells.empty() || now.size() < missing.size())
    {
      best = std::move(result);
      missing = std::move(now);
    }
    if (missing.empty())
    {
      break;
    }
  }
  return best;
}
} // namespace insideout
