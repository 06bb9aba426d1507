// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactTetrahedralization.h"

#include "PointSupport.h"
#include "RecoverFacets.h"
#include "RecoverSegments.h"
#include "RoundPoints.h"
#include "SteinerPoints.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace insideout
{
namespace
{
/** Facets are tried so many times. */
constexpr int MostRounds = 3;

/** Edges that are tried to flip a face away. */
constexpr int MostTwinFlips = 200;

/** Facets are given up in so many rings of cells around points that find no place. */
constexpr int MostRings = 5;

/** The mesh of one attempt to recover facets. */
class Attempt
{
public:
  Attempt(const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor)
    : Points(points)
    , Mesh(points, this->Same, monitor)
    , Facets(this->Renamed(facets))
    , Segments(this->Facets)
    , Progress(monitor)
  {
  }

  /**
   * Recover all facets that can be. Facets that have to be given up, for Steiner points on them
   * find no place in doubles, get another chance when the others are done.
   * @return whether all Steiner points have places; if not, the mesh is good for nothing
   */
  bool Run()
  {
    std::vector<Id> missing(this->Facets.size());
    std::iota(missing.begin(), missing.end(), 0);
    for (int round = 0; round < MostRounds && !missing.empty(); ++round)
    {
      this->Recover(missing);
      std::vector<Id> left = this->RoundAll();
      for (int rings = 0; !left.empty() && rings < MostRings; ++rings)
      {
        this->GiveUp(this->FacetsAround(left, rings));
        left = this->RoundAll();
      }
      if (!left.empty())
      {
        return false;
      }
      missing = this->AnotherChance();
    }
    this->TakeWholeTwinsAway();
    this->MarkLostFacetsThatAreFaces();
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
  void Recover(std::vector<Id> missing)
  {
    FacetRecovery facets(this->Mesh, this->Segments, this->Facets, this->Progress);
    SegmentRecovery edges(this->Mesh, this->Segments, this->Progress);
    missing = facets.MarkWholeFacets(missing);
    edges.RecoverBySplits(edges.RecoverByFlips(edges.FindMissing(this->SegmentsOf(missing))));
    missing = facets.MarkWholeFacets(missing);
    facets.RecoverBySplits(facets.RecoverByFlips(missing));
    this->TidyUp();
  }

  /** Take Steiner points away, or off the surface. */
  void TidyUp()
  {
    SteinerPoints steiner(this->Mesh, this->Segments, this->Progress);
    steiner.Remove();
    steiner.MoveIntoVolume();
    steiner.Remove();
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
  void GiveUp(const std::set<Id>& facets)
  {
    this->GivenUp.insert(facets.begin(), facets.end());
    for (FlippableCell& cell : this->Mesh.Cells)
    {
      for (Id& facet : cell.Facets)
      {
        facet = facets.count(facet) > 0 ? None : facet;
      }
    }
    std::vector<bool> isUsed(static_cast<std::size_t>(this->Segments.Size()), false);
    for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
    {
      for (int k = 0; this->GivenUp.count(facet) == 0 && k < 3; ++k)
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
   * Mark facets that were given up and are there after all. @return the others that can be tried
   * again: facets whose edges have Steiner points cannot be, for these are rounded
   */
  std::vector<Id> AnotherChance()
  {
    FacetRecovery recovery(this->Mesh, this->Segments, this->Facets, this->Progress);
    std::vector<Id> facets;
    for (const Id facet : recovery.MarkWholeFacets({ this->GivenUp.begin(), this->GivenUp.end() }))
    {
      bool isWhole = true;
      for (int k = 0; k < 3; ++k)
      {
        isWhole = isWhole && this->Segments.Path(this->Segments.OfFacet(facet, k)).size() == 2;
      }
      if (isWhole)
      {
        facets.push_back(facet);
      }
    }
    for (const Id facet : facets)
    {
      this->GivenUp.erase(facet);
      for (int k = 0; k < 3; ++k)
      {
        this->Segments.Restore(this->Segments.OfFacet(facet, k));
      }
    }
    return facets;
  }

  void MarkLostFacetsThatAreFaces()
  {
    std::vector<bool> isThere(this->Facets.size(), false);
    for (const FlippableCell& cell : this->Mesh.Cells)
    {
      for (const Id facet : cell.Facets)
      {
        if (facet != None)
        {
          isThere[facet] = true;
        }
      }
    }
    std::vector<Id> lost;
    for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
    {
      if (!isThere[facet])
      {
        lost.push_back(facet);
      }
    }
    FacetRecovery(this->Mesh, this->Segments, this->Facets, this->Progress).MarkWholeFacets(lost);
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
    std::vector<bool> isOnSurface(result.Points.size(), false);
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
          isOnSurface[face[j]] = true;
        }
        result.Faces.push_back(face);
        result.FacetOfFaces.push_back(names[cell.Facets[k]]);
      }
    }
    result.NumberOfSurfaceSteinerPoints = static_cast<Id>(
      std::count(isOnSurface.begin() + this->Mesh.Infinite(), isOnSurface.end(), true));
  }

  const std::vector<Point>& Points;
  std::vector<Id> Same;
  FlippableMesh Mesh;
  std::vector<Triangle> Facets;
  SegmentTable Segments;
  Monitor& Progress;
  std::set<Id> GivenUp;
};

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
} // namespace

ExactTetrahedralization TetrahedralizeExactly(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor)
{
  std::vector<Id> names = FacetsWithArea(points, facets);
  for (;;)
  {
    std::vector<Triangle> chosen;
    for (const Id name : names)
    {
      chosen.push_back(facets[name]);
    }
    Attempt attempt(points, chosen, monitor);
    if (attempt.Run())
    {
      ExactTetrahedralization result = attempt.Result(names);
      std::vector<bool> isThere(facets.size(), false);
      for (const Id facet : result.FacetOfFaces)
      {
        isThere[facet] = true;
      }
      for (std::size_t f = 0; f < facets.size(); ++f)
      {
        if (!isThere[f])
        {
          result.LostFacets.push_back(static_cast<Id>(f));
        }
      }
      return result;
    }
    // Without these, once more; there are fewer each time.
    std::vector<Id> kept;
    for (Id f = 0; f < static_cast<Id>(names.size()); ++f)
    {
      if (attempt.FacetsGivenUp().count(f) == 0)
      {
        kept.push_back(names[f]);
      }
    }
    names = std::move(kept);
  }
}
} // namespace insideout
