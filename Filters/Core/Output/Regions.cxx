// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Regions.h"

#include "Output/InsideBoundary.h"

namespace insideout
{
SolidRegions FindRegions(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  CheckLabels(mesh, inside);
  return FindRegions(mesh.Neighbors, inside, monitor, progress);
}

SolidRegions FindSeparatedRegions(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress)
{
  CheckLabels(mesh, inside);
  std::vector<std::array<Id, 4>> neighbors = mesh.Neighbors;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = mesh.Facets[cell][k];
      if (facet != None && surface.Multiplicity[facet] == 0)
      {
        neighbors[cell][k] = None;
      }
    }
  }
  return FindRegions(neighbors, inside, monitor, progress);
}
} // namespace insideout
