// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boxes.h"
#include "Listener.h"
#include "vtkResolveSelfIntersections.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

TEST(vtkResolveSelfIntersections, KeepsInputPointsAndInterpolatesDataAtNewOnes)
{
  auto surface = TwoBoxes();
  vtkNew<vtkDoubleArray> x;
  x->SetName("x");
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    x->InsertNextValue(surface->GetPoint(p)[0]);
  }
  surface->GetPointData()->AddArray(x);
  vtkNew<vtkResolveSelfIntersections> filter;
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("vtkOriginalPointIds"));
  ASSERT_TRUE(ids);
  vtkIdType newPoints = 0;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(output->GetPointData()->GetArray("x")->GetTuple1(p), output->GetPoint(p)[0], 1e-15);
    newPoints += ids->GetValue(p) < 0;
    if (ids->GetValue(p) >= 0)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_EQ(output->GetPoint(p)[k], surface->GetPoint(ids->GetValue(p))[k]);
      }
    }
  }
  EXPECT_GE(newPoints, 6) << "edges of either box pierce faces of the other";
}

TEST(vtkResolveSelfIntersections, RenamesAnInputArrayThatClashes)
{
  auto surface = TwoBoxes();
  vtkNew<vtkDoubleArray> clash;
  clash->SetName("vtkOriginalCellIds");
  for (int c = 0; c < 12; ++c)
  {
    clash->InsertNextValue(100 + c);
  }
  surface->GetCellData()->AddArray(clash);
  vtkNew<vtkResolveSelfIntersections> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_TRUE(warnings.Heard("Input_vtkOriginalCellIds"));
  vtkCellData* data = filter->GetOutput()->GetCellData();
  ASSERT_TRUE(data->GetArray("Input_vtkOriginalCellIds"));
  EXPECT_EQ(data->GetArray("Input_vtkOriginalCellIds")->GetTuple1(0),
    100 + data->GetArray("vtkOriginalCellIds")->GetTuple1(0));
}
