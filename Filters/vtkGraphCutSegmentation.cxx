// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkGraphCutSegmentation.h"

#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "Data/StatisticsArrays.h"
#include "In/FollowTime.h"
#include "In/Partitions.h"
#include "In/ReadGrid.h"
#include "In/SeedsPort.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Out/PartSolid.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

using namespace insideout;

vtkStandardNewMacro(vtkGraphCutSegmentation);

vtkGraphCutSegmentation::vtkGraphCutSegmentation()
{
  this->SetNumberOfInputPorts(2);
  const SegmentMeshParameters segment;
  this->Gamma = segment.Cut.Gamma;
  this->Sigma = segment.Cut.Sigma;
  this->DataTerm = static_cast<int>(segment.Cut.DataTerm);
  this->ConstrainFacets = segment.ConstrainFacets;
  this->LargestRegions = static_cast<int>(segment.Topology.Regions.LargestRegions);
  this->MinimumRegionVolume = segment.Topology.Regions.MinimumRegionVolume;
  this->SeededRegions = segment.Topology.Regions.SeededRegions;
  this->FillCavities = segment.Topology.Regions.FillCavities;
  this->Topology = static_cast<int>(segment.Topology.Goal);
}

void vtkGraphCutSegmentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "DataTerm: " << this->DataTerm << "\n";
  os << indent << "ConstrainFacets: " << this->ConstrainFacets << "\n";
  os << indent << "NonManifold: " << this->NonManifold << "\n";
  os << indent << "LargestRegions: " << this->LargestRegions << "\n";
  os << indent << "MinimumRegionVolume: " << this->MinimumRegionVolume << "\n";
  os << indent << "SeededRegions: " << this->SeededRegions << "\n";
  os << indent << "FillCavities: " << this->FillCavities << "\n";
  os << indent << "Topology: " << this->Topology << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
}

SegmentMeshParameters vtkInsideOut::SegmentParametersOf(vtkGraphCutSegmentation* filter)
{
  static_assert(vtkGraphCutSegmentation::UNIFORM == static_cast<int>(DataTerm::Uniform));
  static_assert(
    vtkGraphCutSegmentation::VOLUME_WEIGHTED == static_cast<int>(DataTerm::VolumeWeighted));
  static_assert(vtkGraphCutSegmentation::TOPOLOGY_ANY == static_cast<int>(TopologyGoal::Any));
  static_assert(vtkGraphCutSegmentation::TOPOLOGY_ONE_COMPONENT ==
    static_cast<int>(TopologyGoal::OneComponent));
  static_assert(vtkGraphCutSegmentation::TOPOLOGY_SIMPLY_CONNECTED ==
    static_cast<int>(TopologyGoal::SimplyConnected));
  SegmentMeshParameters parameters;
  parameters.Cut.Gamma = filter->GetGamma();
  parameters.Cut.Sigma = filter->GetSigma();
  parameters.Cut.DataTerm = static_cast<DataTerm>(filter->GetDataTerm());
  parameters.ConstrainFacets = filter->GetConstrainFacets();
  parameters.FillNonManifold =
    filter->GetNonManifold() == vtkGraphCutSegmentation::NONMANIFOLD_FILL;
  parameters.Topology.Regions.LargestRegions = filter->GetLargestRegions();
  parameters.Topology.Regions.MinimumRegionVolume = filter->GetMinimumRegionVolume();
  parameters.Topology.Regions.SeededRegions = filter->GetSeededRegions();
  parameters.Topology.Regions.FillCavities = filter->GetFillCavities();
  parameters.Topology.Goal = static_cast<TopologyGoal>(filter->GetTopology());
  return parameters;
}

int vtkGraphCutSegmentation::FillInputPortInformation(int port, vtkInformation* info)
{
  return vtkInsideOut::FillPort(port, info, "vtkUnstructuredGrid");
}

void vtkGraphCutSegmentation::SetSeedsData(vtkDataObject* seeds)
{
  this->SetInputData(1, seeds);
}

void vtkGraphCutSegmentation::SetSeedsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

namespace
{
/** Cells of any type, without constraints. */
MeshSegmentation SegmentCells(
  vtkUnstructuredGrid* grid, const GraphCutParameters& parameters, Monitor& monitor)
{
  CellGraph graph;
  graph.W = vtkInsideOut::ReadWindingNumbers(grid);
  graph.Faces =
    SharedSides(vtkInsideOut::ReadPoints(grid, "the grid"), vtkInsideOut::ReadSides(grid));
  if (parameters.DataTerm == DataTerm::VolumeWeighted)
  {
    graph.Volumes = vtkInsideOut::ReadSizes(grid);
  }
  Segmentation segmentation = GraphCutSegmentation(graph, parameters, monitor);
  return { std::move(segmentation.Inside), { { "Energy", segmentation.Energy } }, {} };
}

/** @param[in] split whether to copy points at which the solid touches itself */
MeshSegmentation Segment(vtkUnstructuredGrid* grid, const std::vector<Seed>& seeds,
  const SegmentMeshParameters& parameters, bool split, Monitor& monitor)
{
  const bool isPlain = seeds.empty() && !parameters.ConstrainFacets &&
    !parameters.FillNonManifold && parameters.Topology.ChangeNothing() && !split;
  const vtkIdType other = vtkInsideOut::FindOtherCell(grid);
  if (other >= 0 && !isPlain)
  {
    throw Error(ErrorCode::InvalidParameter,
      "cell " + std::to_string(other) +
        " is not a tetrahedron; seeds and constraints need tetrahedra alone, and so do the choice "
        "of "
        "regions and Topology");
  }
  if (other >= 0)
  {
    return SegmentCells(grid, parameters.Cut, monitor);
  }
  if (parameters.ConstrainFacets && !vtkInsideOut::HasFacetIds(grid))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the grid has no cell array FacetIds of four values per cell, which tells the facets to "
      "keep");
  }
  const std::vector<double> w = vtkInsideOut::ReadWindingNumbers(grid);
  const TetrahedralMesh mesh = vtkInsideOut::ReadTetrahedra(grid);
  return SegmentMesh(mesh, w, PiecesOfFacets(mesh), seeds, parameters, monitor);
}
} // namespace

int vtkGraphCutSegmentation::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

int vtkGraphCutSegmentation::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector, this->GetNumberOfInputPorts());
  return 1;
}

int vtkGraphCutSegmentation::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputGrid(this);
      vtkInsideOut::AlgorithmMonitor monitor(this, { Stages::Segmenting });
      if (input->GetNumberOfCells() == 0)
      {
        throw Error(ErrorCode::EmptySurface, "the grid has no cells");
      }
      Stopwatch stopwatch;
      const bool split = this->NonManifold == NONMANIFOLD_SPLIT;
      if (split && !this->ExtractInside)
      {
        throw Error(ErrorCode::InvalidParameter,
          "NonManifold of the kind Split takes ExtractInside: only the cells inside can be parted");
      }
      const MeshSegmentation segmentation =
        Segment(input, vtkInsideOut::ReadSeeds(vtkInsideOut::FindSeeds(inputVector)),
          vtkInsideOut::SegmentParametersOf(this), split, monitor);

      vtkInsideOut::Parting parting;
      vtkSmartPointer<vtkUnstructuredGrid> labelled = vtkSmartPointer<vtkUnstructuredGrid>::New();
      labelled->ShallowCopy(input);
      if (split)
      {
        parting.Solid = UnpartedSolid(vtkInsideOut::ReadTetrahedra(input), segmentation.Inside);
        vtkInsideOut::SplitPoints(parting, monitor, { Stages::Segmenting, 1, 1 });
        labelled = vtkInsideOut::MakePartedGrid(input, parting);
      }
      vtkInsideOut::AddInside(segmentation.Inside, labelled);
      output->ShallowCopy(this->ExtractInside
          ? vtkInsideOut::ExtractInside(labelled, monitor, { Stages::Segmenting, 1, 1 }).Get()
          : labelled.Get());
      Statistics statistics = segmentation.Statistics;
      statistics.insert(statistics.end(), parting.Statistics.begin(), parting.Statistics.end());
      statistics.emplace_back(
        "InsideCells", std::count(segmentation.Inside.begin(), segmentation.Inside.end(), 1));
      statistics.emplace_back("SecondsCut", stopwatch.Lap());
      vtkInsideOut::AddStatistics(statistics, output);
      vtkInsideOut::Warn(this, segmentation.Warnings);
    });
}
