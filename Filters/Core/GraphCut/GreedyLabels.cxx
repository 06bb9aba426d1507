// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/GreedyLabels.h"

#include <algorithm>
#include <numeric>

namespace insideout
{
GreedyLabels::GreedyLabels(const CutEnergy& energy, std::vector<unsigned char> inside)
  : Energy(energy)
  , Inside(std::move(inside))
  , Fixed(this->Inside.size(), 0)
  , Kept(this->Inside.size(), 0)
  , IsQueued(this->Inside.size(), 0)
{
}

void GreedyLabels::Flip(Id cell)
{
  this->Inside[cell] = !this->Inside[cell];
  for (LabelConstraint* constraint : this->Constraints)
  {
    constraint->Changed(cell);
  }
}

void GreedyLabels::Force(Id cell)
{
  this->Flip(cell);
  ++this->Forced;
}

void GreedyLabels::TakeBack(Id cell)
{
  this->Flip(cell);
  --this->Forced;
}

bool GreedyLabels::IsImprovement(Id cell) const
{
  // The change of the energy when the cell goes inside, from its label's point of view.
  std::int64_t growth = -this->Energy.Gain(cell);
  for (const CutEnergy::Neighbor& next : this->Energy.Neighbors(cell))
  {
    growth += this->IsInside(next.Cell) ? -next.Cost : next.Cost;
  }
  return this->IsInside(cell) ? growth > 0 : growth < 0;
}

bool GreedyLabels::MayFlip(Id cell) const
{
  return this->Energy.Demand(cell) == 0 && !this->Fixed[cell] &&
    !(this->IsInside(cell) && this->Kept[cell]) &&
    std::all_of(this->Constraints.begin(), this->Constraints.end(),
      [&](LabelConstraint* constraint) { return constraint->Allows(*this, cell); });
}

void GreedyLabels::ReleaseAndImprove()
{
  std::fill(this->Kept.begin(), this->Kept.end(), char(0));
  std::vector<Id> cells(this->Inside.size());
  std::iota(cells.begin(), cells.end(), 0);
  this->ImproveAround(cells);
}

void GreedyLabels::ImproveAround(const std::vector<Id>& cells)
{
  std::vector<Id> queue;
  const auto push = [&](Id cell)
  {
    if (!this->IsQueued[cell])
    {
      this->IsQueued[cell] = 1;
      queue.push_back(cell);
    }
  };
  const auto pushAround = [&](Id cell)
  {
    push(cell);
    for (const CutEnergy::Neighbor& next : this->Energy.Neighbors(cell))
    {
      push(next.Cell);
    }
  };
  std::for_each(cells.begin(), cells.end(), pushAround);
  for (std::size_t k = 0; k < queue.size(); ++k) // grows while it is read
  {
    const Id cell = queue[k];
    this->IsQueued[cell] = 0;
    if (this->IsImprovement(cell) && this->MayFlip(cell))
    {
      this->Flip(cell);
      pushAround(cell);
    }
  }
}
} // namespace insideout
