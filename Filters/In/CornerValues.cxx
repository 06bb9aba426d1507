// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/CornerValues.h"

#include "Common/Error.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVariant.h>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;

vtkSmartPointer<vtkAbstractArray> ValuesOfCorners(vtkPolyData* surface, const std::string& name)
{
  vtkAbstractArray* ofPoints = surface->GetPointData()->GetAbstractArray(name.c_str());
  const bool fits = ofPoints && ofPoints->GetNumberOfComponents() == 1 &&
    ofPoints->GetDataType() != VTK_BIT &&
    ofPoints->GetNumberOfTuples() == surface->GetNumberOfPoints();
  if (!fits)
  {
    return nullptr;
  }
  const vtkIdType points = surface->GetNumberOfPoints();
  const auto values = vtkSmartPointer<vtkAbstractArray>::Take(ofPoints->NewInstance());
  values->SetName(name.c_str());
  values->SetNumberOfTuples(surface->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    // A cell without corners gets the value of point 0, so that it adds no tag.
    const vtkIdType first = corners->GetNumberOfIds() > 0 ? corners->GetId(0) : 0;
    for (const vtkIdType corner : *corners)
    {
      if (corner < 0 || corner >= points)
      {
        throw Error(ErrorCode::PointOutOfRange,
          "cell " + std::to_string(cell) + " refers to point " + std::to_string(corner) + " of " +
            std::to_string(points));
      }
    }
    for (const vtkIdType corner : *corners)
    {
      const vtkVariant expected = ofPoints->GetVariantValue(first);
      const vtkVariant other = ofPoints->GetVariantValue(corner);
      if (other != expected)
      {
        throw Error(ErrorCode::InvalidParameter,
          "the point array " + name + " is " + expected.ToString() + " and " + other.ToString() +
            " at corners of cell " + std::to_string(cell) + ": tags are of whole cells");
      }
    }
    if (points > 0)
    {
      values->SetTuple(cell, first, ofPoints);
    }
  }
  return values;
}
} // namespace vtkInsideOut
