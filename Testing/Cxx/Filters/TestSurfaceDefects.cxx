// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boxes.h"
#include "Listener.h"
#include "Statistics.h"
#include "vtkSurfaceDefects.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
double CellValue(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetTuple1(cell);
}

} // namespace

TEST(vtkSurfaceDefects, MarksTheCellsOfPolygonsByAllTheirTriangles)
{
  vtkNew<vtkSurfaceDefects> filter;
  filter->SetInputData(TwoBoxes());
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  ASSERT_EQ(surface->GetNumberOfCells(), 12);
  double crossings = 0;
  for (vtkIdType c = 0; c < 12; ++c)
  {
    EXPECT_EQ(CellValue(surface, "ComponentId", c), c / 6);
    crossings += CellValue(surface, "SelfIntersections", c);
    for (const char* name : { "Degenerate", "Duplicate", "Inconsistent", "TwoSided" })
    {
      EXPECT_EQ(CellValue(surface, name, c), 0) << name;
    }
    // The first box is met on its three faces at 1, the second on its three at 0.5.
    const bool isMet = c < 6 ? c % 2 == 1 : c % 2 == 0;
    EXPECT_EQ(CellValue(surface, "SelfIntersections", c) > 0, isMet) << c;
    double color[3];
    surface->GetCellData()->GetArray("DefectColor")->GetTuple(c, color);
    EXPECT_EQ(color[0] > color[1] && color[1] > color[2], isMet) << "vermilion where it crosses";
  }
  for (vtkPolyData* output : { surface, filter->GetLines() })
  {
    EXPECT_EQ(2 * StatisticOf(output, "IntersectingPairs"), crossings);
    EXPECT_EQ(StatisticOf(output, "Components"), 2);
    EXPECT_EQ(StatisticOf(output, "OpenEdges"), 0);
  }
}

TEST(vtkSurfaceDefects, DrawsLinesThatSayWhatTheyAre)
{
  auto surface = TwoBoxes();
  vtkNew<vtkCellArray> withoutOne; // a face of the first box
  for (vtkIdType c = 1; c < 12; ++c)
  {
    vtkNew<vtkIdList> quad;
    surface->GetPolys()->GetCellAtId(c, quad);
    withoutOne->InsertNextCell(quad);
  }
  surface->SetPolys(withoutOne);
  vtkNew<vtkSurfaceDefects> filter;
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* lines = filter->GetLines();
  ASSERT_EQ(lines->GetNumberOfCells(), 2);
  ASSERT_EQ(lines->GetNumberOfLines(), 2);
  auto* names = vtkStringArray::SafeDownCast(lines->GetCellData()->GetAbstractArray("DefectName"));
  ASSERT_TRUE(names);
  EXPECT_EQ(CellValue(lines, "DefectType", 0), vtkSurfaceDefects::OPEN_BOUNDARY);
  EXPECT_EQ(names->GetValue(0), "open boundary");
  EXPECT_EQ(CellValue(lines, "DefectType", 1), vtkSurfaceDefects::INTERSECTION_CURVE);
  EXPECT_EQ(names->GetValue(1), "intersection curve");
  vtkDataArray* origins = lines->GetPointData()->GetArray("vtkOriginalPointIds");
  for (vtkIdType line = 0; line < 2; ++line)
  {
    vtkIdList* points = lines->GetCell(line)->GetPointIds();
    EXPECT_EQ(points->GetId(0), points->GetId(points->GetNumberOfIds() - 1)) << "a loop";
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
    {
      const auto origin = static_cast<vtkIdType>(origins->GetTuple1(points->GetId(k)));
      EXPECT_EQ(origin >= 0, line == 0);
      for (int i = 0; origin >= 0 && i < 3; ++i)
      {
        EXPECT_EQ(lines->GetPoint(points->GetId(k))[i], surface->GetPoint(origin)[i]);
      }
    }
  }
}

TEST(vtkSurfaceDefects, DrawsAVertexWhereFacetsOnlyTouch)
{
  auto surface = EmptySurface();
  const double corners[6][3] = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0 }, { 1, 1, 1 },
    { 2, 1, 1 } };
  for (const auto& corner : corners)
  {
    surface->GetPoints()->InsertNextPoint(corner);
  }
  for (const vtkIdType first : { 0, 3 })
  {
    const vtkIdType triangle[3] = { first, first + 1, first + 2 };
    surface->GetPolys()->InsertNextCell(3, triangle);
  }
  vtkNew<vtkSurfaceDefects> filter;
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* lines = filter->GetLines();
  ASSERT_EQ(lines->GetNumberOfVerts(), 1);
  EXPECT_EQ(CellValue(lines, "DefectType", 0), vtkSurfaceDefects::INTERSECTION_CURVE);
  EXPECT_EQ(lines->GetNumberOfLines(), 2) << "the open boundary of either triangle";
  EXPECT_EQ(CellValue(lines, "DefectType", 1), vtkSurfaceDefects::OPEN_BOUNDARY);
}

TEST(vtkSurfaceDefects, KeepsTheInputAsItIsAndRenamesArraysThatClash)
{
  auto surface = TwoBoxes();
  const vtkIdType line[2] = { 0, 1 };
  surface->SetLines(vtkNew<vtkCellArray>());
  surface->GetLines()->InsertNextCell(2, line);
  for (const char* name : { "number", "ComponentId", "short" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (int c = 0; c < (name == std::string("short") ? 2 : 13); ++c)
    {
      array->InsertNextValue(c);
    }
    surface->GetCellData()->AddArray(array);
  }
  vtkNew<vtkSurfaceDefects> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfCells(), 13);
  EXPECT_EQ(output->GetPoints(), surface->GetPoints());
  EXPECT_TRUE(warnings.Heard("Input_ComponentId"));
  EXPECT_TRUE(warnings.Heard("array short has 2 tuples"));
  EXPECT_FALSE(output->GetCellData()->HasArray("short"));
  EXPECT_EQ(CellValue(output, "ComponentId", 0), -1) << "the line";
  for (vtkIdType c = 1; c < 13; ++c)
  {
    EXPECT_EQ(CellValue(output, "ComponentId", c), (c - 1) / 6);
    EXPECT_EQ(CellValue(output, "number", c), c);
    EXPECT_EQ(CellValue(output, "Input_ComponentId", c), c);
  }
}

TEST(vtkSurfaceDefects, AdvisesAMergeTolerance)
{
  auto surface = EmptySurface();
  AddBox(surface, 0, 1);
  AddBox(surface, 1 + 1e-9, 2);
  vtkNew<vtkSurfaceDefects> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "NearPoints"), 2);
  EXPECT_TRUE(warnings.Heard("set MergeTolerance to"));
  filter->SetMergeTolerance(StatisticOf(filter->GetOutput(), "NearDistance"));
  warnings.Texts.clear();
  filter->Update();
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "NearPoints"), 0);
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "Points"), 15);
  EXPECT_TRUE(warnings.Texts.empty());
}

TEST(vtkSurfaceDefects, NamesWhatIsNoSurfaceAndLeavesItsOutputsEmpty)
{
  auto surface = TwoBoxes();
  vtkNew<vtkSurfaceDefects> filter;
  Listener errors(filter, vtkCommand::ErrorEvent);
  filter->SetInputData(surface);
  surface->GetPoints()->SetPoint(11, 0, std::nan(""), 0);
  filter->Update();
  EXPECT_TRUE(errors.Heard("point 11 is not finite"));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetLines()->GetNumberOfCells(), 0);

  filter->SetInputData(EmptySurface());
  filter->Update();
  EXPECT_TRUE(errors.Heard("the surface is empty"));
  filter->SetInputData(TwoBoxes());
  filter->Update();
  EXPECT_EQ(errors.Texts.size(), 2u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 12);
}
