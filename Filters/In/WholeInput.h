// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * @file For filters that need all of their input in one process.
 *
 * A surface is one solid. Among several processes (MPI) the first requests the whole surface and
 * makes the result. The others request nothing and have an empty result; one solid per MPI piece
 * would be wrong.
 */
#pragma once

#include "Data/VtkClasses.h"

namespace vtkInsideOut
{
/**
 * Mark an output whose blocks are each whole in one process: downstream filters then work on the
 * blocks of their own process, each a separate surface.
 */
void SayWhetherPartsAreWhole(vtkInformation* output, bool areWhole);

/**
 * For filters that combine all blocks of their inputs on the first port.
 *
 * @throws insideout::Error InvalidParameter if these are distributed over processes
 */
void RefuseSpreadParts(vtkAlgorithm* algorithm);

/** Request all of the inputs if the first piece of the output is requested, else nothing. */
void RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, int numberOfPorts = 1);

/** Whether a piece other than the first is requested of an output. */
bool IsFurtherPiece(vtkInformationVector* outputVector);

/** Whether an algorithm has nothing to do: the first process does all, or the block of the present
 * partition was done with the first partition. */
bool IsIdle(vtkAlgorithm* algorithm, vtkInformationVector* outputVector);
} // namespace vtkInsideOut
