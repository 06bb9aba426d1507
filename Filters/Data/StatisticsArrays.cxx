// SPDX-License-Identifier: GPL-3.0-or-later
#include "Data/StatisticsArrays.h"

#include "Data/Arrays.h"
#include "Data/FieldNames.h"

#include <vtkAbstractArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <string>
#include <vector>

namespace vtkInsideOut
{
namespace
{
constexpr char StatisticsName[] = "Statistics";
constexpr char NamesOfStatistics[] = "StatisticsNames";

/** Each name once, at its first position with its last value. */
insideout::Statistics Joined(
  const insideout::Statistics& first, const insideout::Statistics& others)
{
  insideout::Statistics all;
  const auto find = [&](const std::string& name)
  {
    return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == name; });
  };
  for (const auto& [name, value] : first)
  {
    const auto found = find(name);
    if (found == all.end())
    {
      all.emplace_back(name, value);
    }
    else
    {
      found->second = value;
    }
  }
  for (const auto& [name, value] : others)
  {
    if (find(name) == all.end())
    {
      all.emplace_back(name, value);
    }
  }
  return all;
}

void Set(const insideout::Statistics& statistics, vtkDataObject* output)
{
  std::vector<std::string> names;
  std::vector<double> values;
  for (const auto& [name, value] : statistics)
  {
    names.push_back(name);
    values.push_back(value);
  }
  vtkNew<vtkFieldData> fields;
  fields->AddArray(MakeArray<vtkDoubleArray>(StatisticsName, values));
  fields->AddArray(MakeStrings(NamesOfStatistics, names));
  vtkFieldData* others = output->GetFieldData();
  for (int i = 0; i < others->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* other = others->GetAbstractArray(i);
    if (!other->GetName() || !fields->HasArray(other->GetName()))
    {
      fields->AddArray(other);
    }
  }
  output->SetFieldData(fields);
}
} // namespace

insideout::Statistics StatisticsOf(vtkFieldData* fields)
{
  insideout::Statistics found;
  const auto* values = vtkDoubleArray::SafeDownCast(fields->GetArray(StatisticsName));
  const std::vector<std::string> names = NamesByNumber(fields, NamesOfStatistics);
  const auto count = static_cast<vtkIdType>(names.size());
  for (vtkIdType i = 0; values && i < std::min(values->GetNumberOfTuples(), count); ++i)
  {
    found.emplace_back(names[i], values->GetValue(i));
  }
  return found;
}

void AddStatistics(const insideout::Statistics& statistics, vtkDataObject* output)
{
  Set(Joined(statistics, StatisticsOf(output->GetFieldData())), output);
}

void KeepStatistics(vtkFieldData* input, vtkDataObject* output)
{
  const insideout::Statistics own = StatisticsOf(output->GetFieldData());
  const insideout::Statistics earlier = StatisticsOf(input);
  if (!own.empty() && !earlier.empty())
  {
    Set(Joined(own, earlier), output);
  }
}
} // namespace vtkInsideOut
