// SPDX-License-Identifier: GPL-3.0-or-later
/** @file The defects of lines as data sets: the two-dimensional part of vtkSurfaceDefects. */
#pragma once

#include "Common/Monitor.h"
#include "In/ReadCurve.h"
#include "Planar/PlanarHull.h"

namespace vtkInsideOut
{
/** vtkSurfaceDefects's number of the first CurveDefect, after those for lines of surfaces. */
constexpr int FirstPointType = 4;

/** Outputs, with warnings and statistics. */
struct MarkedCurve
{
  vtkSmartPointer<vtkPolyData> Curve;  ///< the input with marks
  vtkSmartPointer<vtkPolyData> Points; ///< vertices at defects
  std::vector<std::string> Warnings;
};

/** @throws insideout::Error */
MarkedCurve MarkCurve(const Curve& curve, const insideout::PlanarHullParameters& parameters,
  insideout::Monitor& monitor);
} // namespace vtkInsideOut
