// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The options of filters as parameters of the stages. The filters take their defaults from these
 * parameters; their enums have the same values.
 */
#pragma once

#include "Data/VtkClasses.h"
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

///@{
/** Options of a filter that the stage's filter defines. */
insideout::HullMeshParameters HullParametersOf(vtkGeneralizedWindingNumber* filter);
insideout::SegmentMeshParameters SegmentParametersOf(vtkGraphCutSegmentation* filter);
insideout::RefinementParameters RefinementParametersOf(vtkRefineTetrahedra* filter);
///@}

/** Whether a surface in space is remeshed because SurfaceTreatment is automatic and lengths are
 * given. */
bool FollowsLengths(vtkRefineTetrahedra* filter);

/** Add the lengths of the background that a stage has, if any. @throws insideout::Error */
void AddBackground(vtkRefineTetrahedra* filter, insideout::SizingParameters& sizes);

/** Set another stage as the source of a filter's options; null for none. */
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
