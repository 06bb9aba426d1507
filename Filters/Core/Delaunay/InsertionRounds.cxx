// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/InsertionRounds.h"

#include "Common/Error.h"
#include "Common/ParallelLoop.h"

#include <algorithm>
#include <string>
#include <utility>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerInsertion = 2000;

/** Room made before a round: most points have six to seven cells. */
constexpr std::size_t CellsPerPoint = 8;

/** Room made for one more point. */
constexpr std::size_t MoreCells = 4096;

// Consecutive vertices that a thread inserts before it takes others.
constexpr std::size_t ShortestStretch = 32;
constexpr std::size_t LongestStretch = 2048;
constexpr std::size_t StretchesPerThread = 8;

/** Postponed vertices between two calls of the monitor. */
constexpr std::size_t InsertionsPerCheck = 64;
} // namespace

InsertionRounds::InsertionRounds(DelaunayCells& cells, std::size_t most)
  : Cells(cells)
  , Most(most)
{
}

void InsertionRounds::Insert(
  std::size_t first, std::size_t last, Monitor& monitor, const ProgressRange& progress)
{
  const std::size_t count = last - first;
  this->Cells.Reserve(CellsPerPoint * count, this->Most);
  const std::size_t threads =
    static_cast<std::size_t>(TeamSize(static_cast<double>(count) * NanosecondsPerInsertion));
  const std::size_t length =
    std::clamp(count / (StretchesPerThread * threads), ShortestStretch, LongestStretch);
  const std::size_t stretches = (count + length - 1) / length;
  // Stretches that are begun in a row are far apart.
  const std::size_t stride = (stretches + threads - 1) / threads;
  ParallelLoop(stride * threads, static_cast<double>(length) * NanosecondsPerInsertion, monitor,
    progress,
    [&](std::size_t i)
    {
      const std::size_t begin = first + (i % threads * stride + i / threads) * length;
      this->InsertStretch(std::min(begin, last), std::min(begin + length, last));
    });
  this->InsertPostponed(monitor, progress);
}

void InsertionRounds::InsertStretch(std::size_t begin, std::size_t end)
{
  std::unique_ptr<DelaunayInsertion> insertion = this->TakeInsertion();
  std::vector<Id> postponed;
  std::vector<Coincidence> coincidences;
  for (std::size_t i = begin; i < end; ++i)
  {
    Coincidence found = { static_cast<Id>(i), None };
    const Inserted result = insertion->Insert(found.Vertex, found.Other);
    if (result == Inserted::Coincides)
    {
      coincidences.push_back(found);
    }
    else if (result != Inserted::Fresh)
    {
      postponed.push_back(found.Vertex);
    }
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Idle.push_back(std::move(insertion));
  this->Postponed.insert(this->Postponed.end(), postponed.begin(), postponed.end());
  this->FoundCoincidences.insert(
    this->FoundCoincidences.end(), coincidences.begin(), coincidences.end());
}

/** Insert what threads could not, one vertex after the other. */
void InsertionRounds::InsertPostponed(Monitor& monitor, const ProgressRange& progress)
{
  std::unique_ptr<DelaunayInsertion> insertion = this->TakeInsertion();
  std::size_t inserted = 0;
  for (const Id vertex : this->Postponed)
  {
    if (++inserted % InsertionsPerCheck == 0)
    {
      monitor.Check(progress, 1);
    }
    Coincidence found = { vertex, None };
    Inserted result = insertion->Insert(vertex, found.Other);
    while (result == Inserted::NoRoom)
    {
      if (!this->Cells.Reserve(MoreCells, this->Most))
      {
        throw Error(ErrorCode::TooLarge,
          "the points have more than " + std::to_string(this->Most) + " Delaunay tetrahedra");
      }
      result = insertion->Insert(vertex, found.Other);
    }
    if (result == Inserted::Coincides)
    {
      this->FoundCoincidences.push_back(found);
    }
    else if (result != Inserted::Fresh)
    {
      throw Error(ErrorCode::Inconsistent,
        "no place for vertex " + std::to_string(vertex) + " in the Delaunay tetrahedra");
    }
  }
  this->Postponed.clear();
  this->Idle.push_back(std::move(insertion));
}

std::unique_ptr<DelaunayInsertion> InsertionRounds::TakeInsertion()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Idle.empty())
  {
    return std::make_unique<DelaunayInsertion>(this->Cells, ++this->NumberOfInsertions);
  }
  std::unique_ptr<DelaunayInsertion> insertion = std::move(this->Idle.back());
  this->Idle.pop_back();
  return insertion;
}
} // namespace insideout
