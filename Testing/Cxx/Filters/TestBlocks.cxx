// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkProbeWindingNumber.h"
#include "vtkRobustTetrahedralize.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataSet.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
vtkSmartPointer<vtkPolyData> Box()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0);
  }
  const vtkIdType quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(vtkNew<vtkCellArray>());
  for (const auto& quad : quads)
  {
    box->GetPolys()->InsertNextCell(4, quad);
  }
  return box;
}

vtkSmartPointer<vtkPolyData> BoxWithout(vtkIdType point)
{
  auto box = Box();
  box->GetPoints()->SetPoint(point, std::nan(""), 0, 0);
  return box;
}

void Name(vtkMultiBlockDataSet* blocks, unsigned int block, const char* name)
{
  blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name);
}

/** "sound", "broken", "more" with a block without a name that is broken, too, and one like the
 * first. */
vtkSmartPointer<vtkMultiBlockDataSet> Blocks()
{
  vtkNew<vtkMultiBlockDataSet> more;
  more->SetBlock(0, Box());
  more->SetBlock(1, BoxWithout(5));
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, Box());
  blocks->SetBlock(1, BoxWithout(3));
  blocks->SetBlock(2, more);
  Name(blocks, 0, "sound");
  Name(blocks, 1, "broken");
  Name(blocks, 2, "more");
  return blocks;
}

/** The texts of the errors of an Update, without the executive's generic ones. */
std::vector<std::string> ErrorsOf(vtkAlgorithm* algorithm)
{
  std::vector<std::string> texts;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&texts);
  listen->SetCallback(
    [](vtkObject*, unsigned long, void* heard, void* text)
    {
      std::string line = static_cast<const char*>(text);
      line.erase(line.find_last_not_of('\n') + 1);
      static_cast<std::vector<std::string>*>(heard)->push_back(line.substr(line.find("): ") + 3));
    });
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  const unsigned long heard = algorithm->AddObserver(vtkCommand::ErrorEvent, listen);
  const unsigned long silenced =
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  algorithm->Update();
  algorithm->RemoveObserver(heard);
  algorithm->GetExecutive()->RemoveObserver(silenced);
  return texts;
}
} // namespace

TEST(vtkInsideOutBlock, ErrorsNameTheBlockAndItsPoint)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputDataObject(Blocks());
  const std::vector<std::string> expected = { "block broken: point 3 is not finite",
    "block more/1: point 5 is not finite" };
  EXPECT_EQ(ErrorsOf(filter), expected);
  auto* solids = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(solids, nullptr);
  EXPECT_GT(vtkUnstructuredGrid::SafeDownCast(solids->GetBlock(0))->GetNumberOfCells(), 0);
  filter->SetGamma(1);
  EXPECT_EQ(ErrorsOf(filter), expected) << "the second time, too";
}

TEST(vtkInsideOutBlock, AnErrorOfASurfaceAloneNamesNone)
{
  vtkNew<vtkTrivialProducer> producer; // of one thing after the other
  producer->SetOutput(Blocks());
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputConnection(producer->GetOutputPort());
  EXPECT_EQ(ErrorsOf(filter).size(), 2u);
  producer->SetOutput(BoxWithout(2));
  EXPECT_EQ(ErrorsOf(filter), std::vector<std::string>{ "point 2 is not finite" });
}

TEST(vtkInsideOutBlock, APartThatIsAloneNeedsNoNumber)
{
  vtkNew<vtkPartitionedDataSet> part;
  part->SetPartition(0, BoxWithout(3));
  vtkNew<vtkPartitionedDataSetCollection> parts;
  parts->SetPartitionedDataSet(0, vtkNew<vtkPartitionedDataSet>());
  parts->SetPartitionedDataSet(1, part);
  parts->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "wing");
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputDataObject(parts);
  EXPECT_EQ(ErrorsOf(filter), std::vector<std::string>{ "block wing: point 3 is not finite" });
}

TEST(vtkInsideOutBlock, AProbeNamesTheBlockOfItsSurface)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(image);
  probe->SetInputDataObject(1, Blocks());
  const auto errors = ErrorsOf(probe);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0], "block broken: point 3 is not finite");
}
