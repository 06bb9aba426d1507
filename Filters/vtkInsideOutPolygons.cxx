// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutPolygons.h"

#include "vtkInsideOutArrays.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <limits>
#include <numeric>

using insideout::Error;
using insideout::ErrorCode;
using insideout::Id;

namespace
{
template <typename Value>
vtkSmartPointer<vtkDataArray> MakeArray(
  const insideout::Attribute& attribute, const std::vector<Value>& values)
{
  auto array = vtkSmartPointer<vtkAOSDataArrayTemplate<Value>>::New();
  array->SetName(attribute.Name.c_str());
  array->SetNumberOfComponents(attribute.Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / attribute.Components));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/** Add the attribute as an array, and as VTK's normals, texture coordinates or colours if it is
 * these. */
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

insideout::Point GetPoint(vtkPolyData* input, vtkIdType id)
{
  insideout::Point point;
  input->GetPoint(id, point.data());
  return point;
}
} // namespace

vtkSmartPointer<vtkPolyData> vtkInsideOutMakePolyData(const insideout::PolygonSurface& surface)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> corners;
  for (const Id offset : surface.Offsets)
  {
    offsets->InsertNextValue(offset);
  }
  for (const Id corner : surface.Corners)
  {
    corners->InsertNextValue(corner);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, corners);
  output->SetPoints(vtkInsideOutMakePoints(surface.Points));
  output->SetPolys(polygons);
  for (const insideout::Attribute& attribute : surface.PointAttributes)
  {
    AddAttribute(attribute, output->GetPointData());
  }
  for (const insideout::Attribute& attribute : surface.PolygonAttributes)
  {
    AddAttribute(attribute, output->GetCellData());
  }
  return output;
}

namespace
{
/** Polygon by polygon, checked, with the input cell that each comes from. */
class PolygonCollector
{
public:
  explicit PolygonCollector(vtkIdType numberOfPoints)
    : NumberOfPoints(numberOfPoints)
  {
  }

  void Add(vtkIdType cell, std::initializer_list<vtkIdType> corners)
  {
    this->Add(cell, static_cast<vtkIdType>(corners.size()), corners.begin());
  }

  void Add(vtkIdType cell, vtkIdType size, const vtkIdType* corners)
  {
    for (vtkIdType k = 0; k < size; ++k)
    {
      if (corners[k] < 0 || corners[k] >= this->NumberOfPoints)
      {
        throw Error(ErrorCode::PointOutOfRange,
          "cell " + std::to_string(cell) + " refers to point " + std::to_string(corners[k]) +
            " of " + std::to_string(this->NumberOfPoints));
      }
      this->Surface.Corners.push_back(static_cast<Id>(corners[k]));
    }
    this->Surface.Offsets.push_back(static_cast<Id>(this->Surface.Corners.size()));
    this->Cells.push_back(cell);
  }

  insideout::PolygonSurface Surface;
  std::vector<vtkIdType> Cells;

private:
  vtkIdType NumberOfPoints;
};

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

insideout::Attribute MakeAttribute(
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

std::vector<insideout::Attribute> MakeAttributes(
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
      attributes.push_back(MakeAttribute(name, array, ids));
    }
  }
  return attributes;
}
} // namespace

insideout::PolygonSurface vtkInsideOutReadPolyData(vtkPolyData* input)
{
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  if (numberOfPoints > std::numeric_limits<Id>::max() ||
    input->GetPolys()->GetNumberOfConnectivityIds() +
        3 * input->GetStrips()->GetNumberOfConnectivityIds() >
      std::numeric_limits<Id>::max())
  {
    throw Error(ErrorCode::TooLarge,
      "the surface has more than " + std::to_string(std::numeric_limits<Id>::max()) +
        " points or corners");
  }
  PolygonCollector polygons(numberOfPoints);
  std::vector<vtkIdType> points(numberOfPoints);
  std::iota(points.begin(), points.end(), 0);
  for (const vtkIdType p : points)
  {
    polygons.Surface.Points.push_back(GetPoint(input, p));
  }

  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  vtkIdType size;
  const vtkIdType* corners;
  const auto polys = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell(), ++cell)
  {
    polys->GetCurrentCell(size, corners);
    if (size >= 3)
    {
      polygons.Add(cell, size, corners);
    }
  }
  const auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    strips->GetCurrentCell(size, corners);
    for (vtkIdType k = 0; k + 2 < size; ++k)
    {
      const int odd = k % 2; // every other triangle of a strip runs the other way
      polygons.Add(cell, { corners[k], corners[k + 1 + odd], corners[k + 2 - odd] });
    }
  }

  insideout::PolygonSurface surface = std::move(polygons.Surface);
  surface.PointAttributes = MakeAttributes(input->GetPointData(), points);
  surface.PolygonAttributes = MakeAttributes(input->GetCellData(), polygons.Cells);
  return surface;
}
