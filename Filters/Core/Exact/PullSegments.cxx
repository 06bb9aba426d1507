// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PullSegments.h"

#include "Common/ParallelLoop.h"
#include "Exact/Phases.h"
#include "Exact/PullVertex.h"
#include "Exact/RecoverSegments.h"
#include "Exact/VertexBlocks.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <utility>

namespace insideout
{
namespace
{
/** Segments between two calls of the monitor. */
constexpr std::size_t SegmentsPerCheck = 16;

/** Digits of a block's number: next is a block with four times as many vertices. */
constexpr int LevelsPerRound = 2;

constexpr double NanosecondsPerPull = 7000;

/** The memory of a thread. */
struct Puller
{
  CellMarks Marks;
  EdgeSearch Search;
  EdgeRing Ring;
  Cone Moved;
  FlippableMesh::Workspace Work;
};

/** The segments of a block. */
struct SegmentsOfBlock
{
  std::vector<std::size_t> Missing; ///< indices
  std::vector<Id> DeadCells;        ///< for fresh ones
  std::int64_t Work = 0;
  std::int64_t Changes = 0;
};

/** Whether other pulls since `begin` have connected two vertices: that changes cells around both.
 */
bool WasConnected(const MeshReader& mesh, Id u, Id v, std::int64_t begin)
{
  return mesh->LastChangeAround(u) > begin && mesh->LastChangeAround(v) > begin &&
    mesh.FindEdge(u, v) != None;
}

/** @return whether the pull is complete, or needs no cell of another block to fail */
bool PullInBlock(ExactState& state, const MeshReader& mesh, const std::array<Id, 2>& ends,
  std::int64_t begin, Puller& puller)
{
  if (WasConnected(mesh, ends[0], ends[1], begin))
  {
    return true;
  }
  const Cone& cone = puller.Moved;
  Pull pull = Pull::Obstructed;
  for (int k = 0; k < 2 && pull == Pull::Obstructed; ++k)
  {
    pull = MakePull(mesh, state.Segments, ends[k], ends[1 - k],
      std::numeric_limits<std::size_t>::max(), puller.Ring, puller.Moved);
  }
  if (pull == Pull::Made)
  {
    if (cone.Fresh.size() > cone.Old.Members().size() + puller.Work.FreeCells.size())
    {
      return false;
    }
    state.Mesh.Replace(cone.Old.Members(), cone.Fresh, cone.Facets, puller.Work);
  }
  return pull != Pull::Beyond;
}
} // namespace

std::vector<Id> PullInBlocks(ExactState& state, const std::vector<Id>& missing,
  const std::vector<Id>& blockOf, std::size_t blocks)
{
  FlippableMesh& mesh = state.Mesh;
  std::vector<char> isPutOff(missing.size(), 0);
  std::vector<SegmentsOfBlock> all(blocks);
  for (std::size_t i = 0; i < missing.size(); ++i)
  {
    const std::array<Id, 2>& ends = state.Segments.EndsOf(missing[i]);
    isPutOff[i] = blockOf[ends[0]] != blockOf[ends[1]];
    if (isPutOff[i] == 0)
    {
      all[static_cast<std::size_t>(blockOf[ends[0]])].Missing.push_back(i);
    }
  }
  for (SegmentsOfBlock& block : all)
  {
    block.DeadCells = mesh.AddDeadCells(block.Missing.size()); // most pulls add less than a cell
  }
  const std::int64_t begin = mesh.NumberOfChanges();
  const std::int64_t mostWork = mesh.Work().Left() / static_cast<std::int64_t>(blocks);
  std::vector<Puller> idle;
  std::mutex mutex;
  const ProgressRange still = { Phases::RecoveringSegments.Stage, Phases::RecoveringSegments.Begin,
    Phases::RecoveringSegments.Begin };
  ParallelLoop(blocks,
    NanosecondsPerPull * static_cast<double>(missing.size()) / static_cast<double>(blocks),
    *state.Progress, still,
    [&](std::size_t number)
    {
      Puller puller;
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!idle.empty())
        {
          puller = std::move(idle.back());
          idle.pop_back();
        }
      }
      SegmentsOfBlock& block = all[number];
      puller.Work.Changes = begin;
      puller.Work.FreeCells = std::move(block.DeadCells);
      MeshReader::Block part = { blockOf, static_cast<Id>(number), puller.Marks, puller.Search,
        WorkBudget(mostWork) };
      const MeshReader reader(mesh, part);
      for (const std::size_t i : block.Missing)
      {
        const std::array<Id, 2>& ends = state.Segments.EndsOf(missing[i]);
        isPutOff[i] = part.Work.IsUsedUp() || !PullInBlock(state, reader, ends, begin, puller);
      }
      block.Work = part.Work.Spent();
      block.Changes = puller.Work.Changes;
      block.DeadCells = std::move(puller.Work.FreeCells);
      const std::lock_guard<std::mutex> lock(mutex);
      idle.push_back(std::move(puller));
    });
  for (const SegmentsOfBlock& block : all)
  {
    mesh.Work().Spend(block.Work);
    mesh.TakeOver(block.DeadCells, block.Changes);
  }
  std::vector<Id> putOff;
  for (std::size_t i = 0; i < missing.size(); ++i)
  {
    if (isPutOff[i] != 0)
    {
      putOff.push_back(missing[i]);
    }
  }
  return putOff;
}

std::vector<Id> RecoverSegmentsByPulls(
  ExactState& state, const std::vector<Id>& missing, std::size_t verticesPerBlock)
{
  const FlippableMesh& mesh = state.Mesh;
  std::vector<Id> left = missing;
  int levels = 0;
  while (static_cast<std::size_t>(mesh.Infinite()) >> (levels + 1) >= verticesPerBlock)
  {
    ++levels;
  }
  if (levels > 0 && mesh.Vertices().AreDoubles() && !mesh.HasJournal())
  {
    std::vector<Id> blockOf = BlocksOfVertices(mesh, levels);
    for (; levels > 0; levels -= LevelsPerRound)
    {
      left = PullInBlocks(state, left, blockOf, std::size_t(1) << levels);
      std::for_each(blockOf.begin(), blockOf.end(), [](Id& block) { block >>= LevelsPerRound; });
    }
  }
  const std::int64_t begin = mesh.NumberOfChanges();
  for (std::size_t k = 0; k < left.size() && !mesh.Work().IsUsedUp(); ++k)
  {
    if (k % SegmentsPerCheck == 0)
    {
      state.Report(Phases::RecoveringSegments);
    }
    const std::array<Id, 2>& ends = state.Segments.EndsOf(left[k]);
    if (!WasConnected(mesh, ends[0], ends[1], begin) && !PullVertex(state, ends[0], ends[1]))
    {
      PullVertex(state, ends[1], ends[0]);
    }
  }
  return FindMissingSegments(state, missing);
}
} // namespace insideout
