// SPDX-License-Identifier: GPL-3.0-or-later
#include "Data/Arrays.h"

#include "Common/Error.h"
#include "Common/Vectors.h"

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <limits>
#include <new>

namespace vtkInsideOut
{
std::vector<insideout::Point> ReadPoints(vtkDataSet* input, const std::string& name)
{
  constexpr vtkIdType Most = std::numeric_limits<insideout::Id>::max();
  if (input->GetNumberOfPoints() > Most || input->GetNumberOfCells() > Most)
  {
    throw insideout::Error(insideout::ErrorCode::TooLarge,
      name + " has " + std::to_string(input->GetNumberOfPoints()) + " points and " +
        std::to_string(input->GetNumberOfCells()) + " cells; at most " + std::to_string(Most) +
        " of each can be handled");
  }
  std::vector<insideout::Point> points(input->GetNumberOfPoints());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    input->GetPoint(static_cast<vtkIdType>(p), points[p].data());
  }
  return points;
}

void RequireFinite(const std::vector<insideout::Point>& points)
{
  const auto bad = std::find_if_not(points.begin(), points.end(), insideout::IsFinite);
  if (bad != points.end())
  {
    throw insideout::Error(insideout::ErrorCode::PointNotFinite,
      "point " + std::to_string(bad - points.begin()) + " is not finite");
  }
}

void RequireMemory(vtkIdType bytes)
{
  constexpr vtkIdType ForWhatIsSmall = vtkIdType(1) << 20;
  void* volatile memory = operator new(static_cast<std::size_t>(bytes + ForWhatIsSmall));
  operator delete(memory);
}

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<insideout::Point>& values)
{
  const auto coordinates =
    MakeArray<vtkDoubleArray>("Points", static_cast<vtkIdType>(values.size()), 3);
  if (!values.empty())
  {
    std::copy_n(values.front().data(), 3 * values.size(), coordinates->GetPointer(0));
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

vtkSmartPointer<vtkStringArray> MakeStrings(
  const char* name, const std::vector<std::string>& values)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  const auto size = static_cast<vtkIdType>(values.size());
  RequireMemory(size * array->GetDataTypeSize());
  array->SetName(name);
  array->SetNumberOfValues(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    array->SetValue(i, values[i]);
  }
  return array;
}
} // namespace vtkInsideOut
