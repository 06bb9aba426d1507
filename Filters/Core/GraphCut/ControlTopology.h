// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/ChooseRegions.h"
#include "GraphCut/FacetConstraint.h"
#include "GraphCut/ManifoldConstraint.h"

#include <string>

namespace insideout
{
/** The required topology of the solid, at any cost in energy. */
enum class TopologyGoal
{
  Any,            ///< as the cut leaves it
  OneComponent,   ///< parts joined or dropped (ConnectRegions)
  SimplyConnected ///< a ball, in a plane a disc: no tunnels or cavities either (SimplyConnect)
};

/** Makes the boundary of labels a manifold; reports progress between two fractions. */
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
  const std::vector<std::int8_t>* Demands; ///< as in CellGraph
  const std::vector<FacetPiece>* Pieces;   ///< to be kept where satisfied; null for none
  insideout::MakeManifold MakeManifold;    ///< empty if the boundary need not be manifold
};

struct ControlledTopology
{
  RegionChanges Regions;   ///< including cells of parts dropped to make the solid one part
  Id Joined = 0;           ///< ways between parts
  double EnergyBefore = 0; ///< after regions were chosen, before the topology cost any
  Id ForcedCells = 0;      ///< cells forced to make the boundary manifold again
  Id LeftPoints = 0;       ///< points that stay non-manifold, if a manifold was requested
  std::vector<std::string> Warnings;
};

/**
 * Last step of the cut: choose among the solid's regions and cavities; make it one part or a ball
 * if requested; greedily improve around the changes while it stays so; make the boundary a manifold
 * again. Dropped regions stay dropped, filled cavities filled.
 *
 * @param[in,out] inside one label per cell
 * @throws Error InvalidParameter, Stopped
 */
ControlledTopology ControlTopology(const SimplicialCells& cells, const CutEnergy& energy,
  const OtherConstraints& others, const ControlTopologyParameters& parameters,
  std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
