// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Writes files from C, whole or not at all: see Core's OutputFile.
 *
 * Errors go to the listener, with the file and the system's reason; a listener that wants to stop
 * is obeyed until the file is in its place. For Python, as vtkInsideOutUpdate is.
 */
#pragma once

#include "ForPython/UpdateAlgorithm.h"

#include <cstddef>

extern "C"
{
  /**
   * Write a data set in VTK's XML format for its type, in binary mode: what VTK writes by default,
   * appended mode, cannot be read back where expat has a certain security update. VTK's own writers
   * crash when a disk is full.
   *
   * @param data address of a vtkPolyData, vtkUnstructuredGrid or vtkImageData as a vtkObjectBase
   */
  VTKFILTERSINSIDEOUT_EXPORT void vtkInsideOutWriteData(
    void* data, const char* path, vtkInsideOutListener listener);

  /** Write what is in memory. */
  VTKFILTERSINSIDEOUT_EXPORT void vtkInsideOutWriteBytes(
    const char* bytes, std::size_t length, const char* path, vtkInsideOutListener listener);

  /**
   * Remove all files that are not written to their end, of a process that ends at once: whoever
   * writes one waits from now on.
   */
  VTKFILTERSINSIDEOUT_EXPORT void vtkInsideOutRemoveUnfinishedFiles();
}
