// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/NameSizes.h"

#include "Common/RuleText.h"
#include "Data/FieldNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
using Kind = SizeRule::Kind;

/** The number of a name among others. */
Id NumberAmong(const SizeRule& rule, const std::vector<std::string>& names, const char* what)
{
  const auto found = std::find(names.begin(), names.end(), rule.Name);
  if (found == names.end())
  {
    std::string all;
    for (const std::string& name : names)
    {
      all += (all.empty() ? "" : ", ") + name;
    }
    RefuseRule(rule.Text, std::string("names no ") + what + "; these are " + all);
  }
  return static_cast<Id>(found - names.begin());
}

/** The names of regions, by number: "0" where they have none. */
std::vector<std::string> NamesOfRegions(vtkUnstructuredGrid* grid, vtkDataArray* regions)
{
  std::vector<std::string> names = NamesByNumber(grid->GetFieldData(), "RegionNames");
  const double last = regions ? std::max(0.0, regions->GetRange(0)[1]) : 0;
  for (auto region = static_cast<Id>(names.size()); region <= last; ++region)
  {
    names.push_back(std::to_string(region));
  }
  return names;
}

void SetRegion(const SizeRule& rule, vtkUnstructuredGrid* grid, std::vector<double>& lengths)
{
  vtkDataArray* regions = grid->GetCellData()->GetArray("RegionId");
  const std::vector<std::string> names = NamesOfRegions(grid, regions);
  const bool isNumber = !rule.Name.empty() &&
    std::all_of(rule.Name.begin(), rule.Name.end(), [](char c) { return c >= '0' && c <= '9'; });
  const bool isNamed = std::find(names.begin(), names.end(), rule.Name) != names.end();
  SizeRule numbered = rule;
  if (isNumber && !isNamed && rule.Name.size() < 10 && std::stoul(rule.Name) < names.size())
  {
    numbered.Name = names[std::stoul(rule.Name)];
  }
  const Id region = NumberAmong(numbered, names, "region");
  lengths.resize(
    static_cast<std::size_t>(grid->GetNumberOfCells()), std::numeric_limits<double>::infinity());
  for (std::size_t c = 0; c < lengths.size(); ++c)
  {
    const double here = regions ? regions->GetComponent(static_cast<vtkIdType>(c), 0) : 0;
    lengths[c] = here == region ? std::min(lengths[c], rule.Value) : lengths[c];
  }
}
} // namespace

bool SizesNameTags(const std::vector<SizeRule>& rules)
{
  return std::any_of(
    rules.begin(), rules.end(), [](const SizeRule& rule) { return rule.What == Kind::Tag; });
}

void NameSizes(vtkUnstructuredGrid* grid, vtkPolyData* boundary, SizingParameters& sizes)
{
  for (SizeRule& rule : sizes.Rules)
  {
    if (rule.What == Kind::Tag && !boundary)
    {
      RefuseRule(rule.Text,
        "names a tag, and there is no boundary with tags: vtkRobustTetrahedralize makes one");
    }
    if (rule.What == Kind::Tag)
    {
      rule.Label =
        NumberAmong(rule, NamesByNumber(boundary->GetFieldData(), "BoundaryTagNames"), "tag");
    }
    if (rule.What == Kind::Region)
    {
      SetRegion(rule, grid, sizes.LengthOfCell);
    }
  }
}
} // namespace vtkInsideOut
