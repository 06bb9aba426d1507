// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverSegments.h"

#include "Exact/EngineLimits.h"
#include "Exact/Phases.h"
#include "Exact/PointSupport.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** How often the monitor is asked. */
constexpr std::size_t SegmentsPerCheck = 16;
} // namespace

std::vector<Id> SegmentRecovery::FindMissing(const std::vector<Id>& segments) const
{
  std::vector<Id> missing;
  for (const Id segment : segments)
  {
    const std::array<Id, 2>& ends = this->Segments.EndsOf(segment);
    if (!this->Segments.IsSplit(segment) && this->Mesh.FindEdge(ends[0], ends[1]) == None)
    {
      missing.push_back(segment);
    }
  }
  return missing;
}

// --- Pulls ---------------------------------------------------------------------------------------

/** The segment's other ends, by vertex. */
Buckets<Id> SegmentRecovery::OtherEnds(const std::vector<Id>& segments) const
{
  return Buckets<Id>(static_cast<std::size_t>(this->Mesh.Infinite()),
    [&](const auto& visit)
    {
      for (const Id segment : segments)
      {
        const std::array<Id, 2>& ends = this->Segments.EndsOf(segment);
        visit(static_cast<std::size_t>(ends[0]), ends[1]);
        visit(static_cast<std::size_t>(ends[1]), ends[0]);
      }
    });
}

std::vector<Id> SegmentRecovery::RecoverByPulls(const std::vector<Id>& missing)
{
  const Buckets<Id> others = this->OtherEnds(missing);
  const auto lacks = [&others](Id vertex) { return others[vertex].Size(); };
  std::vector<Id> order;
  for (Id vertex = 0; vertex < this->Mesh.Infinite(); ++vertex)
  {
    if (lacks(vertex) >= EngineLimits::LeastPulled)
    {
      order.push_back(vertex);
    }
  }
  std::stable_sort(order.begin(), order.end(), [&](Id a, Id b) { return lacks(a) > lacks(b); });
  for (std::size_t k = 0; k < order.size() && !this->Mesh.Work().IsUsedUp(); ++k)
  {
    if (k % SegmentsPerCheck == 0)
    {
      this->Progress.Check(Phases::RecoveringSegments, 0);
    }
    std::vector<Id> lacking;
    for (const Id other : others[order[k]])
    {
      if (this->Mesh.FindEdge(order[k], other) == None)
      {
        lacking.push_back(other);
      }
    }
    if (lacking.size() >= EngineLimits::LeastPulled)
    {
      this->Puller.Pull(order[k], lacking);
    }
  }
  return this->FindMissing(missing);
}

// --- Flips ---------------------------------------------------------------------------------------

bool SegmentRecovery::Clear(
  const Crossing& crossing, const FlipTarget& target, const FlipEffort& effort)
{
  int budget = effort.Budget;
  if (crossing.Kind == Crossing::ThroughEdge)
  {
    return this->Flips.RemoveEdgeDeeply(
      crossing.U, crossing.V, target, effort.Limits, effort.Depth, budget);
  }
  const Id cell = crossing.Cell;
  const FlippableCell& near = this->Mesh.Cell(cell);
  if (this->Flips.RemoveFace(cell, crossing.Face, target, effort.Limits))
  {
    return true;
  }
  // Edges that the line between the two apexes passes on the outside first.
  const Id p = near.Corners[crossing.Face];
  const Id q = this->Mesh.Opposite(cell, crossing.Face);
  const Triangle f = this->Mesh.FaceCorners(cell, crossing.Face);
  std::array<bool, 3> isReflex = { { false, false, false } };
  for (int k = 0; k < 3; ++k)
  {
    isReflex[k] = q != this->Mesh.Infinite() && p != this->Mesh.Infinite() &&
      this->Mesh.Vertices().Orient(q, p, f[k], f[(k + 1) % 3]) <= 0;
  }
  for (const bool reflex : { true, false })
  {
    for (int k = 0; k < 3; ++k)
    {
      if (isReflex[k] != reflex)
      {
        continue;
      }
      const std::int64_t before = this->Mesh.NumberOfChanges();
      if (this->Flips.RemoveEdgeDeeply(
            f[k], f[(k + 1) % 3], target, effort.Limits, effort.Depth, budget) ||
        this->Mesh.NumberOfChanges() != before)
      {
        return true;
      }
    }
  }
  return false;
}

/**
 * Take away something that the segment crosses: from one end, or else from the other.
 * @param[in] first what it crosses first
 */
bool SegmentRecovery::ClearOne(
  Id a, Id b, const Crossing& first, const FlipTarget& target, const FlipEffort& effort)
{
  const std::int64_t before = this->Mesh.NumberOfChanges();
  const auto changed = [&]() { return this->Mesh.NumberOfChanges() != before; };
  if (first.Kind == Crossing::AtVertex)
  {
    return false;
  }
  if (this->Clear(first, target, effort) || changed())
  {
    return true;
  }
  const Crossing last = FirstCrossing(this->Mesh, b, a);
  if (last.Kind == Crossing::AtVertex)
  {
    return false;
  }
  return this->Clear(last, target, effort) || changed();
}

bool SegmentRecovery::Recover(Id a, Id b, const FlipEffort& effort)
{
  const FlipTarget target = FlipTarget::Segment(this->Mesh, a, b);
  for (int flips = 0; flips < EngineLimits::FlipsPerSegment; ++flips)
  {
    const Crossing first = FirstCrossing(this->Mesh, a, b);
    if (first.Kind == Crossing::AtEnd)
    {
      return true;
    }
    if (this->Mesh.Work().Spent() > effort.EndOfWork ||
      !this->ClearOne(a, b, first, target, effort))
    {
      return false;
    }
  }
  return false;
}

std::vector<Id> SegmentRecovery::RecoverByFlips(const std::vector<Id>& missing)
{
  return RecoverInRounds(missing, this->Mesh,
    static_cast<std::int64_t>(this->Mesh.Infinite()) + this->Segments.Size(), this->Progress,
    Phases::RecoveringSegments,
    [this](Id segment, const FlipEffort& effort)
    {
      const std::array<Id, 2>& ends = this->Segments.EndsOf(segment);
      return this->Recover(ends[0], ends[1], effort);
    });
}

// --- Steiner points ------------------------------------------------------------------------------

/**
 * A point of the segment from a to b within a cell: of all such points one whose place between a
 * and b has the fewest binary digits, by bisection. `beyondFace` is the corner of the cell across
 * from the face through which the segment enters.
 */
Id SegmentRecovery::SteinerPointWithin(Id cell, Id a, Id b, Id beyondFace)
{
  const Tetrahedron corners = this->Mesh.Cell(cell).Corners;
  const int entry = this->Mesh.CornerIndex(cell, beyondFace);
  DyadicNumber low(0);
  DyadicNumber step(0.5);
  const DyadicNumber one(1);
  const DyadicNumber half(0.5);
  for (int digits = 0; digits < EngineLimits::DigitsOnSegment; ++digits)
  {
    const DyadicNumber t = low + step;
    const Id point = this->Mesh.AddVertexBetween(a, b, one - t, t, { { a, b, b } });
    bool beforeEntry = false;
    bool behindExit = false;
    for (int k = 0; k < 4; ++k)
    {
      Tetrahedron moved = corners;
      moved[k] = point;
      if (this->Mesh.Vertices().Orient(moved[0], moved[1], moved[2], moved[3]) <= 0)
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
    this->Mesh.RemoveLastVertex();
    step = step * half;
  }
  return None;
}

/** Whether a vertex is a Steiner point in the volume, which may lie on the segment by rounding. */
bool SegmentRecovery::IsFree(Id vertex) const
{
  if (vertex <= this->Mesh.Infinite())
  {
    return false;
  }
  const PointSupport support = FindPointSupport(this->Mesh, this->Segments, vertex);
  return support.Segment == None && support.Facets.empty();
}

bool SegmentRecovery::SplitAndRecover(Id segment, Id start, Id end)
{
  Id a = start;
  const Id b = end;
  for (int splits = 0; !this->Recover(a, b, EngineLimits::PlainFlips); ++splits)
  {
    if (splits == EngineLimits::SplitsPerSegment || this->Mesh.Work().IsUsedUp())
    {
      return false;
    }
    this->Progress.Check(Phases::SplittingSegments, 0);
    // Points are made from the segment's own ends, which are short, not from Steiner points on it.
    Id point = None;
    if (FirstCrossing(this->Mesh, a, b).Kind == Crossing::ThroughEdge &&
      this->FlatFlips.MakeEdge(a, b))
    {
      return true;
    }
    const Crossing crossing = FirstCrossing(this->Mesh, a, b);
    if (crossing.Kind == Crossing::ThroughEdge)
    {
      if (this->FlatFlips.StarEdge(crossing.U, crossing.V))
      {
        continue;
      }
      const Id off = this->Mesh.VertexOffPlane(a, b, crossing.U);
      const DyadicNumber atA =
        this->Mesh.Vertices().Determinant(crossing.U, crossing.V, off, start);
      const DyadicNumber atB = this->Mesh.Vertices().Determinant(crossing.U, crossing.V, off, end);
      point = this->Mesh.AddVertexBetween(
        start, end, DyadicNumber(0) - atB, atA, { { start, end, end } });
      EdgeRing ring;
      this->Mesh.Ring(crossing.U, crossing.V, crossing.Cell, ring);
      this->Mesh.SplitEdge(ring, point);
    }
    else if (crossing.Kind == Crossing::AtVertex && this->IsFree(crossing.U))
    {
      point = crossing.U;
    }
    else if (crossing.Kind == Crossing::ThroughFace)
    {
      const Id beyond = this->Mesh.Cell(crossing.Cell).Neighbors[crossing.Face];
      const Id apex = this->Mesh.Opposite(crossing.Cell, crossing.Face);
      if (apex == b)
      {
        this->Flips.RemoveFace(
          crossing.Cell, crossing.Face, FlipTarget(this->Mesh), EngineLimits::AnyFlip);
        return this->Mesh.FindEdge(a, b) != None;
      }
      point = this->SteinerPointWithin(beyond, start, end, apex);
      if (point == None)
      {
        return false;
      }
      this->Mesh.SplitCell(beyond, point);
      this->Flips.RemoveFace(
        crossing.Cell, crossing.Face, FlipTarget(this->Mesh), EngineLimits::AnyFlip);
    }
    if (point == None || this->Mesh.FindEdge(a, point) == None)
    {
      return false;
    }
    this->Segments.Split(segment, a, b, point);
    a = point;
  }
  return true;
}

std::vector<Id> SegmentRecovery::RecoverBySplits(
  const std::vector<Id>& missing, From from, SteinerPoints& steiner)
{
  std::vector<Id> failed;
  for (std::size_t k = 0; k < missing.size(); ++k)
  {
    if (k % SegmentsPerCheck == 0)
    {
      this->Progress.Check(Phases::SplittingSegments, static_cast<double>(k) / missing.size());
    }
    const Id first = this->Mesh.Vertices().Size();
    const std::array<Id, 2> ends = this->Segments.EndsOf(missing[k]);
    const bool isRecovered = from == From::LowerEnd
      ? this->SplitAndRecover(missing[k], ends[0], ends[1])
      : this->SplitAndRecover(missing[k], ends[1], ends[0]);
    if (!isRecovered)
    {
      this->Segments.Release(missing[k]);
      failed.push_back(missing[k]);
    }
    steiner.Tidy(first);
  }
  return failed;
}
} // namespace insideout
