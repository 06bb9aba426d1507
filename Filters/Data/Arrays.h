// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Conversions between VTK's points, cells and arrays and plain ones. */
#pragma once

#include "Common/Types.h"
#include "Data/VtkClasses.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <string>
#include <vector>

namespace vtkInsideOut
{
/**
 * The number of points of a data set, checked to fit Id.
 *
 * @param[in] name of the data set in errors
 * @throws insideout::Error TooLarge, also for its cells
 */
std::vector<insideout::Point> ReadPoints(vtkDataSet* input, const std::string& name);

/** @throws insideout::Error PointNotFinite that names the first point which is not finite */
void RequireFinite(const std::vector<insideout::Point>& points);

/**
 * To be called before VTK's arrays allocate: without memory they end the program, if VTK was built
 * with assertions, as Debian's is.
 *
 * @throws std::bad_alloc if this number of bytes, and some more, are not free
 */
void RequireMemory(vtkIdType bytes);

/** Points in double precision. */
vtkSmartPointer<vtkPoints> MakePoints(const std::vector<insideout::Point>& values);

/** Cells of `Size` points each. */
template <std::size_t Size>
vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<std::array<insideout::Id, Size>>& values)
{
  RequireMemory(static_cast<vtkIdType>((Size + 2) * values.size() * sizeof(vtkIdType)));
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

/** An array with a name and room for tuples. */
template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, vtkIdType size, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  RequireMemory(size * components * array->GetDataTypeSize());
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  return array;
}

/** An array with a name and these values, one per tuple. */
template <typename Array, typename Value>
vtkSmartPointer<Array> MakeArray(const char* name, const std::vector<Value>& values)
{
  auto array = MakeArray<Array>(name, static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/** An array of strings with a name. */
vtkSmartPointer<vtkStringArray> MakeStrings(
  const char* name, const std::vector<std::string>& values);
} // namespace vtkInsideOut
