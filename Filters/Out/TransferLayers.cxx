// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/TransferLayers.h"

#include "Common/Error.h"
#include "Data/Arrays.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace vtkInsideOut
{
using namespace insideout;

std::vector<bool> WallTags(
  const std::vector<std::string>& names, const std::vector<std::string>& tags)
{
  std::vector<bool> isWall(names.size(), tags.empty());
  for (const std::string& tag : tags)
  {
    bool isThere = false;
    std::string all;
    for (std::size_t t = 0; t < names.size(); ++t)
    {
      all += (t > 0 ? ", " : "") + names[t];
      if (names[t] == tag)
      {
        isWall[t] = true;
        isThere = true;
      }
    }
    if (!isThere)
    {
      throw Error(ErrorCode::InvalidParameter,
        "LayerTags names " + tag + ", which is not a tag of the boundary; its tags are " + all);
    }
  }
  return isWall;
}

void TransferLayers(vtkUnstructuredGrid* grid, const std::vector<Attributes::Mixture>& points,
  const std::vector<Id>& cells, const std::vector<Id>& layers, Layering& result)
{
  Attributes::MixPointData(grid, points, {}, result.Grid->GetPointData(), result.Warnings);
  vtkCellData* cellData = result.Grid->GetCellData();
  Attributes::CopyCellData(grid, cells, cellData, result.Warnings);
  cellData->RemoveArray("FacetIds");
  cellData->RemoveArray("FacetMultiplicity");
  Attributes::RenameArrays(cellData, Attributes::AreMadeHere(grid), { "Layer" }, result.Warnings);
  cellData->AddArray(
    MakeArray<vtkIntArray>("Layer", std::vector<int>(layers.begin(), layers.end())));
  result.Grid->GetFieldData()->ShallowCopy(grid->GetFieldData());
}

void CopyChosen(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& chosen, vtkDataSetAttributes* to)
{
  const auto count = static_cast<vtkIdType>(chosen.size());
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    to->CopyData(from, chosen[i], i);
  }
}

void WarnOfHeights(Layering& result)
{
  std::ostringstream words;
  const auto valueOf = [&](const std::string& wanted)
  {
    const auto found = std::find_if(result.Statistics.begin(), result.Statistics.end(),
      [&](const auto& one) { return one.first == wanted; });
    return found->second;
  };
  const double share = valueOf("FullHeightShare");
  words << std::floor(1000 * share) / 10 << " % of the wall have layers of full height; "
        << std::setprecision(9) << valueOf("ReducedPoints") << " of its " << valueOf("WallPoints")
        << " points have lower ones, and " << valueOf("BarePoints") << " have none";
  if (valueOf("NarrowPoints") > 0)
  {
    words << "; at " << valueOf("NarrowPoints")
          << " points the solid is narrower than three times the layers";
  }
  if (valueOf("EndPoints") > 0)
  {
    words << "; at " << valueOf("EndPoints") << " points no direction leads inward";
  }
  if (share < 1)
  {
    result.Warnings.push_back(words.str());
  }
}
} // namespace vtkInsideOut
