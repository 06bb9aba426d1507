// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/ConnectRegions.h"

namespace insideout
{
/**
 * A cell is simple if changing its label keeps the solid's topology: if the cell's intersection
 * with the other cells inside (sides, edges and points) is contractible. Going inside is then an
 * expansion and going outside a collapse. Neither changes the homotopy type, so Betti numbers stay,
 * also of parts that touch in a point or edge.
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
 * grows from the deepest cell inside, through simple cells inside; the remaining cells go outside,
 * as walls across tunnels and ways into cavities. *Fill*: the hull shrinks through simple cells
 * outside; the remaining cells go inside, as membranes across tunnels, and fill cavities. Both take
 * cells far from the solid's boundary first, so that walls and membranes are at narrow places. The
 * result of least energy is taken among cutting, filling, and cutting after some holes were filled;
 * holes are tried one by one, the cheapest membranes first.
 *
 * @param[in,out] inside one label per cell; unchanged if no way respects the fixed labels
 * @return whether it is a ball now
 * @throws Error Stopped
 */
bool SimplyConnect(const SimplicialCells& cells, const CutEnergy& energy, const FixedLabels& fixed,
  std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);

/** Whether the solid is one part, connected through sides, with the Betti numbers of a ball. */
bool IsBall(const SimplicialCells& cells, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
