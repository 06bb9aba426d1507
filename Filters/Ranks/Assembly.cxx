// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ranks/Assembly.h"

#include "In/Blocks.h"
#include "In/Tags.h"

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkCommunicator.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataObjectTypes.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiProcessController.h>
#include <vtkMultiProcessStream.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <set>

namespace vtkInsideOut
{
namespace
{
/** Whether it has parts, and is not a partitioned part. */
bool IsAssembly(vtkDataObject* data)
{
  return vtkDataObjectTree::SafeDownCast(data) && !vtkPartitionedDataSet::SafeDownCast(data);
}

vtkSmartPointer<vtkDataObjectTreeIterator> ChildrenOf(vtkDataObjectTree* tree)
{
  auto child = vtk::TakeSmartPointer(tree->NewTreeIterator());
  child->TraverseSubTreeOff();
  child->VisitOnlyLeavesOff();
  child->SkipEmptyNodesOff();
  return child;
}

/** Visit the positions of parts as (tree, iterator). */
template <typename Visit>
void VisitParts(vtkDataObjectTree* tree, const Visit& visit)
{
  const auto child = ChildrenOf(tree);
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem())
  {
    vtkDataObject* data = child->GetCurrentDataObject();
    IsAssembly(data) ? VisitParts(vtkDataObjectTree::SafeDownCast(data), visit)
                     : visit(tree, child.Get());
  }
}

/** Types and names of a tree's nodes, down to the parts. */
void Describe(vtkDataObjectTree* tree, vtkMultiProcessStream& words)
{
  const auto child = ChildrenOf(tree);
  int children = 0;
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem())
  {
    ++children;
  }
  words << children;
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem())
  {
    vtkDataObject* data = child->GetCurrentDataObject();
    const char* name = child->HasCurrentMetaData()
      ? child->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
      : nullptr;
    const bool isTree = vtkDataObjectTree::SafeDownCast(data) != nullptr;
    words << (isTree ? data->GetDataObjectType() : -1) << static_cast<int>(name != nullptr)
          << std::string(name ? name : "");
    if (IsAssembly(data))
    {
      Describe(vtkDataObjectTree::SafeDownCast(data), words);
    }
  }
}

/** Put data at a position of a tree, with a name. */
void SetChild(vtkDataObjectTree* tree, unsigned int place, vtkDataObject* data, const char* name)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(tree);
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree);
  if (blocks)
  {
    blocks->SetBlock(place, data);
  }
  else if (collection)
  {
    collection->SetPartitionedDataSet(place, vtkPartitionedDataSet::SafeDownCast(data));
  }
  if (name && blocks)
  {
    blocks->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), name);
  }
  else if (name && collection)
  {
    collection->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), name);
  }
}

void Build(vtkMultiProcessStream& words, vtkDataObjectTree* tree)
{
  int children;
  words >> children;
  for (int place = 0; place < children; ++place)
  {
    int type;
    int hasName;
    std::string name;
    words >> type >> hasName >> name;
    const auto data = type >= 0 ? vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(type))
                                : vtkSmartPointer<vtkDataObject>();
    SetChild(tree, place, data, hasName ? name.c_str() : nullptr);
    if (IsAssembly(data))
    {
      Build(words, vtkDataObjectTree::SafeDownCast(data));
    }
  }
}

/** Warn of the arrays of an MPI piece that the whole lacks. */
void WarnOfLost(vtkFieldData* piece, vtkFieldData* whole, std::set<std::string>& warnings)
{
  for (int i = 0; i < piece->GetNumberOfArrays(); ++i)
  {
    const char* name = piece->GetArrayName(i);
    if (name && !whole->HasArray(name))
    {
      warnings.insert(std::string("the array ") + name +
        " is left out of a part: some of its pieces lack it, or have it in another type");
    }
  }
}

vtkSmartPointer<vtkPolyData> Join(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, std::set<std::string>& warnings)
{
  if (pieces.size() < 2)
  {
    return pieces.empty() ? nullptr : pieces.front();
  }
  ShareNames(pieces);
  vtkNew<vtkAppendPolyData> all;
  for (vtkPolyData* piece : pieces)
  {
    all->AddInputData(piece);
  }
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  all->Update();
  vtkPolyData* whole = all->GetOutput();
  for (vtkPolyData* piece : pieces)
  {
    WarnOfLost(piece->GetPointData(), whole->GetPointData(), warnings);
    WarnOfLost(piece->GetCellData(), whole->GetCellData(), warnings);
    WarnOfLost(piece->GetFieldData(), whole->GetFieldData(), warnings);
  }
  return whole;
}
} // namespace

Assembly::Assembly(vtkDataObjectTree* assembly)
{
  this->Structure = vtk::TakeSmartPointer(vtkDataObjectTree::SafeDownCast(assembly->NewInstance()));
  this->Structure->CopyStructure(assembly);
  VisitParts(assembly,
    [this](vtkDataObjectTree*, vtkDataObjectTreeIterator* place)
    {
      this->Pieces.emplace_back();
      for (vtkDataObject* piece : PartitionsOf(place->GetCurrentDataObject()))
      {
        if (!vtkPolyData::SafeDownCast(piece))
        {
          ++this->Others;
          continue;
        }
        auto own = vtkSmartPointer<vtkPolyData>::New();
        own->ShallowCopy(piece);
        own->RemoveGhostCells();
        if (own->GetNumberOfCells() > 0)
        {
          this->Pieces.back().push_back(own);
        }
      }
    });
}

std::string Agree(Assembly& parts, vtkDataObjectTree* output, vtkMultiProcessController* controller)
{
  const auto own = static_cast<vtkIdType>(parts.Pieces.size());
  std::vector<vtkIdType> all(controller->GetNumberOfProcesses());
  controller->AllGather(&own, all.data(), 1);
  const auto most = std::max_element(all.begin(), all.end());
  const auto first = static_cast<int>(most - all.begin());
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    if (all[rank] != 0 && all[rank] != *most)
    {
      return "process " + std::to_string(rank) + " has " + std::to_string(all[rank]) +
        " parts where process " + std::to_string(first) + " has " + std::to_string(*most);
    }
  }
  vtkMultiProcessStream words;
  if (controller->GetLocalProcessId() == first)
  {
    Describe(parts.Structure, words);
  }
  controller->Broadcast(words, first);
  if (own == 0 && *most > 0)
  {
    output->Initialize();
    Build(words, output);
    parts.Pieces.resize(*most);
  }
  else
  {
    output->CopyStructure(parts.Structure);
  }
  return "";
}

std::vector<vtkIdType> CountCells(const Assembly& parts, vtkMultiProcessController* controller)
{
  std::vector<vtkIdType> own(parts.Pieces.size(), 0);
  for (std::size_t part = 0; part < own.size(); ++part)
  {
    for (vtkPolyData* piece : parts.Pieces[part])
    {
      own[part] += piece->GetNumberOfCells();
    }
  }
  std::vector<vtkIdType> all(own.size());
  controller->AllReduce(
    own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
  return all;
}

std::vector<vtkSmartPointer<vtkPolyData>> MoveParts(const Assembly& parts,
  const std::vector<int>& owners, vtkMultiProcessController* controller,
  std::vector<std::string>& warnings)
{
  std::set<std::string> lost;
  const int self = controller->GetLocalProcessId();
  std::vector<vtkSmartPointer<vtkPolyData>> moved(owners.size());
  for (int rank = 0; rank < controller->GetNumberOfProcesses(); ++rank)
  {
    // All data for one rank are one message: one block for each of its parts. Its own parts are not
    // sent.
    std::vector<std::size_t> ids;
    vtkNew<vtkMultiBlockDataSet> message;
    for (std::size_t part = 0; part < owners.size(); ++part)
    {
      if (owners[part] == rank)
      {
        message->SetBlock(static_cast<unsigned int>(ids.size()),
          rank == self ? nullptr : Join(parts.Pieces[part], lost).Get());
        ids.push_back(part);
      }
    }
    std::vector<vtkSmartPointer<vtkDataObject>> messages;
    controller->Gather(message, messages, rank);
    for (std::size_t i = 0; rank == self && i < ids.size(); ++i)
    {
      std::vector<vtkSmartPointer<vtkPolyData>> pieces;
      for (int sender = 0; sender < static_cast<int>(messages.size()); ++sender)
      {
        auto* blocks = vtkMultiBlockDataSet::SafeDownCast(messages[sender]);
        const vtkSmartPointer<vtkPolyData> piece = sender == self
          ? Join(parts.Pieces[ids[i]], lost)
          : vtkSmartPointer<vtkPolyData>(
              vtkPolyData::SafeDownCast(blocks->GetBlock(static_cast<unsigned int>(i))));
        if (piece)
        {
          pieces.push_back(piece);
        }
      }
      moved[ids[i]] = Join(pieces, lost);
    }
  }
  warnings.insert(warnings.end(), lost.begin(), lost.end());
  return moved;
}

void SetParts(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, vtkDataObjectTree* assembly)
{
  std::size_t part = 0;
  VisitParts(assembly,
    [&](vtkDataObjectTree* tree, vtkDataObjectTreeIterator* place)
    {
      vtkPolyData* data = parts[part++];
      if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(place->GetCurrentDataObject()))
      {
        pieces->SetNumberOfPartitions(data ? 1 : 0);
        if (data)
        {
          pieces->SetPartition(0, data);
        }
      }
      else
      {
        tree->SetDataSet(place, data);
      }
    });
}
} // namespace vtkInsideOut
