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

double VolumeWithin(
  const std::vector<Point>& points, const std::vector<BoundaryTriangle>& triangles)
{
  long double sixfold = 0;
  for (const auto& [corners, source] : triangles)
  {
    // Relative to a corner of the surface, so that a solid far from the origin loses no digits.
    std::array<std::array<long double, 3>, 3> v;
    for (int k = 0; k < 3; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        v[k][axis] = static_cast<long double>(points[corners[k]][axis]) -
          points[triangles.front().Corners[0]][axis];
      }
    }
    sixfold += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
      v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
      v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
  }
  return static_cast<double>(sixfold / 6);
}

std::vector<Triangle> TrianglesInMesh(const TriangleSoup& soup, const std::vector<Id>& mergedInto,
  const std::vector<PointOrigin>& origins)
{
  std::vector<Id> place(soup.Points.size(), None);
  for (Id p = 0; p < static_cast<Id>(origins.size()); ++p)
  {
    // Rounding may put a new point, which comes later, at the same place.
    if (origins[p].IsInput() && place[origins[p].Points[0]] == None)
    {
      place[origins[p].Points[0]] = p;
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
