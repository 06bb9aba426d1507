// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/WindingNumbersOfBodies.h"

#include "Boolean/SingleBodies.h"
#include "Common/PartMonitor.h"
#include "WindingNumber/WindingNumberOfCells.h"

namespace insideout
{
std::vector<std::vector<double>> WindingNumbersOfBodies(
  const ResolvedBodies& bodies, const TetrahedralMesh& mesh, int quadratureOrder, Monitor& monitor)
{
  std::vector<std::vector<double>> w;
  for (Id b = 0; b < bodies.NumberOfBodies(); ++b)
  {
    PartMonitor part(monitor, b, bodies.NumberOfBodies());
    w.push_back(WindingNumberOfCells(ComplexOfBody(bodies, b), mesh, part, quadratureOrder));
  }
  return w;
}

std::vector<std::vector<double>> WindingNumbersOfOpenBodies(const ResolvedBodies& bodies,
  const TetrahedralMesh& mesh, const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, int quadratureOrder, Monitor& monitor,
  const ProgressRange& progress)
{
  const std::vector<char> isClosed =
    FindClosedBodies(bodies, SortedFacetEdges(bodies.Surface.Facets));
  std::vector<std::vector<double>> w(isClosed.size());
  for (Id b = 0; b < bodies.NumberOfBodies(); ++b)
  {
    if (isClosed[b] == 0)
    {
      w[b] = WindingNumberOfOtherCells(
        ComplexOfBody(bodies, b), mesh, points, cells, quadratureOrder, monitor, progress);
    }
  }
  return w;
}
} // namespace insideout
