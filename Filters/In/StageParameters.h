// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The options that filters have in common, as parameters of the stages. The filters take their
 * defaults from these parameters; their enums have the same values.
 */
#pragma once

#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Refine/RefineTetrahedra.h"

#include <vtkSmartPointer.h>

namespace vtkInsideOut
{
template <typename Filter>
insideout::CountedChainParameters ChainParametersOf(Filter* filter)
{
  insideout::CountedChainParameters parameters;
  parameters.MergeTolerance = filter->GetMergeTolerance();
  parameters.CountDuplicates = filter->GetCountDuplicates();
  return parameters;
}

template <typename Filter>
insideout::ConstrainedDelaunayParameters DelaunayParametersOf(Filter* filter)
{
  using Engine = insideout::TetrahedralizationEngine;
  static_assert(Filter::ENGINE_AUTOMATIC == static_cast<int>(Engine::Automatic));
  static_assert(Filter::ENGINE_EXACT == static_cast<int>(Engine::Exact));
  static_assert(Filter::ENGINE_TETGEN == static_cast<int>(Engine::TetGen));
  insideout::ConstrainedDelaunayParameters parameters;
  parameters.Engine = static_cast<Engine>(filter->GetEngine());
  parameters.TimeBudget = filter->GetTimeBudget();
  parameters.MemoryBudget = filter->GetMemoryBudget();
  return parameters;
}

template <typename Filter>
insideout::Orientation OrientationOf(Filter* filter)
{
  using insideout::Orientation;
  static_assert(Filter::AUTOMATIC == static_cast<int>(Orientation::Automatic));
  static_assert(Filter::AS_GIVEN == static_cast<int>(Orientation::AsGiven));
  static_assert(Filter::REVERSE == static_cast<int>(Orientation::Reverse));
  static_assert(Filter::OUTWARD == static_cast<int>(Orientation::Outward));
  return static_cast<Orientation>(filter->GetOrientation());
}

template <typename Filter>
insideout::HullMeshParameters HullParametersOf(Filter* filter)
{
  insideout::HullMeshParameters parameters;
  parameters.Chain = ChainParametersOf(filter);
  parameters.Orientation = OrientationOf(filter);
  parameters.Thicken.Width = filter->GetThicken();
  parameters.Thicken.All = filter->GetThickenAll();
  parameters.Budgets = DelaunayParametersOf(filter);
  parameters.QuadratureOrder = filter->GetQuadratureOrder();
  return parameters;
}

template <typename Filter>
insideout::SegmentMeshParameters SegmentParametersOf(Filter* filter)
{
  using insideout::DataTerm;
  static_assert(Filter::UNIFORM == static_cast<int>(DataTerm::Uniform));
  static_assert(Filter::VOLUME_WEIGHTED == static_cast<int>(DataTerm::VolumeWeighted));
  using insideout::TopologyGoal;
  static_assert(Filter::TOPOLOGY_ANY == static_cast<int>(TopologyGoal::Any));
  static_assert(Filter::TOPOLOGY_ONE_COMPONENT == static_cast<int>(TopologyGoal::OneComponent));
  static_assert(
    Filter::TOPOLOGY_SIMPLY_CONNECTED == static_cast<int>(TopologyGoal::SimplyConnected));
  insideout::SegmentMeshParameters parameters;
  parameters.Cut.Gamma = filter->GetGamma();
  parameters.Cut.Sigma = filter->GetSigma();
  parameters.Cut.DataTerm = static_cast<DataTerm>(filter->GetDataTerm());
  parameters.ConstrainFacets = filter->GetConstrainFacets();
  parameters.FillNonManifold = filter->GetNonManifold() == Filter::NONMANIFOLD_FILL;
  parameters.Topology.Regions.LargestRegions = filter->GetLargestRegions();
  parameters.Topology.Regions.MinimumRegionVolume = filter->GetMinimumRegionVolume();
  parameters.Topology.Regions.SeededRegions = filter->GetSeededRegions();
  parameters.Topology.Regions.FillCavities = filter->GetFillCavities();
  parameters.Topology.Goal = static_cast<TopologyGoal>(filter->GetTopology());
  return parameters;
}

template <typename Filter>
insideout::RefinementParameters RefinementParametersOf(Filter* filter)
{
  using insideout::SurfaceTreatment;
  static_assert(Filter::KEPT == static_cast<int>(SurfaceTreatment::Kept));
  static_assert(Filter::SPLIT == static_cast<int>(SurfaceTreatment::Split));
  static_assert(Filter::REMESHED == static_cast<int>(SurfaceTreatment::Remeshed));
  insideout::RefinementParameters parameters;
  parameters.Sizes.EdgeLength = filter->GetEdgeLength();
  parameters.Sizes.Grading = filter->GetGrading();
  parameters.Sizes.MaximumVolume = filter->GetMaximumVolume();
  parameters.Surface = static_cast<SurfaceTreatment>(filter->GetSurface());
  parameters.SurfaceTolerance = filter->GetSurfaceTolerance();
  parameters.FeatureAngle = filter->GetFeatureAngle();
  return parameters;
}

/** Give a filter another stage, whose options it goes by from now on; null is no stage. */
template <typename Filter, typename Stage>
void SetStage(Filter* filter, Stage* stage, vtkSmartPointer<Stage>& held)
{
  if (stage && stage != held)
  {
    held = stage;
    filter->Modified();
  }
}
} // namespace vtkInsideOut
