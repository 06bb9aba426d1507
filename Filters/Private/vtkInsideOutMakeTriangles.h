// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * From a curve in a plane to data sets: what vtkRobustTetrahedralize does in two dimensions.
 */
#pragma once

#include "GraphCut/SegmentMesh.h"
#include "Planar/PlanarHull.h"
#include "Refine/RefineTetrahedra.h"
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
  bool Refine = false;
  insideout::RefinementParameters Refinement;
  bool SplitPoints = false; ///< where the solid touches itself
};

/** One output of a single stage. */
template <typename Data>
struct vtkInsideOutPlanarStage
{
  vtkSmartPointer<Data> Output; ///< with all statistics
  std::vector<std::string> Warnings;
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

/** Stages validate to w: all triangles of the hull. @throws insideout::Error */
vtkInsideOutPlanarStage<vtkUnstructuredGrid> vtkInsideOutMakePlanarHull(
  const vtkInsideOutCurve& curve, const insideout::PlanarHullParameters& parameters,
  insideout::Monitor& monitor);

/** Stage CDT of a curve that does not cross itself. @throws insideout::Error that names the cells
 * that meet */
vtkInsideOutPlanarStage<vtkUnstructuredGrid> vtkInsideOutTriangulate(const vtkInsideOutCurve& curve,
  const insideout::CountedChainParameters& parameters, insideout::Monitor& monitor);

/** Stage pre: polylines that meet in shared points only. @throws insideout::Error */
vtkInsideOutPlanarStage<vtkPolyData> vtkInsideOutResolveLines(const vtkInsideOutCurve& curve,
  const insideout::CountedChainParameters& parameters, insideout::Monitor& monitor);

/** What is to be told of an input for which nobody asked for two dimensions. */
std::string vtkInsideOutTwoDimensions(const vtkInsideOutCurve& curve);
