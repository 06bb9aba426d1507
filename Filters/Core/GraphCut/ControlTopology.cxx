// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/ControlTopology.h"

#include "Common/Stages.h"
#include "GraphCut/ConnectRegions.h"
#include "GraphCut/SimplyConnect.h"

#include <algorithm>

namespace insideout
{
namespace
{
std::vector<Id> DifferentCells(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  std::vector<Id> different;
  for (std::size_t cell = 0; cell < a.size(); ++cell)
  {
    if (a[cell] != b[cell])
    {
      different.push_back(static_cast<Id>(cell));
    }
  }
  return different;
}

/** Cells with a seed, and the cells of chosen regions. */
FixedLabels FixedBy(
  const OtherConstraints& others, const std::vector<Id>& chosen, std::size_t numberOfCells)
{
  FixedLabels fixed;
  fixed.Cells.assign(numberOfCells, 0);
  fixed.Pieces = others.Pieces;
  for (const Id cell : chosen)
  {
    fixed.Cells[cell] = 1;
  }
  for (std::size_t cell = 0; cell < others.Demands->size(); ++cell)
  {
    fixed.Cells[cell] |= (*others.Demands)[cell] != 0;
  }
  return fixed;
}

/** Improve around the cells and restore the manifold, while the solid stays one part, or a ball. */
void Improve(const SimplicialCells& cells, const CutEnergy& energy, const OtherConstraints& others,
  const FixedLabels& fixed, const std::vector<Id>& changed, bool isBall,
  std::vector<unsigned char>& inside, ControlledTopology& result, Monitor& monitor,
  const ProgressRange& progress)
{
  GreedyLabels labels(energy, inside);
  for (Id cell = 0; cell < energy.NumberOfCells(); ++cell)
  {
    if (fixed.Cells[cell])
    {
      labels.Fix(cell);
    }
  }
  OneRegion oneRegion(cells);
  labels.Add(oneRegion);
  SimpleCells simple(cells);
  if (isBall)
  {
    labels.Add(simple);
  }
  const std::vector<FacetPiece> none;
  FacetConstraint facets(others.Pieces ? *others.Pieces : none, energy.NumberOfCells());
  labels.Add(facets);
  labels.ImproveAround(changed);
  if (others.MakeManifold)
  {
    result.LeftPoints =
      others.MakeManifold(labels, monitor, progress.Begin, progress.End).LeftPoints;
  }
  result.ForcedCells = labels.NumberOfForced();
  inside = labels.Labels();
}
} // namespace

ControlledTopology ControlTopology(const SimplicialCells& cells, const CutEnergy& energy,
  const OtherConstraints& others, const ControlTopologyParameters& parameters,
  std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress)
{
  ControlledTopology result;
  std::vector<unsigned char> before = inside;
  result.Regions = ChooseRegions(cells, *others.Demands, parameters.Regions, inside, monitor,
    { progress.Stage, progress.Begin, progress.At(0.2) });
  if (result.Regions.DroppedRegions > 0 &&
    std::find(inside.begin(), inside.end(), 1) == inside.end())
  {
    result.Warnings.push_back("all " + std::to_string(result.Regions.DroppedRegions) +
      " regions of the solid were dropped: none is large enough, or has the seed inside that "
      "is required");
  }
  result.EnergyBefore = energy.Of(inside);
  if (parameters.Goal == TopologyGoal::Any)
  {
    return result;
  }
  const FixedLabels fixed = FixedBy(others, DifferentCells(before, inside), inside.size());
  before = inside;
  const ConnectedRegions connected = ConnectRegions(
    cells, energy, fixed, inside, monitor, { progress.Stage, progress.At(0.2), progress.At(0.5) });
  const bool isAsked = parameters.Goal == TopologyGoal::SimplyConnected;
  const bool isBall = isAsked && connected.Left == 1 &&
    SimplyConnect(cells, energy, fixed, inside, monitor,
      { progress.Stage, progress.At(0.5), progress.At(0.8) });
  const std::vector<Id> changed = DifferentCells(before, inside);
  if (!changed.empty())
  {
    Improve(cells, energy, others, fixed, changed, isBall, inside, result, monitor,
      { progress.Stage, progress.At(0.8), progress.End });
  }
  result.Joined = connected.Joined;
  result.Regions.DroppedRegions += connected.DroppedRegions;
  if (connected.DroppedRegions > 0)
  {
    const ScaledSizes sizes = cells.Sizes();
    double volume = 0;
    for (const Id cell : connected.Dropped)
    {
      volume += inside[cell] ? 0 : sizes.Scaled[cell];
    }
    result.Regions.DroppedVolume += sizes.InUnits(volume);
  }
  const Id left =
    FindRegions(cells, inside, monitor, { progress.Stage, progress.End, progress.End }).Count;
  if (left > 1)
  {
    result.Warnings.push_back("the solid is not one component but " + std::to_string(left) +
      ": what is to be outside, by seeds or because it was dropped, parts it, and what is to be "
      "inside, or kept, cannot be dropped");
  }
  else if (left == 1 && isAsked &&
    !IsBall(cells, inside, monitor, { progress.Stage, progress.End, progress.End }))
  {
    result.Warnings.emplace_back("the solid could not be made simply connected: "
                                 "neither walls nor membranes do that here without breaking what "
                                 "seeds, chosen regions, kept facets or a manifold ask for");
  }
  return result;
}
} // namespace insideout
