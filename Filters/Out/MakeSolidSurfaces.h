// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Outputs 1 and 2 of vtkRobustTetrahedralize: the solid's boundary, and the input's facets that are
 * no part of it.
 */
#pragma once

#include "Boolean/SurfaceOfExpression.h"
#include "Common/Statistics.h"
#include "LostArea.h"
#include "Out/KeptHull.h"
#include "Out/PartSolid.h"
#include "Out/SegmentHull.h"

namespace vtkInsideOut
{
/** The points and triangles that the boundary is to have. */
struct BoundaryOptions
{
  bool MergePieces = false; ///< of input triangles
  bool SplitSeams = false;
  bool IsManifold = false; ///< of a parted solid
  bool TagBodies = false;  ///< the boundary of bodies by the surface's tags, too
};

/** Both, and what is to be told of them. */
struct SolidSurfaces
{
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkSmartPointer<vtkPolyData> Outliers;
  insideout::Statistics Counts;
  insideout::LostArea Lost;
};

/**
 * Both of a hull.
 *
 * @param[in] parted the solid that was parted from the hull, or null; not of named bodies
 * @param[in,out] outputs gains warnings
 * @throws insideout::Error Stopped
 */
SolidSurfaces MakeSolidSurfaces(const KeptHull& kept, const SegmentedHull& segmented,
  const Parting* parted, const BoundaryOptions& options, const Tags& tags, MakeOutputs& outputs,
  insideout::Monitor& monitor);

/** Both of a closed surface whose boundary is known without tetrahedra. */
SolidSurfaces MakeRepairedSurfaces(const KeptHull& kept,
  const insideout::ExpressionSurface& repaired, const BoundaryOptions& options, const Tags& tags,
  MakeOutputs& outputs, insideout::Monitor& monitor);
} // namespace vtkInsideOut
