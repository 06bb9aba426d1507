// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "GraphCut/RealEnergy.h"

namespace insideout
{
/**
 * An energy as integers, by which labellings are compared exactly: its terms scaled by a power of
 * two so that all around any cell sum to less than 2^52, and rounded. Only the difference of a
 * cell's two data terms matters; a difference that outweighs all faces of the cell is limited to
 * twice their sum. A demand is such a difference: every minimum meets it as if it were infinite.
 */
class CutEnergy
{
public:
  /** A cell that shares a face with another, and the cost of labelling the two differently. */
  struct Neighbor
  {
    Id Cell;
    std::uint32_t Face; ///< the neighbors of a cell are in this order
    std::int64_t Cost;  ///< above 0
  };

  /** The graph of the energy must live on. */
  explicit CutEnergy(RealEnergy energy);

  Id NumberOfCells() const { return static_cast<Id>(this->Gains.size()); }

  /** The cost of `cell` alone outside less that inside: 0 if w is 1/2. */
  std::int64_t Gain(Id cell) const { return this->Gains[cell]; }

  /**
   * The neighbors of `cell` that should have its label, without those where a difference costs
   * nothing.
   */
  Buckets<Neighbor>::Range Neighbors(Id cell) const { return this->NeighborsOfCells[cell]; }

  /** E's data term of the cell inside less that outside. */
  double ExtraInside(Id cell) const { return -this->Energy.Gain(cell); }

  /** A neighbor's cost in E, up to rounding. */
  double CostInEnergy(const Neighbor& neighbor) const;

  /** Those of the CellGraph. */
  const std::vector<std::int8_t>& Demands() const { return this->Cells().Demands; }

  /** 1 if the cell has to be inside, -1 outside, 0 for either. */
  int Demand(Id cell) const { return this->Demands().empty() ? 0 : this->Demands()[cell]; }

  double W(Id cell) const { return this->Cells().W[cell]; }

  /** E of a labelling, without demands. */
  double Of(const std::vector<unsigned char>& inside) const { return this->Energy.Of(inside); }

private:
  const CellGraph& Cells() const { return this->Energy.Cells(); }

  const RealEnergy Energy;
  RawVector<std::int64_t> Gains;
  int Shift = 0; ///< costs are E's times 2 to this power
  Buckets<Neighbor> NeighborsOfCells;
};
} // namespace insideout
