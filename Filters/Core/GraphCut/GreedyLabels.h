// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/CutEnergy.h"

namespace insideout
{
class GreedyLabels;

/** What a labelling has to satisfy and cannot be put into the energy's terms. */
class LabelConstraint
{
public:
  virtual ~LabelConstraint() = default;

  /** Whether the constraint stays satisfied wherever it is so now when the cell changes its label.
   */
  virtual bool Allows(const GreedyLabels& labels, Id cell) = 0;

  /** The cell has changed its label. */
  virtual void Changed(Id cell) = 0;
};

/**
 * A labelling that constraints change cell by cell (thesis, section 8.5.2): cells that one of them
 * needs are labelled inside, and after each such step the energy is improved greedily. Energies are
 * compared as integers, so that every improvement is one, and there cannot be endlessly many.
 */
class GreedyLabels
{
public:
  /** @param[in] energy must live on; demands are not touched */
  GreedyLabels(const CutEnergy& energy, std::vector<unsigned char> inside);

  const std::vector<unsigned char>& Labels() const { return this->Inside; }
  bool IsInside(Id cell) const { return this->Inside[cell] != 0; }
  double W(Id cell) const { return this->Energy.W(cell); }

  /** Whether the cell may be labelled inside: no demand forbids it. */
  bool MayBeInside(Id cell) const { return this->Energy.Demand(cell) >= 0 && !this->Fixed[cell]; }

  /** Never change the cell's label. */
  void Fix(Id cell) { this->Fixed[cell] = 1; }

  /** From now on no improvement may violate it. It must live on. */
  void Add(LabelConstraint& constraint) { this->Constraints.push_back(&constraint); }

  /** Label a cell inside that is outside and may be inside. */
  void Force(Id cell);

  /** Label a cell outside that was just forced. */
  void TakeBack(Id cell);

  /** Do not label the cell outside until it is released. */
  void Keep(Id cell) { this->Kept[cell] = 1; }

  /** Release all cells that are kept, and improve around each cell of the mesh. */
  void ReleaseAndImprove();

  /**
   * Change labels as long as a change lowers the energy and no constraint objects. The cells are
   * those in `cells`, next to one of these, or next to a changed one. Neither demands nor kept
   * cells are violated.
   */
  void ImproveAround(const std::vector<Id>& cells);

  /** Cells that were forced. */
  Id NumberOfForced() const { return this->Forced; }

private:
  void Flip(Id cell);
  bool IsImprovement(Id cell) const;
  bool MayFlip(Id cell) const;

  const CutEnergy& Energy;
  std::vector<unsigned char> Inside;
  std::vector<char> Fixed;
  std::vector<char> Kept;
  std::vector<char> IsQueued;
  std::vector<LabelConstraint*> Constraints;
  Id Forced = 0;
};
} // namespace insideout
