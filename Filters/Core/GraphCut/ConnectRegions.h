// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "GraphCut/ChooseRegions.h"
#include "GraphCut/FacetConstraint.h"

namespace insideout
{
/** The labels that joining regions may not change. */
struct FixedLabels
{
  std::vector<unsigned char> Cells;                ///< per cell not 0 where its label stays
  const std::vector<FacetPiece>* Pieces = nullptr; ///< to be kept, those that are; may be null
};

/** What became of the parts of the solid. */
struct ConnectedRegions
{
  Id Joined = 0;           ///< ways that were made between two parts
  std::vector<Id> Dropped; ///< cells of parts that were given up
  Id DroppedRegions = 0;
  Id Left = 0; ///< parts in the end: 1, unless what is fixed forbids it; 0 where nothing is inside
};

/**
 * Make the solid one part, with little energy added: of all ways through the outside from a part to
 * another, and of all parts that can be dropped, take what adds least, again and again. A way is a
 * shortest one in the dual graph, by what each cell on it adds when it goes inside after the one
 * before; what would lower the energy counts as nothing. Greedy, so no minimum: to connect several
 * parts with least energy contains the problem of Steiner trees. Chen, Freedman and Lampert 2011
 * enforce topology on a cut by changing labels as little as that, too.
 *
 * Shortest ways are found from all parts at once, and all that the order of what they add allows is
 * done before they are found anew: a part beside one that was dropped waits for that.
 *
 * @param[in,out] inside one label per cell
 * @throws Error Stopped
 */
ConnectedRegions ConnectRegions(const SimplicialCells& cells, const CutEnergy& energy,
  const FixedLabels& fixed, std::vector<unsigned char>& inside, Monitor& monitor,
  const ProgressRange& progress);

/** By how much E grows when the cell's label changes. */
double GrowthByFlip(const CutEnergy& energy, const std::vector<unsigned char>& inside, Id cell);

/** The cells at each point. */
Buckets<Id> CellsAtPoints(const SimplicialCells& cells);

/**
 * The solid stays one part: no cell goes inside that has none inside beside it, none outside where
 * those inside beside it are not connected around it.
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
