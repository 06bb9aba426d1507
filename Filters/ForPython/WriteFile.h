// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Writes files from C, atomically: see Core's OutputFile.
 *
 * Errors go to the listener, with the file and the system's reason; a listener may stop the writing
 * until the file is in place. For Python, as vtkInsideOutUpdate is.
 */
#pragma once

#include "ForPython/UpdateAlgorithm.h"

#include <cstddef>

extern "C"
{
  /**
   * Write a data set in VTK's XML format for its type, in binary mode: VTK's default, appended
   * mode, cannot be read back by an expat with a certain security update. VTK's own writers crash
   * when a disk is full.
   *
   * @param data address of a vtkPolyData, vtkUnstructuredGrid or vtkImageData as a vtkObjectBase
   */
  VTKFILTERSINSIDEOUT_EXPORT void vtkInsideOutWriteData(
    void* data, const char* path, vtkInsideOutListener listener);

  /** Write bytes from memory. */
  VTKFILTERSINSIDEOUT_EXPORT void vtkInsideOutWriteBytes(
    const char* bytes, std::size_t length, const char* path, vtkInsideOutListener listener);

  /**
   * Remove all unfinished files of a process that is about to exit: calls that write one wait from
   * now on.
   */
  VTKFILTERSINSIDEOUT_EXPORT void vtkInsideOutRemoveUnfinishedFiles();
}
