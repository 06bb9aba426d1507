// SPDX-License-Identifier: GPL-3.0-or-later
/** @file An input that does not fit in memory, requested piece by piece. */
#pragma once

#include "Data/VtkClasses.h"

namespace vtkInsideOut
{
/**
 * A piece of an algorithm's only input at a port, which is let go when the next one is requested.
 *
 * @param piece 0, which VTK has requested before the algorithm began, to pieces - 1
 * @throws insideout::Error if the input's source makes no pieces, or fails, which it has reported
 */
vtkDataObject* PieceOfInput(vtkAlgorithm* algorithm, int port, int piece, int pieces);
} // namespace vtkInsideOut
