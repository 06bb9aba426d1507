// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/FillWithPoints.h"

#include "Common/LoopProgress.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractEdge.h"
#include "Refine/InsertPoint.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <vector>

namespace insideout
{
namespace
{
/**
 * Of the length that edges are to have there: the largest radius of a circumsphere, that of a
 * regular cell being 0.61, and how near another point may be. Edges come out near that length then
 * at the median; where the second is as large as the first, gaps beside facets stay open.
 */
constexpr double LargestRadius = 0.8;
constexpr double LeastSpacing = 0.7;

/**
 * Of the shortest edge of a cell: radii may be this large (Shewchuk 1998). Beside short edges of a
 * surface cells are small then, also where lengths that are means of short and long edges are not.
 */
constexpr double LargestRadiusEdgeRatio = 2;

/** Larger cavities would be of places far from the cell that is to go. */
constexpr std::size_t LargestCavity = 2000;

/** Of the length, where edges are shorter: beside two points that are all but one there would be
 * points without number. */
constexpr double LeastSpacingBesideShort = 0.01;

/** Per point that is there, so many are inserted for radii of thin cells at most: only a budget. */
constexpr std::size_t MostBesideShort = 4;

/** Points nearer to another than this part of the length are taken out. */
constexpr double CrowdedSpacing = 0.5;

double ShortestEdgeOf(const std::array<Point, 4>& c)
{
  return std::min({ Distance(c[0], c[1]), Distance(c[0], c[2]), Distance(c[0], c[3]),
    Distance(c[1], c[2]), Distance(c[1], c[3]), Distance(c[2], c[3]) });
}

double NearestNeighbor(const RefinableMesh& mesh, Id point, std::vector<Id>& star)
{
  star.clear();
  mesh.Star(point, star);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Id cell : star)
  {
    for (const Id other : mesh.Cell(cell).Corners)
    {
      if (other != point)
      {
        nearest = std::min(nearest, Distance(mesh.Points[point], mesh.Points[other]));
      }
    }
  }
  return nearest;
}

/** A cell to look at, and its version, by which one knows whether it is still there. */
struct Candidate
{
  Id Cell;
  Id Version;
};

bool IsTooLarge(const RefinableMesh& mesh, const SizingField& sizes, Id cell,
  const Circumsphere& sphere, double maximumVolume)
{
  if (!IsFinite(sphere.Center))
  {
    return false;
  }
  const double most = LargestRadius * sizes.At(cell, sphere.Center);
  if (sphere.SquaredRadius > most * most)
  {
    return true;
  }
  const std::array<Point, 4> c = CornersOf(mesh.Points, mesh.Cell(cell).Corners);
  return maximumVolume > 0 &&
    Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0])) >
    6 * maximumVolume;
}
} // namespace

void ThinPoints(RefinableMesh& mesh)
{
  Contraction contraction(mesh);
  std::vector<Id> star;
  for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); ++p)
  {
    if (mesh.CellAt(p) != None && mesh.Kinds[p] == PointKind::Free &&
      NearestNeighbor(mesh, p, star) < CrowdedSpacing * mesh.Sizes[p])
    {
      contraction.Remove(p, 0, std::numeric_limits<double>::infinity());
    }
  }
}

void FillWithPoints(RefinableMesh& mesh, SizingField& sizes, double maximumVolume, Monitor& monitor,
  const ProgressRange& progress)
{
  PointInsertion insertion(mesh);
  std::deque<Candidate> queue; // what was looked at goes: there are far more than cells
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    queue.push_back({ cell, mesh.Cell(cell).Version });
  }
  // Each cell that there will be is looked at some times.
  const LoopProgress looked(
    monitor, progress, static_cast<std::size_t>(2 * sizes.EstimatedCells()) + 2 * queue.size());
  std::size_t budget = MostBesideShort * mesh.Points.size();
  for (std::size_t turn = 0; !queue.empty(); ++turn)
  {
    looked.Check(turn);
    const auto [cell, version] = queue.front();
    queue.pop_front();
    if (mesh.IsDead(cell) || mesh.Cell(cell).Version != version)
    {
      continue;
    }
    const std::array<Point, 4> c = CornersOf(mesh.Points, mesh.Cell(cell).Corners);
    const Circumsphere sphere = CircumsphereOf(c[0], c[1], c[2], c[3]);
    const double shortest = ShortestEdgeOf(c);
    const double largest = LargestRadiusEdgeRatio * shortest;
    const bool isThin = budget > 0 && sphere.SquaredRadius > largest * largest;
    if ((!isThin && !IsTooLarge(mesh, sizes, cell, sphere, maximumVolume)) ||
      !insertion.Locate(cell, sphere.Center))
    {
      continue;
    }
    const double size = sizes.At(insertion.Holder(), sphere.Center);
    const double least = isThin ? std::max(shortest, LeastSpacingBesideShort * size) : size;
    const double spacing = std::min(LeastSpacing * size, least);
    if (insertion.SquaredDistanceToHolder() < spacing * spacing ||
      !insertion.FindCavity(LargestCavity) || insertion.SquaredSpacing() < spacing * spacing)
    {
      continue;
    }
    sizes.Append(insertion.Holder(), sphere.Center);
    insertion.Insert(size);
    budget -= isThin ? 1 : 0;
    for (const Id fresh : mesh.Fresh())
    {
      queue.push_back({ fresh, mesh.Cell(fresh).Version });
    }
  }
}
} // namespace insideout
