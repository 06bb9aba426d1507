// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * From a curve in a plane to data sets: what vtkRobustTetrahedralize does in two dimensions.
 */
#pragma once

#include "GraphCut/SegmentMesh.h"
#include "Planar/PlanarHull.h"
#include "vtkInsideOutReadCurve.h"
#include "vtkInsideOutTags.h"

class vtkUnstructuredGrid;

/** The options that matter in two dimensions. */
struct vtkInsideOutPlanarOptions
{
  insideout::PlanarHullParameters Hull;
  insideout::SegmentMeshParameters Segment;
  std::string ConstrainedArray; ///< the cell array that chooses which segments are kept
  bool ExtractInside = true;
};

/** Outputs, and what is to be told of them. */
struct vtkInsideOutTriangles
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< with all statistics
  vtkSmartPointer<vtkPolyData> Boundary;     ///< polylines with the inside on their left
  vtkSmartPointer<vtkPolyData> Outliers;     ///< polylines
  std::vector<std::string> Warnings;
};

/** All stages. @throws insideout::Error */
vtkInsideOutTriangles vtkInsideOutMakeTriangles(const vtkInsideOutCurve& curve,
  const std::vector<insideout::Seed>& seeds, const vtkInsideOutTags& tags,
  const vtkInsideOutPlanarOptions& options, insideout::Monitor& monitor);
