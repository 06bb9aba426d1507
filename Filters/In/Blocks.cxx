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
#include <vtkSmartPointer.h>

namespace vtkInsideOut
{
namespace
{
/** Of an input: the composite data set whose blocks it becomes in turn. */
vtkInformationDataObjectKey* BlocksKey()
{
  static auto* const key = vtkInformationDataObjectKey::MakeKey("BLOCKS", "vtkInsideOut");
  return key;
}

/** One of two or more needs a number where it has no name. */
std::string Part(vtkInformation* metaData, unsigned int index, unsigned int numberOfChildren)
{
  const char* name = metaData ? metaData->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : numberOfChildren > 1 ? std::to_string(index) : std::string();
}

/** Visit what has no blocks of its own as (data, path). */
template <typename Visit>
void VisitLeaves(vtkDataObject* data, const std::string& path, const Visit& visit)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
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

/** The blocks, of which one is that with the data; none is where it is not among them. */
Blocks FindBlock(vtkDataObject* data, vtkDataObject* blocks)
{
  Blocks found;
  VisitLeaves(blocks, std::string(),
    [&](vtkDataObject* block, const std::string& path)
    {
      if (block == data)
      {
        found.Current = static_cast<int>(found.Names.size());
      }
      found.Names.push_back(path);
    });
  return found;
}

/** The blocks that an input of an algorithm has, and which of them it works on. */
Blocks BlocksOf(vtkAlgorithm* algorithm, int port)
{
  vtkInformation* input = algorithm->GetNumberOfInputConnections(port) > 0
    ? algorithm->GetExecutive()->GetInputInformation(port, 0)
    : nullptr;
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

std::vector<vtkDataObject*> BlocksFromHere(vtkAlgorithm* algorithm)
{
  vtkInformation* input = algorithm->GetExecutive()->GetInputInformation(0, 0);
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
