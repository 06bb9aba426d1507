// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Delaunay/DelaunayInsertion.h"

#include <memory>
#include <mutex>
#include <vector>

namespace insideout
{
/** Two vertices in one place; the other one is in the mesh. */
struct Coincidence
{
  Id Vertex;
  Id Other;
};

/**
 * Inserts vertices on several threads, which keep off each other by what they hold. Those that meet
 * a held vertex are few, and are inserted last. The order changes no cell: any points have one
 * Delaunay tetrahedralization.
 */
class InsertionRounds
{
public:
  /** @param[in] most cells there may be */
  InsertionRounds(DelaunayCells& cells, std::size_t most);

  /**
   * Insert the vertices from `first` on before `last`, which are in an order that keeps neighbors
   * together.
   * @throws Error TooLarge, Stopped
   */
  void Insert(std::size_t first, std::size_t last, Monitor& monitor, const ProgressRange& progress);

  /** Vertices that are not in the mesh. */
  const std::vector<Coincidence>& Coincidences() const { return this->FoundCoincidences; }

private:
  void InsertStretch(std::size_t begin, std::size_t end);
  void InsertPostponed(Monitor& monitor, const ProgressRange& progress);
  std::unique_ptr<DelaunayInsertion> TakeInsertion();

  DelaunayCells& Cells;
  const std::size_t Most;
  std::mutex Mutex;                                     ///< for all that follows
  std::vector<std::unique_ptr<DelaunayInsertion>> Idle; ///< one per thread that has worked
  std::uint32_t NumberOfInsertions = 0;
  std::vector<Id> Postponed;
  std::vector<Coincidence> FoundCoincidences;
};
} // namespace insideout
