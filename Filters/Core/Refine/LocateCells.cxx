// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/LocateCells.h"

#include "Common/BoxTree.h"
#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Limit of steps of a walk: longer ones are cyclic. */
constexpr int MostSteps = 1000;

/** Nanoseconds per walk, and per search in a tree. */
constexpr double CostOfWalk = 1000;

Box BoxOf(const std::vector<Point>& points, const Tetrahedron& cell)
{
  Box box = Box::Empty();
  for (const Id corner : cell)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = std::min(box.Low[axis], points[corner][axis]);
      box.High[axis] = std::max(box.High[axis], points[corner][axis]);
    }
  }
  return box;
}

/** Whether a place is beyond a face of a cell. */
bool IsBeyond(
  const std::vector<Point>& points, const Tetrahedron& cell, int face, const Point& place)
{
  const Triangle f = FaceOf(cell, face);
  return Orient3D(points[f[0]], points[f[1]], points[f[2]], place) > 0;
}

bool Holds(const TetrahedralMesh& mesh, Id cell, const Point& place)
{
  for (int k = 0; k < 4; ++k)
  {
    if (IsBeyond(mesh.Points, mesh.Cells[cell], k, place))
    {
      return false;
    }
  }
  return true;
}

/** @return false if the walk met the boundary; the cell is then the last one */
bool Walk(const TetrahedralMesh& mesh, const Point& place, Id& cell)
{
  for (int step = 0; step < MostSteps; ++step)
  {
    int across = -1;
    for (int i = 0; i < 4 && across < 0; ++i)
    {
      const int k = (i + step) % 4;
      across = IsBeyond(mesh.Points, mesh.Cells[cell], k, place) ? k : -1;
    }
    if (across < 0)
    {
      return true;
    }
    const Id next = mesh.Neighbors[cell][across];
    if (next == None)
    {
      return false;
    }
    cell = next;
  }
  return false;
}
} // namespace

void LocateCells(const TetrahedralMesh& mesh, const std::vector<Point>& places,
  std::vector<Id>& cells, Monitor& monitor, const ProgressRange& progress)
{
  std::vector<char> isFound(places.size(), 0);
  ParallelLoop(places.size(), CostOfWalk, monitor,
    { progress.Stage, progress.At(0), progress.At(0.5) },
    [&](std::size_t i) { isFound[i] = Walk(mesh, places[i], cells[i]) ? 1 : 0; });
  if (std::all_of(isFound.begin(), isFound.end(), [](char found) { return found != 0; }))
  {
    return;
  }
  // The solid is not convex: the straight way to the place may leave it.
  std::vector<Box> boxes;
  boxes.reserve(mesh.Cells.size());
  for (const Tetrahedron& cell : mesh.Cells)
  {
    boxes.push_back(BoxOf(mesh.Points, cell));
  }
  const BoxTree tree(std::move(boxes));
  ParallelLoop(places.size(), CostOfWalk, monitor,
    { progress.Stage, progress.At(0.5), progress.At(1) },
    [&](std::size_t i)
    {
      if (isFound[i] == 0)
      {
        Id lowest = None;
        tree.Visit({ places[i], places[i] },
          [&](Id cell)
          {
            if ((lowest == None || cell < lowest) && Holds(mesh, cell, places[i]))
            {
              lowest = cell;
            }
          });
        cells[i] = lowest == None ? cells[i] : lowest;
      }
    });
}
} // namespace insideout
