// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/CutEnergy.h"

namespace insideout
{
/**
 * The cells whose label in the smallest minimum of an energy can be decided without a flow. These
 * are most cells: w jumps across a facet, so that labels that differ there cost nothing, and only
 * near holes do cells of both kinds meet.
 *
 * Let R be a set of cells, each of which gains more energy by being inside than all its faces to
 * cells beyond R cost. No minimum can lack a part of R: adding it costs at most its faces to cells
 * outside R, and gains more. The largest such R starts as all cells that are better inside; cells
 * outweighed by their faces are removed until there are none. Outside is treated likewise, but
 * equality suffices, because the smallest minimum is wanted. The costs between a certain cell and
 * its neighbors are then decided. The procedure is repeated with the remaining cells, as long as it
 * settles most of them.
 */
class CertainCells
{
public:
  explicit CertainCells(const CutEnergy& energy);

  /** The open cells, ascending. */
  const std::vector<Id>& Open() const { return this->OpenCells; }
  bool IsOpen(Id cell) const { return this->States[cell] == State::Open; }

  /** Whether a cell that is not open is inside. */
  bool IsInside(Id cell) const { return this->States[cell] == State::Inside; }

  /** The cost of an open cell outside less that inside, if all other open cells are outside:
   * CutEnergy's gain and the faces to certain cells. */
  std::int64_t Gain(Id cell) const { return this->Gains[cell]; }

private:
  enum class State : unsigned char
  {
    Outside,
    Inside,
    MaybeOutside, ///< used, as the next one, only while deciding
    MaybeInside,
    Open
  };

  bool Look();
  State Guess(Id cell) const;
  void GiveUpIfOutweighed(Id cell);
  void Settle(Id cell);

  const CutEnergy& Energy;
  std::vector<Id> OpenCells;
  std::vector<Id> GivenUp;
  std::vector<State> States;
  std::vector<std::int64_t> Gains;
  std::vector<std::int64_t>
    Against; ///< cost of a cell's faces to cells that are not certain to have its label
};
} // namespace insideout
