// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverSegments.h"

#include "Exact/Flips.h"
#include "Exact/Phases.h"
#include "Exact/PullVertex.h"
#include "Exact/SegmentWalk.h"
#include "Exact/SteinerPoints.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace insideout
{
namespace
{
/** Segments between two calls of the monitor. */
constexpr std::size_t SegmentsPerCheck = 16;
} // namespace

std::vector<Id> FindMissingSegments(const ExactState& state, const std::vector<Id>& segments)
{
  std::vector<Id> missing;
  std::vector<std::array<Id, 2>> edges;
  for (const Id segment : segments)
  {
    if (!state.Segments.IsSplit(segment))
    {
      missing.push_back(segment);
      edges.push_back(state.Segments.EndsOf(segment));
    }
  }
  const std::vector<char> areThere = state.Mesh.HasEdges(edges);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (!areThere[i])
    {
      missing[kept++] = missing[i];
    }
  }
  missing.resize(kept);
  return missing;
}

// --- Flips ---------------------------------------------------------------------------------------

namespace
{
/** Nearly all segments take fewer than ten flips; some would never end. */
constexpr int FlipsPerSegment = 50;

bool Clear(
  ExactState& state, const Crossing& crossing, const FlipTarget& target, const FlipEffort& effort)
{
  const FlippableMesh& mesh = state.Mesh;
  int budget = effort.Budget;
  if (crossing.Kind == Crossing::ThroughEdge)
  {
    return RemoveEdgeDeeply(state, crossing.U, crossing.V, target, effort, budget);
  }
  const Id cell = crossing.Cell;
  if (RemoveFace(state, cell, crossing.Face, target, effort.Limits))
  {
    return true;
  }
  // Edges that the line between the two apexes passes on the outside come first.
  const Id p = mesh.Cell(cell).Corners[crossing.Face];
  const Id q = mesh.Opposite(cell, crossing.Face);
  const Triangle f = mesh.FaceCorners(cell, crossing.Face);
  std::array<bool, 3> isReflex = { { false, false, false } };
  for (int k = 0; k < 3; ++k)
  {
    isReflex[k] = q != mesh.Infinite() && p != mesh.Infinite() &&
      mesh.Vertices().Orient(q, p, f[k], f[(k + 1) % 3]) <= 0;
  }
  const std::int64_t before = mesh.NumberOfChanges();
  for (const bool reflex : { true, false })
  {
    for (int k = 0; k < 3; ++k)
    {
      if (isReflex[k] == reflex &&
        (RemoveEdgeDeeply(state, f[k], f[(k + 1) % 3], target, effort, budget) ||
          mesh.NumberOfChanges() != before))
      {
        return true;
      }
    }
  }
  return false;
}

/**
 * Remove an obstacle of the segment: from one end, or else from the other.
 * @param[in] first the first crossing
 */
bool ClearOne(ExactState& state, Id a, Id b, const Crossing& first, const FlipTarget& target,
  const FlipEffort& effort)
{
  const std::int64_t before = state.Mesh.NumberOfChanges();
  const auto clear = [&](const Crossing& crossing)
  {
    return crossing.Kind != Crossing::AtVertex &&
      (Clear(state, crossing, target, effort) || state.Mesh.NumberOfChanges() != before);
  };
  return first.Kind != Crossing::AtVertex &&
    (clear(first) || clear(FirstCrossing(state.Mesh, b, a)));
}

bool Recover(ExactState& state, Id a, Id b, const FlipEffort& effort)
{
  const FlipTarget target = FlipTarget::Segment(state.Mesh, a, b);
  for (int flips = 0;; ++flips)
  {
    const Crossing first = FirstCrossing(state.Mesh, a, b);
    if (first.Kind == Crossing::AtEnd)
    {
      return true;
    }
    if (flips == FlipsPerSegment || state.Mesh.Work().Spent() > effort.EndOfWork ||
      !ClearOne(state, a, b, first, target, effort))
    {
      return false;
    }
  }
}
} // namespace

std::vector<Id> RecoverSegmentsByFlips(ExactState& state, const std::vector<Id>& missing)
{
  return RecoverInRounds(state, missing, static_cast<std::size_t>(state.Segments.Size()),
    Phases::RecoveringSegments,
    [&state](Id segment, const FlipEffort& effort)
    {
      const std::array<Id, 2>& ends = state.Segments.EndsOf(segment);
      return Recover(state, ends[0], ends[1], effort);
    });
}

// --- Steiner points ------------------------------------------------------------------------------

namespace
{
/** Binary digits of a place on a segment: cells are not thinner, for doubles have 1074. */
constexpr int DigitsOnSegment = 500;

/**
 * A point of the segment from a to b within a cell. Its position between a and b has the fewest
 * binary digits of all such points; bisection finds it. `beyondFace` is the corner of the cell
 * across from the face through which the segment enters.
 */
Id SteinerPointWithin(FlippableMesh& mesh, Id cell, Id a, Id b, Id beyondFace)
{
  const Tetrahedron corners = mesh.Cell(cell).Corners;
  const int entry = mesh.CornerIndex(cell, beyondFace);
  DyadicNumber low(0);
  DyadicNumber step(0.5);
  const DyadicNumber one(1);
  const DyadicNumber half(0.5);
  for (int digits = 0; digits < DigitsOnSegment; ++digits)
  {
    const DyadicNumber t = low + step;
    const Id point = mesh.AddVertexBetween(a, b, one - t, t, { { a, b, b } });
    bool beforeEntry = false;
    bool behindExit = false;
    for (int k = 0; k < 4; ++k)
    {
      Tetrahedron moved = corners;
      moved[k] = point;
      if (mesh.Vertices().Orient(moved[0], moved[1], moved[2], moved[3]) <= 0)
      {
        (k == entry ? beforeEntry : behindExit) = true;
      }
    }
    if (!beforeEntry && !behindExit)
    {
      return point;
    }
    if (beforeEntry)
    {
      low = t;
    }
    mesh.RemoveLastVertex();
    step = step * half;
  }
  return None;
}

/** Insert a point where the segment from start to end crosses an edge. */
Id SplitCrossedEdge(FlippableMesh& mesh, Id start, Id end, const Crossing& crossing, Id off)
{
  const Id u = crossing.U;
  const Id v = crossing.V;
  const DyadicNumber atStart = mesh.Vertices().Determinant(u, v, off, start);
  const DyadicNumber atEnd = mesh.Vertices().Determinant(u, v, off, end);
  const Id point =
    mesh.AddVertexBetween(start, end, DyadicNumber(0) - atEnd, atStart, { { start, end, end } });
  EdgeRing ring;
  mesh.Ring(u, v, crossing.Cell, ring);
  mesh.SplitEdge(ring, point);
  return point;
}

/** A segment that Steiner points split. */
struct SplitSegment
{
  Id Number;
  Id Start;
  Id End;
  SplitFrom Where;
};

/** All crossings of the piece from a to b; the last one is an end or a vertex. */
std::vector<Crossing> CrossingsOf(const FlippableMesh& mesh, Id a, Id b)
{
  std::vector<Crossing> crossings(1, FirstCrossing(mesh, a, b));
  while (crossings.back().Kind == Crossing::ThroughFace ||
    crossings.back().Kind == Crossing::ThroughEdge)
  {
    crossings.push_back(NextCrossing(mesh, a, b, crossings.back()));
  }
  return crossings;
}

/**
 * The crossing in the middle; one through a face if there is any, for a point within a cell has
 * shorter numbers than one on an edge.
 */
const Crossing& MiddleOf(const std::vector<Crossing>& crossings)
{
  const auto rank = [&crossings](const Crossing& crossing)
  {
    const std::ptrdiff_t before = &crossing - crossings.data();
    const std::ptrdiff_t behind = static_cast<std::ptrdiff_t>(crossings.size()) - 1 - before;
    return std::make_pair(crossing.Kind != Crossing::ThroughFace, std::abs(behind - before));
  };
  return *std::min_element(crossings.begin(), crossings.end(),
    [&rank](const Crossing& x, const Crossing& y) { return rank(x) < rank(y); });
}

/**
 * Insert a point of a piece from a to b at a crossing, or beyond it if that is a face. It is made
 * from the segment's own ends, whose numbers are short, not from Steiner points on it.
 */
Id SplitAt(FlippableMesh& mesh, const SplitSegment& segment, Id a, Id b, const Crossing& crossing)
{
  if (crossing.Kind == Crossing::ThroughEdge)
  {
    return SplitCrossedEdge(
      mesh, segment.Start, segment.End, crossing, mesh.VertexOffPlane(a, b, crossing.U));
  }
  const Id beyond = mesh.Cell(crossing.Cell).Neighbors[crossing.Face];
  const Id apex = mesh.Opposite(crossing.Cell, crossing.Face);
  const Id point = SteinerPointWithin(mesh, beyond, segment.Start, segment.End, apex);
  if (point != None)
  {
    mesh.SplitCell(beyond, point);
  }
  return point;
}

/** Limit of the cells that give way to a piece: hardly any pull of more succeeds. */
constexpr std::size_t MostCellsOfPiece = 300;

/** Whether flips or pulls connect a and b. */
bool ConnectPiece(ExactState& state, const SplitSegment& segment, Id a, Id b)
{
  const bool isWhole = a == segment.Start && b == segment.End; // which pulls did not connect
  return Recover(state, a, b, PlainFlips) ||
    (!isWhole &&
      (PullVertex(state, a, b, MostCellsOfPiece) || PullVertex(state, b, a, MostCellsOfPiece)));
}

/** Insert a point at a crossing of a piece from a to b, which does not exist.
 * @return the point; a where it connects the two without one; None on failure */
Id SplitPiece(ExactState& state, const SplitSegment& segment, Id a, Id b)
{
  FlippableMesh& mesh = state.Mesh;
  std::vector<Crossing> crossings = CrossingsOf(mesh, a, b);
  const Crossing last = crossings.back();
  crossings.pop_back();
  if (last.Kind == Crossing::AtEnd && crossings.back().Kind == Crossing::ThroughFace)
  {
    const Crossing face = crossings.back(); // the cell beyond it is the last one
    crossings.pop_back();
    if (crossings.empty())
    {
      return RemoveFace(state, face.Cell, face.Face, FlipTarget(mesh), AnyFlip) ? a : None;
    }
  }
  if (!crossings.empty())
  {
    const bool isMiddle = segment.Where == SplitFrom::Middle;
    return SplitAt(mesh, segment, a, b, isMiddle ? MiddleOf(crossings) : crossings.front());
  }
  // A point in the volume may lie on the segment by rounding.
  const bool isFree = last.U > mesh.Infinite() && state.SupportOf(last.U).IsNothing();
  return isFree ? last.U : None;
}

/** Connect the ends of a segment, split at a crossing, and so on for each part. */
bool SplitAndRecover(ExactState& state, const SplitSegment& segment)
{
  Id a = segment.Start;
  std::vector<Id> ends(1, segment.End); // of pieces that follow each other, the next one last
  while (!ends.empty())
  {
    const Id b = ends.back();
    if (!ConnectPiece(state, segment, a, b))
    {
      if (state.Mesh.Work().IsUsedUp())
      {
        return false;
      }
      state.Report(Phases::SplittingSegments);
      const Id point = SplitPiece(state, segment, a, b);
      if (point == None)
      {
        return false;
      }
      if (point != a)
      {
        state.Segments.Split(segment.Number, a, b, point);
        ends.push_back(point);
        continue;
      }
    }
    a = b;
    ends.pop_back();
  }
  return true;
}
} // namespace

std::vector<Id> RecoverSegmentsBySplits(
  ExactState& state, const std::vector<Id>& missing, SplitFrom from)
{
  std::vector<Id> failed;
  for (std::size_t k = 0; k < missing.size(); ++k)
  {
    if (k % SegmentsPerCheck == 0)
    {
      state.Report(Phases::SplittingSegments, static_cast<double>(k) / missing.size());
    }
    const Id first = state.Mesh.Vertices().Size();
    std::array<Id, 2> ends = state.Segments.EndsOf(missing[k]);
    if (from == SplitFrom::HigherEnd)
    {
      std::swap(ends[0], ends[1]);
    }
    if (!SplitAndRecover(state, { missing[k], ends[0], ends[1], from }))
    {
      state.Segments.Release(missing[k]);
      failed.push_back(missing[k]);
    }
    Tidy(state, first);
  }
  return failed;
}
} // namespace insideout
