// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Each block of a composite data set is a surface of its own: VTK runs a filter once for each, and
 * shows it nothing but the block. A message about point 3 has to name its block, too.
 *
 * A partitioned data set (vtkPartitionedDataSet, vtkMultiPieceDataSet) is one block. VTK runs a
 * filter once for each of its partitions: the first stands for all, and the others are done then.
 */
#pragma once

#include <vtkType.h>

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;

namespace vtkInsideOut
{
/** Call when an input's extent is requested: VTK has not taken it to blocks yet. */
void RememberBlocks(vtkInformation* input);

/** Whether an input whose extent is or was requested is composite. */
bool HasBlocks(vtkInformation* input);

/**
 * "block NAME: " of the block that an algorithm works on, or nothing where no input is composite.
 * NAME is what leads to it: the names of blocks, or numbers from 0 where they have none, parted by
 * slashes.
 */
std::string Block(vtkAlgorithm* algorithm);

/** The blocks of a composite data set by the same names, and which of them is worked on. */
struct Blocks
{
  std::vector<std::string> Names;
  int Current = -1;

  bool AreThere() const { return this->Current >= 0; }
};

/** Those of an algorithm's first input; none where it is not composite. */
Blocks FindBlocks(vtkAlgorithm* algorithm);

/** The block that an algorithm works on and those that it will come to; none where its first input
 * is not composite. */
std::vector<vtkDataObject*> BlocksFromHere(vtkAlgorithm* algorithm);

/** The partitions of a partitioned data set that are there; other data are their only one. */
std::vector<vtkDataObject*> PartitionsOf(vtkDataObject* block);

/** When a data set, or the last of its blocks and partitions, was modified. */
vtkMTimeType LastChange(vtkDataObject* data);

/** The block that an algorithm works on: the partitioned data set where it is shown a partition,
 * else its input. */
vtkDataObject* CurrentBlock(vtkAlgorithm* algorithm, int port = 0);

/** Whether an algorithm's first input is a partition other than the first of its block. */
bool IsFurtherPartition(vtkAlgorithm* algorithm);

/** Visit the blocks of a composite data set that have no blocks of their own, as (data, name); what
 * is not composite is the only one, and has no name. */
void VisitBlocks(
  vtkDataObject* data, const std::function<void(vtkDataObject*, const std::string&)>& visit);
} // namespace vtkInsideOut
