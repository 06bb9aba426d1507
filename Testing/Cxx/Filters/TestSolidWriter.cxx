// SPDX-License-Identifier: GPL-3.0-or-later
// What vtkSolidWriter takes and refuses. The files are read in Testing/Python/TestSolidFiles.py.
#include "vtkSolidWriter.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{
/** Two tetrahedra on the face 1 2 3. */
vtkSmartPointer<vtkUnstructuredGrid> TwoCells()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p :
    { std::array<double, 3>{ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } })
  {
    points->InsertNextPoint(p.data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  const vtkIdType first[4] = { 0, 1, 2, 3 };
  const vtkIdType second[4] = { 4, 2, 1, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, first);
  grid->InsertNextCell(VTK_TETRA, 4, second);
  return grid;
}

/** Two of their faces. */
vtkSmartPointer<vtkPolyData> TwoFaces()
{
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  boundary->SetPoints(TwoCells()->GetPoints());
  vtkNew<vtkCellArray> triangles;
  const vtkIdType first[3] = { 0, 1, 3 };
  const vtkIdType second[3] = { 2, 1, 4 };
  triangles->InsertNextCell(3, first);
  triangles->InsertNextCell(3, second);
  boundary->SetPolys(triangles);
  return boundary;
}

template <typename Array = vtkIntArray>
void AddNumbers(vtkDataSet* data, const char* name, const std::vector<double>& numbers)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const double number : numbers)
  {
    array->InsertNextTuple1(number);
  }
  data->GetCellData()->AddArray(array);
}

void AddNames(vtkPolyData* boundary, const std::vector<std::string>& names)
{
  vtkNew<vtkStringArray> array;
  array->SetName("BoundaryTagNames");
  for (const std::string& name : names)
  {
    array->InsertNextValue(name);
  }
  boundary->GetFieldData()->AddArray(array);
}

/** A writer, what it says, and what it wrote. */
class Writing
{
public:
  explicit Writing(const std::string& ending = ".msh")
    : Path(testing::TempDir() + "insideout-solid-" + std::to_string(getpid()) + ending)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Writing*>(self)->Errors.emplace_back(static_cast<const char*>(text)); });
    this->Writer->AddObserver(vtkCommand::ErrorEvent, command);
    this->Writer->SetFileName(this->Path.c_str());
  }

  ~Writing() { unlink(this->Path.c_str()); }

  std::string Text() const
  {
    std::ifstream file(this->Path);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }

  bool Has(const std::string& words) const { return this->Text().find(words) != std::string::npos; }

  const std::string Path;
  vtkNew<vtkSolidWriter> Writer;
  std::vector<std::string> Errors;
};

/** Expect that nothing is written of two cells and faces that were changed, and one error. */
void ExpectError(
  const std::string& words, const std::function<void(vtkUnstructuredGrid*, vtkPolyData*)>& change)
{
  const auto solid = TwoCells();
  const auto boundary = TwoFaces();
  change(solid, boundary);
  Writing writing;
  writing.Writer->SetInputData(solid);
  writing.Writer->SetBoundaryData(boundary);
  EXPECT_EQ(writing.Writer->Write(), 0);
  ASSERT_EQ(writing.Errors.size(), 1u) << words;
  EXPECT_NE(writing.Errors[0].find(words), std::string::npos) << writing.Errors[0];
  EXPECT_EQ(writing.Text(), "");
}
} // namespace

TEST(vtkSolidWriter, MakesOneGroupOfASolidAloneAndOneOfItsBoundary)
{
  Writing writing;
  writing.Writer->SetInputData(TwoCells());
  EXPECT_EQ(writing.Writer->Write(), 1);
  EXPECT_TRUE(
    writing.Has("$PhysicalNames\n2\n2 1 \"surface\"\n3 1 \"solid\"\n$EndPhysicalNames\n"));
  EXPECT_TRUE(writing.Has("\n2 1 2 6\n")); // faces of one cell
  EXPECT_TRUE(writing.Has("\n3 1 4 2\n"));
}

TEST(vtkSolidWriter, NamesRegionsAndTagsAndNumbersThemFromOne)
{
  const auto solid = TwoCells();
  AddNumbers(solid, "RegionId", { 3, 0 });
  const auto boundary = TwoFaces();
  AddNumbers(boundary, "BoundaryTag", { 2, 7 });
  AddNames(boundary, { "a", "b", "wall" });
  Writing writing;
  writing.Writer->SetInputData(solid);
  writing.Writer->SetBoundaryData(boundary);
  EXPECT_EQ(writing.Writer->Write(), 1);
  EXPECT_TRUE(writing.Has(
    "$PhysicalNames\n4\n2 3 \"wall\"\n2 8 \"tag_7\"\n3 1 \"region_0\"\n3 4 \"region_3\"\n"));
  writing.Writer->SetMshVersion(vtkSolidWriter::MSHVERSION_2_2);
  EXPECT_EQ(writing.Writer->Write(), 1);
  EXPECT_TRUE(writing.Has("$MeshFormat\n2.2 0 8\n"));
  EXPECT_TRUE(
    writing.Has("\n1 2 2 3 3 1 2 4\n2 2 2 8 8 5 2 3\n3 4 2 4 4 1 2 3 4\n4 4 2 1 1 5 3 2 4\n"));
}

TEST(vtkSolidWriter, TellsWhatIsOutside)
{
  const auto hull = TwoCells();
  AddNumbers(hull, "RegionId", { -1, 4 });
  Writing writing;
  writing.Writer->SetInputData(hull);
  EXPECT_EQ(writing.Writer->Write(), 1);
  EXPECT_TRUE(writing.Has("\n3 6 \"outside\"\n3 5 \"region_4\"\n"));
  AddNumbers(hull, "RegionId", { -1, 0 });
  EXPECT_EQ(writing.Writer->Write(), 1);
  EXPECT_TRUE(writing.Has("\n3 2 \"outside\"\n3 1 \"solid\"\n"));
}

TEST(vtkSolidWriter, TakesAGroupOfSolidAndBoundary)
{
  const auto boundary = TwoFaces();
  AddNumbers(boundary, "BoundaryTag", { 0, 1 });
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, boundary);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, inner);
  blocks->SetBlock(1, TwoCells());
  blocks->SetBlock(2, vtkNew<vtkPolyData>()); // outliers, say, of which there are none
  Writing writing;
  writing.Writer->SetInputDataObject(blocks);
  EXPECT_EQ(writing.Writer->Write(), 1);
  EXPECT_TRUE(writing.Has("\n2 1 \"tag_0\"\n2 2 \"tag_1\"\n3 1 \"solid\"\n"));

  const std::array<vtkSmartPointer<vtkDataSet>, 2> others = { boundary, TwoCells() };
  for (const auto& more : others)
  {
    blocks->SetBlock(2, more);
    blocks->Modified();
    writing.Errors.clear();
    EXPECT_EQ(writing.Writer->Write(), 0);
    ASSERT_EQ(writing.Errors.size(), 1u);
    EXPECT_NE(writing.Errors[0].find("one is written, and its boundary"), std::string::npos);
  }
}

TEST(vtkSolidWriter, NamesWhatItCannotWrite)
{
  ExpectError(
    "the grid has no cells", [](vtkUnstructuredGrid* solid, vtkPolyData*) { solid->Reset(); });
  ExpectError("cell 2 is of VTK's type 5; a solid has tetrahedra",
    [](vtkUnstructuredGrid* solid, vtkPolyData*)
    {
      const vtkIdType ids[3] = { 0, 1, 2 };
      solid->InsertNextCell(VTK_TRIANGLE, 3, ids);
    });
  ExpectError("cell 2 refers to point 4294967297 of 5",
    [](vtkUnstructuredGrid* solid, vtkPolyData*)
    {
      const vtkIdType ids[4] = { 0, 4294967297, 2, 3 };
      solid->InsertNextCell(VTK_TETRA, 4, ids);
    });
  ExpectError("point 4 has a coordinate that is infinite or no number",
    [](vtkUnstructuredGrid* solid, vtkPolyData*)
    { solid->GetPoints()->SetPoint(4, 0, 0, HUGE_VAL); });
  ExpectError("RegionId is -2.000000 at cell 1; it has to hold whole numbers from -1",
    [](vtkUnstructuredGrid* solid, vtkPolyData*) {
      AddNumbers(solid, "RegionId", { 0, -2 });
    });
  ExpectError("BoundaryTag is 0.500000 at cell 1",
    [](vtkUnstructuredGrid*, vtkPolyData* boundary) {
      AddNumbers<vtkDoubleArray>(boundary, "BoundaryTag", { 0, 0.5 });
    });
  ExpectError("BoundaryTag has not one number per cell",
    [](vtkUnstructuredGrid*, vtkPolyData* boundary)
    { AddNumbers(boundary, "BoundaryTag", { 0 }); });
  ExpectError("cell 2 of the boundary has 4 corners; it has to have 3",
    [](vtkUnstructuredGrid*, vtkPolyData* boundary)
    {
      const vtkIdType ids[4] = { 0, 1, 2, 3 };
      boundary->GetPolys()->InsertNextCell(4, ids);
    });
  ExpectError("cells that are not polygons",
    [](vtkUnstructuredGrid*, vtkPolyData* boundary)
    {
      vtkNew<vtkCellArray> lines;
      const vtkIdType ids[2] = { 0, 1 };
      lines->InsertNextCell(2, ids);
      boundary->SetLines(lines);
    });
  ExpectError("triangle 2 of the boundary is not a face of the solid's cells",
    [](vtkUnstructuredGrid*, vtkPolyData* boundary)
    {
      const vtkIdType ids[3] = { 0, 1, 4 };
      boundary->GetPolys()->InsertNextCell(3, ids);
    });
}

TEST(vtkSolidWriter, NamesAFileThatItCannotWrite)
{
  Writing writing(".vtu");
  writing.Writer->SetInputData(TwoCells());
  EXPECT_EQ(writing.Writer->Write(), 0);
  writing.Writer->SetFileName(nullptr);
  EXPECT_EQ(writing.Writer->Write(), 0);
  ASSERT_EQ(writing.Errors.size(), 2u);
  EXPECT_NE(
    writing.Errors[0].find(".vtu: the ending is none of .msh, .inp and .mesh"), std::string::npos);
  EXPECT_NE(writing.Errors[1].find("no file name is set"), std::string::npos);
}

TEST(vtkSolidWriter, WritesNothingWhenItIsStopped)
{
  Writing writing;
  writing.Writer->SetInputData(TwoCells());
  // As late as can be: up to VTK 9.2 an algorithm that begins forgets that it is to stop.
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* writer, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(writer)->SetAbortExecute(1); });
  const unsigned long stopping = writing.Writer->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(writing.Writer->Write(), 0);
  EXPECT_TRUE(writing.Errors.empty());
  EXPECT_EQ(writing.Text(), "");
  writing.Writer->RemoveObserver(stopping);
  writing.Writer->SetAbortExecute(0);
  EXPECT_EQ(writing.Writer->Write(), 1);
}

TEST(vtkSolidWriter, HasTheVersionOfGmsh4ByDefault)
{
  vtkNew<vtkSolidWriter> writer;
  EXPECT_EQ(writer->GetMshVersion(), vtkSolidWriter::MSHVERSION_4_1);
  writer->SetMshVersion(7);
  EXPECT_EQ(writer->GetMshVersion(), vtkSolidWriter::MSHVERSION_2_2);
}
