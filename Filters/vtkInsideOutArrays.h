// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutArrays
 * @brief   Makes VTK's points and cells of InsideOut's plain ones.
 */
#ifndef vtkInsideOutArrays_h
#define vtkInsideOutArrays_h

#include "Common/Types.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <vector>

/** Points in double precision. */
vtkSmartPointer<vtkPoints> vtkInsideOutMakePoints(const std::vector<insideout::Point>& values);

/** Cells of `Size` points each. */
template <std::size_t Size>
vtkSmartPointer<vtkCellArray> vtkInsideOutMakeCells(
  const std::vector<std::array<insideout::Id, Size>>& values)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(Size * values.size()));
  if (!values.empty())
  {
    std::copy_n(values.front().data(), Size * values.size(), connectivity->GetPointer(0));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(static_cast<vtkIdType>(Size), connectivity);
  return cells;
}

#endif
