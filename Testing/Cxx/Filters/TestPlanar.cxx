// SPDX-License-Identifier: GPL-3.0-or-later
// vtkRobustTriangulate, and what the other classes do in a plane. The laws stand in
// Cxx/Core/Planar.
#include "Listener.h"
#include "Statistics.h"
#include "vtkBoundaryLayers.h"
#include "vtkConstrainedDelaunay3D.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkProbeWindingNumber.h"
#include "vtkRefineTetrahedra.h"
#include "vtkResolveSelfIntersections.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkRobustTriangulate.h"
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
#include <limits>
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
  vtkNew<vtkRobustTriangulate> Filter;
  std::vector<std::string> Warnings;
  std::vector<std::string> Errors;

  explicit FilterRun(vtkPolyData* input)
  {
    this->Listen(vtkCommand::WarningEvent, this->Warnings);
    this->Listen(vtkCommand::ErrorEvent, this->Errors);
    vtkNew<vtkCallbackCommand> silence;
    silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
    this->Filter->SetInputData(input);
  }

  void Listen(unsigned long event, std::vector<std::string>& texts)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&texts);
    command->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
      { static_cast<std::vector<std::string>*>(all)->push_back(static_cast<const char*>(text)); });
    this->Filter->AddObserver(event, command);
  }

  double Statistic(const std::string& name) { return StatisticOf(this->Filter->GetOutput(), name); }
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

TEST(vtkRobustTriangulate, MakesTrianglesOfLinesThatCross)
{
  FilterRun run(TwoSquares());
  run.Filter->Update();
  EXPECT_TRUE(run.Warnings.empty());
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

TEST(vtkRobustTriangulate, GivesABoundaryOfPolylinesWithTheInsideOnTheirLeft)
{
  const Data input = TwoSquares();
  FilterRun run(input);
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

TEST(vtkRobustTriangulate, TakesPolygonsInOnePlaneThatMayOverlap)
{
  // Two squares that overlap, the second one seen from below, in the plane z = x.
  const Data input = MakeData({ { 0, 0, 0 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 0 }, { 1, 1, 1 },
                                { 3, 1, 3 }, { 3, 4, 3 }, { 1, 4, 1 } },
    {}, { { 0, 1, 2, 3 }, { 7, 6, 5, 4 } });
  FilterRun run(input);
  run.Filter->Update();
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_NE(run.Warnings[0].find("1 polygons face the other way"), std::string::npos);
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

TEST(vtkRobustTriangulate, GivesAFlatMeshItsOwnTriangles)
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

TEST(vtkRobustTriangulate, PutsWhatIsNotPartOfTheSolidAmongTheOutliers)
{
  const Data input = MakeData(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 5, 0, 0 }, { 5, 1, 0 }, { 6, 1, 0 } },
    { { 0, 1, 2, 3, 0 }, { 4, 5, 6 } });
  FilterRun run(input);
  run.Filter->Update();
  vtkPolyData* outliers = run.Filter->GetOutliers();
  ASSERT_EQ(outliers->GetNumberOfLines(), 1);
  EXPECT_EQ(outliers->GetCell(0)->GetNumberOfPoints(), 3);
  EXPECT_EQ(outliers->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(0), 1);
  EXPECT_EQ(outliers->GetCellData()->GetArray("OutlierReason")->GetTuple1(0),
    vtkRobustTetrahedralize::OUTLIER_BY_ENERGY);
  EXPECT_DOUBLE_EQ(AreaOf(run.Filter->GetOutput()), 1);

  run.Filter->SetConstrainFacets(true);
  run.Filter->Update();
  EXPECT_EQ(run.Filter->GetOutliers()->GetNumberOfCells(), 0);
  run.Filter->SetConstrainFacets(false);
  run.Filter->GenerateHullOn();
  run.Filter->Update();
  EXPECT_EQ(run.Filter->GetHull()->GetNumberOfPoints(), 7);
  EXPECT_NE(run.Filter->GetHull()->GetCellData()->GetArray("Inside"), nullptr);
}

TEST(vtkRobustTriangulate, RefusesWhatIsNotFlatAndWhatItCannotRefine)
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
  second.Filter->GetRefinement()->SetSurfaceTreatment(vtkRefineTetrahedra::REMESHED);
  second.Filter->Update();
  ASSERT_EQ(second.Errors.size(), 1u);
  EXPECT_NE(second.Errors[0].find("not remeshed"), std::string::npos);
  second.Filter->GetRefinement()->SetSurfaceTreatment(vtkRefineTetrahedra::SPLIT);
  second.Filter->GetRefinement()->QuadraticCellsOn();
  second.Filter->Update();
  ASSERT_EQ(second.Errors.size(), 2u);
  EXPECT_NE(second.Errors[1].find("QuadraticCells"), std::string::npos);
}

TEST(vtkRobustTriangulate, RefinesTheTrianglesAndCarriesTheirData)
{
  FilterRun run(TwoSquares());
  run.Filter->RefineOn();
  run.Filter->SetEdgeLength(0.2); // which splits lines, too
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

  run.Filter->GetRefinement()->SetSurfaceTreatment(vtkRefineTetrahedra::KEPT);
  run.Filter->Update();
  EXPECT_EQ(run.Filter->GetBoundary()->GetNumberOfPoints(), 8);
  EXPECT_GT(run.Filter->GetOutput()->GetNumberOfCells(), 100);
}

TEST(vtkRobustTriangulate, KeepsTheHullUntilWhatItIsMadeOfChanges)
{
  const Data input = TwoSquares();
  FilterRun run(input);
  std::set<std::string> stages;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&stages);
  listen->SetCallback(
    [](vtkObject* caller, unsigned long, void* all, void*)
    {
      if (const char* text = static_cast<vtkAlgorithm*>(caller)->GetProgressText())
      {
        static_cast<std::set<std::string>*>(all)->insert(text);
      }
    });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, listen);
  const auto meshesAgain = [&]()
  {
    stages.clear();
    run.Filter->Update();
    EXPECT_EQ(stages.count("segmenting"), 1u);
    EXPECT_DOUBLE_EQ(run.Statistic("Area"), 7);
    return stages.count("triangulating") > 0;
  };
  EXPECT_TRUE(meshesAgain());
  run.Filter->SetGamma(1);
  EXPECT_FALSE(meshesAgain());
  run.Filter->RefineOn();
  EXPECT_FALSE(meshesAgain());
  run.Filter->CountDuplicatesOn();
  EXPECT_TRUE(meshesAgain());
  run.Filter->SetOrientation(vtkRobustTriangulate::OUTWARD);
  EXPECT_TRUE(meshesAgain());
  input->Modified();
  EXPECT_TRUE(meshesAgain());
  run.Filter->ReleaseDataFlagOn();
  input->Modified();
  EXPECT_TRUE(meshesAgain());
  run.Filter->SetGamma(2);
  EXPECT_TRUE(meshesAgain());
}

TEST(vtkRobustTriangulate, GivesTheHullAndTheResolvedLinesWhereTheyAreAskedFor)
{
  FilterRun run(TwoSquares());
  run.Filter->Update();
  EXPECT_EQ(run.Filter->GetHull()->GetNumberOfCells(), 0);
  EXPECT_EQ(run.Filter->GetResolvedLines()->GetNumberOfCells(), 0);
  run.Filter->GenerateHullOn();
  run.Filter->Update();
  vtkUnstructuredGrid* hull = run.Filter->GetHull();
  EXPECT_DOUBLE_EQ(AreaOf(hull), 8);
  std::set<double> values;
  for (vtkIdType c = 0; c < hull->GetNumberOfCells(); ++c)
  {
    values.insert(hull->GetCellData()->GetArray("w")->GetTuple1(c));
  }
  EXPECT_EQ(values, (std::set<double>{ 0, 1, 2 }));
  vtkPolyData* lines = run.Filter->GetResolvedLines();
  EXPECT_EQ(lines->GetNumberOfPoints(), 10);
  EXPECT_EQ(lines->GetNumberOfLines(), 4); // two crossings, in each two polylines
  EXPECT_NE(lines->GetCellData()->GetArray("FacetMultiplicity"), nullptr);

  // A further stage by itself makes the same of the hull.
  vtkNew<vtkGraphCutSegmentation> segmentation;
  segmentation->SetInputConnection(run.Filter->GetOutputPort(3));
  segmentation->Update();
  EXPECT_DOUBLE_EQ(AreaOf(segmentation->GetOutput()), 7);
}

TEST(ClassesOfSurfaces, NameTheOneThatTakesLinesAndPolygonsInAPlane)
{
  const Data square =
    MakeData({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, {}, { { 0, 1, 2, 3 } });
  vtkNew<vtkResolveSelfIntersections> resolve;
  vtkNew<vtkConstrainedDelaunay3D> tetrahedralize;
  vtkNew<vtkGeneralizedWindingNumber> windingNumber;
  vtkNew<vtkRobustTetrahedralize> robust;
  for (vtkAlgorithm* filter :
    std::vector<vtkAlgorithm*>{ resolve, tetrahedralize, windingNumber, robust })
  {
    for (const Data& input : { TwoSquares(), square })
    {
      const bool isTaken = filter == resolve && input == square;
      std::vector<std::string> errors;
      vtkNew<vtkCallbackCommand> keep;
      keep->SetClientData(&errors);
      keep->SetCallback(
        [](vtkObject*, unsigned long, void* all, void* text) {
          static_cast<std::vector<std::string>*>(all)->push_back(static_cast<const char*>(text));
        });
      filter->AddObserver(vtkCommand::ErrorEvent, keep);
      vtkNew<vtkCallbackCommand> silence;
      silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
      filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
      filter->SetInputDataObject(input);
      filter->Update();
      filter->RemoveObserver(keep);
      ASSERT_EQ(errors.size(), isTaken ? 0u : 1u) << filter->GetClassName();
      EXPECT_TRUE(isTaken || errors[0].find("vtkRobustTriangulate") != std::string::npos);
    }
  }
  windingNumber->SetThicken(0.5);
  windingNumber->Update();
  EXPECT_GT(windingNumber->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_TRUE(vtkRobustTriangulate::IsInAPlane(square));
  EXPECT_TRUE(vtkRobustTriangulate::IsInAPlane(TwoSquares()));
  square->GetPoints()->SetPoint(2, 1, 1, 1e-3);
  EXPECT_FALSE(vtkRobustTriangulate::IsInAPlane(square));
  EXPECT_FALSE(vtkRobustTriangulate::IsInAPlane(nullptr));
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

TEST(vtkRobustTriangulate, CanBeStoppedInEveryStage)
{
  struct Stopper
  {
    int Reports = 0;
    int StopAt = 0;
  };
  FilterRun first(TwoSquares());
  first.Filter->Update();
  const vtkIdType whole = first.Filter->GetOutput()->GetNumberOfCells();
  for (int stopAt = 1; stopAt <= 200; ++stopAt)
  {
    FilterRun run(TwoSquares());
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
      EXPECT_GT(stopAt, 7); // the number of stages
      return;
    }
    const vtkIdType cells = run.Filter->GetOutput()->GetNumberOfCells();
    EXPECT_TRUE(cells == 0 || cells == whole) << "stopped at report " << stopAt;
  }
  FAIL() << "reports without end";
}
} // namespace

TEST(vtkBoundaryLayers, MakesQuadsInATiltedPlaneAndCarriesDataOver)
{
  const double c = std::sqrt(0.5);
  vtkNew<vtkRobustTriangulate> triangulate;
  const Data square = MakeData({ { 0, 0, 0 }, { c, 0, c }, { c, 1, c }, { 0, 1, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } });
  triangulate->SetInputData(square);
  triangulate->SetRefine(true);
  triangulate->SetEdgeLength(0.1);
  triangulate->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(triangulate->GetOutput());
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    heights->InsertNextValue(grid->GetPoint(p)[1]);
  }
  grid->GetPointData()->AddArray(heights);
  vtkNew<vtkBoundaryLayers> layers;
  layers->SetInputData(grid);
  layers->SetBoundaryData(triangulate->GetBoundary());
  layers->SetFirstHeight(0.01);
  layers->Update();
  vtkUnstructuredGrid* made = layers->GetOutput();
  vtkIdType quads = 0;
  for (vtkIdType cell = 0; cell < made->GetNumberOfCells(); ++cell)
  {
    const bool isQuad = made->GetCellType(cell) == VTK_QUAD;
    quads += isQuad ? 1 : 0;
    EXPECT_EQ(made->GetCellData()->GetArray("Layer")->GetTuple1(cell) > 0, isQuad);
  }
  EXPECT_EQ(quads, StatisticOf(made, "Quads"));
  EXPECT_EQ(quads, 3 * StatisticOf(made, "WallEdges"));
  EXPECT_EQ(StatisticOf(made, "FullHeightShare"), 1);
  vtkDataArray* after = made->GetPointData()->GetArray("Height");
  ASSERT_TRUE(after);
  for (vtkIdType p = 0; p < made->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(after->GetTuple1(p), made->GetPoint(p)[1], 1e-12);
    EXPECT_NEAR(made->GetPoint(p)[0], made->GetPoint(p)[2], 1e-12);
  }
  EXPECT_GT(layers->GetBoundary()->GetNumberOfLines(), 0);
  EXPECT_FALSE(made->GetCellData()->GetArray("FacetIds"));
}

TEST(vtkBoundaryLayers, NamesWhatIsWrongInAPlane)
{
  const auto gridOf = [](const std::vector<Place>& places, const Cells& cells)
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    for (const Place& place : places)
    {
      points->InsertNextPoint(place.data());
    }
    grid->SetPoints(points);
    grid->SetCells(VTK_TRIANGLE, MakeCells(cells));
    return grid;
  };
  const std::vector<Place> square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const auto good = gridOf(square, { { 0, 1, 2 }, { 0, 2, 3 } });
  const auto linesOf = [&](const Cells& lines) { return MakeData(square, lines); };
  const Data around = linesOf({ { 0, 1, 2, 3, 0 } });
  std::vector<Place> bent = square;
  bent[3][2] = 0.1;
  std::vector<Place> endless = square;
  endless[3][1] = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkUnstructuredGrid> mixed;
  mixed->SetPoints(good->GetPoints());
  mixed->Allocate(2);
  const vtkIdType ids[] = { 0, 1, 2, 3 };
  mixed->InsertNextCell(VTK_TRIANGLE, 3, ids);
  mixed->InsertNextCell(VTK_QUAD, 4, ids);
  struct Case
  {
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    Data Boundary;
    std::string Words;
  };
  const std::vector<Case> cases = { { gridOf(bent, { { 0, 1, 2 }, { 0, 2, 3 } }), nullptr,
                                      "off a plane" },
    { gridOf(square, { { 0, 1, 2 }, { 0, 3, 2 } }), nullptr, "cell 1 has no area, or runs" },
    { gridOf(square, { { 0, 1, 2 }, { 0, 1, 3 } }), nullptr,
      "the edge between points 0 and 1 has several triangles on one side" },
    { gridOf(square, { { 0, 1, 2 }, { 0, 2, 7 } }), nullptr, "cell 1 refers to point 7 of 4" },
    { mixed.Get(), nullptr, "cell 1 is of VTK's type 9" },
    { gridOf(endless, { { 0, 1, 2 }, { 0, 2, 3 } }), nullptr, "point 3 is not finite" },
    { good, MakeData(endless, { { 0, 1 } }), "point 3 is not finite" },
    { good, linesOf({ { 0, 3, 2, 1, 0 } }), "line 0 of the boundary goes from point 0 to 3" },
    { good, linesOf({ { 0, 1 }, { 0, 2 } }), "line 1 of the boundary goes from point 0 to 2" },
    { good, MakeData(square, {}, { { 0, 1, 2 } }), "cells that are not lines" } };
  for (const Case& one : cases)
  {
    vtkNew<vtkBoundaryLayers> layers;
    const Listener errors(layers, vtkCommand::ErrorEvent);
    layers->SetInputData(one.Grid);
    layers->SetBoundaryData(one.Boundary);
    layers->SetFirstHeight(0.1);
    layers->Update();
    EXPECT_TRUE(errors.Heard(one.Words)) << one.Words;
    EXPECT_EQ(layers->GetOutput()->GetNumberOfCells(), 0);
  }
  vtkNew<vtkBoundaryLayers> layers;
  layers->SetInputData(good);
  layers->SetBoundaryData(around);
  layers->SetFirstHeight(0.1);
  layers->SetLayers(1);
  layers->Update();
  EXPECT_EQ(StatisticOf(layers->GetOutput(), "Quads"), 4);
}
