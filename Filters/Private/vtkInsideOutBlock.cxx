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

#include <optional>

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

std::optional<std::string> PathTo(vtkDataObject* block, vtkDataObject* data)
{
  if (data == block)
  {
    return std::string();
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return std::nullopt;
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
    if (const auto rest = PathTo(block, child->GetCurrentDataObject()))
    {
      vtkInformation* metaData =
        child->HasCurrentMetaData() ? child->GetCurrentMetaData() : nullptr;
      const std::string part = Part(metaData, index, numberOfChildren);
      return part + (part.empty() || rest->empty() ? "" : "/") + *rest;
    }
  }
  return std::nullopt;
}
} // namespace

void vtkInsideOutRememberBlocks(vtkInformation* input)
{
  vtkDataObject* data = input->Get(vtkDataObject::DATA_OBJECT());
  if (vtkDataObjectTree::SafeDownCast(data))
  {
    input->Set(Blocks(), data);
  }
  else if (!PathTo(data, input->Get(Blocks())))
  {
    input->Remove(Blocks());
  }
}

std::string vtkInsideOutBlock(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* input = algorithm->GetNumberOfInputConnections(port) > 0
      ? algorithm->GetExecutive()->GetInputInformation(port, 0)
      : nullptr;
    vtkDataObject* blocks = input ? input->Get(Blocks()) : nullptr;
    vtkDataObject* block = input ? input->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
    const auto path = PathTo(block, blocks);
    if (path && block != blocks)
    {
      return "block " + (path->empty() ? "0" : *path) + ": ";
    }
  }
  return "";
}
