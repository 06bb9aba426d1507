// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/ConnectCells.h"

#include "Common/Error.h"
#include "Common/FaceTable.h"
#include "Common/PointPredicates.h"

namespace insideout
{
TetrahedralMesh ConnectCells(std::vector<Point> points, std::vector<Tetrahedron> cells)
{
  TetrahedralMesh mesh;
  mesh.Points = std::move(points);
  mesh.Cells = std::move(cells);
  mesh.Neighbors.assign(mesh.Cells.size(), { { None, None, None, None } });
  mesh.Facets.assign(mesh.Cells.size(), { { None, None, None, None } });
  mesh.FacetSides.assign(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  for (Tetrahedron& cell : mesh.Cells)
  {
    if (Orient3D(mesh.Points, cell) < 0)
    {
      std::swap(cell[2], cell[3]);
    }
  }
  if (mesh.Cells.empty())
  {
    return mesh;
  }
  const FaceTable table(mesh.Points.size(), mesh.Cells);
  table.ForEach(
    [&](FaceTable::Range face, Id)
    {
      const std::ptrdiff_t sharing = face.end() - face.begin();
      if (sharing > 2)
      {
        throw Error(ErrorCode::InvalidParameter,
          "cells " + std::to_string(face.First[0].Cell) + ", " +
            std::to_string(face.First[1].Cell) + " and " + std::to_string(face.First[2].Cell) +
            " share one face: the grid does not conform");
      }
      if (sharing == 2)
      {
        mesh.Neighbors[face.First[0].Cell][face.First[0].Face] = face.First[1].Cell;
        mesh.Neighbors[face.First[1].Cell][face.First[1].Face] = face.First[0].Cell;
      }
    });
  return mesh;
}
} // namespace insideout
