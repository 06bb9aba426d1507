// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefinedSurface.h"

#include "Common/ParallelLoop.h"
#include "Common/PartMonitor.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Vectors.h"
#include "Refine/SurfaceBound.h"
#include "Resolve/FindIntersections.h"

#include <algorithm>
#include <atomic>

namespace insideout
{
namespace
{
/** In nanoseconds. */
constexpr double CostOfDistance = 5000;
} // namespace

std::vector<Id> CrossingFacets(
  const RefinableMesh& mesh, Monitor& monitor, const ProgressRange& progress)
{
  std::vector<Triangle> triangles;
  std::vector<Id> facets;
  mesh.VisitFacets(
    [&](Id c, int k)
    {
      if (mesh.Cell(c).Neighbors[k] == None)
      {
        triangles.push_back(FaceAcross(mesh.Cell(c).Corners, k));
        facets.push_back(mesh.Cell(c).Facets[k]);
      }
    });
  QuietMonitor quiet(monitor, progress);
  std::vector<Id> crossing;
  for (const auto& [i, j] : FindIntersections(mesh.Points, triangles, quiet))
  {
    crossing.insert(crossing.end(), { facets[i], facets[j] });
  }
  SortUniquely(crossing);
  return crossing;
}

void FindNearestFacets(const std::vector<FacetOfInput>& facets, RefinableMesh& mesh,
  Monitor& monitor, const ProgressRange& progress)
{
  const TriangleTree tree(TrianglesOf(facets));
  ParallelLoop(mesh.NumberOfCells(), CostOfDistance, monitor, progress,
    [&](Id c)
    {
      for (int k = 0; k < 4 && !mesh.IsDead(c); ++k)
      {
        const RefinableCell& cell = mesh.Cell(c);
        if (cell.Facets[k] != None)
        {
          // The center is the same from both sides, and so is the nearest facet.
          const Triangle sorted = SortedTriangle(FaceAcross(cell.Corners, k)).Points;
          const Point centre = CentreOf(CornersOf(mesh.Points, sorted));
          const Id facet = cell.Facets[k];
          mesh.SetFacet(c, k, tree.NearestTo(centre, facets[facet].Label, facet).Triangle);
        }
      }
    });
}

double LargestDistance(const std::vector<LabelledTriangle>& from,
  const std::vector<LabelledTriangle>& to, double enough, Monitor& monitor,
  const ProgressRange& progress)
{
  const TriangleTree tree(to);
  // Few triangles are farther than those before them; the rest need no close check.
  std::atomic<double> largest{ 0 };
  ParallelLoop(from.size(), CostOfDistance, monitor, progress,
    [&](std::size_t i)
    {
      double known = largest;
      const double distance = tree.LargestDistanceOf(from[i], enough, std::max(enough, known));
      while (distance > known && !largest.compare_exchange_weak(known, distance))
      {
      }
    });
  return largest;
}
} // namespace insideout
