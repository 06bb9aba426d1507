// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/AssembleMesh.h"

#include "Common/FaceTable.h"
#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Tetrahedralize/CheckConvexHull.h"
#include "Tetrahedralize/PlaceFacets.h"

#include <algorithm>
#include <atomic>
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

/** A point among the first `count` may be in no cell only if another point lies at its position. */
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

/** Leave out Steiner points that the tetrahedralizer added and removed again; TetGen keeps them in
 * its list. */
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

/** The tetrahedralizer may orient cells either way: TetGen's orientation is opposite to VTK's. */
void OrientCells(const std::vector<Point>& points, std::vector<Tetrahedron>& cells)
{
  const double cost = 50;
  std::atomic<std::size_t> firstFlat{ cells.size() };
  ParallelLoop(cells.size(), cost,
    [&](std::size_t c)
    {
      const int orientation = Orient3D(points, cells[c]);
      if (orientation < 0)
      {
        std::swap(cells[c][2], cells[c][3]);
      }
      for (std::size_t first = firstFlat; orientation == 0 && c < first;)
      {
        firstFlat.compare_exchange_weak(first, c);
      }
    });
  if (firstFlat < cells.size())
  {
    const Tetrahedron& cell = cells[firstFlat];
    ThrowInconsistent("cell " + std::to_string(firstFlat) + " (points " + std::to_string(cell[0]) +
      " " + std::to_string(cell[1]) + " " + std::to_string(cell[2]) + " " +
      std::to_string(cell[3]) + ") is flat");
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
