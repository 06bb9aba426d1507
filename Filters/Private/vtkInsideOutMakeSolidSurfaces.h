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
#include "vtkInsideOutHull.h"
#include "vtkInsideOutPart.h"
#include "vtkInsideOutSegmentHull.h"

/** What the points and triangles of the boundary are to be. */
struct vtkInsideOutBoundaryOptions
{
  bool MergePieces = false; ///< of input triangles
  bool SplitSeams = false;
  bool IsManifold = false; ///< of a parted solid
  bool TagBodies = false;  ///< the boundary of bodies by the surface's tags, too
};

/** Both, and what is to be told of them. */
struct vtkInsideOutSolidSurfaces
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
vtkInsideOutSolidSurfaces vtkInsideOutMakeSolidSurfaces(const vtkInsideOutHull& kept,
  const vtkInsideOutSegmentedHull& segmented, const vtkInsideOutParting* parted,
  const vtkInsideOutBoundaryOptions& options, const vtkInsideOutTags& tags,
  vtkInsideOutMakeOutputs& outputs, insideout::Monitor& monitor);

/** Both of a closed surface whose boundary is known without tetrahedra. */
vtkInsideOutSolidSurfaces vtkInsideOutMakeRepairedSurfaces(const vtkInsideOutHull& kept,
  const insideout::ExpressionSurface& repaired, const vtkInsideOutBoundaryOptions& options,
  const vtkInsideOutTags& tags, vtkInsideOutMakeOutputs& outputs, insideout::Monitor& monitor);
