// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boxes.h"
#include "Listener.h"
#include "Statistics.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkSurfaceDefects.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
/** Expect one error that holds `words` and three empty outputs; then that the filter still works.
 */
void ExpectError(vtkPolyData* surface, const std::string& words)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  Listener errors(filter, vtkCommand::ErrorEvent);
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_EQ(errors.Texts.size(), 1u);
  EXPECT_TRUE(errors.Heard(words)) << (errors.Texts.empty() ? "no error" : errors.Texts[0]);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetBoundary()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutliers()->GetNumberOfCells(), 0);

  filter->SetInputData(TwoBoxes());
  filter->Update();
  EXPECT_EQ(errors.Texts.size(), 1u);
  EXPECT_NEAR(Volume(filter->GetOutput()), 1.875, 1e-12);
}
} // namespace

TEST(vtkRobustTetrahedralize, ReplacesWhatAnotherFilterMarkedWithoutAWord)
{
  vtkNew<vtkSurfaceDefects> defects;
  defects->SetInputData(TwoBoxes());
  vtkNew<vtkRobustTetrahedralize> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputConnection(defects->GetOutputPort());
  filter->Update();
  vtkCellData* data = filter->GetBoundary()->GetCellData();
  EXPECT_TRUE(data->HasArray("Turned"));
  EXPECT_FALSE(data->HasArray("Input_Turned"));
  EXPECT_TRUE(data->HasArray("ComponentId")) << "what it does not make itself is passed on";
  EXPECT_FALSE(warnings.Heard("Turned"));
}

TEST(vtkRobustTetrahedralize, MeshesTheUnionOfOverlappingBoxes)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(TwoBoxes());
  filter->Update();
  EXPECT_NEAR(Volume(filter->GetOutput()), 2 - 0.125, 1e-12);
  EXPECT_EQ(filter->GetOutliers()->GetNumberOfCells(), 0);
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "Components"), 2);
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "MaximumW"), 2);
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "Closed"), 1);
}

TEST(vtkRobustTetrahedralize, GivesTheWholeHullWhereThatIsAskedFor)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(TwoBoxes());
  filter->Update();
  EXPECT_EQ(filter->GetHull()->GetNumberOfCells(), 0);
  filter->GenerateHullOn();
  filter->Update();
  vtkUnstructuredGrid* hull = filter->GetHull();
  const double hullVolume = Volume(hull);
  EXPECT_GT(hullVolume, 1.9);
  auto* inside = vtkUnsignedCharArray::SafeDownCast(hull->GetCellData()->GetArray("Inside"));
  auto* w = vtkDoubleArray::SafeDownCast(hull->GetCellData()->GetArray("w"));
  ASSERT_TRUE(inside && w);
  std::set<double> values;
  for (vtkIdType c = 0; c < hull->GetNumberOfCells(); ++c)
  {
    values.insert(w->GetValue(c));
    EXPECT_EQ(inside->GetValue(c), w->GetValue(c) > 0.5);
  }
  EXPECT_EQ(values, (std::set<double>{ 0, 1, 2 }));
}

TEST(vtkRobustTetrahedralize, GivesTheSameHullBesideAnySolid)
{
  vtkNew<vtkRobustTetrahedralize> plain;
  plain->SetInputData(TwoBoxes());
  plain->GenerateHullOn();
  plain->Update();
  vtkUnstructuredGrid* wanted = plain->GetHull();
  EXPECT_NEAR(wanted->GetFieldData()->GetArray("RegionVolume")->GetTuple1(0), 1.875, 1e-12);
  for (const int option : { 0, 1, 2, 3 })
  {
    vtkNew<vtkRobustTetrahedralize> filter;
    filter->SetInputData(TwoBoxes());
    filter->GenerateHullOn();
    filter->SetRefine(option == 0);
    filter->SetSeparateOverlaps(option == 1);
    filter->SetNonManifold(option == 2 ? vtkGraphCutSegmentation::NONMANIFOLD_SPLIT
                                       : vtkGraphCutSegmentation::NONMANIFOLD_KEEP);
    filter->SetSurfaceOnly(option == 3);
    filter->Update();
    vtkUnstructuredGrid* hull = filter->GetHull();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells() == 0, option == 3);
    ASSERT_EQ(hull->GetNumberOfCells(), wanted->GetNumberOfCells());
    for (const char* name : { "w", "Inside", "RegionId" })
    {
      for (vtkIdType c = 0; c < hull->GetNumberOfCells(); ++c)
      {
        ASSERT_EQ(hull->GetCellData()->GetArray(name)->GetTuple1(c),
          wanted->GetCellData()->GetArray(name)->GetTuple1(c));
      }
    }
    vtkDataArray* volumes = hull->GetFieldData()->GetArray("RegionVolume");
    ASSERT_EQ(volumes->GetNumberOfTuples(), 1);
    EXPECT_NEAR(volumes->GetTuple1(0), 1.875, 1e-12);
  }
}

TEST(vtkRobustTetrahedralize, TellsStatesOfBeforeWhereTheHullIs)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetExtractInside(true);
  EXPECT_FALSE(filter->GetGenerateHull());
  EXPECT_TRUE(warnings.Texts.empty());
  filter->SetExtractInside(false);
  EXPECT_TRUE(filter->GetGenerateHull());
  EXPECT_TRUE(warnings.Heard("output 3"));
}

TEST(vtkRobustTetrahedralize, NamesThePointThatIsNotFinite)
{
  auto surface = TwoBoxes();
  surface->GetPoints()->SetPoint(11, 0, std::nan(""), 0);
  ExpectError(surface, "point 11 is not finite");
}

TEST(vtkRobustTetrahedralize, NamesTheCellWhosePointIsOutOfRange)
{
  auto surface = TwoBoxes();
  const vtkIdType corners[3] = { 0, 1, 99 };
  surface->GetPolys()->InsertNextCell(3, corners);
  ExpectError(surface, "cell 12 refers to point 99 of 16");
}

TEST(vtkRobustTetrahedralize, SaysThatThereAreNoPolygons)
{
  ExpectError(EmptySurface(), "the surface is empty");
  auto surface = EmptySurface();
  surface->GetPoints()->InsertNextPoint(0, 0, 0);
  surface->GetPoints()->InsertNextPoint(1, 0, 0);
  const vtkIdType corners[2] = { 0, 1 };
  surface->SetLines(vtkNew<vtkCellArray>());
  surface->GetLines()->InsertNextCell(2, corners);
  ExpectError(surface, "the input is lines, which bound no volume: vtkRobustTriangulate");
}

TEST(vtkRobustTetrahedralize, SaysThatAllIsDegenerateOrFlat)
{
  auto surface = EmptySurface();
  for (int i = 0; i < 4; ++i)
  {
    surface->GetPoints()->InsertNextPoint(i, i, i);
  }
  const vtkIdType line[3] = { 0, 1, 2 };
  surface->GetPolys()->InsertNextCell(3, line);
  ExpectError(surface, "degenerate");

  surface->GetPoints()->SetPoint(2, 0, 1, 0);
  surface->GetPoints()->SetPoint(3, 1, 1, 1);
  surface->GetPoints()->SetPoint(1, 1, 0, 1);
  const vtkIdType other[3] = { 1, 3, 2 };
  surface->GetPolys()->InsertNextCell(3, other);
  ExpectError(surface, "the polygons lie in one plane and bound no volume: vtkRobustTriangulate");
}

TEST(vtkRobustTetrahedralize, CanBeStoppedInEveryStageAndRunAgain)
{
  vtkNew<vtkRobustTetrahedralize> first;
  first->SetInputData(TwoBoxes());
  first->Update();
  vtkUnstructuredGrid* undisturbed = first->GetOutput();

  struct Stopper
  {
    std::string Stage;
    bool Met = false;
  };
  for (const char* stage :
    { "validating", "finding self-intersections", "resolving self-intersections",
      "tetrahedralizing", "winding numbers", "segmenting", "extracting" })
  {
    vtkNew<vtkRobustTetrahedralize> filter;
    filter->SetInputData(TwoBoxes());
    Stopper stopper{ stage };
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(&stopper);
    observer->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        auto* wanted = static_cast<Stopper*>(data);
        if (algorithm->GetProgressText() && wanted->Stage == algorithm->GetProgressText())
        {
          wanted->Met = true;
          algorithm->SetAbortExecute(1);
        }
      });
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, observer);
    Listener errors(filter, vtkCommand::ErrorEvent);
    filter->Update();
    EXPECT_TRUE(stopper.Met) << stage;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0) << stage;
    EXPECT_TRUE(errors.Texts.empty()) << "stopping is no error: " << errors.Texts[0];

    filter->RemoveObserver(tag);
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    ASSERT_EQ(filter->GetOutput()->GetNumberOfCells(), undisturbed->GetNumberOfCells()) << stage;
    EXPECT_EQ(Volume(filter->GetOutput()), Volume(undisturbed)) << stage;
  }
}

TEST(vtkRobustTetrahedralize, DoesNotBeginWhenItIsToldToStopBefore)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(TwoBoxes());
  filter->SetAbortExecute(1);
  int stages = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&stages);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*) {
      *static_cast<int*>(data) += static_cast<vtkAlgorithm*>(caller)->GetProgressText() != nullptr;
    });
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  if (!filter->GetAbortExecute())
  {
    GTEST_SKIP() << "this VTK resets the flag when an algorithm begins";
  }
  EXPECT_EQ(stages, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(vtkRobustTetrahedralize, IsStoppedWhileTetGenHangs)
{
  struct Watch
  {
    int Reports = 0;
    const int Enough = 3;
  } watch;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&watch);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      auto* seen = static_cast<Watch*>(data);
      const char* stage = algorithm->GetProgressText();
      if (stage && std::string(stage) == "tetrahedralizing" && ++seen->Reports == seen->Enough)
      {
        algorithm->SetAbortExecute(1);
      }
    });
  const std::string helper = testing::TempDir() + "insideout-hangs-" + std::to_string(getpid());
  std::ofstream(helper) << "#!/bin/sh\nexec sleep infinity\n";
  std::filesystem::permissions(helper, std::filesystem::perms::owner_all);
  setenv("INSIDEOUT_TETGEN", helper.c_str(), 1);
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(TwoBoxes());
  filter->GetWindingNumber()->SetEngineToTetGen();
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  EXPECT_EQ(watch.Reports, watch.Enough);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  unsetenv("INSIDEOUT_TETGEN");
  std::filesystem::remove(helper);
}

TEST(vtkRobustTetrahedralize, IgnoresLinesAndVerticesWithAWarningAndKeepsCellNumbers)
{
  auto surface = TwoBoxes();
  const vtkIdType corners[2] = { 0, 1 };
  surface->SetLines(vtkNew<vtkCellArray>());
  surface->GetLines()->InsertNextCell(2, corners);
  surface->GetLines()->InsertNextCell(2, corners);
  vtkNew<vtkDoubleArray> number;
  number->SetName("number");
  for (int c = 0; c < 14; ++c)
  {
    number->InsertNextValue(c);
  }
  surface->GetCellData()->AddArray(number);
  vtkNew<vtkRobustTetrahedralize> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_TRUE(warnings.Heard("2 vertices and lines are ignored"));
  vtkCellData* boundary = filter->GetBoundary()->GetCellData();
  std::set<double> cells;
  for (vtkIdType c = 0; c < filter->GetBoundary()->GetNumberOfCells(); ++c)
  {
    cells.insert(boundary->GetArray("vtkOriginalCellIds")->GetTuple1(c));
    EXPECT_EQ(boundary->GetArray("number")->GetTuple1(c),
      boundary->GetArray("vtkOriginalCellIds")->GetTuple1(c));
  }
  std::set<double>
    expected; // each face of each box is partly on the boundary; lines are cells 0, 1
  for (int c = 2; c < 14; ++c)
  {
    expected.insert(c);
  }
  EXPECT_EQ(cells, expected);
}

TEST(vtkRobustTetrahedralize, ReadsStripsLikePolygons)
{
  auto surface = EmptySurface();
  for (int i = 0; i < 4; ++i)
  {
    surface->GetPoints()->InsertNextPoint(i & 1, i >> 1 & 1, i == 3 ? 0 : i == 0 ? 1 : 0);
  }
  // A tetrahedron as one strip: 0 1 2 3 0 1.
  surface->SetPolys(nullptr);
  surface->SetStrips(vtkNew<vtkCellArray>());
  const vtkIdType strip[6] = { 0, 1, 2, 3, 0, 1 };
  surface->GetStrips()->InsertNextCell(6, strip);
  vtkNew<vtkRobustTetrahedralize> filter;
  Listener warnings(filter, vtkCommand::WarningEvent); // it may be inside out
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_NEAR(Volume(filter->GetOutput()), 1.0 / 6, 1e-15);
}

TEST(vtkRobustTetrahedralize, TurnsASurfaceThatIsInsideOut)
{
  auto surface = EmptySurface();
  AddBox(surface, 1, 0); // the box mirrored in all axes: its normals point inward
  for (const int orientation : { vtkGeneralizedWindingNumber::AUTOMATIC,
         vtkGeneralizedWindingNumber::AS_GIVEN, vtkGeneralizedWindingNumber::REVERSE })
  {
    vtkNew<vtkRobustTetrahedralize> filter;
    Listener warnings(filter, vtkCommand::WarningEvent);
    filter->SetInputData(surface);
    filter->SetOrientation(orientation);
    filter->Update();
    const bool asGiven = orientation == vtkGeneralizedWindingNumber::AS_GIVEN;
    EXPECT_NEAR(Volume(filter->GetOutput()), asGiven ? 0 : 1, 1e-15);
    EXPECT_EQ(
      warnings.Heard("it is turned over"), orientation == vtkGeneralizedWindingNumber::AUTOMATIC);
    EXPECT_EQ(warnings.Heard("nothing is inside: w ranges from -1"), asGiven);
    EXPECT_EQ(warnings.Heard("set Orientation to Automatic"), asGiven);
  }
}

TEST(vtkRobustTetrahedralize, KnowsAPolygonAgainWhereverItBeginsAndWhicheverWayItRuns)
{
  for (const bool reversed : { false, true })
  {
    auto surface = EmptySurface();
    AddBox(surface, 0, 1);
    for (vtkIdType c = 0; c < 6; ++c)
    {
      vtkNew<vtkIdList> quad;
      surface->GetPolys()->GetCellAtId(c, quad);
      vtkIdType turned[4];
      for (int k = 0; k < 4; ++k)
      {
        turned[k] = quad->GetId(reversed ? 3 - k : (k + 1) % 4);
      }
      surface->GetPolys()->InsertNextCell(4, turned);
    }
    vtkNew<vtkRobustTetrahedralize> filter;
    Listener warnings(filter, vtkCommand::WarningEvent);
    filter->SetInputData(surface);
    filter->Update();
    EXPECT_NEAR(Volume(filter->GetOutput()), 1, 1e-15);
    EXPECT_EQ(StatisticOf(filter->GetOutput(), "DuplicateFacets"), 12);
    EXPECT_EQ(StatisticOf(filter->GetOutput(), "MaximumW"), 1);
    EXPECT_EQ(warnings.Heard("two-sided"), reversed);
  }
}

TEST(vtkRobustTetrahedralize, LeavesOutArraysOfTheWrongLengthWithAWarning)
{
  auto surface = TwoBoxes();
  for (const char* name : { "short", "FacetMultiplicity" })
  {
    vtkNew<vtkShortArray> array;
    array->SetName(name);
    array->InsertNextValue(7);
    surface->GetCellData()->AddArray(array);
    surface->GetPointData()->AddArray(array);
  }
  vtkNew<vtkRobustTetrahedralize> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_TRUE(warnings.Heard("array short has 1 tuples where 12 are needed"));
  EXPECT_TRUE(warnings.Heard("array FacetMultiplicity has 1 tuples where 16 are needed"));
  EXPECT_NEAR(Volume(filter->GetOutput()), 1.875, 1e-12);
  EXPECT_FALSE(filter->GetBoundary()->GetCellData()->HasArray("short"));
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray("short"));
}

TEST(vtkRobustTetrahedralize, TakesMultiplicitiesOfAnyIntegerTypeAndPassesOtherArraysOn)
{
  auto surface = TwoBoxes();
  vtkNew<vtkIntArray> twice; // as a file format may give it back
  vtkNew<vtkDoubleArray> real;
  for (int c = 0; c < 12; ++c)
  {
    twice->InsertNextValue(2);
    real->InsertNextValue(c);
  }
  twice->SetName("FacetMultiplicity");
  surface->GetCellData()->AddArray(twice);
  vtkNew<vtkRobustTetrahedralize> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "MaximumW"), 4);

  surface->GetCellData()->RemoveArray("FacetMultiplicity");
  real->SetName("FacetMultiplicity"); // a user's own
  surface->GetCellData()->AddArray(real);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "MaximumW"), 2);
  EXPECT_TRUE(filter->GetBoundary()->GetCellData()->HasArray("Input_FacetMultiplicity"));
  EXPECT_TRUE(warnings.Heard("Input_FacetMultiplicity"));
}

TEST(vtkRobustTetrahedralize, PassesFieldDataOn)
{
  auto surface = TwoBoxes();
  vtkNew<vtkDoubleArray> time;
  time->SetName("TimeValue");
  time->InsertNextValue(3.5);
  surface->GetFieldData()->AddArray(time);
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(surface);
  filter->Update();
  for (int port = 0; port < 3; ++port)
  {
    vtkDataArray* found = filter->GetOutputDataObject(port)->GetFieldData()->GetArray("TimeValue");
    ASSERT_TRUE(found) << port;
    EXPECT_EQ(found->GetTuple1(0), 3.5);
  }
}
