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
  vtkAbstractArray* of = surface->GetPointData()->GetAbstractArray(name.c_str());
  const bool fits = of && of->GetNumberOfComponents() == 1 && of->GetDataType() != VTK_BIT &&
    of->GetNumberOfTuples() == surface->GetNumberOfPoints();
  if (!fits)
  {
    return nullptr;
  }
  const auto values = vtkSmartPointer<vtkAbstractArray>::Take(of->NewInstance());
  values->SetName(name.c_str());
  values->SetNumberOfTuples(surface->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    for (const vtkIdType corner : *corners)
    {
      const vtkVariant first = of->GetVariantValue(corners->GetId(0));
      const vtkVariant other = of->GetVariantValue(corner);
      if (other != first)
      {
        throw Error(ErrorCode::InvalidParameter,
          "the point array " + name + " is " + first.ToString() + " and " + other.ToString() +
            " at corners of cell " + std::to_string(cell) + ": tags are of whole cells");
      }
      values->SetTuple(cell, corner, of);
    }
  }
  return values;
}
} // namespace vtkInsideOut
