// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/AssembleMesh.h"

#include "Common/FaceTable.h"
#include "Common/Kernel.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Tetrahedralize/CheckConvexHull.h"
#include "Tetrahedralize/PlaceFacets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

namespace insideout
{
namespace
{

[[noreturn]] void ThrowInconsistent(const std::string& what)
{
  throw Error(ErrorCode::Inconsistent, "the mesh is inconsistent: " + what);
}

// --- Points and cells ----------------------------------------------------------------------------

void CheckInputPoints(const std::vector<Point>& input, const std::vector<Point>& points)
{
  for (std::size_t p = 0; p < input.size(); ++p)
  {
    if (p >= points.size() || std::memcmp(&input[p], &points[p], sizeof(Point)) != 0)
    {
      ThrowInconsistent("point " + std::to_string(p) + " is missing or was moved");
    }
  }
  for (std::size_t p = input.size(); p < points.size(); ++p)
  {
    if (!IsFinite(points[p]))
    {
      ThrowInconsistent("Steiner point " + std::to_string(p) + " is not finite");
    }
  }
}

std::vector<bool> PointsInCells(std::size_t points, const std::vector<Tetrahedron>& cells)
{
  std::vector<bool> used(points, false);
  for (const Tetrahedron& cell : cells)
  {
    for (const Id corner : cell)
    {
      used[corner] = true;
    }
  }
  return used;
}

/** Of the first `count` points only a second one at the same place may be in no cell. */
void CheckPointsAreUsed(
  const std::vector<Point>& points, std::size_t count, const std::vector<bool>& used)
{
  if (std::find(used.begin(), used.begin() + count, false) == used.begin() + count)
  {
    return;
  }
  std::set<Point> places;
  for (std::size_t p = 0; p < count; ++p)
  {
    if (used[p])
    {
      places.insert(points[p]);
    }
  }
  for (std::size_t p = 0; p < count; ++p)
  {
    if (!used[p] && places.count(points[p]) == 0)
    {
      ThrowInconsistent("point " + std::to_string(p) + " is in no cell");
    }
  }
}

/** Steiner points that were added and taken back may still be in the list (TetGen's are): leave
 * them out. */
void RemoveUnusedSteinerPoints(
  std::size_t inputPoints, const std::vector<bool>& used, RawTetrahedra& raw)
{
  std::vector<Id> renamed(raw.Points.size(), None);
  std::size_t kept = 0;
  for (std::size_t p = 0; p < raw.Points.size(); ++p)
  {
    if (p < inputPoints || used[p])
    {
      raw.Points[kept] = raw.Points[p];
      renamed[p] = static_cast<Id>(kept++);
    }
  }
  if (kept == raw.Points.size())
  {
    return;
  }
  raw.Points.resize(kept);
  const auto rename = [&](auto& elements)
  {
    for (auto& element : elements)
    {
      for (Id& p : element)
      {
        p = renamed[p];
      }
    }
  };
  rename(raw.Cells);
  rename(raw.Faces);
}

/** Whatever the tetrahedralizer's own orientation is: TetGen's is the other way than VTK's. */
void OrientCells(const std::vector<Point>& points, std::vector<Tetrahedron>& cells)
{
  const auto at = [&](Id p) { return Kernel::Point_3(points[p][0], points[p][1], points[p][2]); };
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    Tetrahedron& cell = cells[c];
    const CGAL::Orientation orientation =
      CGAL::orientation(at(cell[0]), at(cell[1]), at(cell[2]), at(cell[3]));
    if (orientation == CGAL::COPLANAR)
    {
      ThrowInconsistent("cell " + std::to_string(c) + " (points " + std::to_string(cell[0]) + " " +
        std::to_string(cell[1]) + " " + std::to_string(cell[2]) + " " + std::to_string(cell[3]) +
        ") is flat");
    }
    if (orientation == CGAL::NEGATIVE)
    {
      std::swap(cell[2], cell[3]);
    }
  }
}

void MatchNeighbors(const FaceTable& faces, TetrahedralMesh& mesh)
{
  mesh.Neighbors.assign(mesh.Cells.size(), { { None, None, None, None } });
  faces.ForEach(
    [&](const FaceTable::Range& face, Id lowest)
    {
      const FaceEntry& first = face.First[0];
      const auto name = [&]()
      {
        return "face " + std::to_string(lowest) + " " + std::to_string(first.Middle()) + " " +
          std::to_string(first.Highest());
      };
      const auto cells = face.Last - face.First;
      if (cells > 2)
      {
        ThrowInconsistent(name() + " has " + std::to_string(cells) + " cells");
      }
      if (cells == 2)
      {
        const FaceEntry& second = face.First[1];
        if (first.Turned == second.Turned)
        {
          ThrowInconsistent(name() + " has cells " + std::to_string(first.Cell) + " and " +
            std::to_string(second.Cell) + " on one side");
        }
        mesh.Neighbors[first.Cell][first.Face] = second.Cell;
        mesh.Neighbors[second.Cell][second.Face] = first.Cell;
      }
    });
}
} // namespace

TetrahedralMesh AssembleMesh(const FacetComplex& surface, RawTetrahedra raw, Monitor& monitor)
{
  monitor.Check(Stages::Tetrahedralizing, 0.9);
  CheckInputPoints(surface.Points, raw.Points);
  const std::vector<bool> used = PointsInCells(raw.Points.size(), raw.Cells);
  CheckPointsAreUsed(raw.Points, surface.Points.size(), used);
  RemoveUnusedSteinerPoints(surface.Points.size(), used, raw);
  OrientCells(raw.Points, raw.Cells);
  monitor.Check(Stages::Tetrahedralizing, 0.93);
  TetrahedralMesh mesh;
  mesh.Points = std::move(raw.Points);
  mesh.Cells = std::move(raw.Cells);
  mesh.Origins = surface.Origins;
  mesh.Origins.resize(mesh.Points.size());
  mesh.NumberOfSteinerPoints = static_cast<Id>(mesh.Points.size() - surface.Points.size());
  const FaceTable faces(mesh.Points.size(), mesh.Cells);
  MatchNeighbors(faces, mesh);
  CheckConvexHull(mesh, surface.Points.size());
  monitor.Check(Stages::Tetrahedralizing, 0.96);
  PlaceFacets(surface, faces, raw.Faces, raw.FacetOfFaces, mesh);
  return mesh;
}
} // namespace insideout
