// SPDX-License-Identifier: GPL-3.0-or-later
#include "Statistics.h"
#include "Support/AllowedThreads.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkRobustTetrahedralize.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{
void AddBox(vtkPolyData* surface, std::array<double, 3> low, double size)
{
  const vtkIdType first = surface->GetNumberOfPoints();
  for (int i = 0; i < 8; ++i)
  {
    surface->GetPoints()->InsertNextPoint(
      low[0] + (i & 1 ? size : 0), low[1] + (i & 2 ? size : 0), low[2] + (i & 4 ? size : 0));
  }
  const vtkIdType quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& quad : quads)
  {
    surface->GetPolys()->InsertNextCell(4);
    for (const vtkIdType corner : quad)
    {
      surface->GetPolys()->InsertCellPoint(first + corner);
    }
  }
}

/** 27 places, at each two boxes that cross. */
vtkSmartPointer<vtkPolyData> Assembly()
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  surface->SetPoints(points);
  surface->SetPolys(vtkNew<vtkCellArray>());
  for (int i = 0; i < 27; ++i)
  {
    const std::array<double, 3> low = { 4.0 * (i % 3), 4.0 * (i / 3 % 3), 4.0 * (i / 9) };
    AddBox(surface, low, 1);
    AddBox(surface, { low[0] + 0.5, low[1] + 0.25, low[2] + 0.125 }, 1 + i / 64.0);
  }
  return surface;
}

/** The texts of events of an Update, without the executive's. */
std::vector<std::string> TextsOf(vtkAlgorithm* algorithm, unsigned long event)
{
  std::vector<std::string> texts;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&texts);
  listen->SetCallback([](vtkObject*, unsigned long, void* heard, void* text)
    { static_cast<std::vector<std::string>*>(heard)->push_back(static_cast<const char*>(text)); });
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  const unsigned long heard = algorithm->AddObserver(event, listen);
  const unsigned long silenced =
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  algorithm->Update();
  algorithm->RemoveObserver(heard);
  algorithm->GetExecutive()->RemoveObserver(silenced);
  return texts;
}

void ExpectRefused(vtkRobustTetrahedralize* filter, const std::string& words)
{
  const std::vector<std::string> errors = TextsOf(filter, vtkCommand::ErrorEvent);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find(words), std::string::npos) << errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

using Corner = std::pair<std::array<double, 3>, vtkIdType>;

/** Each triangle by its corners, from the lowest on: place and input point; and its input cell. */
std::vector<std::pair<std::array<Corner, 3>, vtkIdType>> TrianglesOf(vtkPolyData* boundary)
{
  vtkDataArray* originalPoints = boundary->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* originalCells = boundary->GetCellData()->GetArray("vtkOriginalCellIds");
  std::vector<std::pair<std::array<Corner, 3>, vtkIdType>> triangles;
  for (vtkIdType c = 0; c < boundary->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    boundary->GetCellPoints(c, ids);
    std::array<Corner, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      boundary->GetPoint(ids->GetId(k), corners[k].first.data());
      corners[k].second = static_cast<vtkIdType>(originalPoints->GetTuple1(ids->GetId(k)));
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.emplace_back(corners, static_cast<vtkIdType>(originalCells->GetTuple1(c)));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/** Points, corners and w, bit by bit. */
std::vector<double> BitsOf(vtkUnstructuredGrid* solid)
{
  std::vector<double> bits;
  for (vtkIdType p = 0; p < solid->GetNumberOfPoints(); ++p)
  {
    const double* place = solid->GetPoint(p);
    bits.insert(bits.end(), place, place + 3);
  }
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> corners;
    solid->GetCellPoints(c, corners);
    bits.insert(bits.end(), corners->begin(), corners->end());
    bits.push_back(solid->GetCellData()->GetArray("w")->GetTuple1(c));
  }
  return bits;
}
} // namespace

TEST(PartsApart, GiveTheSameSolid)
{
  vtkNew<vtkRobustTetrahedralize> whole;
  whole->SetInputData(Assembly());
  whole->Update();
  vtkNew<vtkRobustTetrahedralize> apart;
  apart->SetInputData(Assembly());
  apart->PartsApartOn();
  apart->Update();
  EXPECT_EQ(StatisticOf(whole->GetOutput(), "PartsApart"), -1);
  EXPECT_EQ(StatisticOf(apart->GetOutput(), "PartsApart"), 27);
  EXPECT_EQ(StatisticOf(apart->GetOutput(), "SurfaceSteinerPoints"), 0);
  EXPECT_GT(apart->GetBoundary()->GetNumberOfCells(), 27 * 12);
  EXPECT_EQ(TrianglesOf(apart->GetBoundary()), TrianglesOf(whole->GetBoundary()));
  EXPECT_EQ(apart->GetOutliers()->GetNumberOfCells(), whole->GetOutliers()->GetNumberOfCells());
  for (const char* same : { "Regions", "Components", "IntersectingPairs", "SolidComponents",
         "Genus", "OutlierFacets", "Closed", "MaximumW" })
  {
    const std::string name = std::string(same);
    EXPECT_EQ(StatisticOf(apart->GetOutput(), name), StatisticOf(whole->GetOutput(), name)) << name;
  }
  for (const char* near : { "Volume", "CenterOfMassX", "InertiaXX", "InertiaYZ" })
  {
    const std::string name = std::string(near);
    const double expected = StatisticOf(whole->GetOutput(), name);
    EXPECT_NEAR(StatisticOf(apart->GetOutput(), name), expected, 1e-9 * std::abs(expected)) << name;
  }
  const auto weigh = [](vtkRobustTetrahedralize* filter)
  {
    vtkDataArray* volumes = filter->GetOutput()->GetFieldData()->GetArray("RegionVolume");
    std::vector<double> sorted;
    for (vtkIdType r = 0; r < volumes->GetNumberOfTuples(); ++r)
    {
      sorted.push_back(volumes->GetTuple1(r));
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const std::vector<double> volumes = weigh(whole);
  const std::vector<double> found = weigh(apart);
  ASSERT_EQ(found.size(), volumes.size());
  for (std::size_t r = 0; r < volumes.size(); ++r)
  {
    EXPECT_NEAR(found[r], volumes[r], 1e-12) << r;
  }
}

TEST(PartsApart, AreTheSameOnAnyNumberOfThreadsAndWhenTheCutChanges)
{
  std::vector<double> expected;
  for (const int number : { 1, 2, 8 })
  {
    const testthreads::Allowed threads(number);
    vtkNew<vtkRobustTetrahedralize> apart;
    apart->SetInputData(Assembly());
    apart->PartsApartOn();
    apart->Update();
    const double seconds = StatisticOf(apart->GetOutput(), "SecondsCDT");
    expected = expected.empty() ? BitsOf(apart->GetOutput()) : expected;
    EXPECT_EQ(BitsOf(apart->GetOutput()), expected) << number;
    apart->SetGamma(1.5);
    apart->Update();
    EXPECT_EQ(BitsOf(apart->GetOutput()), expected) << number;
    EXPECT_EQ(StatisticOf(apart->GetOutput(), "SecondsCDT"), seconds)
      << "it was tetrahedralized anew";
    apart->PartsApartOff();
    apart->Update();
    EXPECT_EQ(StatisticOf(apart->GetOutput(), "PartsApart"), -1);
  }
}

TEST(PartsApart, HullsAreThoseOfTheParts)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(Assembly());
  filter->GenerateHullOn();
  filter->Update();
  const vtkIdType whole = filter->GetHull()->GetNumberOfCells();
  filter->PartsApartOn();
  filter->Update();
  EXPECT_LT(filter->GetHull()->GetNumberOfCells(), whole);
  EXPECT_EQ(filter->GetHull()->GetNumberOfCells(), StatisticOf(filter->GetOutput(), "HullCells"));
}

TEST(PartsApart, RefuseWhatTakesOneHull)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(Assembly());
  filter->PartsApartOn();
  for (const int topology : { vtkGraphCutSegmentation::TOPOLOGY_ONE_COMPONENT,
         vtkGraphCutSegmentation::TOPOLOGY_SIMPLY_CONNECTED })
  {
    filter->GetSegmentation()->SetTopology(topology);
    ExpectRefused(filter, "Topology takes one hull, and PartsApart");
  }
  filter->GetSegmentation()->SetTopology(vtkGraphCutSegmentation::TOPOLOGY_ANY);
  filter->SetBodyArrayName("Part");
  ExpectRefused(filter, "PartsApart takes one body, and BodyArrayName");
  filter->SetBodyArrayName("");
  EXPECT_TRUE(TextsOf(filter, vtkCommand::ErrorEvent).empty());
}

TEST(PartsApart, ASeedBetweenThemThatIsToBeInsideDoesNotCountAndAWarningSaysSo)
{
  vtkNew<vtkPolyData> seeds;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(3, 3, 3);
  points->InsertNextPoint(0.25, 0.125, 0.0625);
  vtkNew<vtkIntArray> inside;
  inside->SetName("Inside");
  inside->InsertNextValue(1);
  inside->InsertNextValue(0);
  seeds->SetPoints(points);
  seeds->GetPointData()->AddArray(inside);
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(Assembly());
  filter->SetSeedsData(seeds);
  filter->PartsApartOn();
  const std::vector<std::string> warnings = TextsOf(filter, vtkCommand::WarningEvent);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
    [](const std::string& warning)
    {
      return warning.find("seed 0 is to be inside, but lies beyond all cells") != std::string::npos;
    }));
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "SeedConflicts"), 1);
}

TEST(PartsApart, StopAndThenGiveTheSolid)
{
  const testthreads::Allowed threads(4);
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputData(Assembly());
  filter->PartsApartOn();
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* stopped = vtkRobustTetrahedralize::SafeDownCast(caller);
      if (stopped->GetProgressText() &&
        std::string(stopped->GetProgressText()).find("etrahedral") != std::string::npos)
      {
        stopped->SetAbortExecute(1);
      }
    });
  const unsigned long observer = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_TRUE(TextsOf(filter, vtkCommand::ErrorEvent).empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->RemoveObserver(observer);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(StatisticOf(filter->GetOutput(), "PartsApart"), 27);
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
}
