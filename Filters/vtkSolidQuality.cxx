// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSolidQuality.h"

#include "Common/Error.h"
#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Data/StatisticsArrays.h"
#include "In/Partitions.h"
#include "In/ReadGrid.h"
#include "In/ReadSolid.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Output/Topology.h"
#include "Quality/QualityOfMesh.h"
#include "Quality/SolidDefects.h"
#include "Quality/SolverFitness.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <utility>

using namespace insideout;

vtkStandardNewMacro(vtkSolidQuality);

void vtkSolidQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkSolidQuality::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector);
  return 1;
}

namespace
{
/** The regions of tetrahedra; empty without an array of one integer per cell. */
std::vector<Id> RegionsOf(const vtkInsideOut::GridTetrahedra& tetrahedra, vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetCellData()->GetArray("RegionId");
  if (!array || array->GetNumberOfComponents() != 1 || !vtkInsideOut::HasIntegers(array, grid))
  {
    return {};
  }
  std::vector<double> values;
  for (std::size_t c = 0; c < tetrahedra.Cells.size(); ++c)
  {
    values.push_back(array->GetComponent(tetrahedra.CellIds[c], 0));
  }
  return vtkInsideOut::NumberedAnew(values);
}

/** An array with a value for each of the first cells that were read, and 0 for others. */
template <typename Array, typename ValueOf>
void AddArray(const char* name, const vtkInsideOut::GridTetrahedra& tetrahedra, std::size_t cells,
  vtkUnstructuredGrid* grid, const ValueOf& valueOf)
{
  const auto array = vtkInsideOut::MakeArray<Array>(name, grid->GetNumberOfCells());
  array->Fill(0);
  for (std::size_t c = 0; c < cells; ++c)
  {
    array->SetValue(tetrahedra.CellIds[c], valueOf(c));
  }
  grid->GetCellData()->AddArray(array);
}

void MarkCells(const vtkInsideOut::GridTetrahedra& cells, const SolidDefects& defects,
  const std::vector<CellQuality>& qualities, vtkUnstructuredGrid* grid)
{
  const std::size_t tetrahedra = cells.Cells.size();
  AddArray<vtkDoubleArray>("MinDihedralAngle", cells, tetrahedra, grid,
    [&](std::size_t c) { return qualities[c].MinDihedralAngle(); });
  AddArray<vtkDoubleArray>("MaxDihedralAngle", cells, tetrahedra, grid,
    [&](std::size_t c) { return qualities[c].MaxDihedralAngle(); });
  AddArray<vtkDoubleArray>("RadiusEdgeRatio", cells, tetrahedra, grid,
    [&](std::size_t c) { return qualities[c].RadiusEdgeRatio; });
  AddArray<vtkDoubleArray>(
    "MeanRatio", cells, tetrahedra, grid, [&](std::size_t c) { return qualities[c].MeanRatio; });
  AddArray<vtkSignedCharArray>("Orientation", cells, cells.CellIds.size(), grid,
    [&](std::size_t c) { return defects.Orientations[c]; });
}
} // namespace

int vtkSolidQuality::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputGrid(this);
      vtkInsideOut::AlgorithmMonitor monitor(
        this, { Stages::Validating, Stages::FindingIntersections, Stages::Measuring });
      const vtkInsideOut::GridTetrahedra given = vtkInsideOut::ReadTetrahedraAndLayers(input);
      if (given.CellIds.empty())
      {
        throw Error(ErrorCode::EmptySurface, "the grid has no tetrahedra");
      }
      std::vector<std::string> warnings;
      const vtkIdType others =
        input->GetNumberOfCells() - static_cast<vtkIdType>(given.CellIds.size());
      if (others > 0)
      {
        warnings.push_back(std::to_string(others) + " cells are ignored: they are not tetrahedra");
      }
      const SolidDefects defects = FindSolidDefects(given.Points, given.Cells, given, monitor);
      const std::vector<CellQuality> qualities =
        QualityOfCells(given.Points, given.Cells, monitor, { Stages::Measuring, 0, 0.5 });
      const MeshQuality quality = SummarizeQuality(
        given.Cells, qualities, given.Points.size(), monitor, { Stages::Measuring, 0.5, 1 });

      vtkNew<vtkUnstructuredGrid> marked;
      marked->CopyStructure(input);
      vtkInsideOut::Attributes::PassAll(input,
        { "MinDihedralAngle", "MaxDihedralAngle", "RadiusEdgeRatio", "MeanRatio", "Orientation" },
        marked, warnings);
      MarkCells(given, defects, qualities, marked);
      marked->GetFieldData()->AddArray(
        vtkInsideOut::MakeArray<vtkIdTypeArray>("DihedralAngleHistogram",
          std::vector<vtkIdType>(quality.Histogram.begin(), quality.Histogram.end())));
      Statistics statistics;
      AppendSolidDefects(defects, statistics);
      if (given.HasLayers())
      {
        statistics.emplace_back("Pyramids", given.Pyramids.size());
        statistics.emplace_back("Prisms", given.Prisms.size());
      }
      AppendQuality(quality, statistics);
      const SolverFitness fitness = FitnessForSolver(given.Points, given.Cells, given.Midpoints,
        given, RegionsOf(given, input), monitor, { Stages::Measuring, 1, 1 });
      AppendFitness(fitness, statistics);
      if (!fitness.IsGood())
      {
        warnings.push_back(WordsOfFitness(
          fitness, vtkInsideOut::TreatmentOf(input), vtkInsideOut::MayBeRemeshed(input)));
      }
      if (defects.Conforms())
      {
        AppendTopology(FindTopology(given.Points.size(), defects.Parts, defects.Boundary,
                         defects.NumberOfRegions),
          statistics);
      }
      vtkInsideOut::AddStatistics(statistics, marked);
      output->ShallowCopy(marked);
      vtkInsideOut::Warn(this, warnings);
    });
}
