// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/Flips.h"

#include <algorithm>
#include <array>
#include <utility>

namespace insideout
{
namespace
{
/** The obstacles that a triangulation of a ring leaves to a target. */
struct CostsOfRing
{
  static constexpr int Edge = 0;
  static constexpr int Impossible = std::numeric_limits<int>::max() / 4;

  bool IsBetter(int a, int b) const { return a < b; }
  bool IsEnough(int cost) const { return cost <= this->Most; }
  int Join(int a, int b) const { return a + b; }

  int OfTriangle(int i, int j, int k) const
  {
    const std::vector<Id>& p = this->Ring.Points;
    const bool isPositive = this->Vertices.Orient(p[i], p[j], p[k], this->Ring.V) > 0 &&
      this->Vertices.Orient(p[j], p[i], p[k], this->Ring.U) > 0;
    return isPositive ? this->Target.CostOfFace(p[i], p[j], p[k]) : Impossible;
  }

  int OfDiagonal(int i, int j) const
  {
    const Id p = this->Ring.Points[i];
    const Id q = this->Ring.Points[j];
    const bool isOfRing = i == 0 && static_cast<std::size_t>(j) + 1 == this->Ring.Points.size();
    return isOfRing ? 0
                    : this->Target.CostOfEdge(p, q) + this->Target.CostOfFace(this->Ring.U, p, q) +
        this->Target.CostOfFace(this->Ring.V, p, q);
  }

  const ExactVertices& Vertices;
  const EdgeRing& Ring;
  const FlipTarget& Target;
  int Most;
};

bool IsLocked(const ExactState& state, const EdgeRing& ring)
{
  return ring.IsLocked || state.Segments.Find(ring.U, ring.V) != None;
}

/**
 * Around an edge of the hull the ring begins with the infinite vertex here. The edge may be removed
 * if the two faces of the hull beside it form a flat, strictly convex quadrilateral.
 */
bool IsHullFlip(const ExactVertices& vertices, const EdgeRing& ring)
{
  const Id p = ring.Points[1];
  const Id q = ring.Points.back();
  if (ring.Points.size() < 4 || vertices.Orient(ring.U, ring.V, p, q) != 0)
  {
    return false;
  }
  const Id inner = ring.Points[2];
  const int side = vertices.Orient(ring.U, p, ring.V, inner);
  return vertices.Orient(ring.U, p, q, inner) == side &&
    vertices.Orient(p, ring.V, q, inner) == side;
}
} // namespace

bool RemoveFace(
  ExactState& state, Id cell, int face, const FlipTarget& target, const FlipLimits& limits)
{
  FlippableMesh& mesh = state.Mesh;
  const FlippableCell& near = mesh.Cell(cell);
  const Id other = near.Neighbors[face];
  if (near.Facets[face] != None || mesh.IsInfinite(cell) || mesh.IsInfinite(other))
  {
    return false;
  }
  const Id p = near.Corners[face];
  const Id q = mesh.Opposite(cell, face);
  const Triangle f = mesh.FaceCorners(cell, face);
  std::vector<Tetrahedron> fresh;
  for (int k = 0; k < 3; ++k)
  {
    if (mesh.Vertices().Orient(q, p, f[k], f[(k + 1) % 3]) <= 0)
    {
      return false;
    }
    fresh.push_back({ { q, p, f[k], f[(k + 1) % 3] } });
  }
  int cost = target.CostOfEdge(p, q) - target.CostOfFace(f[0], f[1], f[2]);
  for (int k = 0; k < 3 && cost <= limits.Increase; ++k)
  {
    cost += target.CostOfFace(p, q, f[k]);
  }
  if (cost > limits.Increase)
  {
    return false;
  }
  mesh.Replace({ cell, other }, fresh);
  return true;
}

bool RemoveEdge(
  ExactState& state, Id u, Id v, Id cell, const FlipTarget& target, const FlipLimits& limits)
{
  FlippableMesh& mesh = state.Mesh;
  EdgeRing& ring = state.Scratch.Ring;
  mesh.Ring(u, v, cell, ring);
  const int n = static_cast<int>(ring.Points.size());
  if (n < 3 || n > limits.LargestRing || u == mesh.Infinite() || v == mesh.Infinite() ||
    IsLocked(state, ring))
  {
    return false;
  }
  const auto infinite =
    std::find(ring.Points.begin(), ring.Points.end(), mesh.Infinite()) - ring.Points.begin();
  const bool onHull = infinite < n;
  if (onHull)
  {
    std::rotate(ring.Points.begin(), ring.Points.begin() + infinite, ring.Points.end());
    std::rotate(ring.Cells.begin(), ring.Cells.begin() + infinite, ring.Cells.end());
    if (!IsHullFlip(mesh.Vertices(), ring))
    {
      return false;
    }
  }
  CostsOfRing costs = { mesh.Vertices(), ring, target, limits.Increase + target.CostOfEdge(u, v) };
  for (const Id p : ring.Points)
  {
    costs.Most += target.CostOfFace(u, v, p);
  }
  RingTriangulation<int>& triangulation = state.Scratch.Triangulation;
  const int first = onHull ? 1 : 0;
  if (!triangulation.Find(costs, first, n))
  {
    return false;
  }
  std::vector<Tetrahedron> fresh;
  triangulation.AppendCells(ring, first, n - 1, fresh);
  if (onHull)
  {
    triangulation.AppendPair(ring, 0, 1, n - 1, fresh);
  }
  mesh.Replace(ring.Cells, fresh);
  return true;
}

bool RemoveEdgeDeeply(
  ExactState& state, Id u, Id v, const FlipTarget& target, const FlipEffort& effort, int& budget)
{
  FlippableMesh& mesh = state.Mesh;
  const Id cell = mesh.FindEdge(u, v);
  if (cell == None || RemoveEdge(state, u, v, cell, target, effort.Limits))
  {
    return true;
  }
  if (effort.Depth == 0 || budget <= 0 || IsLocked(state, state.Scratch.Ring) ||
    state.Scratch.Ring.Points.size() < 4)
  {
    return false;
  }
  const std::vector<Id> points = state.Scratch.Ring.Points;
  FlipEffort inner = effort;
  inner.Limits.Increase = std::max(effort.Limits.Increase, 0);
  --inner.Depth;
  for (const Id p : points)
  {
    for (const Id end : { u, v })
    {
      if (p == mesh.Infinite())
      {
        continue;
      }
      if (--budget < 0)
      {
        return false;
      }
      const std::int64_t before = mesh.NumberOfChanges();
      RemoveEdgeDeeply(state, end, p, target, inner, budget);
      if (mesh.NumberOfChanges() != before)
      {
        const Id now = mesh.FindEdge(u, v);
        if (now == None || RemoveEdge(state, u, v, now, target, effort.Limits))
        {
          return true;
        }
      }
    }
  }
  return false;
}

// --- Rounds --------------------------------------------------------------------------------------

namespace
{
/**
 * Work limit of a round of plain flips, per point and constraint: about 0.02 ms. Surfaces that
 * flips recover almost entirely take a tenth of it.
 */
constexpr std::int64_t WorkPerElement = 1000;

/** The deeper flips that follow; each gains less for more work. */
constexpr std::array<FlipEffort, 3> DeepFlips = { { { { -1, 10 }, 1, 40 }, { { 0, 12 }, 2, 150 },
  { { 1, 12 }, 3, 500 } } };

/**
 * Work limits of each of these, per point and constraint, and in all: one or two ms, for surfaces
 * that need no cut then. Cuts recover the rest in less time.
 */
constexpr std::int64_t DeepWorkPerElement = 375;
constexpr std::int64_t MostWorkOnDeepFlips = 60000;

/** Constraints between two calls of the monitor. */
constexpr std::size_t ConstraintsPerCheck = 4;
} // namespace

std::vector<Id> RecoverInRounds(const ExactState& state, std::vector<Id> missing,
  std::size_t constraints, const ProgressRange& phase,
  const std::function<bool(Id, const FlipEffort&)>& recover)
{
  const WorkBudget& work = state.Mesh.Work();
  const std::int64_t elements = state.Mesh.Infinite() + static_cast<std::int64_t>(constraints);
  // The number of rounds is unknown: each gets half of the remaining progress of the phase.
  double left = 1;
  const auto round = [&](FlipEffort effort, std::int64_t mostWork)
  {
    effort.EndOfWork = work.Spent() + mostWork;
    std::vector<Id> still;
    for (std::size_t k = 0; k < missing.size(); ++k)
    {
      if (k % ConstraintsPerCheck == 0)
      {
        state.Report(phase, 1 - left + left / 2 * static_cast<double>(k) / missing.size());
      }
      if (!recover(missing[k], effort))
      {
        still.push_back(missing[k]);
      }
    }
    missing = std::move(still);
    left /= 2;
  };

  // Another round follows while the last one recovered more than half.
  std::size_t before = 2 * missing.size() + 2;
  while (!missing.empty() && missing.size() < before - before / 10)
  {
    before = missing.size();
    round(PlainFlips, WorkPerElement * elements);
  }
  for (const FlipEffort& effort : DeepFlips)
  {
    if (!work.IsUsedUp())
    {
      round(effort, std::min(MostWorkOnDeepFlips, DeepWorkPerElement * elements));
    }
  }
  return missing;
}
} // namespace insideout
