// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefinedSurface.h"

#include "Common/ParallelLoop.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Vectors.h"
#include "Resolve/FindIntersections.h"

#include <algorithm>
#include <atomic>

namespace insideout
{
namespace
{
/** In nanoseconds. */
constexpr double CostOfDistance = 5000;

/** Reports only that a search is running. */
class QuietMonitor : public Monitor
{
public:
  QuietMonitor(Monitor& caller, const ProgressRange& progress)
    : Caller(caller)
    , Progress(progress)
  {
  }

  bool Continue(const char* /*stage*/, double /*fraction*/) override
  {
    return this->Caller.Continue(this->Progress.Stage, this->Progress.Begin);
  }

private:
  Monitor& Caller;
  const ProgressRange& Progress;
};
} // namespace

std::vector<Id> CrossingFacets(
  const RefinableMesh& mesh, Monitor& monitor, const ProgressRange& progress)
{
  std::vector<Triangle> triangles;
  std::vector<Id> facets;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4 && !mesh.IsDead(c); ++k)
    {
      if (mesh.Cell(c).Neighbors[k] == None)
      {
        triangles.push_back(FaceAcross(mesh.Cell(c).Corners, k));
        facets.push_back(mesh.Cell(c).Facets[k]);
      }
    }
  }
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
  std::vector<LabelledTriangle> triangles;
  for (const FacetOfInput& facet : facets)
  {
    triangles.push_back({ facet.Corners, facet.Label });
  }
  const TriangleTree tree(std::move(triangles));
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
          const auto [p, q, r] = CornersOf(mesh.Points, sorted);
          const Point centre = { { p[0] / 3 + q[0] / 3 + r[0] / 3, p[1] / 3 + q[1] / 3 + r[1] / 3,
            p[2] / 3 + q[2] / 3 + r[2] / 3 } };
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
