// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The defects of lines as data sets: what vtkSurfaceDefects does in two dimensions.
 */
#pragma once

#include "Common/Monitor.h"
#include "Planar/PlanarHull.h"
#include "vtkInsideOutReadCurve.h"

/** Outputs, and what is to be told of them. */
struct vtkInsideOutMarkedCurve
{
  vtkSmartPointer<vtkPolyData> Curve;  ///< the input with marks
  vtkSmartPointer<vtkPolyData> Points; ///< vertices where something is wrong
  std::vector<std::string> Warnings;
};

/** @throws insideout::Error */
vtkInsideOutMarkedCurve vtkInsideOutMarkCurve(const vtkInsideOutCurve& curve,
  const insideout::PlanarHullParameters& parameters, insideout::Monitor& monitor);
