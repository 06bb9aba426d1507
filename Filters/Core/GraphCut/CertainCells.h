// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/CutEnergy.h"

namespace insideout
{
/**
 * The cells whose label in the smallest minimum of an energy can be told without any flow: most of
 * them, for across a facet w jumps, so that neither side costs the other anything, and only near
 * holes do cells of both kinds meet.
 *
 * Let R be cells that are each better inside by more than all their faces to cells outside R. No
 * minimum can lack a part of R: adding it costs at most its faces to cells outside R, and gains
 * more. The largest such R comes from all cells that are better inside, by taking away those that
 * their faces outweigh until there are none. Likewise for the outside, where equality will do, for
 * the smallest minimum is wanted. The costs between a certain cell and its neighbors are then no
 * longer open. The same is done again with the cells that are left, as long as that settles most of
 * them.
 */
class CertainCells
{
public:
  explicit CertainCells(const CutEnergy& energy);

  /** The cells that are left, ascending. */
  const std::vector<Id>& Open() const { return this->OpenCells; }
  bool IsOpen(Id cell) const { return this->States[cell] == State::Open; }

  /** Whether a cell that is not open is inside. */
  bool IsInside(Id cell) const { return this->States[cell] == State::Inside; }

  /** By how much an open cell costs less inside than outside, if all other open ones are outside
   * whatever it is: CutEnergy's gain and the faces to certain cells. */
  std::int64_t Gain(Id cell) const { return this->Gains[cell]; }

private:
  enum class State : unsigned char
  {
    Outside,
    Inside,
    MaybeOutside, ///< this and the next only while looking
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
    Against; ///< a cell's faces to others that are not certain to be like it
};
} // namespace insideout
