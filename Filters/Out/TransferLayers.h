// SPDX-License-Identifier: GPL-3.0-or-later
/** @file The parts that layers in space and in a plane have in common. */
#pragma once

#include "Data/Attributes.h"
#include "Out/MakeLayers.h"

#include <vtkCellArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace vtkInsideOut
{
/** Whether each tag of a boundary is of the wall: those named, or all if none is.
 * @throws insideout::Error that names a tag which is not there */
std::vector<bool> WallTags(
  const std::vector<std::string>& names, const std::vector<std::string>& tags);

/** Append cells of one type. */
template <std::size_t Size>
void AddCells(const std::vector<std::array<insideout::Id, Size>>& cells, int type,
  vtkCellArray* output, vtkUnsignedCharArray* types)
{
  for (const auto& cell : cells)
  {
    std::array<vtkIdType, Size> ids;
    std::copy(cell.begin(), cell.end(), ids.begin());
    output->InsertNextCell(static_cast<vtkIdType>(Size), ids.data());
    types->InsertNextValue(static_cast<unsigned char>(type));
  }
}

/** Transfer a grid's data to the grid with layers, which gets the cell array Layer.
 * @param[in] points, cells the origins of the result's points and cells */
void TransferLayers(vtkUnstructuredGrid* grid, const std::vector<Attributes::Mixture>& points,
  const std::vector<insideout::Id>& cells, const std::vector<insideout::Id>& layers,
  Layering& result);

/** Copy the data of chosen points or cells. */
void CopyChosen(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& chosen, vtkDataSetAttributes* to);

/** Warn of a wall that has not full height everywhere, by the statistics. */
void WarnOfHeights(Layering& result);
} // namespace vtkInsideOut
