// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Outputs 1 and 2 of vtkRobustTetrahedralize: the solid's boundary, and facets of the input
 * that are not part of it.
 */
#pragma once

#include "Boolean/SurfaceOfExpression.h"
#include "Common/Statistics.h"
#include "LostArea.h"
#include "Out/KeptHull.h"
#include "Out/PartSolid.h"
#include "Out/SegmentHull.h"
#include "Output/TagRules.h"

namespace vtkInsideOut
{
/** Requirements of the boundary's points and triangles. */
struct BoundaryOptions
{
  bool MergePieces = false; ///< of input triangles
  bool SplitSeams = false;
  bool IsManifold = false;                  ///< of a parted solid
  bool TagBodies = false;                   ///< tags of the surface on the boundary of bodies, too
  std::vector<insideout::TagRule> TagRules; ///< applied after all other tags
};

/** Both outputs, with warnings and statistics. */
struct SolidSurfaces
{
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkSmartPointer<vtkPolyData> Outliers;
  insideout::Statistics Counts;
  insideout::LostArea Lost;
};

/**
 * Both outputs of a hull.
 *
 * @param[in] parted the separated solid, or null; not with named bodies
 * @param[in,out] outputs gains warnings
 * @throws insideout::Error Stopped
 */
SolidSurfaces MakeSolidSurfaces(const KeptHull& kept, const SegmentedHull& segmented,
  const Parting* parted, const BoundaryOptions& options, const Tags& tags, MakeOutputs& outputs,
  insideout::Monitor& monitor);

/** Both outputs of a closed surface whose boundary is known without tetrahedra. */
SolidSurfaces MakeRepairedSurfaces(const KeptHull& kept,
  const insideout::ExpressionSurface& repaired, const BoundaryOptions& options, const Tags& tags,
  MakeOutputs& outputs, insideout::Monitor& monitor);
} // namespace vtkInsideOut
