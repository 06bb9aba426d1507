// SPDX-License-Identifier: GPL-3.0-or-later
#include "Data/FieldNames.h"

#include <vtkFieldData.h>
#include <vtkStringArray.h>

namespace vtkInsideOut
{
std::vector<std::string> NamesByNumber(vtkFieldData* data, const char* array)
{
  std::vector<std::string> names;
  vtkAbstractArray* found = data->GetAbstractArray(array);
  if (auto* strings = vtkStringArray::SafeDownCast(found))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      names.push_back(strings->GetValue(i));
    }
  }
  else if (found && found->HasAComponentName())
  {
    for (int k = 0; k < found->GetNumberOfComponents(); ++k)
    {
      const char* component = found->GetComponentName(k);
      names.emplace_back(component ? component : "");
    }
  }
  return names;
}
} // namespace vtkInsideOut
