// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "GraphCut/ChooseRegions.h"
#include "GraphCut/FacetConstraint.h"

namespace insideout
{
/** Constraints on joining regions. */
struct FixedLabels
{
  std::vector<unsigned char> Cells; ///< per cell, not 0 if its label is fixed
  /// constraints to be kept where they are satisfied; may be null
  const std::vector<FacetPiece>* Pieces = nullptr;
};

/** The result of joining the parts of the solid. */
struct ConnectedRegions
{
  Id Joined = 0;           ///< ways that were made between two parts
  std::vector<Id> Dropped; ///< cells of dropped parts
  Id DroppedRegions = 0;
  Id Left = 0; ///< parts in the end: 1, unless fixed labels forbid it; 0 if nothing is inside
};

/**
 * Make the solid one part, adding little energy: repeatedly either join two parts by a way through
 * the outside or drop a part, whichever adds least. A way is a shortest path in the dual graph; the
 * length of a cell is the energy it adds when it goes inside after the cell before, at least 0. The
 * result is greedy, not minimal: connecting several parts with least energy contains the Steiner
 * tree problem. Chen, Freedman and Lampert 2011 likewise enforce topology on a cut by small changes
 * of labels.
 *
 * Shortest ways are found from all parts at once. All actions that the order of added energies
 * permits are performed before new ways are found; a part next to a dropped one waits for these.
 *
 * @param[in,out] inside one label per cell
 * @throws Error Stopped
 */
ConnectedRegions ConnectRegions(const SimplicialCells& cells, const CutEnergy& energy,
  const FixedLabels& fixed, std::vector<unsigned char>& inside, Monitor& monitor,
  const ProgressRange& progress);

/** The change of E when the cell's label changes. */
double GrowthByFlip(const CutEnergy& energy, const std::vector<unsigned char>& inside, Id cell);

/** The cells at each point. */
Buckets<Id> CellsAtPoints(const SimplicialCells& cells);

/**
 * A constraint: the solid stays one part. A cell goes inside only next to a cell inside, and
 * outside only if its neighbors inside are connected around it.
 */
class OneRegion : public LabelConstraint
{
public:
  /** @param[in] cells must live on */
  explicit OneRegion(const SimplicialCells& cells);

  bool Allows(const GreedyLabels& labels, Id cell) override;
  void Changed(Id) override {}

private:
  const SimplicialCells& Cells;
  const Buckets<Id> AtPoints;
};
} // namespace insideout
