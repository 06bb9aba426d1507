// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkResolveSelfIntersections.h"

#include "Common/Stages.h"
#include "Data/Label.h"
#include "Data/StatisticsArrays.h"
#include "In/Partitions.h"
#include "In/ReadCurve.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <numeric>

using namespace insideout;

vtkStandardNewMacro(vtkResolveSelfIntersections);

vtkResolveSelfIntersections::vtkResolveSelfIntersections() = default;

void vtkResolveSelfIntersections::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
}

int vtkResolveSelfIntersections::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector);
  return 1;
}

int vtkResolveSelfIntersections::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputSurface(this);
      vtkInsideOut::RefuseLines(input);
      vtkInsideOut::AlgorithmMonitor monitor(
        this, { Stages::Validating, Stages::FindingIntersections, Stages::Resolving });
      const vtkInsideOut::Surface given =
        vtkInsideOut::ReadSurface(input, this->NonParticipatingArrayName);
      const CountedChain chain =
        CountFacets(given.Soup, vtkInsideOut::ChainParametersOf(this), monitor);
      const Resolution resolution = ResolveSelfIntersections(chain.Surface, monitor);
      const FacetComplex& surface = resolution.Surface;

      std::vector<Id> facets(surface.NumberOfConstraints);
      std::iota(facets.begin(), facets.end(), 0);
      vtkInsideOut::MakeOutputs outputs(given);
      output->ShallowCopy(outputs.MakeSurface(surface, facets));

      Statistics statistics;
      AddCounts(chain.Counts, statistics);
      statistics.emplace_back("IntersectingPairs", resolution.IntersectingPairs.size());
      statistics.emplace_back("ResolvedFacets", facets.size());
      statistics.emplace_back(
        "LeftOutFacets", surface.NumberOfFacets() - surface.NumberOfConstraints);
      vtkInsideOut::AddStatistics(statistics, output);
      outputs.AddLeftOutCells(surface, output);

      vtkInsideOut::Warn(this, chain.Warnings);
      vtkInsideOut::Warn(this, resolution.Warnings);
      vtkInsideOut::Warn(this, outputs.Warnings);
      if (surface.NumberOfConstraints < surface.NumberOfFacets())
      {
        const auto cells =
          vtkIdTypeArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("LeftOutCellIds"));
        vtkWarningMacro(
          << vtkInsideOut::Label(this) << surface.NumberOfFacets() - surface.NumberOfConstraints
          << " facets still cross others after rounding and are left out; they are pieces of "
          << cells->GetNumberOfValues() << " input cells, of which cell " << cells->GetValue(0)
          << " is the first");
      }
    });
}
