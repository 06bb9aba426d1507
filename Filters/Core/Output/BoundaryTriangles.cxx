// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/BoundaryTriangles.h"

#include "Common/LoopProgress.h"

namespace insideout
{
std::vector<BoundaryTriangle> BoundaryTriangles(const FacetComplex& surface,
  const TetrahedralMesh& mesh, const std::vector<BoundaryFace>& faces, Monitor& monitor,
  const ProgressRange& progress)
{
  const LoopProgress turns(monitor, progress, faces.size());
  std::vector<BoundaryTriangle> triangles;
  triangles.reserve(faces.size());
  for (const BoundaryFace& face : faces)
  {
    turns.Check(triangles.size());
    triangles.push_back({ face.Corners,
      face.Facet == None
        ? None
        : SourceOfFacet(surface, face.Facet, mesh.FacetSides[face.Cell][face.Face]) });
  }
  return triangles;
}

std::vector<Triangle> TrianglesInMesh(
  const TriangleSoup& soup, const std::vector<Id>& mergedInto, const TetrahedralMesh& mesh)
{
  std::vector<Id> place(soup.Points.size(), None);
  for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); ++p)
  {
    // Rounding may put a new point, which comes later, in the same place.
    if (mesh.Origins[p].IsInput() && place[mesh.Origins[p].Points[0]] == None)
    {
      place[mesh.Origins[p].Points[0]] = p;
    }
  }
  std::vector<Triangle> triangles = soup.Triangles;
  for (Triangle& triangle : triangles)
  {
    for (Id& corner : triangle)
    {
      corner = place[mergedInto[corner]];
    }
  }
  return triangles;
}
} // namespace insideout
