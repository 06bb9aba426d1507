// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/ConnectRegions.h"

namespace insideout
{
/**
 * A cell is simple when the solid keeps its topology as the cell changes its label: when what the
 * cell has in common with the other cells inside, its sides, edges and points, can shrink to a
 * point. Going inside is then an expansion and going outside a collapse, neither of which changes
 * a homotopy type; so Betti numbers stay, those of parts that touch in a point or edge included.
 */
class SimpleCells : public LabelConstraint
{
public:
  /** @param[in] cells must live on */
  explicit SimpleCells(const SimplicialCells& cells);

  bool IsSimple(const std::vector<unsigned char>& inside, Id cell) const;

  bool Allows(const GreedyLabels& labels, Id cell) override;
  void Changed(Id) override {}

private:
  const SimplicialCells& Cells;
  const Buckets<Id> AtPoints;
};

/**
 * Make the solid a ball, in a plane a disc: one part without tunnels or cavities. *Cut*: a ball
 * grows from the deepest cell inside, through simple cells inside; what it cannot take stays
 * outside, as walls across tunnels and ways into cavities. *Fill*: the hull shrinks through simple
 * cells outside; what it cannot leave stays inside, as membranes across tunnels, and cavities.
 * Either takes deep cells first, those many sides from the solid's boundary, so that walls and
 * membranes stand where it is narrow. The way of least energy is taken, among both and cutting once
 * some holes are filled: the holes are tried one by one, the membranes that cost least first.
 *
 * @param[in,out] inside one label per cell; left alone where no way obeys what is fixed
 * @return whether it is a ball now
 * @throws Error Stopped
 */
bool SimplyConnect(const SimplicialCells& cells, const CutEnergy& energy, const FixedLabels& fixed,
  std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);

/** Whether the solid is one part, which sides connect, with the Betti numbers of a ball. */
bool IsBall(const SimplicialCells& cells, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
