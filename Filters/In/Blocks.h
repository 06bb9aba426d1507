// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Each block of a composite data set is a separate surface: VTK runs a filter once for each,
 * and passes only the block. Messages about a point have to name its block, too.
 *
 * A partitioned data set (vtkPartitionedDataSet, vtkMultiPieceDataSet) is one block. VTK runs a
 * filter once for each of its partitions: the run for the first handles all.
 */
#pragma once

#include "Data/VtkClasses.h"

#include <vtkType.h>

#include <functional>
#include <string>
#include <vector>

namespace vtkInsideOut
{
/** Call when an input's extent is requested, before VTK splits it into blocks. */
void RememberBlocks(vtkInformation* input);

/** Whether an input, whose extent is or was requested, is composite. */
bool HasBlocks(vtkInformation* input);

/**
 * "block NAME: " for the block that an algorithm works on; empty if no input is composite. NAME is
 * the path of names of blocks (numbers from 0 for unnamed ones), separated by slashes.
 */
std::string Block(vtkAlgorithm* algorithm);

/** The blocks of a composite data set by these names, with the current one. */
struct Blocks
{
  std::vector<std::string> Names;
  int Current = -1;

  bool AreThere() const { return this->Current >= 0; }
};

/** The blocks of an algorithm's first input; none if it is not composite. */
Blocks FindBlocks(vtkAlgorithm* algorithm);

/** The current block of an algorithm and the blocks after it; none if its first input is not
 * composite. */
std::vector<vtkDataObject*> BlocksFromHere(vtkAlgorithm* algorithm);

/** The existing partitions of a partitioned data set; other data are their only partition. */
std::vector<vtkDataObject*> PartitionsOf(vtkDataObject* block);

/** The last modification time of a data set with its blocks and partitions. */
vtkMTimeType LastChange(vtkDataObject* data);

/** The block that an algorithm works on: the partitioned data set if it gets a partition, else its
 * input. */
vtkDataObject* CurrentBlock(vtkAlgorithm* algorithm, int port = 0);

/** Whether an algorithm's first input is a partition other than the first of its block. */
bool IsFurtherPartition(vtkAlgorithm* algorithm);

/** Visit the leaf blocks of a composite data set as (data, name); a data set that is not composite
 * is the only one, without a name. */
void VisitBlocks(
  vtkDataObject* data, const std::function<void(vtkDataObject*, const std::string&)>& visit);
} // namespace vtkInsideOut
