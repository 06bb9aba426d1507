// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SteinerPoints.h"

#include "Exact/DissolvePoint.h"
#include "Exact/Flips.h"
#include "Exact/MovePoint.h"
#include "Exact/Phases.h"

#include <algorithm>

namespace insideout
{
// --- One point -----------------------------------------------------------------------------------

namespace
{
/** Remove unconstrained edges at a point. */
void LowerDegree(ExactState& state, Id point)
{
  const FlippableMesh& mesh = state.Mesh;
  const FlipTarget nothing(mesh);
  std::int64_t before = -1; // an edge stays if nothing has changed around it since its last trial
  while (mesh.NumberOfChanges() > before)
  {
    const std::int64_t since = before;
    before = mesh.NumberOfChanges();
    for (const Id neighbor : mesh.NeighborsOf(point))
    {
      const Id cell =
        mesh.LastChangeAround(neighbor) > since ? mesh.FindEdge(point, neighbor) : None;
      if (cell != None)
      {
        RemoveEdge(state, point, neighbor, cell, nothing, AnyFlip);
      }
    }
  }
}

bool RemovePoint(ExactState& state, Id point)
{
  LowerDegree(state, point);
  return DissolvePoint(state, point, VolumePoints::None) ||
    (state.SupportOf(point).IsNothing() &&
      CollapsePoint(state, point, state.Mesh.NeighborsOf(point)));
}
} // namespace

// --- Moving and removing -------------------------------------------------------------------------

namespace
{
/** Stop removing points one by one when fewer than one in this many goes. */
constexpr std::size_t LeastYield = 50;

void MoveIntoVolume(ExactState& state, Id first, std::int64_t since)
{
  const FlippableMesh& mesh = state.Mesh;
  for (Id point = mesh.Vertices().Size() - 1; point >= first && !mesh.Work().IsUsedUp(); --point)
  {
    if (mesh.HasVertex(point) && mesh.LastChangeAround(point) > since)
    {
      state.Report(Phases::MovingPoints);
      DissolvePoint(state, point, VolumePoints::AsNeeded);
    }
  }
}

void RemovePoints(ExactState& state, Id first, std::int64_t since)
{
  const FlippableMesh& mesh = state.Mesh;
  // A failed removal is repeated only after a change around the point.
  std::vector<std::int64_t> triedAt(
    static_cast<std::size_t>(mesh.Vertices().Size() - first), since);
  std::size_t tried = 0;
  std::size_t removed = 1;
  while (removed > tried / LeastYield)
  {
    tried = 0;
    removed = 0;
    for (Id point = mesh.Vertices().Size() - 1; point >= first && !mesh.Work().IsUsedUp(); --point)
    {
      if (mesh.HasVertex(point) && mesh.LastChangeAround(point) > triedAt[point - first])
      {
        state.Report(Phases::RemovingPoints);
        ++tried;
        removed += RemovePoint(state, point) ? 1 : 0;
        triedAt[point - first] = mesh.NumberOfChanges();
      }
    }
  }
}
} // namespace

void Tidy(ExactState& state, Id first, std::int64_t since)
{
  MoveIntoVolume(state, first, since);
  RemovePoints(state, first, since);
}

// --- Shaking -------------------------------------------------------------------------------------

namespace
{
/** Limits of random flips around a point: per cell there, and in all. */
constexpr std::size_t FlipsPerCell = 2;
constexpr std::size_t FlipsPerShake = 200;
} // namespace

void FlipAround(ExactState& state, Id vertex)
{
  const FlippableMesh& mesh = state.Mesh;
  std::mt19937& random = state.Random;
  const FlipTarget nothing(mesh);
  std::vector<Id> star;
  mesh.Star(vertex, star);
  std::int64_t starAt = mesh.NumberOfChanges();
  const std::size_t tries = std::min(FlipsPerCell * star.size(), FlipsPerShake);
  for (std::size_t k = 0; k < tries; ++k)
  {
    if (mesh.LastChangeAround(vertex) > starAt)
    {
      star.clear();
      mesh.Star(vertex, star);
      starAt = mesh.NumberOfChanges();
    }
    const Id cell = star[random() % star.size()];
    const int i = static_cast<int>(random() % 4);
    const int j = static_cast<int>(i + 1 + random() % 3) % 4;
    const Id u = mesh.Cell(cell).Corners[i];
    const Id v = mesh.Cell(cell).Corners[j];
    if (random() % 2 == 0 || !RemoveFace(state, cell, i, nothing, AnyFlip))
    {
      RemoveEdge(state, u, v, cell, nothing, AnyFlip);
    }
  }
}

void Shake(ExactState& state, const std::vector<Id>& points)
{
  for (const Id point : points)
  {
    state.Report(Phases::ShakingPoints);
    if (state.Mesh.HasVertex(point))
    {
      FlipAround(state, point);
      if (!RemovePoint(state, point))
      {
        DissolvePoint(state, point, VolumePoints::AsNeeded);
      }
    }
  }
}
} // namespace insideout
