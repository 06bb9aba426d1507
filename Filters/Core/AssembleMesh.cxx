// SPDX-License-Identifier: GPL-3.0-or-later
#include "AssembleMesh.h"

#include "FaceTable.h"
#include "PlaceFacets.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

namespace insideout
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

[[noreturn]] void ThrowInconsistent(const std::string& what)
{
  throw Error(ErrorCode::Inconsistent, "TetGen's mesh is inconsistent: " + what);
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
    if (!std::all_of(points[p].begin(), points[p].end(), [](double x) { return std::isfinite(x); }))
    {
      ThrowInconsistent("Steiner point " + std::to_string(p) + " is not finite");
    }
  }
}

std::vector<bool> UsedPoints(std::size_t numberOfPoints, const std::vector<Tetrahedron>& cells)
{
  std::vector<bool> used(numberOfPoints, false);
  for (const Tetrahedron& cell : cells)
  {
    for (const Id corner : cell)
    {
      used[corner] = true;
    }
  }
  return used;
}

/** TetGen hands out Steiner points too that it has taken out of every cell again: drop them. */
void DropUnusedSteinerPoints(std::size_t numberOfInputPoints, TetgenAnswer& answer)
{
  const std::vector<bool> used = UsedPoints(answer.Points.size(), answer.Cells);
  std::vector<Id> index(answer.Points.size());
  std::size_t kept = 0;
  for (std::size_t p = 0; p < answer.Points.size(); ++p)
  {
    index[p] = static_cast<Id>(kept);
    answer.Points[kept] = answer.Points[p];
    kept += p < numberOfInputPoints || used[p];
  }
  answer.Points.resize(kept);
  for (Tetrahedron& cell : answer.Cells)
  {
    for (Id& corner : cell)
    {
      corner = index[corner];
    }
  }
  for (Triangle& face : answer.Faces)
  {
    for (Id& corner : face)
    {
      corner = index[corner];
    }
  }
}

/** Only a second point at the same place may be in no cell. */
void CheckPointsAreUsed(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
{
  const std::vector<bool> used = UsedPoints(points.size(), cells);
  if (std::find(used.begin(), used.end(), false) == used.end())
  {
    return;
  }
  std::set<Point> places;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (used[p])
    {
      places.insert(points[p]);
    }
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (!used[p] && places.count(points[p]) == 0)
    {
      ThrowInconsistent("point " + std::to_string(p) + " is in no cell");
    }
  }
}

/** TetGen's cells are oriented the other way than VTK's. */
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
        return "face " + std::to_string(lowest) + " " + std::to_string(first.Middle) + " " +
          std::to_string(first.Highest);
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

TetrahedralMesh AssembleMesh(const FacetComplex& surface, TetgenAnswer answer)
{
  CheckInputPoints(surface.Points, answer.Points);
  DropUnusedSteinerPoints(surface.Points.size(), answer);
  CheckPointsAreUsed(answer.Points, answer.Cells);
  OrientCells(answer.Points, answer.Cells);
  TetrahedralMesh mesh;
  mesh.Points = std::move(answer.Points);
  mesh.Cells = std::move(answer.Cells);
  mesh.Origins = surface.Origins;
  mesh.Origins.resize(mesh.Points.size());
  mesh.NumberOfSteinerPoints = static_cast<Id>(mesh.Points.size() - surface.Points.size());
  const FaceTable faces(mesh.Points.size(), mesh.Cells);
  MatchNeighbors(faces, mesh);
  PlaceFacets(surface, faces, answer.Faces, answer.FacetOfFaces, mesh);
  return mesh;
}
} // namespace insideout
