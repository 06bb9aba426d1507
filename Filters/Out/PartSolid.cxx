// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/PartSolid.h"

#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Output/SeparateOverlaps.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <sstream>

namespace vtkInsideOut
{
using namespace insideout;

void SeparateOverlaps(
  const HullMesh& hull, Parting& parting, Monitor& monitor, const ProgressRange& progress)
{
  const OverlapCounts counts =
    SeparateOverlaps(hull.Surface, hull.W, parting.Solid, monitor, progress);
  parting.Statistics.emplace_back("Overlaps", counts.Overlaps);
  parting.Statistics.emplace_back("SeparatedOverlaps", counts.Separated);
  parting.Statistics.emplace_back("CopiedCells", counts.CopiedCells);
  if (const Id left = counts.Overlaps - counts.Separated; left > 0)
  {
    std::ostringstream words;
    words << left << " of " << counts.Overlaps << " overlaps stay glued, the first at ("
          << counts.Left[0] << ", " << counts.Left[1] << ", " << counts.Left[2]
          << "): nothing tells which of their faces belong to which of two layers";
    parting.Warnings.push_back(words.str());
  }
}

void SplitPoints(Parting& parting, Monitor& monitor, const ProgressRange& progress)
{
  const std::size_t before = parting.Solid.Mesh.Points.size();
  PartPoints(parting.Solid, std::vector<unsigned char>(before, 1), monitor, progress);
  parting.Statistics.emplace_back("SplitPoints", parting.Solid.Mesh.Points.size() - before);
}

void TellOfSharedPoints(
  const ManifoldSurface& boundary, Statistics& statistics, std::vector<std::string>& warnings)
{
  statistics.emplace_back("SharedPoints", boundary.SharedPoints);
  statistics.emplace_back("NonManifoldEdges", boundary.LeftEdges);
  if (boundary.SharedPoints > 0)
  {
    warnings.push_back(std::to_string(boundary.SharedPoints) +
      " points of the boundary are copies that the solid's cells share: these join all around what "
      "touches there");
  }
  if (boundary.LeftEdges > 0)
  {
    warnings.push_back(std::to_string(boundary.LeftEdges) +
      " edges of the boundary have more than two triangles, in overlaps that were separated");
  }
}

namespace
{
/** The solid's cells with their corners in the grid's order. */
std::vector<Tetrahedron> CellsInOrderOf(vtkUnstructuredGrid* grid, const PartedSolid& solid)
{
  std::vector<Tetrahedron> cells = solid.Mesh.Cells;
  vtkNew<vtkIdList> given;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    grid->GetCellPoints(solid.Originals[c], given);
    for (int k = 0; k < 4; ++k)
    {
      cells[c][k] = *std::find_if(solid.Mesh.Cells[c].begin(), solid.Mesh.Cells[c].end(),
        [&](Id corner) { return solid.Places[corner] == given->GetId(k); });
    }
  }
  return cells;
}
} // namespace

vtkSmartPointer<vtkUnstructuredGrid> MakePartedGrid(
  vtkUnstructuredGrid* grid, const Parting& parting)
{
  const PartedSolid& solid = parting.Solid;
  std::vector<Attributes::Mixture> copies;
  copies.reserve(solid.Places.size());
  for (const Id place : solid.Places)
  {
    copies.push_back({ { { place, 0, 0, 0 } }, { { 1, 0, 0, 0 } }, false });
  }
  std::vector<std::string> told; // reported when the grid was made
  auto parted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  parted->SetPoints(MakePoints(solid.Mesh.Points));
  parted->SetCells(VTK_TETRA, MakeCells(CellsInOrderOf(grid, solid)));
  Attributes::MixPointData(grid, copies, {}, parted->GetPointData(), told);
  Attributes::CopyCellData(grid, solid.Originals, parted->GetCellData(), told);
  parted->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return parted;
}
} // namespace vtkInsideOut
