// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Common/Monitor.h"
#include "Exact/FlipFlat.h"
#include "Exact/FlipRounds.h"
#include "Exact/PullVertex.h"
#include "Exact/SegmentWalk.h"
#include "Exact/SteinerPoints.h"

namespace insideout
{
/** Makes segments edges of the mesh. */
class SegmentRecovery
{
public:
  SegmentRecovery(FlippableMesh& mesh, SegmentTable& segments, Monitor& monitor)
    : Mesh(mesh)
    , Segments(segments)
    , Progress(monitor)
    , Flips(mesh, segments)
    , FlatFlips(mesh, segments)
    , Puller(mesh, segments)
  {
  }

  /** The segments without Steiner points that are no edges. */
  std::vector<Id> FindMissing(const std::vector<Id>& segments) const;

  /**
   * Recover segments by connecting vertices with all that they lack at once, those that lack most
   * first.
   * @return the ones that are still missing, in the same order
   */
  std::vector<Id> RecoverByPulls(const std::vector<Id>& missing);

  /** Recover segments by flips alone. @return the ones that are still missing */
  std::vector<Id> RecoverByFlips(const std::vector<Id>& missing);

  /** The end at which Steiner points begin. */
  enum class From
  {
    LowerEnd,
    HigherEnd
  };

  /**
   * Recover segments with Steiner points that lie exactly on them. Each is put where the segment
   * passes through a cell or over an edge, so nothing that is there goes, and what is left to do
   * gets less: this fails on no segment that passes through no vertex.
   * @return the segments that do
   */
  std::vector<Id> RecoverBySplits(
    const std::vector<Id>& missing, From from, SteinerPoints& steiner);

private:
  Buckets<Id> OtherEnds(const std::vector<Id>& segments) const;
  bool Recover(Id a, Id b, const FlipEffort& effort);
  bool ClearOne(
    Id a, Id b, const Crossing& first, const FlipTarget& target, const FlipEffort& effort);
  bool Clear(const Crossing& crossing, const FlipTarget& target, const FlipEffort& effort);
  bool SplitAndRecover(Id segment, Id start, Id end);
  bool IsFree(Id vertex) const;
  Id SteinerPointWithin(Id cell, Id a, Id b, Id beyondFace);

  FlippableMesh& Mesh;
  SegmentTable& Segments;
  Monitor& Progress;
  FlipOperator Flips;
  FlatFlipper FlatFlips;
  VertexPuller Puller;
};
} // namespace insideout
