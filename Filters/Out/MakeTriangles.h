// SPDX-License-Identifier: GPL-3.0-or-later
/** @file From a curve in a plane to data sets: the work of vtkRobustTriangulate. */
#pragma once

#include "Data/VtkClasses.h"
#include "GraphCut/SegmentMesh.h"
#include "In/ReadCurve.h"
#include "In/Tags.h"
#include "Planar/PlanarHull.h"
#include "Refine/RefineTetrahedra.h"

#include <tuple>

namespace vtkInsideOut
{
/** The hull of a curve. */
struct KeptPlanarHull
{
  /** Stages validate to w. @throws insideout::Error */
  KeptPlanarHull(vtkPolyData* input, const insideout::PlanarHullParameters& parameters,
    const std::string& nonParticipating, insideout::Monitor& monitor);

  vtkInsideOut::Curve Curve;
  insideout::PlanarHull Hull;
};

/** The cache key of the hull. Does not compile once a parameter is added. */
inline auto AsTuple(
  const insideout::PlanarHullParameters& parameters, const std::string& nonParticipating)
{
  const auto& [chain, orientation] = parameters;
  const auto& [mergeTolerance, countDuplicates] = chain;
  return std::make_tuple(mergeTolerance, countDuplicates, orientation, nonParticipating);
}

/** The options of stages after the hull. */
struct PlanarOptions
{
  insideout::SegmentMeshParameters Segment;
  std::string ConstrainedArray; ///< cell array that selects the segments to keep
  bool SplitPoints = false;     ///< where the solid touches itself
  bool GenerateHull = false;    ///< Triangles::Hull and Resolved, too
  bool Refine = false;
  insideout::RefinementParameters Refinement;
};

/** Outputs, with warnings and statistics. */
struct Triangles
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< with all statistics
  vtkSmartPointer<vtkPolyData> Boundary;     ///< polylines with the inside on their left
  vtkSmartPointer<vtkPolyData> Outliers;     ///< polylines
  vtkSmartPointer<vtkUnstructuredGrid> Hull; ///< all triangles, with all statistics; or null
  vtkSmartPointer<vtkPolyData> Resolved;     ///< polylines that meet only in shared points; or null
  std::vector<std::string> Warnings;
};

/** The stages after the hull. @throws insideout::Error */
Triangles MakeTriangles(const KeptPlanarHull& kept, const std::vector<insideout::Seed>& seeds,
  const Tags& tags, const PlanarOptions& options, insideout::Monitor& monitor);
} // namespace vtkInsideOut
