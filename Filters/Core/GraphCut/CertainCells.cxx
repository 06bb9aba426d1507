// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/CertainCells.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerCell = 20; ///< for looking at a cell's neighbors
} // namespace

CertainCells::CertainCells(const CutEnergy& energy)
  : Energy(energy)
  , OpenCells(energy.NumberOfCells())
  , States(energy.NumberOfCells(), State::Open)
  , Gains(energy.NumberOfCells())
  , Against(energy.NumberOfCells())
{
  std::iota(this->OpenCells.begin(), this->OpenCells.end(), 0);
  for (const Id cell : this->OpenCells)
  {
    this->Gains[cell] = energy.Gain(cell);
  }
  while (this->Look())
  {
  }
}

CertainCells::State CertainCells::Guess(Id cell) const
{
  return this->Gains[cell] > 0 ? State::MaybeInside : State::MaybeOutside;
}

void CertainCells::GiveUpIfOutweighed(Id cell)
{
  const bool outweighed = this->States[cell] == State::MaybeInside
    ? this->Gains[cell] <= this->Against[cell]
    : -this->Gains[cell] < this->Against[cell];
  if (outweighed)
  {
    this->States[cell] = State::Open;
    this->GivenUp.push_back(cell);
  }
}

void CertainCells::Settle(Id cell)
{
  const bool inside = this->States[cell] == State::MaybeInside;
  this->States[cell] = inside ? State::Inside : State::Outside;
  for (const CutEnergy::Neighbor& next : this->Energy.Neighbors(cell))
  {
    if (this->IsOpen(next.Cell))
    {
      this->Gains[next.Cell] += inside ? next.Cost : -next.Cost;
    }
  }
}

/** @return whether another pass pays off: whether most cells became certain */
bool CertainCells::Look()
{
  const std::size_t before = this->OpenCells.size();
  for (const Id cell : this->OpenCells)
  {
    this->States[cell] = this->Guess(cell);
  }
  ParallelLoop(before, NanosecondsPerCell,
    [this](std::size_t i)
    {
      const Id cell = this->OpenCells[i];
      const State opposite =
        this->States[cell] == State::MaybeInside ? State::MaybeOutside : State::MaybeInside;
      this->Against[cell] = 0;
      for (const CutEnergy::Neighbor& next : this->Energy.Neighbors(cell))
      {
        this->Against[cell] += this->States[next.Cell] == opposite ? next.Cost : 0;
      }
    });
  this->GivenUp.clear();
  for (const Id cell : this->OpenCells)
  {
    this->GiveUpIfOutweighed(cell);
  }
  for (std::size_t k = 0; k < this->GivenUp.size(); ++k) // grows while it is read
  {
    const Id cell = this->GivenUp[k];
    for (const CutEnergy::Neighbor& next : this->Energy.Neighbors(cell))
    {
      if (this->States[next.Cell] == this->Guess(cell))
      {
        this->Against[next.Cell] += next.Cost;
        this->GiveUpIfOutweighed(next.Cell);
      }
    }
  }
  for (const Id cell : this->OpenCells)
  {
    if (!this->IsOpen(cell))
    {
      this->Settle(cell);
    }
  }
  std::sort(this->GivenUp.begin(), this->GivenUp.end());
  std::swap(this->OpenCells, this->GivenUp);
  return this->OpenCells.size() < before / 2;
}
} // namespace insideout
