// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boxes.h"
#include "Listener.h"
#include "Statistics.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"

#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Labels = std::vector<int>;

Grid MakeGrid(const std::vector<std::array<double, 3>>& corners,
  const std::vector<std::array<vtkIdType, 4>>& cells, const std::vector<double>& windingNumbers)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner.data());
  }
  grid->SetPoints(points);
  for (const auto& cell : cells)
  {
    grid->InsertNextCell(VTK_TETRA, 4, cell.data());
  }
  vtkNew<vtkDoubleArray> w;
  w->SetName("w");
  for (const double value : windingNumbers)
  {
    w->InsertNextValue(value);
  }
  grid->GetCellData()->AddArray(w);
  return grid;
}

/** Three tetrahedra in a row, each sharing a face with the next; the middle one is `height` long.
 */
Grid Three(const std::vector<double>& w, double height = 1)
{
  return MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, height }, { 0, 0, -1 },
                    { -0.5 / height, 0.5, height / 2 } },
    { { 0, 1, 2, 3 }, { 0, 2, 1, 4 }, { 0, 3, 2, 5 } }, w);
}

/** Cubes of side 1, `size` along each axis, six tetrahedra around the diagonal of each. w is 1 in
 * the cubes with these numbers and 0 in the others. */
Grid Cubes(int size, const std::set<int>& filled)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<vtkIdType, 4>> cells;
  std::vector<double> w;
  const int steps[3] = { 1, size + 1, (size + 1) * (size + 1) };
  for (int p = 0; p < (size + 1) * steps[2]; ++p)
  {
    points.push_back({ p % (size + 1) * 1.0, p / steps[1] % (size + 1) * 1.0, p / steps[2] * 1.0 });
  }
  for (int cube = 0; cube < size * size * size; ++cube)
  {
    const vtkIdType first =
      cube % size + cube / size % size * steps[1] + cube / (size * size) * steps[2];
    for (int i = 0; i < 3; ++i)
    {
      for (const int j : { (i + 1) % 3, (i + 2) % 3 })
      {
        cells.push_back({ first, first + steps[i], first + steps[i] + steps[j],
          first + steps[0] + steps[1] + steps[2] });
        w.push_back(filled.count(cube));
      }
    }
  }
  return MakeGrid(points, cells, w);
}

void AddFacetIds(vtkUnstructuredGrid* grid, vtkIdType cell, int face)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("FacetIds");
  ids->SetNumberOfComponents(4);
  ids->SetNumberOfTuples(grid->GetNumberOfCells());
  ids->Fill(-1);
  ids->SetComponent(cell, face, 7);
  grid->GetCellData()->AddArray(ids);
}

vtkSmartPointer<vtkPolyData> Seeds(
  const std::vector<std::array<double, 3>>& places, const std::vector<int>& inside)
{
  auto seeds = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("Inside");
  for (const auto& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  for (const int value : inside)
  {
    array->InsertNextValue(static_cast<unsigned char>(value));
  }
  seeds->SetPoints(points);
  seeds->GetPointData()->AddArray(array);
  return seeds;
}

/** The filter with what it says, and all cells in its output. */
struct Cut
{
  explicit Cut(vtkUnstructuredGrid* grid, double gamma = 0)
  {
    this->Command->SetClientData(&this->Said);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* said, void* text)
      { *static_cast<std::string*>(said) += static_cast<const char*>(text); });
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Command);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this->Command);
    this->Silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Silence);
    this->Filter->SetInputData(grid);
    this->Filter->SetGamma(gamma);
    this->Filter->ExtractInsideOff();
  }

  Labels Inside()
  {
    this->Said.clear();
    this->Filter->Update();
    Labels labels;
    vtkUnstructuredGrid* output = this->Filter->GetOutput();
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      labels.push_back(static_cast<int>(output->GetCellData()->GetArray("Inside")->GetTuple1(c)));
    }
    return labels;
  }

  double Statistic(const std::string& name) const
  {
    return StatisticOf(this->Filter->GetOutput(), name);
  }

  bool Says(const std::string& words) const { return this->Said.find(words) != std::string::npos; }

  std::string Said;
  vtkNew<vtkGraphCutSegmentation> Filter;

private:
  vtkNew<vtkCallbackCommand> Command;
  vtkNew<vtkCallbackCommand> Silence;
};

std::set<vtkIdType> PointsOf(vtkCell* cell)
{
  return { cell->GetPointIds()->begin(), cell->GetPointIds()->end() };
}

/** Edges of the boundary that are not in exactly two of its faces. */
int CountBadEdges(vtkUnstructuredGrid* grid, const Labels& inside)
{
  std::map<std::set<vtkIdType>, int> faces;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (int k = 0; inside[c] && k < 4; ++k)
    {
      ++faces[PointsOf(grid->GetCell(c)->GetFace(k))];
    }
  }
  std::map<std::set<vtkIdType>, int> edges;
  for (const auto& [face, sides] : faces)
  {
    for (const vtkIdType point : face)
    {
      std::set<vtkIdType> edge = face;
      edge.erase(point);
      edges[edge] += sides == 1;
    }
  }
  int bad = 0;
  for (const auto& edge : edges)
  {
    bad += edge.second != 0 && edge.second != 2;
  }
  return bad;
}
} // namespace

TEST(vtkGraphCutSegmentation, KeepsTheFaceThatFacetIdsNamesHoweverTheCellIsTurned)
{
  for (const bool turned : { false, true })
  {
    for (int face = 0; face < 4; ++face)
    {
      auto grid = Three({ 0.1, 0.2, 0 });
      if (turned)
      {
        const vtkIdType corners[4] = { 0, 1, 3, 2 };
        grid->GetCells()->ReplaceCellAtId(0, 4, corners);
      }
      AddFacetIds(grid, 0, face);
      const auto corners = PointsOf(grid->GetCell(0)->GetFace(face));
      const bool withSecond = corners == std::set<vtkIdType>{ 0, 1, 2 };
      Cut cut(grid);
      EXPECT_EQ(cut.Inside(), Labels({ 0, 0, 0 }));
      cut.Filter->ConstrainFacetsOn();
      // The cell of the larger w: the first, except where it shares the face with the second.
      EXPECT_EQ(cut.Inside(), withSecond ? Labels({ 0, 1, 0 }) : Labels({ 1, 0, 0 }))
        << "face " << face << (turned ? " of a turned cell" : "");
      EXPECT_EQ(cut.Statistic("ForcedFacets"), 1);
      EXPECT_GT(cut.Statistic("Energy"), cut.Statistic("EnergyOfCut"));
      EXPECT_EQ(cut.Said, "");
    }
  }
}

TEST(vtkGraphCutSegmentation, MakesTheBoundaryAManifold)
{
  // Numbers of cubes that share an edge alone, a point alone, and all of both colors of a board.
  const std::set<int> families[] = { { 0, 4 }, { 0, 13 },
    { 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26 } };
  for (const std::set<int>& filled : families)
  {
    auto grid = Cubes(3, filled);
    Cut cut(grid);
    const Labels before = cut.Inside();
    cut.Filter->SetNonManifoldToFill();
    const Labels after = cut.Inside();
    EXPECT_EQ(CountBadEdges(grid, before) > 0, filled.count(13) == 0);
    EXPECT_EQ(CountBadEdges(grid, after), 0);
    EXPECT_NE(after, before);
    EXPECT_EQ(cut.Statistic("NonManifoldPoints"), 0);
    EXPECT_GT(cut.Statistic("ForcedCells"), 0);
    EXPECT_EQ(cut.Said, "");
  }
}

TEST(vtkGraphCutSegmentation, ObeysSeedsAndSaysWhichForbidAConstraint)
{
  auto grid = Three({ 1, 0, 1 });
  AddFacetIds(grid, 0, 3); // between the first two cells
  Cut cut(grid, 0.01);
  EXPECT_EQ(cut.Inside(), Labels({ 1, 0, 1 }));
  cut.Filter->SetSeedsData(Seeds({ { 0.1, 0.1, 0.1 }, { 0.1, 0.1, -0.1 } }, { 0, 1 }));
  EXPECT_EQ(cut.Inside(), Labels({ 0, 1, 1 }));
  EXPECT_EQ(cut.Said, "");

  vtkNew<vtkTrivialProducer> producer;
  const auto outside = Seeds({ { 0.1, 0.1, 0.1 }, { 0.1, 0.1, -0.1 } }, { 0, 0 });
  producer->SetOutput(outside);
  cut.Filter->SetSeedsConnection(producer->GetOutputPort());
  cut.Filter->ConstrainFacetsOn();
  EXPECT_EQ(cut.Inside(), Labels({ 0, 0, 1 }));
  EXPECT_TRUE(cut.Says("1 pieces of facets are not kept")) << cut.Said;
  EXPECT_EQ(cut.Statistic("SeedConflicts"), 1);

  cut.Filter->SetSeedsData(nullptr);
  EXPECT_EQ(cut.Inside(), Labels({ 1, 0, 1 })) << "without seeds all is as before";
  EXPECT_EQ(cut.Said, "");
}

TEST(vtkGraphCutSegmentation, WeighsCellsByVolumeIfTold)
{
  // Two cells that lean inside around a far larger one that leans outside; smoothness joins all.
  Cut cut(Three({ 0.45, 0.6, 0.6 }, 1000), 100);
  cut.Filter->SetSigma(10);
  EXPECT_EQ(cut.Inside(), Labels({ 1, 1, 1 }));
  cut.Filter->SetDataTerm(vtkGraphCutSegmentation::VOLUME_WEIGHTED);
  EXPECT_EQ(cut.Inside(), Labels({ 0, 0, 0 }));
}

TEST(vtkGraphCutSegmentation, WeighsCellsOfAnyShapeByVolumeFarFromTheOrigin)
{
  // Two boxes that lean inside around a larger one that leans outside. In floats, which are 8 apart
  // here, the middle one would be empty.
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int p = 0; p < 16; ++p)
  {
    const double xs[4] = { -5, -3, 3, 5 };
    points->InsertNextPoint(1e8 + xs[p % 4], p / 4 % 2, p / 8);
  }
  grid->SetPoints(points);
  vtkNew<vtkDoubleArray> w;
  w->SetName("w");
  for (vtkIdType x = 0; x < 3; ++x)
  {
    const vtkIdType corners[8] = { x, x + 1, x + 4, x + 5, x + 8, x + 9, x + 12, x + 13 };
    grid->InsertNextCell(VTK_VOXEL, 8, corners);
    w->InsertNextValue(x == 1 ? 0.45 : 0.55);
  }
  grid->GetCellData()->AddArray(w);
  Cut cut(grid, 100);
  cut.Filter->SetSigma(10);
  EXPECT_EQ(cut.Inside(), Labels({ 1, 1, 1 }));
  cut.Filter->SetDataTerm(vtkGraphCutSegmentation::VOLUME_WEIGHTED);
  EXPECT_EQ(cut.Inside(), Labels({ 0, 0, 0 }));
}

TEST(vtkGraphCutSegmentation, RefusesWhatItsOptionsCannotWorkOn)
{
  const auto expectError = [](vtkUnstructuredGrid* grid, auto set, const std::string& words)
  {
    Cut cut(grid);
    set(cut.Filter);
    EXPECT_TRUE(cut.Inside().empty());
    EXPECT_TRUE(cut.Says(words)) << cut.Said;
  };
  const auto keepFacets = [](vtkGraphCutSegmentation* cut) { cut->ConstrainFacetsOn(); };
  const auto beManifold = [](vtkGraphCutSegmentation* cut) { cut->SetNonManifoldToFill(); };
  const auto addSeed = [](vtkGraphCutSegmentation* cut) {
    cut->SetSeedsData(Seeds({ { 0, 0, 0 } }, { 1 }));
  };

  auto mixed = Cubes(1, { 0 });
  const vtkIdType corners[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  mixed->InsertNextCell(VTK_VOXEL, 8, corners);
  vtkDoubleArray::SafeDownCast(mixed->GetCellData()->GetArray("w"))->InsertNextValue(0);
  const std::string words =
    "cell 6 is not a tetrahedron; seeds and constraints need tetrahedra alone";
  expectError(mixed, keepFacets, words);
  expectError(mixed, beManifold, words);
  expectError(mixed, addSeed, words);

  expectError(Three({ 0, 0, 0 }), keepFacets, "no cell array FacetIds of four values per cell");
  expectError(
    Three({ 0, 0, 0 }),
    [](vtkGraphCutSegmentation* cut)
    {
      auto seeds = Seeds({ { 0, 0, 0 } }, { 1 });
      seeds->GetPointData()->Initialize();
      cut->SetSeedsData(seeds);
    },
    "no point array Inside");

  auto overlapping = Three({ 1, 1, 1 });
  overlapping->GetPoints()->SetPoint(4, 0, 0, 2);
  expectError(overlapping, beManifold, "cells 0 and 1 are on one side of the face that they share");
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
