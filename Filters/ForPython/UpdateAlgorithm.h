// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Updates an algorithm from C, with a C function as its observer.
 *
 * VTK's Python wrapping holds the interpreter's lock while an algorithm runs, so that no other
 * thread runs and Ctrl-C is delayed. Python's ctypes releases the lock while it calls this
 * function, and takes it again for the listener.
 */
#pragma once

#include "vtkFiltersInsideOutModule.h" // for export macro

extern "C"
{
  /** The kinds of messages to a listener. */
  enum vtkInsideOutEvent
  {
    VTK_INSIDEOUT_PROGRESS = 0,       ///< text: the stage; fraction: total progress
    VTK_INSIDEOUT_WARNING = 1,        ///< text: VTK's message
    VTK_INSIDEOUT_ERROR = 2,          ///< the same
    VTK_INSIDEOUT_REQUEST_FAILED = 3, ///< the same, from the algorithm's executive
  };

  /** @return 0 to continue; anything else stops the algorithm */
  typedef int (*vtkInsideOutListener)(int event, const char* text, double fraction);

  /**
   * Update an algorithm. It must not have observers written in Python: VTK calls these without the
   * interpreter's lock.
   *
   * @param algorithm address of a vtkAlgorithm as a vtkObjectBase
   * @param wholeExtent 0, or 1 to update all of its input's extent, which is how writers write
   * @return 1, or 0 after an error
   */
  VTKFILTERSINSIDEOUT_EXPORT int vtkInsideOutUpdate(
    void* algorithm, int wholeExtent, vtkInsideOutListener listener);
}
