// SPDX-License-Identifier: GPL-3.0-or-later
// vtkRobustTetrahedralize in two dimensions. The laws stand in Cxx/Core/Planar.
#include "vtkConstrainedDelaunay3D.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkProbeWindingNumber.h"
#include "vtkResolveSelfIntersections.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkSurfaceDefects.h"

#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace
{
using Place = std::array<double, 3>;
using Cells = std::vector<std::vector<vtkIdType>>;
using Data = vtkSmartPointer<vtkPolyData>;

vtkSmartPointer<vtkCellArray> MakeCells(const Cells& cells)
{
  auto made = vtkSmartPointer<vtkCellArray>::New();
  for (const std::vector<vtkIdType>& cell : cells)
  {
    made->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return made;
}

Data MakeData(const std::vector<Place>& places, const Cells& lines, const Cells& polygons = {})
{
  auto data = Data::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  data->SetPoints(points);
  data->SetLines(MakeCells(lines));
  data->SetPolys(MakeCells(polygons));
  vtkNew<vtkDoubleArray> height; // linear, so that interpolation gives it back
  height->SetName("Linear");
  for (const Place& p : places)
  {
    height->InsertNextValue(1 + 2 * p[0] - 3 * p[1]);
  }
  data->GetPointData()->AddArray(height);
  return data;
}

/** Two squares whose edges cross, the second a polyline that starts in the first. */
Data TwoSquares()
{
  return MakeData({ { 0, 0, 5 }, { 2, 0, 5 }, { 2, 2, 5 }, { 0, 2, 5 }, { 1, 1, 5 }, { 3, 1, 5 },
                    { 3, 3, 5 }, { 1, 3, 5 } },
    { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 } });
}

/** The filter, and what it says. */
struct FilterRun
{
  vtkNew<vtkRobustTetrahedralize> Filter;
  std::vector<std::string> Warnings;
  std::vector<std::string> Errors;

  explicit FilterRun(vtkPolyData* input, int dimension = 0)
  {
    this->Listen(vtkCommand::WarningEvent, this->Warnings);
    this->Listen(vtkCommand::ErrorEvent, this->Errors);
    vtkNew<vtkCallbackCommand> silence;
    silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
    this->Filter->SetInputData(input);
    this->Filter->SetDimension(dimension);
  }

  void Listen(unsigned long event, std::vector<std::string>& texts)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&texts);
    command->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
      { static_cast<std::vector<std::string>*>(all)->push_back(static_cast<const char*>(text)); });
    this->Filter->AddObserver(event, command);
  }

  double Statistic(const std::string& name)
  {
    vtkDataArray* array =
      this->Filter->GetOutput()->GetFieldData()->GetArray(("Statistics_" + name).c_str());
    return array ? array->GetTuple1(0) : std::nan("");
  }
};

/** The signed area of a grid's triangles, seen from above. */
double AreaOf(vtkUnstructuredGrid* grid)
{
  double area = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(grid->GetCellType(c), VTK_TRIANGLE);
    Place p[3];
    for (int k = 0; k < 3; ++k)
    {
      grid->GetPoint(grid->GetCell(c)->GetPointId(k), p[k].data());
    }
    area +=
      ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])) / 2;
  }
  return area;
}

TEST(vtkRobustTetrahedralizeInAPlane, MakesTrianglesOfLinesThatCrossAndSaysSo)
{
  FilterRun run(TwoSquares());
  run.Filter->Update();
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_NE(run.Warnings[0].find("the input is lines: two dimensions"), std::string::npos);
  vtkUnstructuredGrid* grid = run.Filter->GetOutput();
  EXPECT_DOUBLE_EQ(AreaOf(grid), 7);
  EXPECT_DOUBLE_EQ(run.Statistic("Area"), 7);
  EXPECT_EQ(run.Statistic("Dimension"), 2);
  EXPECT_EQ(run.Statistic("IntersectingPairs"), 2);
  EXPECT_EQ(run.Statistic("Regions"), 1);
  EXPECT_EQ(run.Statistic("MaximumW"), 2);
  EXPECT_EQ(grid->GetCellData()->GetArray("FacetIds")->GetNumberOfComponents(), 3);
  EXPECT_EQ(grid->GetCellData()->GetArray("FacetMultiplicity")->GetNumberOfComponents(), 3);
  EXPECT_EQ(run.Filter->GetOutliers()->GetNumberOfCells(), 0);

  vtkDataArray* original = grid->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* linear = grid->GetPointData()->GetArray("Linear");
  int added = 0;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    Place place;
    grid->GetPoint(p, place.data());
    EXPECT_EQ(place[2], 5);
    EXPECT_DOUBLE_EQ(linear->GetTuple1(p), 1 + 2 * place[0] - 3 * place[1]);
    added += original->GetTuple1(p) < 0;
  }
  EXPECT_EQ(added, 2);
}

TEST(vtkRobustTetrahedralizeInAPlane, GivesABoundaryOfPolylinesWithTheInsideOnTheirLeft)
{
  const Data input = TwoSquares();
  FilterRun run(input, 2);
  run.Filter->Update();
  EXPECT_TRUE(run.Warnings.empty());
  vtkPolyData* boundary = run.Filter->GetBoundary();
  double area = 0;
  std::set<vtkIdType> sources;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < boundary->GetNumberOfLines(); ++line)
  {
    boundary->GetCellPoints(line, ids);
    sources.insert(static_cast<vtkIdType>(
      boundary->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(line)));
    for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      Place p, q;
      boundary->GetPoint(ids->GetId(k), p.data());
      boundary->GetPoint(ids->GetId(k + 1), q.data());
      area += (p[0] * q[1] - p[1] * q[0]) / 2;
    }
  }
  EXPECT_DOUBLE_EQ(area, 7);
  EXPECT_EQ(boundary->GetNumberOfLines(), 2);
  EXPECT_EQ(sources, (std::set<vtkIdType>{ 0, 1 }));
  EXPECT_NE(boundary->GetCellData()->GetArray("Turned"), nullptr);
  EXPECT_NE(boundary->GetCellData()->GetArray("BoundaryTag"), nullptr);
}

TEST(vtkRobustTetrahedralizeInAPlane, TakesPolygonsInOnePlaneThatMayOverlap)
{
  // Two squares that overlap, the second one seen from below, in the plane z = x.
  const Data input = MakeData({ { 0, 0, 0 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 0 }, { 1, 1, 1 },
                                { 3, 1, 3 }, { 3, 4, 3 }, { 1, 4, 1 } },
    {}, { { 0, 1, 2, 3 }, { 7, 6, 5, 4 } });
  FilterRun run(input);
  run.Filter->Update();
  ASSERT_EQ(run.Warnings.size(), 2u);
  EXPECT_NE(run.Warnings[0].find("the polygons lie in one plane"), std::string::npos);
  EXPECT_NE(run.Warnings[1].find("1 polygons face the other way"), std::string::npos);
  EXPECT_NEAR(run.Statistic("Area"), (4 + 6 - 1) * std::sqrt(2), 1e-12);
  EXPECT_EQ(run.Statistic("MaximumW"), 2);
  vtkUnstructuredGrid* grid = run.Filter->GetOutput();
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    Place place;
    grid->GetPoint(p, place.data());
    EXPECT_EQ(place[0], place[2]);
  }
  vtkDataArray* turned = grid->GetFieldData()->GetArray("TurnedCellIds");
  ASSERT_EQ(turned->GetNumberOfTuples(), 1);
}

TEST(vtkRobustTetrahedralizeInAPlane, GivesAFlatMeshItsOwnTriangles)
{
  // A square ring of eight triangles around a hole.
  std::vector<Place> places;
  for (const double r : { 1.0, 2.0 })
  {
    for (const auto& [x, y] :
      { std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1) })
    {
      places.push_back({ x * r, y * r, 0 });
    }
  }
  Cells triangles;
  for (vtkIdType k = 0; k < 4; ++k)
  {
    const vtkIdType next = (k + 1) % 4;
    triangles.push_back({ 4 + k, 4 + next, next });
    triangles.push_back({ 4 + k, next, k });
  }
  FilterRun run(MakeData(places, {}, triangles));
  run.Filter->Update();
  std::set<std::set<vtkIdType>> wanted;
  for (const auto& triangle : triangles)
  {
    wanted.insert({ triangle.begin(), triangle.end() });
  }
  std::set<std::set<vtkIdType>> made;
  vtkUnstructuredGrid* grid = run.Filter->GetOutput();
  vtkDataArray* original = grid->GetPointData()->GetArray("vtkOriginalPointIds");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    std::set<vtkIdType> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.insert(static_cast<vtkIdType>(original->GetTuple1(grid->GetCell(c)->GetPointId(k))));
    }
    made.insert(corners);
  }
  EXPECT_EQ(made, wanted);
  EXPECT_EQ(run.Statistic("TurnedSegments"), 0);
}

TEST(vtkRobustTetrahedralizeInAPlane, PutsWhatIsNotPartOfTheSolidAmongTheOutliers)
{
  const Data input = MakeData(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 5, 0, 0 }, { 5, 1, 0 }, { 6, 1, 0 } },
    { { 0, 1, 2, 3, 0 }, { 4, 5, 6 } });
  FilterRun run(input, 2);
  run.Filter->Update();
  vtkPolyData* outliers = run.Filter->GetOutliers();
  ASSERT_EQ(outliers->GetNumberOfLines(), 1);
  EXPECT_EQ(outliers->GetCell(0)->GetNumberOfPoints(), 3);
  EXPECT_EQ(outliers->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(0), 1);
  EXPECT_EQ(outliers->GetCellData()->GetArray("OutlierReason")->GetTuple1(0),
    vtkRobustTetrahedralize::OUTLIER_BY_ENERGY);
  EXPECT_DOUBLE_EQ(AreaOf(run.Filter->GetOutput()), 1);

  run.Filter->ConstrainFacetsOn();
  run.Filter->Update();
  EXPECT_EQ(run.Filter->GetOutliers()->GetNumberOfCells(), 0);
  run.Filter->ConstrainFacetsOff();
  run.Filter->ExtractInsideOff();
  run.Filter->Update();
  EXPECT_EQ(run.Filter->GetOutput()->GetNumberOfPoints(), 7);
  EXPECT_NE(run.Filter->GetOutput()->GetCellData()->GetArray("Inside"), nullptr);
}

TEST(vtkRobustTetrahedralizeInAPlane, RefusesWhatIsNotFlatAndWhatItCannotRefine)
{
  const Data bent =
    MakeData({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0.1 }, { 0, 1, 0 } }, { { 0, 1, 2, 3, 0 } });
  FilterRun first(bent);
  first.Filter->Update();
  ASSERT_EQ(first.Errors.size(), 1u);
  EXPECT_NE(first.Errors[0].find("does not lie in a plane"), std::string::npos);
  EXPECT_EQ(first.Filter->GetOutput()->GetNumberOfCells(), 0);

  FilterRun second(TwoSquares());
  second.Filter->RefineOn();
  second.Filter->SetSurface(vtkRobustTetrahedralize::REMESHED);
  second.Filter->Update();
  ASSERT_EQ(second.Errors.size(), 1u);
  EXPECT_NE(second.Errors[0].find("not remeshed"), std::string::npos);
  second.Filter->SetSurface(vtkRobustTetrahedralize::SPLIT);
  second.Filter->QuadraticCellsOn();
  second.Filter->Update();
  ASSERT_EQ(second.Errors.size(), 2u);
  EXPECT_NE(second.Errors[1].find("QuadraticCells"), std::string::npos);

  FilterRun third(TwoSquares(), 1);
  third.Filter->Update();
  ASSERT_EQ(third.Errors.size(), 1u);
  EXPECT_NE(third.Errors[0].find("Dimension is 2, 3, or 0"), std::string::npos);
}

TEST(vtkRobustTetrahedralizeInAPlane, RefinesTheTrianglesAndCarriesTheirData)
{
  FilterRun run(TwoSquares(), 2);
  run.Filter->RefineOn();
  run.Filter->SetSurface(vtkRobustTetrahedralize::SPLIT);
  run.Filter->SetEdgeLength(0.2);
  run.Filter->Update();
  vtkUnstructuredGrid* grid = run.Filter->GetOutput();
  EXPECT_GT(grid->GetNumberOfCells(), 300);
  EXPECT_EQ(run.Statistic("RefinedCells"), static_cast<double>(grid->GetNumberOfCells()));
  EXPECT_LT(run.Statistic("InsideCells"), 20);
  EXPECT_GT(run.Statistic("MinAngle"), 20.7);
  EXPECT_NEAR(AreaOf(grid), 7, 1e-12);
  EXPECT_DOUBLE_EQ(run.Statistic("Area"), 7);
  vtkDataArray* original = grid->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* linear = grid->GetPointData()->GetArray("Linear");
  std::set<double> kept;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    Place place;
    grid->GetPoint(p, place.data());
    EXPECT_EQ(place[2], 5);
    EXPECT_NEAR(linear->GetTuple1(p), 1 + 2 * place[0] - 3 * place[1], 1e-12);
    if (original->GetTuple1(p) >= 0)
    {
      kept.insert(original->GetTuple1(p));
    }
  }
  EXPECT_EQ(kept.size(), 8u);
  // w is 2 where both squares are, and no triangle is in two of the three parts.
  double area = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    Place middle{ { 0, 0, 0 } };
    for (int k = 0; k < 3; ++k)
    {
      Place place;
      grid->GetPoint(grid->GetCell(c)->GetPointId(k), place.data());
      middle[0] += place[0] / 3;
      middle[1] += place[1] / 3;
    }
    const bool isInBoth = 1 < middle[0] && middle[0] < 2 && 1 < middle[1] && middle[1] < 2;
    EXPECT_EQ(grid->GetCellData()->GetArray("w")->GetTuple1(c), isInBoth ? 2 : 1);
    EXPECT_EQ(grid->GetCellData()->GetArray("RegionId")->GetTuple1(c), 0);
  }
  vtkPolyData* boundary = run.Filter->GetBoundary();
  EXPECT_EQ(boundary->GetNumberOfLines(), 2); // one per square
  EXPECT_GT(boundary->GetNumberOfPoints(), 40);
  EXPECT_EQ(boundary->GetPointData()->GetArray("Linear")->GetNumberOfTuples(),
    boundary->GetNumberOfPoints());
  for (vtkIdType line = 0; line < boundary->GetNumberOfLines(); ++line)
  {
    vtkCell* cell = boundary->GetCell(line);
    for (vtkIdType k = 0; k + 1 < cell->GetNumberOfPoints(); ++k)
    {
      Place p, q;
      boundary->GetPoint(cell->GetPointId(k), p.data());
      boundary->GetPoint(cell->GetPointId(k + 1), q.data());
      area += (p[0] * q[1] - p[1] * q[0]) / 2;
    }
  }
  EXPECT_NEAR(area, 7, 1e-12);

  run.Filter->SetSurface(vtkRobustTetrahedralize::KEPT);
  run.Filter->Update();
  EXPECT_EQ(run.Filter->GetBoundary()->GetNumberOfPoints(), 8);
  EXPECT_GT(run.Filter->GetOutput()->GetNumberOfCells(), 100);
}

TEST(StagesInAPlane, GiveTheSameTrianglesAsAllAtOnce)
{
  vtkNew<vtkResolveSelfIntersections> resolve;
  resolve->SetInputData(TwoSquares());
  vtkNew<vtkConstrainedDelaunay3D> triangulate;
  triangulate->SetInputConnection(resolve->GetOutputPort());
  vtkNew<vtkGeneralizedWindingNumber> windingNumber;
  windingNumber->SetInputData(TwoSquares());
  vtkNew<vtkGraphCutSegmentation> segmentation;
  segmentation->SetInputConnection(windingNumber->GetOutputPort());
  FilterRun run(TwoSquares(), 2);
  run.Filter->ExtractInsideOff();
  std::vector<std::string> warnings;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&warnings);
  keep->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
    { static_cast<std::vector<std::string>*>(all)->push_back(static_cast<const char*>(text)); });
  for (vtkAlgorithm* filter : std::vector<vtkAlgorithm*>{ resolve, triangulate, windingNumber })
  {
    filter->AddObserver(vtkCommand::WarningEvent, keep);
  }
  triangulate->Update();
  segmentation->Update();
  run.Filter->Update();
  EXPECT_EQ(
    std::count_if(warnings.begin(), warnings.end(),
      [](const std::string& text) { return text.find("two dimensions") != std::string::npos; }),
    3);

  EXPECT_EQ(resolve->GetOutput()->GetNumberOfPoints(), 10);
  EXPECT_EQ(resolve->GetOutput()->GetNumberOfLines(), 4); // two crossings, in each two polylines
  const vtkIdType cells = run.Filter->GetOutput()->GetNumberOfCells();
  EXPECT_EQ(triangulate->GetOutput()->GetNumberOfCells(), cells);
  EXPECT_EQ(windingNumber->GetOutput()->GetNumberOfCells(), cells);
  EXPECT_DOUBLE_EQ(AreaOf(triangulate->GetOutput()), AreaOf(windingNumber->GetOutput()));
  EXPECT_DOUBLE_EQ(AreaOf(segmentation->GetOutput()), 7);
}

TEST(QueriesInAPlane, GiveTheWindingNumberOfLines)
{
  const Data places =
    MakeData({ { 0.5, 0.5, 0 }, { 1.5, 1.5, 5 }, { 2.5, 0.5, 5 }, { 2.5, 2.5, 9 } }, {});
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(places);
  probe->SetSurfaceData(TwoSquares());
  probe->Update();
  vtkNew<vtkImplicitWindingNumber> implicit;
  implicit->SetInput(TwoSquares());
  const double wanted[4] = { 1, 2, 0, 1 };
  vtkDataArray* w = probe->GetOutput()->GetPointData()->GetArray("w");
  for (vtkIdType p = 0; p < 4; ++p)
  {
    EXPECT_EQ(w->GetTuple1(p), wanted[p]);
    EXPECT_EQ(probe->IsInside(p), wanted[p] > 0.5);
    EXPECT_EQ(implicit->FunctionValue(places->GetPoint(p)), 0.5 - wanted[p]);
  }
}

TEST(vtkSurfaceDefectsInAPlane, MarksOpenEndsCrossingsTJunctionsAndDuplicates)
{
  // A cross, a line that ends within another, the same line twice, one without length.
  const Data input = MakeData({ { 0, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 2, 0, 0 }, { 5, 0, 0 },
                                { 7, 0, 0 }, { 6, 0, 0 }, { 6, 3, 0 } },
    { { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 }, { 0, 1 }, { 5, 5 } });
  vtkNew<vtkSurfaceDefects> defects;
  defects->SetInputData(input);
  defects->Update();
  vtkCellData* cells = defects->GetOutput()->GetCellData();
  const auto expect = [&](const char* array, const std::vector<int>& wanted)
  {
    for (std::size_t c = 0; c < wanted.size(); ++c)
    {
      EXPECT_EQ(cells->GetArray(array)->GetTuple1(static_cast<vtkIdType>(c)), wanted[c])
        << array << " of cell " << c;
    }
  };
  expect("ComponentId", { 0, 1, 2, 3, 0, -1 });
  expect("SelfIntersections", { 1, 1, 1, 0, 1, 0 });
  expect("Duplicate", { 0, 0, 0, 0, 1, 0 });
  expect("Degenerate", { 0, 0, 0, 0, 0, 1 });
  vtkPolyData* points = defects->GetLines();
  std::array<int, 3> count{ { 0, 0, 0 } };
  for (vtkIdType p = 0; p < points->GetNumberOfVerts(); ++p)
  {
    const int type = static_cast<int>(points->GetCellData()->GetArray("DefectType")->GetTuple1(p));
    ++count[type - vtkSurfaceDefects::OPEN_END];
    if (type == vtkSurfaceDefects::CROSSING)
    {
      EXPECT_EQ(points->GetPoint(p)[0], 1);
      EXPECT_EQ(points->GetPoint(p)[1], 1);
      EXPECT_EQ(points->GetPointData()->GetArray("vtkOriginalPointIds")->GetTuple1(p), -1);
    }
  }
  EXPECT_EQ(count, (std::array<int, 3>{ { 8, 1, 1 } }));
}

TEST(StagesInAPlane, RefuseToTriangulateWhatCrosses)
{
  vtkNew<vtkConstrainedDelaunay3D> triangulate;
  triangulate->SetInputData(TwoSquares());
  std::vector<std::string> errors;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&errors);
  keep->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
    { static_cast<std::vector<std::string>*>(all)->push_back(static_cast<const char*>(text)); });
  triangulate->AddObserver(vtkCommand::ErrorEvent, keep);
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  triangulate->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  triangulate->Update();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("the first of 2 pairs of segments"), std::string::npos);
  EXPECT_EQ(triangulate->GetOutput()->GetNumberOfCells(), 0);
}

TEST(vtkRobustTetrahedralizeInAPlane, CanBeStoppedInEveryStage)
{
  struct Stopper
  {
    int Reports = 0;
    int StopAt = 0;
  };
  FilterRun first(TwoSquares(), 2);
  first.Filter->Update();
  const vtkIdType whole = first.Filter->GetOutput()->GetNumberOfCells();
  for (int stopAt = 1; stopAt <= 200; ++stopAt)
  {
    FilterRun run(TwoSquares(), 2);
    Stopper stopper{ 0, stopAt };
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&stopper);
    command->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* count = static_cast<Stopper*>(data);
        if (++count->Reports == count->StopAt)
        {
          static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
        }
      });
    run.Filter->AddObserver(vtkCommand::ProgressEvent, command);
    run.Filter->Update();
    EXPECT_TRUE(run.Errors.empty());
    if (stopper.Reports < stopAt)
    {
      EXPECT_GT(stopAt, 7); // there are so many stages
      return;
    }
    const vtkIdType cells = run.Filter->GetOutput()->GetNumberOfCells();
    EXPECT_TRUE(cells == 0 || cells == whole) << "stopped at report " << stopAt;
  }
  FAIL() << "reports without end";
}
} // namespace
