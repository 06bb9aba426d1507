// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Outliers.h"

#include "Common/LoopProgress.h"
#include "Output/InsideBoundary.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Per facet, whether the mesh has it as faces. */
std::vector<char> FacetsInMesh(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  std::vector<char> isThere(surface.Facets.size(), 0);
  for (const std::array<Id, 4>& facets : mesh.Facets)
  {
    for (const Id facet : facets)
    {
      if (facet != None)
      {
        isThere[facet] = 1;
      }
    }
  }
  for (const Id facet : mesh.LostFacets)
  {
    isThere[facet] = 0;
  }
  std::fill(isThere.begin() + surface.NumberOfConstraints, isThere.end(), 0);
  return isThere;
}

/** Face k of a cell, in the orientation of the facet that it lies on. */
Triangle AlongFacet(const TetrahedralMesh& mesh, Id cell, int k)
{
  const Triangle face = FaceOf(mesh.Cells[cell], k);
  return mesh.FacetSides[cell][k] < 0 ? Triangle{ { face[0], face[2], face[1] } } : face;
}
} // namespace

std::vector<OutlierPiece> OutlierPieces(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress)
{
  CheckLabels(mesh, inside);
  return OutlierPieces(
    surface, mesh, [&](Id, Id cell) { return inside[cell] != 0; }, monitor, progress);
}

std::vector<OutlierPiece> OutlierPieces(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::function<bool(Id, Id)>& isInside, Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<char> isInMesh = FacetsInMesh(surface, mesh);
  std::vector<OutlierPiece> pieces;
  const LoopProgress cells(monitor, progress, mesh.Cells.size());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    cells.Check(static_cast<std::size_t>(cell));
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = mesh.Facets[cell][k];
      const Id beyond = mesh.Neighbors[cell][k];
      const bool isFirstSide = beyond == None || cell < beyond;
      if (facet != None && isInMesh[facet] && isFirstSide && !isInside(facet, cell) &&
        (beyond == None || !isInside(facet, beyond)))
      {
        pieces.push_back({ AlongFacet(mesh, cell, k), facet, OutlierReason::Energy });
      }
    }
  }
  for (Id facet = 0; facet < surface.NumberOfFacets(); ++facet)
  {
    if (!isInMesh[facet])
    {
      pieces.push_back({ surface.Facets[facet], facet,
        facet < surface.NumberOfConstraints ? OutlierReason::Lost : OutlierReason::LeftOut });
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(),
    [](const OutlierPiece& a, const OutlierPiece& b) { return a.Facet < b.Facet; });
  return pieces;
}
} // namespace insideout
