// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/FacetAhead.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/** Cosine below which a ray counts as running along a face, as rays in the planes of rims do. */
constexpr double LeastCosineThrough = 1e-5;

/**
 * Limit of cells along a ray: most rays cross a few, but among flat cells rounding may make a
 * cycle.
 */
constexpr int MostSteps = 2000;
} // namespace

FacetAhead FindFacetAhead(
  const RefinableMesh& mesh, const RayStart& start, const Point& direction, double enough)
{
  Id cell = start.Cell;
  int entry = start.Entry;
  double way = 0;
  for (int step = 0; cell != None && way <= enough && step < MostSteps; ++step)
  {
    int exit = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4; ++k)
    {
      const bool isBarred = step == 0 && start.Exit >= 0 && k != start.Exit;
      const auto corners = CornersOf(mesh.Points, mesh.FaceCorners(cell, k));
      const Point normal = NormalOf(corners[0], corners[1], corners[2]); // inward
      const double along = Dot(normal, direction);
      if (k == entry || isBarred || !(along < -LeastCosineThrough * Length(normal)))
      {
        continue;
      }
      const double there = Dot(normal, Difference(corners[0], start.From)) / along;
      if (there < nearest)
      {
        nearest = there;
        exit = k;
      }
    }
    if (exit < 0)
    {
      break; // by rounding
    }
    way = std::max(way, nearest);
    if (mesh.Cell(cell).Facets[exit] != None)
    {
      return { way, cell, exit };
    }
    const Id next = mesh.Cell(cell).Neighbors[exit];
    entry = mesh.MirrorIndex(cell, exit);
    cell = next;
  }
  return { way > enough ? std::numeric_limits<double>::infinity() : way, None, -1 };
}
} // namespace insideout
