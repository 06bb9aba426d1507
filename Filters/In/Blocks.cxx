// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/Blocks.h"

#include <vtkAlgorithm.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationDataObjectKey.h>
#include <vtkPartitionedDataSet.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace vtkInsideOut
{
namespace
{
/** Key in an input's information: the composite data set whose blocks replace it in turn. */
vtkInformationDataObjectKey* BlocksKey()
{
  static auto* const key = vtkInformationDataObjectKey::MakeKey("BLOCKS", "vtkInsideOut");
  return key;
}

/** An unnamed block needs a number if there are two or more. */
std::string Part(vtkInformation* metaData, unsigned int index, unsigned int numberOfChildren)
{
  const char* name = metaData ? metaData->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : numberOfChildren > 1 ? std::to_string(index) : std::string();
}

bool IsPartition(vtkDataObject* data, vtkDataObject* block)
{
  const std::vector<vtkDataObject*> partitions = PartitionsOf(block);
  return std::find(partitions.begin(), partitions.end(), data) != partitions.end();
}

/** Visit the leaves as (data, path). */
template <typename Visit>
void VisitLeaves(vtkDataObject* data, const std::string& path, const Visit& visit)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree || vtkPartitionedDataSet::SafeDownCast(data))
  {
    visit(data, path);
    return;
  }
  auto child = vtk::TakeSmartPointer(tree->NewTreeIterator());
  child->TraverseSubTreeOff();
  child->VisitOnlyLeavesOff();
  child->SkipEmptyNodesOff();
  unsigned int numberOfChildren = 0;
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem())
  {
    ++numberOfChildren;
  }
  unsigned int index = 0;
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem(), ++index)
  {
    if (vtkDataObject* block = child->GetCurrentDataObject())
    {
      vtkInformation* metaData =
        child->HasCurrentMetaData() ? child->GetCurrentMetaData() : nullptr;
      const std::string part = Part(metaData, index, numberOfChildren);
      VisitLeaves(block, path + (part.empty() || path.empty() ? "" : "/") + part, visit);
    }
  }
}

/**
 * The blocks, with the one that is or contains the data as the current one; none if it is not among
 * them.
 */
Blocks FindBlock(vtkDataObject* data, vtkDataObject* blocks)
{
  Blocks found;
  VisitLeaves(blocks, std::string(),
    [&](vtkDataObject* block, const std::string& path)
    {
      if (IsPartition(data, block))
      {
        found.Current = static_cast<int>(found.Names.size());
      }
      found.Names.push_back(path);
    });
  return found;
}

/** The first input of a port, or null. */
vtkInformation* InputOf(vtkAlgorithm* algorithm, int port)
{
  return algorithm->GetNumberOfInputPorts() > port &&
      algorithm->GetNumberOfInputConnections(port) > 0
    ? algorithm->GetExecutive()->GetInputInformation(port, 0)
    : nullptr;
}

/** The blocks of an algorithm's input, with the current one. */
Blocks BlocksOf(vtkAlgorithm* algorithm, int port)
{
  vtkInformation* input = InputOf(algorithm, port);
  vtkDataObject* blocks = input ? input->Get(BlocksKey()) : nullptr;
  vtkDataObject* block = input ? input->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
  return blocks && block ? FindBlock(block, blocks) : Blocks();
}
} // namespace

void RememberBlocks(vtkInformation* input)
{
  vtkDataObject* data = input->Get(vtkDataObject::DATA_OBJECT());
  if (vtkDataObjectTree::SafeDownCast(data))
  {
    input->Set(BlocksKey(), data);
  }
  else if (vtkDataObject* blocks = input->Get(BlocksKey());
           blocks && !FindBlock(data, blocks).AreThere())
  {
    input->Remove(BlocksKey());
  }
}

bool HasBlocks(vtkInformation* input)
{
  return input->Has(BlocksKey()) != 0;
}

std::string Block(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    const Blocks blocks = BlocksOf(algorithm, port);
    if (blocks.AreThere())
    {
      const std::string& name = blocks.Names[blocks.Current];
      return "block " + (name.empty() ? "0" : name) + ": ";
    }
  }
  return "";
}

Blocks FindBlocks(vtkAlgorithm* algorithm)
{
  const Blocks blocks = BlocksOf(algorithm, 0);
  return blocks.AreThere() ? blocks : Blocks();
}

std::vector<vtkDataObject*> PartitionsOf(vtkDataObject* block)
{
  std::vector<vtkDataObject*> partitions = { block };
  if (auto* partitioned = vtkPartitionedDataSet::SafeDownCast(block))
  {
    partitions.clear();
    for (unsigned int p = 0; p < partitioned->GetNumberOfPartitions(); ++p)
    {
      partitions.push_back(partitioned->GetPartitionAsDataObject(p));
    }
  }
  partitions.erase(std::remove(partitions.begin(), partitions.end(), nullptr), partitions.end());
  return partitions;
}

vtkMTimeType LastChange(vtkDataObject* data)
{
  vtkMTimeType last = data->GetMTime();
  VisitLeaves(data, std::string(),
    [&](vtkDataObject* block, const std::string&)
    {
      last = std::max(last, block->GetMTime());
      for (vtkDataObject* partition : PartitionsOf(block))
      {
        last = std::max(last, partition->GetMTime());
      }
    });
  return last;
}

vtkDataObject* CurrentBlock(vtkAlgorithm* algorithm, int port)
{
  vtkInformation* input = InputOf(algorithm, port);
  vtkDataObject* data = input ? input->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
  vtkDataObject* current = data;
  if (vtkDataObject* blocks = input ? input->Get(BlocksKey()) : nullptr)
  {
    VisitLeaves(blocks, std::string(),
      [&](vtkDataObject* block, const std::string&)
      { current = IsPartition(data, block) ? block : current; });
  }
  return current;
}

bool IsFurtherPartition(vtkAlgorithm* algorithm)
{
  vtkInformation* input = InputOf(algorithm, 0);
  vtkDataObject* data = input ? input->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
  vtkDataObject* block = CurrentBlock(algorithm);
  return block != data && PartitionsOf(block).front() != data;
}

std::vector<vtkDataObject*> BlocksFromHere(vtkAlgorithm* algorithm)
{
  vtkInformation* input = InputOf(algorithm, 0);
  const int current = FindBlocks(algorithm).Current;
  std::vector<vtkDataObject*> blocks;
  if (current >= 0)
  {
    VisitLeaves(input->Get(BlocksKey()), std::string(),
      [&](vtkDataObject* block, const std::string&) { blocks.push_back(block); });
    blocks.erase(blocks.begin(), blocks.begin() + current);
  }
  return blocks;
}

void VisitBlocks(
  vtkDataObject* data, const std::function<void(vtkDataObject*, const std::string&)>& visit)
{
  VisitLeaves(data, std::string(), visit);
}
} // namespace vtkInsideOut
