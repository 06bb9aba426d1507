// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadPlanarSolid.h"

#include "Common/Edge.h"
#include "Common/Error.h"
#include "Common/PointPredicates.h"
#include "Data/Arrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
[[noreturn]] void Refuse(const std::string& what)
{
  throw Error(ErrorCode::InvalidParameter, what);
}

void ReadTriangles(vtkUnstructuredGrid* grid, PlanarSolid& solid)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int type = grid->GetCellType(c);
    if (type != VTK_TRIANGLE)
    {
      Refuse("cell " + std::to_string(c) + " is of VTK's type " + std::to_string(type) +
        "; layers in a plane are made of triangles (5) alone");
    }
    grid->GetCellPoints(c, ids);
    Triangle cell;
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType p = ids->GetId(k);
      if (p < 0 || p >= grid->GetNumberOfPoints())
      {
        throw Error(ErrorCode::PointOutOfRange,
          "cell " + std::to_string(c) + " refers to point " + std::to_string(p) + " of " +
            std::to_string(grid->GetNumberOfPoints()));
      }
      cell[k] = static_cast<Id>(p);
    }
    solid.Mesh.Cells.push_back(cell);
  }
}

int SideOf(const PlanarSolid& solid, const Triangle& cell)
{
  return Orient2D(solid.Places[cell[0]], solid.Places[cell[1]], solid.Places[cell[2]]);
}

void Project(PlanarSolid& solid)
{
  solid.Places.clear();
  for (const Point& p : solid.Points)
  {
    solid.Places.push_back(solid.Plane.Project(p));
  }
}

/** Find the plane, and see it from the side from which the first cell runs counter-clockwise. */
void PutInPlane(PlanarSolid& solid)
{
  solid.Plane = FindPlane(solid.Points);
  if (solid.Plane.Distance > RoundingOfSingles)
  {
    Refuse("the cells are triangles, and points lie up to " + std::to_string(solid.Plane.Distance) +
      " of the largest coordinate off a plane; layers are made of triangles in a plane, or of "
      "tetrahedra");
  }
  Project(solid);
  if (SideOf(solid, solid.Mesh.Cells.front()) < 0)
  {
    solid.Plane = solid.Plane.Turned();
    Project(solid);
  }
  for (std::size_t c = 0; c < solid.Mesh.Cells.size(); ++c)
  {
    if (SideOf(solid, solid.Mesh.Cells[c]) <= 0)
    {
      Refuse("cell " + std::to_string(c) +
        " has no area, or runs the other way than the first: triangles in a plane all run the same "
        "way");
    }
  }
}

void Connect(PlanarSolid& solid)
{
  PlanarMesh& mesh = solid.Mesh;
  mesh.Neighbors.assign(mesh.Cells.size(), { { None, None, None } });
  std::unordered_map<Edge, std::pair<Id, int>, HashOfEdge> open; // number of cells from 1
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Segment ends = EdgeOf(mesh.Cells[c], k);
      auto& [other, count] = open[EdgeBetween(ends[0], ends[1])];
      ++count;
      if (count == 2)
      {
        Id& back = mesh.Neighbors[other / 3][other % 3];
        const Segment there = EdgeOf(mesh.Cells[other / 3], other % 3);
        count = there[0] == ends[1] ? 2 : 3;
        back = c;
        mesh.Neighbors[c][k] = other / 3;
      }
      if (count > 2)
      {
        Refuse("the edge between points " + std::to_string(ends[0]) + " and " +
          std::to_string(ends[1]) + " has several triangles on one side");
      }
      other = 3 * c + k;
    }
  }
}

/** Whether a cell array of three components tells of a facet on an edge. */
bool HasFacet(vtkDataArray* facets, Id cell, int k)
{
  return facets && facets->GetNumberOfComponents() == 3 && facets->GetComponent(cell, k) >= 0;
}

void AddConstraints(vtkUnstructuredGrid* grid, Id label, PlanarSolid& solid)
{
  vtkDataArray* regions = grid->GetCellData()->GetArray("RegionId");
  vtkDataArray* facets = grid->GetCellData()->GetArray("FacetIds");
  PlanarMesh& mesh = solid.Mesh;
  mesh.Segments.assign(mesh.Cells.size(), { { None, None, None } });
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id beyond = mesh.Neighbors[c][k];
      const bool isConstraint = beyond == None || HasFacet(facets, c, k) ||
        (regions && regions->GetComponent(c, 0) != regions->GetComponent(beyond, 0));
      mesh.Segments[c][k] = isConstraint ? label : None;
    }
  }
}

/** Find the edge of each line's segments, and give it the line's tag. */
void AddLines(vtkPolyData* boundary, PlanarSolid& solid)
{
  const std::vector<Point> points = ReadPoints(boundary, "the boundary");
  RequireFinite(points);
  std::map<std::pair<Point, Point>, Id> edges;
  for (Id c = 0; c < solid.Mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Segment ends = EdgeOf(solid.Mesh.Cells[c], k);
      if (solid.Mesh.Neighbors[c][k] == None)
      {
        edges[{ solid.Points[ends[0]], solid.Points[ends[1]] }] = 3 * c + k;
      }
    }
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < boundary->GetNumberOfLines(); ++line)
  {
    boundary->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType from = ids->GetId(i);
      const vtkIdType to = ids->GetId(i + 1);
      const auto count = static_cast<vtkIdType>(points.size());
      const auto found = std::min(from, to) < 0 || std::max(from, to) >= count
        ? edges.end()
        : edges.find({ points[from], points[to] });
      if (found == edges.end())
      {
        Refuse("line " + std::to_string(line) + " of the boundary goes from point " +
          std::to_string(from) + " to " + std::to_string(to) +
          ", which is no edge of one triangle that lies on its left");
      }
      solid.LineOfEdge[found->second] = line;
      solid.Mesh.Segments[found->second / 3][found->second % 3] = solid.Tags.OfCell[line];
    }
  }
}
} // namespace

PlanarSolid ReadPlanarSolid(vtkUnstructuredGrid* grid, vtkPolyData* boundary)
{
  PlanarSolid solid;
  solid.Points = ReadPoints(grid, "the grid");
  RequireFinite(solid.Points);
  ReadTriangles(grid, solid);
  PutInPlane(solid);
  Connect(solid);
  solid.LineOfEdge.assign(3 * solid.Mesh.Cells.size(), -1);
  if (!boundary)
  {
    solid.Tags.Names = { NoTag };
    AddConstraints(grid, 0, solid);
    return solid;
  }
  if (boundary->GetNumberOfLines() != boundary->GetNumberOfCells())
  {
    Refuse("the boundary has cells that are not lines: the grid's cells are triangles");
  }
  solid.Tags = ReadTags(boundary, "", Blocks());
  AddConstraints(grid, static_cast<Id>(solid.Tags.Names.size()), solid);
  AddLines(boundary, solid);
  return solid;
}
} // namespace vtkInsideOut
