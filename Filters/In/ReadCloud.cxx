// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadCloud.h"

#include "Common/Error.h"
#include "Data/Arrays.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
void CheckLength(vtkDataArray* array, vtkPolyData* cloud, const std::string& what)
{
  if (array->GetNumberOfTuples() != cloud->GetNumberOfPoints())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the cloud has " + std::to_string(array->GetNumberOfTuples()) + " " + what + " for " +
        std::to_string(cloud->GetNumberOfPoints()) + " points");
  }
}
} // namespace

bool IsCloud(vtkPolyData* input)
{
  return input->GetNumberOfPoints() > 0 && input->GetNumberOfPolys() == 0 &&
    input->GetNumberOfStrips() == 0 && input->GetNumberOfLines() == 0;
}

vtkDataArray* FindNormals(vtkPolyData* input)
{
  vtkDataArray* const normals = input->GetPointData()->GetNormals();
  vtkDataArray* const array = normals ? normals : input->GetPointData()->GetArray("Normals");
  return array && array->GetNumberOfComponents() == 3 ? array : nullptr;
}

PointCloud ReadCloud(vtkPolyData* input, const std::string& areas)
{
  vtkDataArray* const normals = FindNormals(input);
  if (!normals)
  {
    throw Error(ErrorCode::EmptySurface,
      "the surface is empty: it has no polygons, and its points have no normals, with which they "
      "would be a cloud");
  }
  CheckLength(normals, input, "normals");
  PointCloud cloud;
  cloud.Points = ReadPoints(input, "the cloud");
  cloud.Normals.resize(cloud.Points.size());
  for (std::size_t i = 0; i < cloud.Points.size(); ++i)
  {
    normals->GetTuple(static_cast<vtkIdType>(i), cloud.Normals[i].data());
  }
  vtkDataArray* const array = input->GetPointData()->GetArray(areas.c_str());
  if (array && array->GetNumberOfComponents() != 1)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the cloud's point array " + areas + " has " +
        std::to_string(array->GetNumberOfComponents()) + " components; areas have one");
  }
  if (array)
  {
    CheckLength(array, input, "areas");
  }
  for (std::size_t i = 0; array && i < cloud.Points.size(); ++i)
  {
    cloud.Areas.push_back(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return cloud;
}
} // namespace vtkInsideOut
