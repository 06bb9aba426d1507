// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boxes.h"
#include "Listener.h"
#include "Statistics.h"
#include "vtkBoundaryLayers.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkSolidQuality.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <set>

namespace
{
/** A refined box of side 1, whose lowest and highest facets are called inlet and outlet. */
class BoundaryLayers : public testing::Test
{
protected:
  BoundaryLayers()
  {
    auto surface = EmptySurface();
    AddBox(surface, 0, 1);
    vtkNew<vtkIntArray> tags;
    tags->SetName("BoundaryTag");
    for (const int tag : { 0, 1, 2, 2, 2, 2 })
    {
      tags->InsertNextValue(tag);
    }
    surface->GetCellData()->AddArray(tags);
    vtkNew<vtkStringArray> names;
    names->SetName("BoundaryTagNames");
    for (const char* name : { "inlet", "outlet", "wall" })
    {
      names->InsertNextValue(name);
    }
    surface->GetFieldData()->AddArray(names);
    this->Tetrahedra->SetInputData(surface);
    this->Tetrahedra->SetRefine(true);
    this->Tetrahedra->SetEdgeLength(0.25);
    this->Layers->SetInputConnection(this->Tetrahedra->GetOutputPort());
    this->Layers->SetBoundaryConnection(this->Tetrahedra->GetOutputPort(1));
    this->Layers->SetFirstHeight(0.01);
    this->Layers->SetLayerTags("wall");
  }

  vtkIdType CountCells(int type)
  {
    vtkUnstructuredGrid* grid = this->Layers->GetOutput();
    vtkIdType count = 0;
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
    {
      count += grid->GetCellType(c) == type ? 1 : 0;
    }
    return count;
  }

  vtkNew<vtkRobustTetrahedralize> Tetrahedra;
  vtkNew<vtkBoundaryLayers> Layers;
};
} // namespace

TEST_F(BoundaryLayers, AreMadeAtTheWallAndGoOnAlongInletAndOutlet)
{
  vtkNew<vtkSolidQuality> quality;
  quality->SetInputConnection(this->Layers->GetOutputPort());
  quality->Update();
  vtkUnstructuredGrid* grid = this->Layers->GetOutput();
  EXPECT_GT(this->CountCells(VTK_WEDGE), 0);
  EXPECT_EQ(this->CountCells(VTK_WEDGE), StatisticOf(grid, "Prisms"));
  EXPECT_EQ(this->CountCells(VTK_PYRAMID), 0);
  EXPECT_EQ(StatisticOf(grid, "FullHeightShare"), 1);
  EXPECT_EQ(StatisticOf(quality->GetOutput(), "NegativeCells"), 0);
  EXPECT_EQ(StatisticOf(quality->GetOutput(), "Conforms"), 1);
  EXPECT_EQ(StatisticOf(quality->GetOutput(), "Prisms"), StatisticOf(grid, "Prisms"));

  std::set<int> layers;
  auto* array = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray("Layer"));
  ASSERT_TRUE(array);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    layers.insert(array->GetValue(c));
  }
  EXPECT_EQ(layers, (std::set<int>{ 0, 1, 2, 3 }));

  // The boundary has the sides of the layers, with the tag of the facet that they are on.
  vtkPolyData* boundary = this->Layers->GetBoundary();
  EXPECT_EQ(boundary->GetNumberOfCells(), StatisticOf(quality->GetOutput(), "BoundaryFaces"));
  vtkDataArray* tags = boundary->GetCellData()->GetArray("BoundaryTag");
  ASSERT_TRUE(tags);
  for (vtkIdType c = 0; c < boundary->GetNumberOfCells(); ++c)
  {
    double bounds[6];
    boundary->GetCell(c)->GetBounds(bounds);
    const double tag = tags->GetTuple1(c);
    EXPECT_EQ(tag == 0, bounds[5] == 0);
    EXPECT_EQ(tag == 1, bounds[4] == 1);
  }
}

TEST_F(BoundaryLayers, CarryDataOver)
{
  this->Tetrahedra->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(this->Tetrahedra->GetOutput());
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    heights->InsertNextValue(grid->GetPoint(p)[2]);
  }
  grid->GetPointData()->AddArray(heights);
  vtkNew<vtkIntArray> materials;
  materials->SetName("Material");
  materials->SetNumberOfValues(grid->GetNumberOfCells());
  materials->Fill(7);
  grid->GetCellData()->AddArray(materials);
  this->Layers->SetInputData(grid);
  this->Layers->Update();
  vtkUnstructuredGrid* output = this->Layers->GetOutput();
  vtkDataArray* after = output->GetPointData()->GetArray("Height");
  ASSERT_TRUE(after);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(after->GetTuple1(p), output->GetPoint(p)[2], 1e-9);
  }
  double range[2];
  output->GetCellData()->GetArray("Material")->GetRange(range);
  EXPECT_EQ(range[0], 7);
  EXPECT_EQ(range[1], 7);
}

TEST_F(BoundaryLayers, TellWhereThereIsNoRoomAndNameWhatIsWrong)
{
  const Listener warnings(this->Layers, vtkCommand::WarningEvent);
  const Listener errors(this->Layers, vtkCommand::ErrorEvent);
  this->Layers->SetFirstHeight(0.3);
  this->Layers->Update();
  EXPECT_TRUE(warnings.Heard("the solid is narrower than three times the layers"));
  EXPECT_TRUE(errors.Texts.empty());
  this->Layers->SetLayerTags("door");
  this->Layers->Update();
  EXPECT_TRUE(
    errors.Heard("door, which is not a tag of the boundary; its tags are inlet, outlet, wall"));
  EXPECT_EQ(this->Layers->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(this->Layers->GetBoundary()->GetNumberOfCells(), 0);
}
