// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The polygons of a surface for a file that Python writes. For Python, as vtkInsideOutUpdate is.
 */
#pragma once

#include "ForPython/UpdateAlgorithm.h"

extern "C"
{
  /**
   * Copy the polygons and strips of a surface, checked, strips as triangles, without lines and
   * vertices (ReadPolygons).
   *
   * @param surface, plain addresses of vtkPolyData as vtkObjectBase, to read and to fill
   * @param inFloats whether to round the points to floats (RoundToFloats), which loses the points'
   * attributes; the listener gets a warning of new defects
   */
  VTKFILTERSINSIDEOUT_EXPORT void vtkInsideOutPlainPolygons(
    void* surface, void* plain, int inFloats, vtkInsideOutListener listener);
}
