// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutBlock.h"

#include <vtkAlgorithm.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationDataObjectKey.h>
#include <vtkSmartPointer.h>

namespace
{
/** Of an input: the composite data set whose blocks it becomes in turn. */
vtkInformationDataObjectKey* Blocks()
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
vtkInsideOutBlocks FindBlock(vtkDataObject* data, vtkDataObject* blocks)
{
  vtkInsideOutBlocks found;
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
vtkInsideOutBlocks BlocksOf(vtkAlgorithm* algorithm, int port)
{
  vtkInformation* input = algorithm->GetNumberOfInputConnections(port) > 0
    ? algorithm->GetExecutive()->GetInputInformation(port, 0)
    : nullptr;
  vtkDataObject* blocks = input ? input->Get(Blocks()) : nullptr;
  vtkDataObject* block = input ? input->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
  return blocks && block ? FindBlock(block, blocks) : vtkInsideOutBlocks();
}
} // namespace

void vtkInsideOutRememberBlocks(vtkInformation* input)
{
  vtkDataObject* data = input->Get(vtkDataObject::DATA_OBJECT());
  if (vtkDataObjectTree::SafeDownCast(data))
  {
    input->Set(Blocks(), data);
  }
  else if (vtkDataObject* blocks = input->Get(Blocks());
           blocks && !FindBlock(data, blocks).AreThere())
  {
    input->Remove(Blocks());
  }
}

bool vtkInsideOutHasBlocks(vtkInformation* input)
{
  return input->Has(Blocks()) != 0;
}

std::string vtkInsideOutBlock(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    const vtkInsideOutBlocks blocks = BlocksOf(algorithm, port);
    if (blocks.AreThere())
    {
      const std::string& name = blocks.Names[blocks.Current];
      return "block " + (name.empty() ? "0" : name) + ": ";
    }
  }
  return "";
}

vtkInsideOutBlocks vtkInsideOutFindBlocks(vtkAlgorithm* algorithm)
{
  const vtkInsideOutBlocks blocks = BlocksOf(algorithm, 0);
  return blocks.AreThere() ? blocks : vtkInsideOutBlocks();
}

std::vector<vtkDataObject*> vtkInsideOutBlocksFromHere(vtkAlgorithm* algorithm)
{
  vtkInformation* input = algorithm->GetExecutive()->GetInputInformation(0, 0);
  const int current = vtkInsideOutFindBlocks(algorithm).Current;
  std::vector<vtkDataObject*> blocks;
  if (current >= 0)
  {
    VisitLeaves(input->Get(Blocks()), std::string(),
      [&](vtkDataObject* block, const std::string&) { blocks.push_back(block); });
    blocks.erase(blocks.begin(), blocks.begin() + current);
  }
  return blocks;
}

void vtkInsideOutVisitBlocks(
  vtkDataObject* data, const std::function<void(vtkDataObject*, const std::string&)>& visit)
{
  VisitLeaves(data, std::string(), visit);
}
