// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutArrays.h"

vtkSmartPointer<vtkPoints> vtkInsideOutMakePoints(const std::vector<insideout::Point>& values)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(values.size()));
  if (!values.empty())
  {
    std::copy_n(
      values.front().data(), 3 * values.size(), static_cast<double*>(points->GetVoidPointer(0)));
  }
  return points;
}
