// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/ChooseRegions.h"
#include "GraphCut/FacetConstraint.h"
#include "GraphCut/ManifoldConstraint.h"

#include <string>

namespace insideout
{
/** The topology that the solid is to have, whatever energy it takes. */
enum class TopologyGoal
{
  Any,            ///< as the cut has it
  OneComponent,   ///< parts joined or dropped (ConnectRegions)
  SimplyConnected ///< a ball, in a plane a disc: no tunnels and cavities either (SimplyConnect)
};

/** Makes the boundary of labels a manifold, and reports from one fraction to another. */
using MakeManifold = std::function<ManifoldConstraint::Outcome(
  GreedyLabels& labels, Monitor& monitor, double begin, double end)>;

struct ControlTopologyParameters
{
  ChooseRegionsParameters Regions;
  TopologyGoal Goal = TopologyGoal::Any;

  bool ChangeNothing() const
  {
    return this->Regions.ChooseAll() && this->Goal == TopologyGoal::Any;
  }
};

/** Further constraints on the labels. */
struct OtherConstraints
{
  const std::vector<std::int8_t>* Demands; ///< as CellGraph has them
  const std::vector<FacetPiece>* Pieces;   ///< to be kept where they are; null for none
  insideout::MakeManifold MakeManifold;    ///< empty where the boundary need not be one
};

struct ControlledTopology
{
  RegionChanges Regions;   ///< with those that were dropped to make the solid one part
  Id Joined = 0;           ///< ways between parts
  double EnergyBefore = 0; ///< once regions were chosen, before the goal cost any
  Id ForcedCells = 0;      ///< to make the boundary a manifold again
  Id LeftPoints = 0;       ///< that are not manifold in the end, where that was asked for
  std::vector<std::string> Warnings;
};

/**
 * Last step of the cut: choose among the solid's regions and cavities; make it one part or a ball
 * where that is asked for; greedily improve around the changes as long as it stays so; make the
 * boundary a manifold once more. Dropped regions stay dropped, filled cavities filled.
 *
 * @param[in,out] inside one label per cell
 * @throws Error InvalidParameter, Stopped
 */
ControlledTopology ControlTopology(const SimplicialCells& cells, const CutEnergy& energy,
  const OtherConstraints& others, const ControlTopologyParameters& parameters,
  std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
