// SPDX-License-Identifier: GPL-3.0-or-later
#include "ForPython/DataForXml.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <numeric>
#include <string>

namespace vtkInsideOut
{
namespace
{
/** Encode for the value of an attribute. VTK's reader searches for numbers after the first `>`. */
std::string EncodedForXml(const std::string& name)
{
  std::string encoded;
  for (const char c : name)
  {
    // XML cannot represent most of these
    const bool isControl = static_cast<unsigned char>(c) < ' ';
    switch (isControl ? ' ' : c)
    {
      case '&':
        encoded += "&amp;";
        break;
      case '<':
        encoded += "&lt;";
        break;
      case '>':
        encoded += "&gt;";
        break;
      case '"':
        encoded += "&quot;";
        break;
      default:
        encoded += isControl ? ' ' : c;
    }
  }
  return encoded;
}

/** Encode names of components, in arrays that replace those of the data. */
void EncodeComponentNames(vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i); // null where it is not numeric
    if (array && array->HasAComponentName())
    {
      const auto encoded = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
      encoded->ShallowCopy(array);
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        const char* name = array->GetComponentName(k);
        encoded->SetComponentName(k, EncodedForXml(name ? name : "").c_str());
      }
      data->AddArray(encoded); // replaces the array of the same name
    }
  }
}

vtkSmartPointer<vtkAbstractArray> AsComponents(vtkStringArray* names)
{
  const auto count = static_cast<int>(names->GetNumberOfValues());
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(names->GetName());
  array->SetNumberOfComponents(count);
  array->SetNumberOfTuples(1);
  std::iota(array->GetPointer(0), array->GetPointer(0) + count, 0);
  for (int k = 0; k < count; ++k)
  {
    array->SetComponentName(k, names->GetValue(k).c_str());
  }
  return array;
}

vtkSmartPointer<vtkFieldData> WithoutStrings(vtkFieldData* data)
{
  auto made = vtkSmartPointer<vtkFieldData>::New();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    auto* names = vtkStringArray::SafeDownCast(array);
    if (array->GetNumberOfValues() > 0)
    {
      made->AddArray(names ? AsComponents(names).Get() : array);
    }
  }
  return made;
}
} // namespace

vtkSmartPointer<vtkDataSet> DataForXml(vtkDataSet* data)
{
  const auto made = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  made->ShallowCopy(data);
  if (vtkUnstructuredGrid::SafeDownCast(made))
  {
    made->SetFieldData(WithoutStrings(made->GetFieldData()));
  }
  for (vtkFieldData* arrays : { static_cast<vtkFieldData*>(made->GetPointData()),
         static_cast<vtkFieldData*>(made->GetCellData()), made->GetFieldData() })
  {
    EncodeComponentNames(arrays);
  }
  return made;
}
} // namespace vtkInsideOut
