// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "InteriorFaces.h"
#include "MergePieces.h"
#include "NothingInside.h"
#include "vtkInsideOutConversion.h"
#include "vtkInsideOutMonitor.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

using namespace insideout;

vtkStandardNewMacro(vtkRobustTetrahedralize);

vtkRobustTetrahedralize::vtkRobustTetrahedralize()
{
  this->SetNumberOfOutputPorts(3);
}

void vtkRobustTetrahedralize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
  os << indent << "MergeCoplanarPieces: " << this->MergeCoplanarPieces << "\n";
  os << indent << "SplitSeams: " << this->SplitSeams << "\n";
  os << indent << "QuadratureOrder: " << this->QuadratureOrder << "\n";
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
}

int vtkRobustTetrahedralize::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkRobustTetrahedralize::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

vtkPolyData* vtkRobustTetrahedralize::GetBoundary()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPolyData* vtkRobustTetrahedralize::GetOutliers()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

namespace
{
/** Outputs 1 and 2, and their counts. */
struct Surfaces
{
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkSmartPointer<vtkPolyData> Outliers;
  Statistics Counts;
};

void CountOutliers(
  const HullMesh& hull, const std::vector<OutlierPiece>& pieces, Statistics& statistics)
{
  const auto count = [&](OutlierReason reason)
  {
    return std::count_if(pieces.begin(), pieces.end(),
      [&](const OutlierPiece& piece) { return piece.Reason == reason; });
  };
  statistics.emplace_back("OutlierFacets", pieces.size() + hull.DegenerateTriangles.size());
  statistics.emplace_back("OutliersByEnergy", count(OutlierReason::Energy));
  statistics.emplace_back("OutliersLost", count(OutlierReason::Lost));
  statistics.emplace_back("OutliersLeftOut", count(OutlierReason::LeftOut));
  statistics.emplace_back("OutliersDegenerate", hull.DegenerateTriangles.size());
}

Surfaces MakeSurfaces(const HullMesh& hull, const std::vector<unsigned char>& inside,
  bool mergePieces, bool splitSeams, vtkInsideOutConversion& conversion)
{
  Surfaces surfaces;
  std::vector<BoundaryTriangle> boundary =
    BoundaryTriangles(hull.Surface, hull.Mesh, BoundaryFaces(hull.Mesh, inside));
  if (mergePieces)
  {
    boundary = MergePieces(boundary, TrianglesInMesh(conversion.Soup, hull.MergedInto, hull.Mesh));
  }
  surfaces.Boundary = splitSeams ? conversion.MakeSeamedBoundary(hull, boundary)
                                 : conversion.MakeBoundary(hull, boundary);
  const Id seamPoints = conversion.CountSeamPoints(hull);
  if (seamPoints > 0 && !splitSeams)
  {
    conversion.Warnings.push_back(std::to_string(seamPoints) +
      " points were merged with ones that have other texture coordinates or normals: the boundary "
      "has the lowest id's; SplitSeams keeps them all");
  }
  surfaces.Counts.emplace_back("BoundaryFaces", boundary.size());
  surfaces.Counts.emplace_back("SeamPoints", seamPoints);

  const std::vector<OutlierPiece> outliers = OutlierPieces(hull.Surface, hull.Mesh, inside);
  surfaces.Outliers = conversion.MakeOutliers(hull, outliers);
  CountOutliers(hull, outliers, surfaces.Counts);
  return surfaces;
}
} // namespace

int vtkRobustTetrahedralize::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  return vtkInsideOutRun(this, outputVector,
    [&]()
    {
      vtkInsideOutMonitor monitor(this,
        { "validating", "finding self-intersections", "resolving self-intersections",
          "tetrahedralizing", "winding numbers", "segmenting" });
      vtkInsideOutConversion conversion(input, this->NonParticipatingArrayName);
      const HullMesh hull = MeshHull(conversion.Soup,
        { { this->MergeTolerance, this->CountDuplicates },
          static_cast<insideout::Orientation>(this->Orientation),
          { this->TimeBudget, this->MemoryBudget,
            static_cast<TetrahedralizationEngine>(this->Engine) },
          this->QuadratureOrder },
        monitor);

      Stopwatch stopwatch;
      const Segmentation segmentation = GraphCutSegmentation(
        hull.W, InteriorFaces(hull.Mesh), { this->Gamma, this->Sigma }, monitor);
      const double cutSeconds = stopwatch.Lap();
      const Surfaces surfaces = MakeSurfaces(
        hull, segmentation.Inside, this->MergeCoplanarPieces, this->SplitSeams, conversion);

      vtkSmartPointer<vtkUnstructuredGrid> solid = conversion.MakeGrid(hull);
      vtkInsideOutAddInside(segmentation.Inside, solid);
      if (this->ExtractInside)
      {
        solid = vtkInsideOutExtractInside(solid);
      }
      const auto insideCells =
        std::count(segmentation.Inside.begin(), segmentation.Inside.end(), 1);
      Statistics statistics = hull.Statistics;
      statistics.emplace_back("SecondsCut", cutSeconds);
      statistics.emplace_back("Energy", segmentation.Energy);
      statistics.emplace_back("InsideCells", insideCells);
      statistics.insert(statistics.end(), surfaces.Counts.begin(), surfaces.Counts.end());
      statistics.emplace_back("PeakMemory", PeakMemory());

      vtkUnstructuredGrid::GetData(outputVector, 0)->ShallowCopy(solid);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(surfaces.Boundary);
      vtkPolyData::GetData(outputVector, 2)->ShallowCopy(surfaces.Outliers);
      vtkInsideOutAddStatistics(statistics, vtkUnstructuredGrid::GetData(outputVector, 0));
      conversion.AddLeftOutCells(hull.Surface, vtkUnstructuredGrid::GetData(outputVector, 0));
      vtkInsideOutWarn(this, hull.Warnings);
      vtkInsideOutWarn(this, conversion.Warnings);
      if (insideCells == 0)
      {
        vtkWarningMacro(<< NothingInside(hull));
      }
    });
}
