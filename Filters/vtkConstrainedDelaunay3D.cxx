// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkConstrainedDelaunay3D.h"

#include "Common/Stages.h"
#include "Data/StatisticsArrays.h"
#include "In/Partitions.h"
#include "In/ReadCurve.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Resolve/FindIntersections.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"
#include "Tetrahedralize/Ladder.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

using namespace insideout;

vtkStandardNewMacro(vtkConstrainedDelaunay3D);

vtkConstrainedDelaunay3D::vtkConstrainedDelaunay3D()
{
  const ConstrainedDelaunayParameters delaunay;
  this->Engine = static_cast<int>(delaunay.Engine);
  this->TimeBudget = delaunay.TimeBudget;
  this->MemoryBudget = delaunay.MemoryBudget;
}

void vtkConstrainedDelaunay3D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
}

int vtkConstrainedDelaunay3D::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

const char* vtkConstrainedDelaunay3D::GetRungName(int rung)
{
  return RungName(rung);
}

namespace
{
/** TetGen's behavior is undefined if facets cross, so crossings have to be found before. */
void CheckThatNothingCrosses(
  const FacetComplex& surface, const vtkInsideOut::Surface& input, Monitor& monitor)
{
  const auto pairs = FindIntersections(surface.Points, surface.Facets, monitor);
  if (!pairs.empty())
  {
    throw Error(ErrorCode::SelfIntersecting,
      "cells " + std::to_string(input.CellOfFacet(surface, pairs.front()[0], +1)) + " and " +
        std::to_string(input.CellOfFacet(surface, pairs.front()[1], +1)) +
        " intersect, the first of " + std::to_string(pairs.size()) +
        " pairs: run vtkResolveSelfIntersections first");
  }
}
} // namespace

int vtkConstrainedDelaunay3D::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector);
  return 1;
}

int vtkConstrainedDelaunay3D::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputSurface(this);
      vtkInsideOut::RefusePlane(input);
      vtkInsideOut::AlgorithmMonitor monitor(
        this, { Stages::Validating, Stages::FindingIntersections, Stages::Tetrahedralizing });
      const vtkInsideOut::Surface surface =
        vtkInsideOut::ReadSurface(input, this->NonParticipatingArrayName);
      const CountedChain chain =
        CountFacets(surface.Soup, vtkInsideOut::ChainParametersOf(this), monitor);
      CheckThatNothingCrosses(chain.Surface, surface, monitor);
      Stopwatch stopwatch;
      const Tetrahedralization result =
        ConstrainedDelaunay(chain.Surface, vtkInsideOut::DelaunayParametersOf(this), monitor);
      Statistics statistics;
      AddMeshCounts(result, statistics);
      statistics.emplace_back("SecondsCDT", stopwatch.Lap());
      std::vector<std::string> warnings = chain.Warnings;
      AddWarnings(result, warnings);

      vtkInsideOut::MakeOutputs outputs(surface);
      output->ShallowCopy(outputs.MakeGrid(chain.Surface, result.Mesh));
      vtkInsideOut::AddStatistics(statistics, output);
      vtkInsideOut::Warn(this, warnings);
      vtkInsideOut::Warn(this, outputs.Warnings);
    });
}
