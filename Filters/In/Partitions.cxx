// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/Partitions.h"

#include "Common/Error.h"
#include "In/Blocks.h"
#include "In/ReadSurface.h"

#include <vtkAppendFilter.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <map>
#include <vector>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;

namespace
{
struct Labelled
{
  std::string Label;
  vtkSmartPointer<vtkPolyData> Surface;
};

/** The only one as it is. */
vtkSmartPointer<vtkPolyData> Append(const std::vector<Labelled>& surfaces)
{
  if (surfaces.size() == 1)
  {
    return surfaces.front().Surface;
  }
  vtkNew<vtkAppendPolyData> append;
  for (const auto& [label, surface] : surfaces)
  {
    CheckPolygons(surface, label);
    vtkNew<vtkPolyData> own;
    own->ShallowCopy(surface);
    own->RemoveGhostCells();
    append->AddInputData(own);
  }
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  return append->GetOutput();
}

/** The non-empty partitions of a block in order, or else the first; none if one has another type.
 */
template <typename Data>
std::map<std::size_t, Data*> FilledPartitions(vtkDataObject* block)
{
  std::map<std::size_t, Data*> filled;
  const std::vector<vtkDataObject*> partitions = PartitionsOf(block);
  for (std::size_t p = 0; p < partitions.size(); ++p)
  {
    Data* data = Data::SafeDownCast(partitions[p]);
    if (!data)
    {
      return {};
    }
    if (data->GetNumberOfPoints() > 0)
    {
      filled[p] = data;
    }
  }
  if (filled.empty() && !partitions.empty())
  {
    filled[0] = Data::SafeDownCast(partitions.front());
  }
  return filled;
}

Error NotOfType(vtkDataObject* block, const char* type, const std::string& label)
{
  for (vtkDataObject* partition : PartitionsOf(block))
  {
    if (!partition->IsA(type))
    {
      block = partition;
    }
  }
  return { ErrorCode::InvalidParameter,
    label + "the input is a " + block->GetClassName() + ", not a " + type };
}
} // namespace

vtkSmartPointer<vtkPolyData> JoinPartitions(vtkDataObject* block, const std::string& label)
{
  std::vector<Labelled> partitions;
  for (const auto& [number, partition] : FilledPartitions<vtkPolyData>(block))
  {
    partitions.push_back({ label + "partition " + std::to_string(number) + ": ", partition });
  }
  return partitions.empty() ? nullptr : Append(partitions);
}

vtkSmartPointer<vtkPolyData> SurfaceOfBlock(vtkDataObject* block, const std::string& label)
{
  auto surface = JoinPartitions(block, label);
  if (!surface)
  {
    throw NotOfType(block, "vtkPolyData", label);
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> InputSurface(vtkAlgorithm* algorithm)
{
  return SurfaceOfBlock(CurrentBlock(algorithm));
}

vtkSmartPointer<vtkUnstructuredGrid> InputGrid(vtkAlgorithm* algorithm)
{
  vtkDataObject* block = CurrentBlock(algorithm);
  const std::map<std::size_t, vtkUnstructuredGrid*> grids =
    FilledPartitions<vtkUnstructuredGrid>(block);
  if (grids.empty())
  {
    throw NotOfType(block, "vtkUnstructuredGrid", "");
  }
  if (grids.size() == 1)
  {
    return grids.begin()->second;
  }
  vtkNew<vtkAppendFilter> append;
  for (const auto& [number, grid] : grids)
  {
    vtkNew<vtkUnstructuredGrid> own;
    own->ShallowCopy(grid);
    own->RemoveGhostCells();
    append->AddInputData(own);
  }
  append->MergePointsOn();
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkPolyData> JoinSurfaces(vtkDataObject* blocks)
{
  std::vector<Labelled> surfaces;
  VisitBlocks(blocks,
    [&](vtkDataObject* block, const std::string& name)
    {
      const bool isAlone = block == blocks;
      const std::string number = std::to_string(surfaces.size());
      const std::string label =
        isAlone ? std::string() : "block " + (name.empty() ? number : name) + ": ";
      surfaces.push_back({ label, SurfaceOfBlock(block, label) });
    });
  if (surfaces.empty())
  {
    throw Error(ErrorCode::EmptySurface, "the surface is empty: it has no blocks");
  }
  return Append(surfaces);
}

vtkSmartPointer<vtkDataSet> JoinDataSets(vtkDataObject* blocks, const std::string& array)
{
  if (auto* alone = vtkDataSet::SafeDownCast(blocks))
  {
    return alone;
  }
  vtkNew<vtkAppendFilter> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  bool isThere = false;
  std::string without; // the first block without the array
  int number = 0;
  const auto add = [&](vtkDataObject* block, const std::string& name)
  {
    const std::string called = name.empty() ? std::to_string(number) : name;
    ++number;
    for (vtkDataObject* partition : PartitionsOf(block))
    {
      auto* data = vtkDataSet::SafeDownCast(partition);
      if (data && data->GetNumberOfPoints() > 0)
      {
        const auto own = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
        own->ShallowCopy(data);
        if (auto* grid = vtkUnstructuredGrid::SafeDownCast(own))
        {
          grid->RemoveGhostCells();
        }
        append->AddInputData(own);
        const bool hasArray = data->GetPointData()->HasArray(array.c_str()) ||
          data->GetCellData()->HasArray(array.c_str());
        isThere = isThere || hasArray;
        without = hasArray || !without.empty() ? without : called;
      }
    }
  };
  if (blocks)
  {
    VisitBlocks(blocks, add);
  }
  if (isThere && !without.empty())
  {
    throw Error(ErrorCode::InvalidParameter,
      "block " + without + " has no array " + array + ", which other blocks have");
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  append->Update();
  return append->GetOutput();
}
} // namespace vtkInsideOut
