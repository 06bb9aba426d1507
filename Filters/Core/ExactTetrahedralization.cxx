// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactTetrahedralization.h"

#include "RecoverFacets.h"
#include "RecoverSegments.h"
#include "SteinerPoints.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace insideout
{
namespace
{
/** The mesh of one attempt to recover facets. */
class Attempt
{
public:
  Attempt(const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor)
    : Points(points)
    , Mesh(points, this->Same)
    , Facets(this->Renamed(facets))
    , Segments(this->Facets)
    , Progress(monitor)
  {
  }

  /**
   * Recover all facets that can be.
   * @return the facets around Steiner points that found no place in doubles, ascending: as long as
   *         there are any, the mesh is good for nothing
   */
  std::vector<Id> Run()
  {
    FacetRecovery facets(this->Mesh, this->Segments, this->Facets, this->Progress);
    SegmentRecovery edges(this->Mesh, this->Segments, this->Progress);
    std::vector<Id> missing(this->Facets.size());
    std::iota(missing.begin(), missing.end(), 0);
    missing = facets.MarkWholeFacets(missing);
    edges.RecoverBySplits(edges.RecoverByFlips(edges.FindMissing()));
    missing = facets.MarkWholeFacets(missing);
    facets.RecoverBySplits(facets.RecoverByFlips(missing));

    SteinerPoints steiner(this->Mesh, this->Segments, this->Progress);
    steiner.Remove();
    steiner.MoveIntoVolume();
    steiner.Remove();
    std::set<Id> around;
    for (const Id point : steiner.Round())
    {
      const std::vector<Id> here = steiner.FacetsAt(point);
      around.insert(here.begin(), here.end());
    }
    return { around.begin(), around.end() };
  }

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
    const std::vector<Id> givenUp = attempt.Run();
    if (givenUp.empty())
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
      if (!std::binary_search(givenUp.begin(), givenUp.end(), f))
      {
        kept.push_back(names[f]);
      }
    }
    names = std::move(kept);
  }
}
} // namespace insideout
