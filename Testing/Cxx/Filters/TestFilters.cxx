// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkConstrainedDelaunay3D.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkResolveSelfIntersections.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkSurfaceDefects.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
/** A box of quadrilaterals, normals outward, added to `surface`. */
void AddBox(vtkPolyData* surface, double low, double high)
{
  const vtkIdType first = surface->GetNumberOfPoints();
  for (int i = 0; i < 8; ++i)
  {
    surface->GetPoints()->InsertNextPoint(
      i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low);
  }
  const vtkIdType quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& quad : quads)
  {
    vtkIdType corners[4];
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = first + quad[k];
    }
    surface->GetPolys()->InsertNextCell(4, corners);
  }
}

vtkSmartPointer<vtkPolyData> EmptySurface()
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  surface->SetPoints(points);
  surface->SetPolys(vtkNew<vtkCellArray>());
  return surface;
}

/** Two boxes of side 1 that overlap in a box of side 1/2. */
vtkSmartPointer<vtkPolyData> TwoBoxes()
{
  auto surface = EmptySurface();
  AddBox(surface, 0, 1);
  AddBox(surface, 0.5, 1.5);
  return surface;
}

double Volume(vtkUnstructuredGrid* grid)
{
  double volume = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkPoints* p = grid->GetCell(c)->GetPoints();
    double x[4][3];
    for (int k = 0; k < 4; ++k)
    {
      p->GetPoint(k, x[k]);
    }
    const auto d = [&](int k, int i) { return x[k][i] - x[0][i]; };
    volume += (d(1, 0) * (d(2, 1) * d(3, 2) - d(2, 2) * d(3, 1)) +
                d(1, 1) * (d(2, 2) * d(3, 0) - d(2, 0) * d(3, 2)) +
                d(1, 2) * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0))) /
      6;
  }
  return volume;
}

/** Collects the texts of an algorithm's events instead of printing them. */
class Listener
{
public:
  Listener(vtkAlgorithm* algorithm, unsigned long event)
  {
    this->Command->SetClientData(&this->Texts);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* texts, void* text) {
        static_cast<std::vector<std::string>*>(texts)->push_back(static_cast<const char*>(text));
      });
    algorithm->AddObserver(event, this->Command);
    if (event == vtkCommand::ErrorEvent)
    {
      algorithm->GetExecutive()->AddObserver(event, this->Silence); // its generic line adds nothing
    }
    this->Silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  }

  bool Heard(const std::string& words) const
  {
    for (const std::string& text : this->Texts)
    {
      if (text.find(words) != std::string::npos)
      {
        return true;
      }
    }
    return false;
  }

  std::vector<std::string> Texts;

private:
  vtkNew<vtkCallbackCommand> Command;
  vtkNew<vtkCallbackCommand> Silence;
};

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

TEST(vtkRobustTetrahedralize, MeshesTheUnionOfOverlappingBoxes)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(TwoBoxes());
  filter->Update();
  EXPECT_NEAR(Volume(filter->GetOutput()), 2 - 0.125, 1e-12);
  EXPECT_EQ(filter->GetOutliers()->GetNumberOfCells(), 0);
  vtkFieldData* statistics = filter->GetOutput()->GetFieldData();
  EXPECT_EQ(statistics->GetArray("Statistics_Components")->GetTuple1(0), 2);
  EXPECT_EQ(statistics->GetArray("Statistics_MaximumW")->GetTuple1(0), 2);
  EXPECT_EQ(statistics->GetArray("Statistics_Closed")->GetTuple1(0), 1);
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
    vtkFieldData* statistics = filter->GetOutput()->GetFieldData();
    EXPECT_NEAR(Volume(filter->GetOutput()), 1, 1e-15);
    EXPECT_EQ(statistics->GetArray("Statistics_DuplicateFacets")->GetTuple1(0), 12);
    EXPECT_EQ(statistics->GetArray("Statistics_MaximumW")->GetTuple1(0), 1);
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
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("Statistics_MaximumW")->GetTuple1(0), 4);

  surface->GetCellData()->RemoveArray("FacetMultiplicity");
  real->SetName("FacetMultiplicity"); // a user's own
  surface->GetCellData()->AddArray(real);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("Statistics_MaximumW")->GetTuple1(0), 2);
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

TEST(vtkConstrainedDelaunay3D, RefusesFacetsThatCrossAndNamesTheirCells)
{
  vtkNew<vtkConstrainedDelaunay3D> filter;
  Listener errors(filter, vtkCommand::ErrorEvent);
  filter->SetInputData(TwoBoxes());
  filter->Update();
  EXPECT_TRUE(errors.Heard("intersect")) << errors.Texts.size();
  EXPECT_TRUE(errors.Heard("vtkResolveSelfIntersections"));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(vtkConstrainedDelaunay3D, TakesWhatTheResolverGivesWithItsMultiplicities)
{
  auto surface = EmptySurface();
  AddBox(surface, 0, 1);
  AddBox(surface, 0, 1); // every face twice, which counts once
  vtkNew<vtkResolveSelfIntersections> resolve;
  resolve->SetInputData(surface);
  vtkNew<vtkConstrainedDelaunay3D> mesh;
  Listener warnings(mesh, vtkCommand::WarningEvent);
  mesh->SetInputConnection(resolve->GetOutputPort());
  mesh->Update();
  vtkUnstructuredGrid* grid = mesh->GetOutput();
  EXPECT_NEAR(Volume(grid), 1, 1e-15);
  vtkDataArray* multiplicity = grid->GetCellData()->GetArray("FacetMultiplicity");
  vtkDataArray* facets = grid->GetCellData()->GetArray("FacetIds");
  ASSERT_EQ(multiplicity->GetNumberOfComponents(), 4);
  int onFacets = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const bool onFacet = facets->GetComponent(c, k) >= 0;
      EXPECT_EQ(multiplicity->GetComponent(c, k), onFacet ? 1 : 0);
      onFacets += onFacet;
    }
  }
  EXPECT_EQ(onFacets, 12);
}

TEST(vtkGraphCutSegmentation, LabelsWhatTheWindingNumberFilterGives)
{
  vtkNew<vtkGeneralizedWindingNumber> w;
  w->SetInputData(TwoBoxes());
  vtkNew<vtkGraphCutSegmentation> cut;
  cut->SetInputConnection(w->GetOutputPort());
  cut->Update();
  EXPECT_NEAR(Volume(cut->GetOutput()), 1.875, 1e-12);
  cut->ExtractInsideOff();
  cut->Update();
  EXPECT_EQ(cut->GetOutput()->GetNumberOfCells(), w->GetOutput()->GetNumberOfCells());
  EXPECT_TRUE(cut->GetOutput()->GetCellData()->GetArray("Inside"));
}

TEST(vtkGraphCutSegmentation, SeesTheSameFacesInVoxelsAsInHexahedra)
{
  constexpr int Size = 6;
  vtkIdType inside[2] = { 0, 0 };
  for (const int type : { VTK_VOXEL, VTK_HEXAHEDRON })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> w;
    w->SetName("w");
    for (int i = 0; i < (Size + 1) * (Size + 1) * (Size + 1); ++i)
    {
      points->InsertNextPoint(
        i % (Size + 1), i / (Size + 1) % (Size + 1), i / (Size + 1) / (Size + 1));
    }
    grid->SetPoints(points);
    for (int c = 0; c < Size * Size * Size; ++c)
    {
      vtkIdType corners[8];
      for (int k = 0; k < 8; ++k)
      {
        corners[k] = c % Size + (k & 1) +
          (Size + 1) * (c / Size % Size + (k >> 1 & 1) + (Size + 1) * (c / Size / Size + (k >> 2)));
      }
      if (type == VTK_HEXAHEDRON)
      {
        std::swap(corners[2], corners[3]);
        std::swap(corners[6], corners[7]);
      }
      grid->InsertNextCell(type, 8, corners);
      w->InsertNextValue((c * 7919) % 10 < 6 ? 0.55 : 0.45);
    }
    grid->GetCellData()->AddArray(w);
    vtkNew<vtkGraphCutSegmentation> cut;
    cut->SetInputData(grid);
    cut->SetGamma(10);
    cut->Update();
    inside[type == VTK_VOXEL] = cut->GetOutput()->GetNumberOfCells();
  }
  EXPECT_EQ(inside[0], Size * Size * Size) << "smoothness decides where w is unsure";
  EXPECT_EQ(inside[1], inside[0]);
}

TEST(vtkGraphCutSegmentation, SaysThatWHasNotOneValuePerCell)
{
  vtkNew<vtkGeneralizedWindingNumber> filter;
  filter->SetInputData(TwoBoxes());
  filter->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(filter->GetOutput());
  vtkNew<vtkDoubleArray> w;
  w->SetName("w");
  grid->GetCellData()->RemoveArray("w");
  grid->GetCellData()->AddArray(w);
  vtkNew<vtkGraphCutSegmentation> cut;
  Listener errors(cut, vtkCommand::ErrorEvent);
  cut->SetInputData(grid);
  cut->Update();
  EXPECT_TRUE(errors.Heard("one value per cell"));
}

TEST(vtkGraphCutSegmentation, SaysThatThereIsNoW)
{
  vtkNew<vtkGeneralizedWindingNumber> w;
  w->SetInputData(TwoBoxes());
  w->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(w->GetOutput());
  grid->GetCellData()->RemoveArray("w");
  vtkNew<vtkGraphCutSegmentation> cut;
  Listener errors(cut, vtkCommand::ErrorEvent);
  cut->SetInputData(grid);
  cut->Update();
  EXPECT_TRUE(errors.Heard("no cell array w"));
}

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

namespace
{
double CellValue(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetTuple1(cell);
}

double Statistic(vtkDataObject* data, const std::string& name)
{
  return data->GetFieldData()->GetArray(("Statistics_" + name).c_str())->GetTuple1(0);
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
    EXPECT_EQ(color[0] > 200 && color[1] == 0 && color[2] == 0, isMet) << "red where it crosses";
  }
  for (vtkPolyData* output : { surface, filter->GetLines() })
  {
    EXPECT_EQ(2 * Statistic(output, "IntersectingPairs"), crossings);
    EXPECT_EQ(Statistic(output, "Components"), 2);
    EXPECT_EQ(Statistic(output, "OpenEdges"), 0);
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
  EXPECT_EQ(Statistic(filter->GetOutput(), "NearPoints"), 2);
  EXPECT_TRUE(warnings.Heard("set MergeTolerance to"));
  filter->SetMergeTolerance(Statistic(filter->GetOutput(), "NearDistance"));
  warnings.Texts.clear();
  filter->Update();
  EXPECT_EQ(Statistic(filter->GetOutput(), "NearPoints"), 0);
  EXPECT_EQ(Statistic(filter->GetOutput(), "Points"), 15);
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
