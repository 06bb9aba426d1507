// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/AllowedThreads.h"
#include "vtkConstrainedDelaunay3D.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkProbeWindingNumber.h"
#include "vtkRefineTetrahedra.h"
#include "vtkResolveSelfIntersections.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkSurfaceDefects.h"
#include "vtkVoxelFractions.h"
#include "vtkWindingNumberToImageStencil.h"

#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkImageStencilData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiPieceDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <array>
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

TEST(Blocks, ErrorsNameTheBlockAndItsPoint)
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

TEST(Blocks, AnErrorOfASurfaceAloneNamesNone)
{
  vtkNew<vtkTrivialProducer> producer; // of one thing after the other
  producer->SetOutput(Blocks());
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputConnection(producer->GetOutputPort());
  EXPECT_EQ(ErrorsOf(filter).size(), 2u);
  producer->SetOutput(BoxWithout(2));
  EXPECT_EQ(ErrorsOf(filter), std::vector<std::string>{ "point 2 is not finite" });
}

TEST(Blocks, APartThatIsAloneNeedsNoNumber)
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

TEST(Blocks, AProbeNamesTheBlockOfItsSurface)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(image);
  probe->SetInputDataObject(1, Blocks());
  EXPECT_EQ(ErrorsOf(probe), std::vector<std::string>{ "block broken: point 3 is not finite" });
}

namespace
{
/** A box in two partitions. */
vtkSmartPointer<vtkPolyData> PartOfBox(vtkIdType first, vtkIdType end)
{
  const auto box = Box();
  vtkNew<vtkCellArray> some;
  for (vtkIdType quad = first; quad < end; ++quad)
  {
    some->InsertNextCell(box->GetCell(quad));
  }
  box->SetPolys(some);
  return box;
}

vtkSmartPointer<vtkPartitionedDataSet> BoxInPartitions(vtkSmartPointer<vtkPartitionedDataSet> box)
{
  box->SetPartition(1, PartOfBox(0, 2)); // after one that is not there
  box->SetPartition(2, PartOfBox(2, 6));
  return box;
}

double VolumeOf(vtkDataObject* solid)
{
  vtkDataArray* volumes = solid->GetFieldData()->GetArray("RegionVolume");
  return volumes && volumes->GetNumberOfTuples() == 1 ? volumes->GetComponent(0, 0) : 0;
}

vtkIdType CellsOf(vtkDataObject* data)
{
  return vtkDataSet::SafeDownCast(data)->GetNumberOfCells();
}

using Counts = std::vector<vtkIdType>;

Counts CellsOfLeaves(vtkAlgorithm* filter)
{
  auto* made = vtkCompositeDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  Counts cells;
  const auto leaf = vtk::TakeSmartPointer(made->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    cells.push_back(CellsOf(leaf->GetCurrentDataObject()));
  }
  return cells;
}
} // namespace

namespace
{
/** Points by their coordinates, and their value of Inside. */
vtkSmartPointer<vtkPolyData> Seeds(const std::vector<std::array<double, 4>>& places)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> inside;
  inside->SetName("Inside");
  for (const std::array<double, 4>& place : places)
  {
    points->InsertNextPoint(place.data());
    inside->InsertNextValue(static_cast<int>(place[3]));
  }
  auto seeds = vtkSmartPointer<vtkPolyData>::New();
  seeds->SetPoints(points);
  seeds->GetPointData()->AddArray(inside);
  return seeds;
}

/** Some data sets as blocks, the last of them in a block of its own. */
vtkSmartPointer<vtkMultiBlockDataSet> BlocksOf(
  const std::vector<vtkSmartPointer<vtkDataSet>>& dataSets)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t i = 0; i + 1 < dataSets.size(); ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(i), dataSets[i]);
  }
  vtkNew<vtkMultiBlockDataSet> last;
  last->SetBlock(0, dataSets.back());
  blocks->SetBlock(static_cast<unsigned int>(dataSets.size()), last);
  return blocks;
}
} // namespace

TEST(Blocks, AreOneSetOfSeeds)
{
  // VTK takes the first composite input of a filter to blocks, and gives it others as they are.
  const std::array<double, 4> inside = { 0.4, 0.45, 0.5, 1 };
  const std::array<double, 4> outside = { 0.9, 0.95, 0.8, 0 };
  const auto volumeWith = [](vtkDataObject* surface, vtkDataObject* seeds)
  {
    vtkNew<vtkRobustTetrahedralize> filter;
    filter->SetInputDataObject(surface);
    filter->SetSeedsData(seeds);
    filter->GetSegmentation()->SeededRegionsOn();
    EXPECT_TRUE(ErrorsOf(filter).empty());
    auto* solids = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(solids != nullptr, surface->IsA("vtkMultiBlockDataSet"));
    return VolumeOf(solids ? solids->GetBlock(0) : filter->GetOutputDataObject(0));
  };
  const double both = volumeWith(Box(), Seeds({ inside, outside }));
  EXPECT_GT(both, 0);
  EXPECT_LT(both, 1);
  const auto blocks = BlocksOf({ Seeds({ inside }), Seeds({ outside }) });
  EXPECT_DOUBLE_EQ(volumeWith(Box(), blocks), both);
  EXPECT_DOUBLE_EQ(volumeWith(BlocksOf({ Box(), Box() }), blocks), both);
}

TEST(Blocks, AreOneBackgroundAndOneSolid)
{
  vtkNew<vtkRobustTetrahedralize> box;
  box->SetInputDataObject(Box());
  box->Update();
  const auto half = [](double from)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetOrigin(from, 0, 0);
    image->SetDimensions(2, 2, 2);
    image->SetSpacing(0.5, 1, 1);
    vtkNew<vtkDoubleArray> lengths;
    lengths->SetName("Length");
    lengths->SetNumberOfValues(8);
    lengths->Fill(0.2);
    image->GetPointData()->AddArray(lengths);
    return image;
  };
  const auto cells = [&](vtkDataObject* background)
  {
    vtkNew<vtkRefineTetrahedra> refine;
    refine->SetInputConnection(box->GetOutputPort());
    refine->SetBackgroundData(background);
    refine->SetSizingArrayName("Length");
    refine->SetSurfaceTreatment(vtkRefineTetrahedra::SPLIT);
    EXPECT_TRUE(ErrorsOf(refine).empty());
    return CellsOf(refine->GetOutputDataObject(0));
  };
  const vtkIdType ofHalf = cells(half(0));
  EXPECT_GT(cells(BlocksOf({ half(0), half(0.5) })), 3 * ofHalf / 2);

  vtkNew<vtkVoxelFractions> fractions;
  fractions->SetInputData(half(0));
  fractions->SetSolidData(BlocksOf({ vtkSmartPointer<vtkDataSet>(box->GetOutput()) }));
  EXPECT_TRUE(ErrorsOf(fractions).empty());
  auto* made = vtkImageData::SafeDownCast(fractions->GetOutputDataObject(0));
  ASSERT_NE(made, nullptr) << "one output for one image";
  EXPECT_DOUBLE_EQ(made->GetCellData()->GetArray("VolumeFraction")->GetComponent(0, 0), 1);
  auto bare = vtkSmartPointer<vtkUnstructuredGrid>::New();
  bare->CopyStructure(vtkUnstructuredGrid::SafeDownCast(box->GetOutput()));
  fractions->SetSolidData(
    BlocksOf({ vtkSmartPointer<vtkDataSet>(box->GetOutput()), vtkSmartPointer<vtkDataSet>(bare) }));
  EXPECT_EQ(ErrorsOf(fractions),
    std::vector<std::string>{ "block 2 has no array Inside, which other blocks have" });
  fractions->SetSolidData(vtkNew<vtkMultiBlockDataSet>());
  EXPECT_EQ(ErrorsOf(fractions), std::vector<std::string>{ "the solid has no blocks" });
}

TEST(Blocks, PartitionsAreOneSurfaceAndTheFirstHasWhatIsMadeOfIt)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputDataObject(BoxInPartitions(vtkSmartPointer<vtkPartitionedDataSet>::New()));
  EXPECT_TRUE(ErrorsOf(filter).empty());
  auto* solid = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(solid, nullptr);
  EXPECT_DOUBLE_EQ(VolumeOf(solid->GetPartition(1)), 1);
  EXPECT_EQ(CellsOf(solid->GetPartition(2)), 0);
  auto* boundary = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  vtkDataArray* cells = boundary->GetPartition(1)->GetCellData()->GetArray("vtkOriginalCellIds");
  double range[2];
  cells->GetRange(range);
  EXPECT_EQ(range[0], 0) << "cells are numbered one partition after the other";
  EXPECT_EQ(range[1], 5);
}

TEST(Blocks, PartitionsAreOneBlockOfAllFilters)
{
  const std::vector<vtkSmartPointer<vtkAlgorithm>> filters = {
    vtkSmartPointer<vtkConstrainedDelaunay3D>::New(),
    vtkSmartPointer<vtkGeneralizedWindingNumber>::New(),
    vtkSmartPointer<vtkResolveSelfIntersections>::New(), vtkSmartPointer<vtkSurfaceDefects>::New(),
    vtkSmartPointer<vtkRobustTetrahedralize>::New()
  };
  for (const auto& filter : filters)
  {
    filter->SetInputDataObject(Box());
    EXPECT_TRUE(ErrorsOf(filter).empty());
    const vtkIdType alone = CellsOf(filter->GetOutputDataObject(0));
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, BoxInPartitions(vtkSmartPointer<vtkMultiPieceDataSet>::New()));
    blocks->SetBlock(1, Box());
    filter->SetInputDataObject(blocks);
    EXPECT_TRUE(ErrorsOf(filter).empty()) << filter->GetClassName();
    EXPECT_EQ(CellsOfLeaves(filter), (Counts{ alone, 0, alone })) << filter->GetClassName();
    vtkNew<vtkPartitionedDataSetCollection> collection;
    collection->SetPartitionedDataSet(
      0, BoxInPartitions(vtkSmartPointer<vtkPartitionedDataSet>::New()));
    filter->SetInputDataObject(collection);
    EXPECT_TRUE(ErrorsOf(filter).empty()) << filter->GetClassName();
    EXPECT_EQ(CellsOfLeaves(filter), (Counts{ alone, 0 })) << filter->GetClassName();
  }
}

TEST(Blocks, OutputsOfPartitionsFollowTheirChanges)
{
  const auto box = BoxInPartitions(vtkSmartPointer<vtkPartitionedDataSet>::New());
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputDataObject(box);
  filter->Update();
  for (unsigned int p : { 1u, 2u })
  {
    vtkPoints* points = vtkPolyData::SafeDownCast(box->GetPartition(p))->GetPoints();
    for (vtkIdType i = 0; i < 8; ++i)
    {
      double* x = points->GetPoint(i);
      points->SetPoint(i, 2 * x[0], x[1], x[2]);
    }
    points->Modified();
  }
  box->Modified();
  filter->Update();
  auto* solid = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_DOUBLE_EQ(VolumeOf(solid->GetPartition(1)), 2);
}

TEST(Blocks, APartitionThatRefersToPointsOfAnotherIsAnErrorThatNamesIt)
{
  const auto box = BoxInPartitions(vtkSmartPointer<vtkPartitionedDataSet>::New());
  const vtkIdType corners[3] = { 0, 1, 8 };
  vtkPolyData::SafeDownCast(box->GetPartition(1))->GetPolys()->InsertNextCell(3, corners);
  vtkNew<vtkRobustTetrahedralize> filter;
  filter->SetInputDataObject(box);
  EXPECT_EQ(ErrorsOf(filter),
    std::vector<std::string>{ "block 0: partition 0: cell 2 refers to point 8 of 8" });
}

namespace
{
/** Two boxes beside each other. */
vtkSmartPointer<vtkMultiBlockDataSet> TwoBoxes()
{
  const auto other = Box();
  for (vtkIdType i = 0; i < 8; ++i)
  {
    double* x = other->GetPoint(i);
    other->GetPoints()->SetPoint(i, x[0] + 2, x[1], x[2]);
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, Box());
  blocks->SetBlock(1, other);
  return blocks;
}
} // namespace

TEST(Blocks, OfWhatIsProbedAreOneSurface)
{
  vtkNew<vtkImageData> image; // of which a place is in each box, and one in none
  image->SetDimensions(3, 1, 1);
  image->SetOrigin(0.5, 0.5, 0.5);
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(image);
  probe->SetSurfaceData(TwoBoxes());
  EXPECT_TRUE(ErrorsOf(probe).empty());
  ASSERT_NE(vtkImageData::SafeDownCast(probe->GetOutputDataObject(0)), nullptr);
  vtkNew<vtkWindingNumberToImageStencil> stencil;
  stencil->SetInputData(TwoBoxes());
  stencil->SetInformationInput(image);
  EXPECT_TRUE(ErrorsOf(stencil).empty());
  vtkNew<vtkImplicitWindingNumber> function;
  const auto boxes = TwoBoxes();
  function->SetInput(boxes);
  for (int x = 0; x < 3; ++x)
  {
    const int isInside = x != 1;
    EXPECT_EQ(probe->IsInside(x), isInside);
    EXPECT_EQ(stencil->GetOutput()->IsInside(x, 0, 0), isInside);
    EXPECT_EQ(function->FunctionValue(x + 0.5, 0.5, 0.5) < 0, isInside == 1);
  }
  vtkPolyData::SafeDownCast(boxes->GetBlock(0))->GetPoints()->SetPoint(0, 0.6, 0.6, 0.6);
  vtkPolyData::SafeDownCast(boxes->GetBlock(0))->GetPoints()->Modified();
  EXPECT_GT(function->FunctionValue(0.5, 0.5, 0.5), 0) << "it follows changes of blocks";
}

namespace
{
/** A surface, cells of a volume, and the surface again. */
vtkSmartPointer<vtkMultiBlockDataSet> BlocksOfTwoTypes()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, Box());
  blocks->SetBlock(1, vtkNew<vtkUnstructuredGrid>());
  blocks->SetBlock(2, Box());
  return blocks;
}

const std::vector<std::string> OfAnotherType = {
  "block 1: the input is a vtkUnstructuredGrid, not a vtkPolyData"
};
} // namespace

TEST(Blocks, OneOfAnotherTypeIsAnErrorAndKeepsNoOtherFromItsSolid)
{
  for (const int atOnce : { 1, 2 })
  {
    vtkNew<vtkRobustTetrahedralize> filter;
    filter->SetInputDataObject(BlocksOfTwoTypes());
    filter->SetBlocksAtOnce(atOnce);
    EXPECT_EQ(ErrorsOf(filter), OfAnotherType) << atOnce;
    auto* solids = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(solids, nullptr);
    for (const unsigned int block : { 0u, 2u })
    {
      EXPECT_GT(vtkUnstructuredGrid::SafeDownCast(solids->GetBlock(block))->GetNumberOfCells(), 0);
    }
  }
}

TEST(Blocks, OneOfAnotherTypeIsAnErrorOfAllFilters)
{
  const std::vector<vtkSmartPointer<vtkAlgorithm>> filters = {
    vtkSmartPointer<vtkConstrainedDelaunay3D>::New(),
    vtkSmartPointer<vtkGeneralizedWindingNumber>::New(),
    vtkSmartPointer<vtkResolveSelfIntersections>::New(), vtkSmartPointer<vtkSurfaceDefects>::New()
  };
  for (const auto& filter : filters)
  {
    filter->SetInputDataObject(BlocksOfTwoTypes());
    EXPECT_EQ(ErrorsOf(filter), OfAnotherType) << filter->GetClassName();
  }
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(Box());
  probe->SetInputDataObject(1, BlocksOfTwoTypes());
  EXPECT_EQ(ErrorsOf(probe), OfAnotherType);
}

namespace
{
/** Boxes that cross each other, and are sheared; more of them in some. */
vtkSmartPointer<vtkPolyData> CrossingBoxes(int number)
{
  const auto all = Box();
  for (int i = 0; i < 1 + number % 3; ++i)
  {
    const auto box = Box();
    const vtkIdType first = all->GetNumberOfPoints();
    for (vtkIdType p = 0; p < 8; ++p)
    {
      double x[3];
      box->GetPoint(p, x);
      const double shear = 0.1 * i * x[(i + number) % 3];
      all->GetPoints()->InsertNextPoint(x[0] + 0.3 * (i + 1) + shear, x[1] + shear, x[2] + 0.2 * i);
    }
    for (vtkIdType c = 0; c < box->GetNumberOfCells(); ++c)
    {
      vtkIdList* corners = box->GetCell(c)->GetPointIds();
      all->GetPolys()->InsertNextCell(4);
      for (vtkIdType k = 0; k < 4; ++k)
      {
        all->GetPolys()->InsertCellPoint(first + corners->GetId(k));
      }
    }
  }
  return all;
}

/** Blocks, one of which fails when it is read, and one when it is counted. */
vtkSmartPointer<vtkMultiBlockDataSet> ManyBlocks()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (int number = 0; number < 20; ++number)
  {
    blocks->SetBlock(number, CrossingBoxes(number));
  }
  blocks->SetBlock(7, BoxWithout(3));
  auto flat = Box();
  for (vtkIdType p = 0; p < 8; ++p)
  {
    flat->GetPoints()->SetPoint(p, p, 2 * p, 4 * p);
  }
  blocks->SetBlock(18, flat);
  return blocks;
}

/** Points, corners and w of all solids, bit by bit. */
std::vector<double> BitsOf(vtkDataObject* solids)
{
  std::vector<double> bits;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(solids);
  for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
  {
    auto* solid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(b));
    bits.push_back(solid ? static_cast<double>(solid->GetNumberOfCells()) : -1);
    for (vtkIdType p = 0; solid && p < solid->GetNumberOfPoints(); ++p)
    {
      bits.insert(bits.end(), solid->GetPoint(p), solid->GetPoint(p) + 3);
    }
    for (vtkIdType c = 0; solid && c < solid->GetNumberOfCells(); ++c)
    {
      vtkIdList* corners = solid->GetCell(c)->GetPointIds();
      bits.insert(bits.end(), corners->begin(), corners->end());
      bits.push_back(solid->GetCellData()->GetArray("w")->GetTuple1(c));
    }
  }
  return bits;
}
} // namespace

TEST(MeshAhead, SolidsAndErrorsAreTheSameForBlocksAtOnce)
{
  const testthreads::Allowed threads(4);
  const auto blocks = ManyBlocks();
  vtkNew<vtkRobustTetrahedralize> alone;
  alone->SetInputDataObject(blocks);
  const std::vector<std::string> errors = ErrorsOf(alone);
  ASSERT_EQ(errors.size(), 2u);
  const std::vector<double> expected = BitsOf(alone->GetOutputDataObject(0));
  EXPECT_GT(expected.size(), 1000u);
  for (const bool release : { false, true })
  {
    vtkNew<vtkRobustTetrahedralize> several;
    several->SetInputDataObject(blocks);
    several->SetBlocksAtOnce(2);
    several->SetReleaseDataFlag(release);
    EXPECT_EQ(ErrorsOf(several), errors) << release;
    EXPECT_EQ(BitsOf(several->GetOutputDataObject(0)), expected) << release;
    several->SetGamma(1.5);
    several->Update();
    several->SetGamma(alone->GetGamma());
    EXPECT_EQ(ErrorsOf(several), errors) << "a second time, release " << release;
    EXPECT_EQ(BitsOf(several->GetOutputDataObject(0)), expected) << release;
  }
}

TEST(MeshAhead, StopsAndThenMakesAll)
{
  const testthreads::Allowed threads(4);
  vtkNew<vtkRobustTetrahedralize> several;
  several->SetInputDataObject(ManyBlocks());
  several->SetBlocksAtOnce(2);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      auto* stopped = vtkRobustTetrahedralize::SafeDownCast(filter);
      if (stopped->GetProgressText())
      {
        stopped->SetAbortExecute(1);
      }
    });
  const unsigned long observer = several->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_TRUE(ErrorsOf(several).empty());
  for (const double cells : BitsOf(several->GetOutputDataObject(0)))
  {
    ASSERT_LE(cells, 0);
  }
  several->RemoveObserver(observer);
  several->SetAbortExecute(0);
  several->Modified();
  EXPECT_EQ(ErrorsOf(several).size(), 2u);
  EXPECT_GT(BitsOf(several->GetOutputDataObject(0)).size(), 1000u);
}
