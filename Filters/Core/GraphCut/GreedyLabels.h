// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/CutEnergy.h"

namespace insideout
{
class GreedyLabels;

/** A constraint on labels that the energy's terms cannot express. */
class LabelConstraint
{
public:
  virtual ~LabelConstraint() = default;

  /** Whether a change of the cell's label violates the constraint nowhere where it is satisfied
   * now. */
  virtual bool Allows(const GreedyLabels& labels, Id cell) = 0;

  /** Notification: the cell has changed its label. */
  virtual void Changed(Id cell) = 0;
};

/**
 * A labelling that constraints change cell by cell (thesis, section 8.5.2): cells that a constraint
 * needs are labelled inside, and after each step the energy is improved greedily. Energies are
 * compared as integers, so every improvement is strict and their number is finite.
 */
class GreedyLabels
{
public:
  /** @param[in] energy must live on; its demands are never violated */
  GreedyLabels(const CutEnergy& energy, std::vector<unsigned char> inside);

  const std::vector<unsigned char>& Labels() const { return this->Inside; }
  bool IsInside(Id cell) const { return this->Inside[cell] != 0; }
  double W(Id cell) const { return this->Energy.W(cell); }

  /** Whether the cell may be labelled inside: no demand forbids it. */
  bool MayBeInside(Id cell) const { return this->Energy.Demand(cell) >= 0 && !this->Fixed[cell]; }

  /** Never change the cell's label. */
  void Fix(Id cell) { this->Fixed[cell] = 1; }

  /** Add a constraint that no later improvement may violate. It must live on. */
  void Add(LabelConstraint& constraint) { this->Constraints.push_back(&constraint); }

  /** Force an outside cell inside; it must be allowed to be inside. */
  void Force(Id cell);

  /** Label a just forced cell outside. */
  void TakeBack(Id cell);

  /** Do not label the cell outside until it is released. */
  void Keep(Id cell) { this->Kept[cell] = 1; }

  /** Release all cells that are kept, and improve around each cell of the mesh. */
  void ReleaseAndImprove();

  /**
   * Change labels while a change lowers the energy and violates no constraint. Candidates are the
   * cells in `cells`, their neighbors, and neighbors of changed cells. Neither demands nor kept
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
