// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * @file
 * What filters share that need all of their input in one place.
 *
 * A surface means one solid. Among several processes (MPI) the first asks for the whole and makes
 * the one result. The others ask for nothing and have none; a solid of each piece would be wrong.
 */
#pragma once

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

namespace vtkInsideOut
{
/**
 * Say of an output whether each of its blocks is whole in one process: filters that follow, and
 * those that follow them, then work on the blocks that their own process has, and each is a surface
 * of its own.
 */
void SayWhetherPartsAreWhole(vtkInformation* output, bool areWhole);

/**
 * For what takes all blocks of its inputs on the first port together.
 *
 * @throws insideout::Error InvalidParameter where they are whole in one process each
 */
void RefuseSpreadParts(vtkAlgorithm* algorithm);

/** Ask all inputs for the whole where the first piece of the output is wanted, else for nothing. */
void RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, int numberOfPorts = 1);

/** Whether a piece other than the first is wanted of an output. */
bool IsFurtherPiece(vtkInformationVector* outputVector);

/** Whether an algorithm has nothing to do: the first process does it all, or the block that it is
 * shown a partition of was done with the first of these. */
bool IsIdle(vtkAlgorithm* algorithm, vtkInformationVector* outputVector);
} // namespace vtkInsideOut
