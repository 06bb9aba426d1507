// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactTetrahedralization.h"

#include "Exact/FlipTwins.h"
#include "Exact/RecoverConstraints.h"
#include "Exact/RecoverFacets.h"
#include "Exact/RecoverLostFacets.h"
#include "Exact/ValidFacets.h"

#include <numeric>
#include <utility>

namespace insideout
{
namespace
{
/** Attempts from scratch before meshing without facets. */
constexpr int Attempts = 8;

/** The finite cells, and the faces with facets by these names. */
RawTetrahedra ResultOf(
  const FlippableMesh& mesh, const std::vector<Point>& points, const std::vector<Id>& names)
{
  RawTetrahedra result;
  result.Points = points;
  std::vector<Id> renamed(static_cast<std::size_t>(mesh.Vertices().Size()), None);
  std::iota(renamed.begin(), renamed.begin() + mesh.Infinite(), 0);
  result.Cells.reserve(static_cast<std::size_t>(mesh.NumberOfCells()));
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (mesh.IsDead(cell) || mesh.IsInfinite(cell))
    {
      continue;
    }
    result.Cells.push_back(mesh.Cell(cell).Corners);
    for (Id& corner : result.Cells.back())
    {
      if (renamed[corner] == None)
      {
        renamed[corner] = static_cast<Id>(result.Points.size());
        result.Points.push_back(mesh.Vertices().Nearest(corner));
      }
      corner = renamed[corner];
    }
  }
  result.Faces.reserve(names.size());
  result.FacetOfFaces.reserve(names.size());
  mesh.VisitFacets(
    [&](Id id, int k)
    {
      const FlippableCell& cell = mesh.Cell(id);
      if (cell.Neighbors[k] >= id) // each face once
      {
        const Triangle face = mesh.FaceCorners(id, k);
        result.Faces.push_back({ { renamed[face[0]], renamed[face[1]], renamed[face[2]] } });
        result.FacetOfFaces.push_back(names[cell.Facets[k]]);
      }
    });
  return result;
}

/**
 * One attempt from scratch.
 * @param[in,out] names of the facets with area. Facets with Steiner points that cannot be rounded
 * are removed; then there is no result
 */
bool Attempt(const std::vector<Point>& points, const std::vector<Triangle>& facets, SplitFrom from,
  std::int64_t workPerElement, Monitor& monitor, std::vector<Id>& names,
  ExactTetrahedralization& result)
{
  std::vector<Triangle> chosen;
  for (const Id name : names)
  {
    chosen.push_back(facets[name]);
  }
  WorkBudget work(workPerElement * static_cast<std::int64_t>(points.size() + chosen.size()));
  ExactState state(points, std::move(chosen), work, monitor);
  std::vector<Id> all(names.size());
  std::iota(all.begin(), all.end(), 0);
  std::set<Id> givenUp;
  if (RecoverConstraints(state, all, from, -1, givenUp))
  {
    RecoverLostFacets(state, points, from);
    FlipTwinsAway(state);
    FindLostFacets(state); // marks facets that flips made faces by chance
    result = { ResultOf(state.Mesh, points, names), work.Spent() };
    return true;
  }
  std::vector<Id> kept;
  for (const Id facet : Without(givenUp, all))
  {
    kept.push_back(names[facet]);
  }
  names = std::move(kept);
  return false;
}

/** Repeat attempts, each without the facets given up by the one before. */
ExactTetrahedralization AttemptUntilPointsHavePlaces(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, SplitFrom from, std::int64_t workPerElement,
  Monitor& monitor)
{
  ExactTetrahedralization result;
  std::vector<Id> names = FacetsWithArea(points, facets);
  for (int attempts = 1;; ++attempts)
  {
    const std::size_t before = names.size();
    if (Attempt(points, facets, from, workPerElement, monitor, names, result))
    {
      return result;
    }
    if (attempts == Attempts || names.size() == before)
    {
      names.clear(); // without facets there are no Steiner points, so the loop ends
    }
  }
}

/** Facets that lie on no face, ascending. */
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
  ForwardMonitor forward(monitor);
  ExactTetrahedralization best;
  std::vector<Id> missing;
  for (const auto from : { SplitFrom::Middle, SplitFrom::HigherEnd })
  {
    const bool isFirst = best.Tetrahedra.Cells.empty();
    if (!isFirst && Without(FacetsThatCross(points, facets, missing, forward), missing).empty())
    {
      break;
    }
    ExactTetrahedralization result =
      AttemptUntilPointsHavePlaces(points, facets, from, workPerElement, forward);
    std::vector<Id> now = FacetsWithoutFaces(facets.size(), result.Tetrahedra.FacetOfFaces);
    if (isFirst || now.size() < missing.size())
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
