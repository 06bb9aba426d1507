// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/InsideBoundary.h"

#include "Common/Error.h"
#include "Common/LoopProgress.h"

namespace insideout
{
void CheckLabels(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  if (inside.size() != mesh.Cells.size())
  {
    throw Error(ErrorCode::InvalidParameter,
      std::to_string(inside.size()) + " inside labels for " + std::to_string(mesh.Cells.size()) +
        " cells");
  }
}

namespace
{
bool IsInside(const std::vector<unsigned char>& inside, Id cell)
{
  return cell != None && inside[cell] != 0;
}
} // namespace

std::vector<BoundaryFace> BoundaryFaces(const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress)
{
  CheckLabels(mesh, inside);
  const LoopProgress cells(monitor, progress, mesh.Cells.size());
  std::vector<BoundaryFace> faces;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    cells.Check(static_cast<std::size_t>(cell));
    for (int k = 0; inside[cell] != 0 && k < 4; ++k)
    {
      if (!IsInside(inside, mesh.Neighbors[cell][k]))
      {
        faces.push_back({ FaceOf(mesh.Cells[cell], k), cell, k, mesh.Facets[cell][k] });
      }
    }
  }
  return faces;
}
} // namespace insideout
