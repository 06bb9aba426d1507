// SPDX-License-Identifier: GPL-3.0-or-later
#include "Data/FileAttributes.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTypeTraits.h>

#include <algorithm>
#include <limits>

namespace vtkInsideOut
{
namespace
{
/** An array of one of VTK's named classes, such as vtkIntArray. */
template <typename Value>
vtkSmartPointer<vtkDataArray> MakeArray(
  const insideout::Attribute& attribute, const std::vector<Value>& values)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(vtkTypeTraits<Value>::VTK_TYPE_ID));
  array->SetName(attribute.Name.c_str());
  array->SetNumberOfComponents(attribute.Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / attribute.Components));
  std::copy(values.begin(), values.end(), static_cast<Value*>(array->GetVoidPointer(0)));
  return array;
}

/** The values of the tuples of these ids. */
template <typename Value>
std::vector<Value> GetValues(vtkDataArray* array, const std::vector<vtkIdType>& ids)
{
  std::vector<Value> values;
  values.reserve(ids.size() * array->GetNumberOfComponents());
  for (const vtkIdType id : ids)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      values.push_back(static_cast<Value>(array->GetComponent(id, k)));
    }
  }
  return values;
}

bool HoldsInts(vtkDataArray* array)
{
  double range[2] = { 0, 0 };
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    array->GetRange(range, k);
    if (range[0] < std::numeric_limits<std::int32_t>::min() ||
      range[1] > std::numeric_limits<std::int32_t>::max())
    {
      return false;
    }
  }
  return true;
}

insideout::Attribute ReadAttribute(
  const std::string& name, vtkDataArray* array, const std::vector<vtkIdType>& ids)
{
  insideout::Attribute attribute;
  attribute.Name = name;
  attribute.Components = array->GetNumberOfComponents();
  const int type = array->GetDataType();
  if (type == VTK_FLOAT)
  {
    attribute.Values = GetValues<float>(array, ids);
  }
  else if (type == VTK_UNSIGNED_CHAR)
  {
    attribute.Values = GetValues<unsigned char>(array, ids);
  }
  else if (type != VTK_DOUBLE && HoldsInts(array))
  {
    attribute.Values = GetValues<std::int32_t>(array, ids);
  }
  else
  {
    attribute.Values = GetValues<double>(array, ids);
  }
  return attribute;
}

bool IsColor(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  return array->GetDataType() == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
}
} // namespace

void AddAttribute(const insideout::Attribute& attribute, vtkDataSetAttributes* data)
{
  const vtkSmartPointer<vtkDataArray> array =
    std::visit([&](const auto& values) { return MakeArray(attribute, values); }, attribute.Values);
  if (attribute.Name == "Normals")
  {
    data->SetNormals(array);
  }
  else if (attribute.Name == "TCoords")
  {
    data->SetTCoords(array);
  }
  else if (attribute.Name == "Colors")
  {
    data->SetScalars(array);
  }
  else
  {
    data->AddArray(array);
  }
}

std::vector<insideout::Attribute> ReadAttributes(
  vtkDataSetAttributes* data, const std::vector<vtkIdType>& ids)
{
  std::vector<insideout::Attribute> attributes;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i); // null where it is not numeric
    if (!array || array->GetNumberOfComponents() == 0)
    {
      continue;
    }
    std::string name = array->GetName() ? array->GetName() : "";
    if (array == data->GetNormals())
    {
      name = "Normals";
    }
    else if (array == data->GetTCoords())
    {
      name = "TCoords";
    }
    else if (array == data->GetScalars() && IsColor(array))
    {
      name = "Colors";
    }
    if (!name.empty())
    {
      attributes.push_back(ReadAttribute(name, array, ids));
    }
  }
  return attributes;
}

std::vector<insideout::AttributeNames> ReadNames(vtkFieldData* data)
{
  std::vector<insideout::AttributeNames> all;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(i));
    if (array && array->GetName() && array->GetNumberOfComponents() == 1)
    {
      all.push_back({ array->GetName(), {} });
      for (vtkIdType value = 0; value < array->GetNumberOfValues(); ++value)
      {
        all.back().Values.push_back(array->GetValue(value));
      }
    }
  }
  return all;
}
} // namespace vtkInsideOut
