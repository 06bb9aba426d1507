// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/TagByRules.h"

#include "Data/Arrays.h"
#include "In/Tags.h"

#include "Common/Error.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <map>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
TaggedSurface SurfaceOf(vtkPolyData* boundary)
{
  TaggedSurface surface;
  surface.Points.resize(static_cast<std::size_t>(boundary->GetNumberOfPoints()));
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    boundary->GetPoint(static_cast<vtkIdType>(p), surface.Points[p].data());
  }
  vtkDataArray* sources = boundary->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < boundary->GetNumberOfCells(); ++cell)
  {
    boundary->GetCellPoints(cell, corners);
    surface.Triangles.push_back({ { static_cast<Id>(corners->GetId(0)),
      static_cast<Id>(corners->GetId(1)), static_cast<Id>(corners->GetId(2)) } });
    surface.Sources.push_back(static_cast<Id>(sources->GetComponent(cell, 0)));
  }
  surface.IsIn = [boundary, sources](const std::string& array, Id triangle)
  {
    return sources->GetComponent(triangle, 0) >= 0 &&
      boundary->GetCellData()->GetArray(array.c_str())->GetComponent(triangle, 0) != 0;
  };
  return surface;
}

void RequireArrays(const std::vector<TagRule>& rules, vtkPolyData* boundary)
{
  for (const TagRule& rule : rules)
  {
    for (const TagCondition& condition : rule.Conditions)
    {
      const bool isNamed = condition.What == TagCondition::Kind::Array;
      vtkDataArray* array =
        isNamed ? boundary->GetCellData()->GetArray(condition.Name.c_str()) : nullptr;
      if (isNamed && (!array || array->GetNumberOfComponents() != 1))
      {
        throw Error(ErrorCode::InvalidParameter,
          "the rule " + rule.Text +
            " names a cell array of one number per cell, which the surface does not have");
      }
    }
  }
}
} // namespace

std::vector<std::string> TagByRules(const std::vector<TagRule>& rules, vtkPolyData* boundary)
{
  if (rules.empty() || boundary->GetNumberOfCells() == 0)
  {
    return {};
  }
  RequireArrays(rules, boundary);
  const std::vector<TagMatch> matches = MatchTagRules(rules, SurfaceOf(boundary));
  vtkDataArray* given = boundary->GetCellData()->GetArray(BoundaryTag);
  auto* givenNames =
    vtkStringArray::SafeDownCast(boundary->GetFieldData()->GetAbstractArray("BoundaryTagNames"));
  std::vector<std::string> nameOf; // per triangle
  std::vector<vtkIdType> counts(rules.size(), 0);
  for (std::size_t t = 0; t < matches.size(); ++t)
  {
    const auto [rule, face] = matches[t];
    const auto tag = static_cast<vtkIdType>(given->GetComponent(static_cast<vtkIdType>(t), 0));
    nameOf.push_back(rule == None ? std::string(givenNames->GetValue(tag))
        : face == None            ? rules[rule].Name
                                  : rules[rule].Name + "_" + std::to_string(face + 1));
    counts[rule == None ? 0 : rule] += rule != None;
  }
  // First the names that were there, then those of the rules.
  std::map<std::string, int> numbers;
  std::vector<std::string> names;
  const auto keep = [&](const std::string& name)
  {
    if (numbers.insert({ name, static_cast<int>(names.size()) }).second)
    {
      names.push_back(name);
    }
  };
  for (vtkIdType tag = 0; tag < givenNames->GetNumberOfValues(); ++tag)
  {
    const std::string name = givenNames->GetValue(tag);
    if (std::find(nameOf.begin(), nameOf.end(), name) != nameOf.end())
    {
      keep(name);
    }
  }
  std::for_each(nameOf.begin(), nameOf.end(), keep);
  std::vector<int> tagOf;
  for (const std::string& name : nameOf)
  {
    tagOf.push_back(numbers.at(name));
  }
  boundary->GetCellData()->AddArray(MakeArray<vtkIntArray>(BoundaryTag, tagOf));
  boundary->GetFieldData()->AddArray(MakeStrings("BoundaryTagNames", names));
  std::vector<std::string> warnings;
  for (std::size_t r = 0; r < rules.size(); ++r)
  {
    if (counts[r] == 0)
    {
      warnings.push_back("no triangle of the boundary is tagged by the rule " + rules[r].Text);
    }
  }
  return warnings;
}
} // namespace vtkInsideOut
