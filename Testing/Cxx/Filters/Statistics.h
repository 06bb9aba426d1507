// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

/** A figure of a filter's output by its name; -1 where there is none. */
inline double StatisticOf(vtkDataObject* data, const std::string& name)
{
  vtkDataArray* values = data->GetFieldData()->GetArray("Statistics");
  auto* names =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("StatisticsNames"));
  const vtkIdType index = values && names ? names->LookupValue(name) : -1;
  return index < 0 ? -1 : values->GetTuple1(index);
}
