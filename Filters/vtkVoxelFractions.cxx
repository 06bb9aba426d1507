// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkVoxelFractions.h"

#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "In/FollowTime.h"
#include "In/Partitions.h"
#include "In/ReadGrid.h"
#include "Output/VoxelFractions.h"
#include "Probe/VisitPlaces.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkAlgorithmOutput.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

using namespace insideout;

vtkStandardNewMacro(vtkVoxelFractions);

vtkVoxelFractions::vtkVoxelFractions()
{
  this->SetNumberOfInputPorts(2);
}

void vtkVoxelFractions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkVoxelFractions::SetSolidData(vtkDataObject* solid)
{
  this->SetInputData(1, solid);
}

void vtkVoxelFractions::SetSolidConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

int vtkVoxelFractions::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkRectilinearGrid");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  return 1;
}

int vtkVoxelFractions::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

/** Each piece of the output needs the whole solid. */
int vtkVoxelFractions::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (vtkInformation* solid = inputVector[1]->GetInformationObject(0))
  {
    solid->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    solid->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    solid->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return done;
}

namespace
{
std::array<std::vector<double>, 3> ReadSides(vtkDataSet* input)
{
  GridPlaces grid;
  if (!vtkInsideOut::ReadAxes(input, true, grid))
  {
    throw Error(
      ErrorCode::InvalidParameter, "the image has no points, or its axes are not x, y and z");
  }
  double smallest = 1; // volume of a voxel
  double largest = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& sides = grid.Axes[axis];
    const auto doNotAscend = [](double a, double b) { return !(a < b); };
    if (sides.size() < 2 ||
      std::adjacent_find(sides.begin(), sides.end(), doNotAscend) != sides.end())
    {
      throw Error(ErrorCode::InvalidParameter,
        std::string("the grid's coordinates along ") + "xyz"[axis] +
          " are fewer than two, or do not ascend");
    }
    double shortest = sides[1] - sides[0];
    double longest = shortest;
    for (std::size_t i = 2; i < sides.size(); ++i)
    {
      shortest = std::min(shortest, sides[i] - sides[i - 1]);
      longest = std::max(longest, sides[i] - sides[i - 1]);
    }
    smallest *= shortest;
    largest *= longest;
  }
  if (!std::isnormal(smallest) || !std::isfinite(largest))
  {
    throw Error(ErrorCode::InvalidParameter,
      std::string("the voxels are too ") + (std::isfinite(largest) ? "small" : "large") +
        ": the volume of one is out of the range of doubles");
  }
  return grid.Axes;
}

/** The tetrahedra that count. */
std::vector<Tetrahedron> ReadInside(
  vtkUnstructuredGrid* solid, const vtkInsideOut::GridTetrahedra& all)
{
  vtkDataArray* const inside = solid->GetCellData()->GetArray("Inside");
  if (inside && inside->GetNumberOfTuples() != solid->GetNumberOfCells())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the cell array Inside has " + std::to_string(inside->GetNumberOfTuples()) + " tuples for " +
        std::to_string(solid->GetNumberOfCells()) + " cells");
  }
  std::vector<Tetrahedron> cells;
  for (std::size_t c = 0; c < all.Cells.size(); ++c)
  {
    if (!inside || inside->GetComponent(all.CellIds[c], 0) != 0)
    {
      cells.push_back(all.Cells[c]);
    }
  }
  return cells;
}
} // namespace

int vtkVoxelFractions::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  vtkDataObject* given = vtkDataObject::GetData(inputVector[1]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  return vtkInsideOut::Run(this, outputVector,
    [&]()
    {
      vtkInsideOut::AlgorithmMonitor monitor(this, { Stages::Measuring });
      const vtkSmartPointer<vtkUnstructuredGrid> solid =
        vtkUnstructuredGrid::SafeDownCast(vtkInsideOut::JoinDataSets(given, "Inside"));
      if (!solid)
      {
        throw Error(ErrorCode::InvalidParameter, "the solid has no blocks");
      }
      const vtkInsideOut::GridTetrahedra tetrahedra = vtkInsideOut::ReadTetrahedraOfAnyOrder(solid);
      const std::vector<double> fractions = VoxelFractions(tetrahedra.Points,
        ReadInside(solid, tetrahedra), ReadSides(input), monitor, { Stages::Measuring, 0, 1 });
      output->ShallowCopy(input);
      std::vector<std::string> warnings;
      vtkInsideOut::Attributes::RenameArrays(
        output->GetCellData(), false, { "VolumeFraction" }, warnings);
      output->GetCellData()->AddArray(
        vtkInsideOut::MakeArray<vtkDoubleArray>("VolumeFraction", fractions));
      // SetScalars would remove earlier arrays.
      output->GetCellData()->SetActiveScalars("VolumeFraction");
      vtkInsideOut::Warn(this, warnings);
    });
}
