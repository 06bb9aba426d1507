// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "InsideBoundary.h"
#include "SegmentMesh.h"
#include "vtkInsideOutConversion.h"
#include "vtkInsideOutMonitor.h"
#include "vtkInsideOutSegmentation.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

using namespace insideout;

vtkStandardNewMacro(vtkRobustTetrahedralize);

vtkRobustTetrahedralize::vtkRobustTetrahedralize()
{
  this->SetConstrainedFacetsArrayName("");
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkRobustTetrahedralize::~vtkRobustTetrahedralize()
{
  this->SetConstrainedFacetsArrayName(nullptr);
}

void vtkRobustTetrahedralize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "DataTerm: " << this->DataTerm << "\n";
  os << indent << "ConstrainFacets: " << this->ConstrainFacets << "\n";
  os << indent << "ConstrainManifold: " << this->ConstrainManifold << "\n";
  os << indent << "ConstrainedFacetsArrayName: "
     << (this->ConstrainedFacetsArrayName ? this->ConstrainedFacetsArrayName : "(none)") << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "QuadratureOrder: " << this->QuadratureOrder << "\n";
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
}

int vtkRobustTetrahedralize::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

void vtkRobustTetrahedralize::SetSeedsData(vtkPointSet* seeds)
{
  this->SetInputData(1, seeds);
}

void vtkRobustTetrahedralize::SetSeedsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
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
vtkSmartPointer<vtkPolyData> MakeBoundary(
  vtkInsideOutConversion& conversion, const HullMesh& hull, const std::vector<BoundaryFace>& faces)
{
  std::vector<Triangle> triangles;
  std::vector<vtkIdType> cells;
  for (const BoundaryFace& face : faces)
  {
    triangles.push_back(face.Corners);
    cells.push_back(face.Facet == None ? -1
                                       : conversion.CellOfFacet(hull.Surface, face.Facet,
                                           hull.Mesh.FacetSides[face.Cell][face.Face]));
  }
  return conversion.MakeSurface(hull.Mesh, triangles, cells);
}

std::string NothingInside(const std::vector<double>& w)
{
  const auto [least, most] = std::minmax_element(w.begin(), w.end());
  return "nothing is inside: w ranges from " + std::to_string(*least) + " to " +
    std::to_string(*most) +
    ". The surface may be two-sided, too open, or face both ways; look at w in the whole hull";
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
      vtkInsideOutConversion conversion(input);
      const std::vector<Seed> seeds = vtkInsideOutReadSeeds(vtkPointSet::GetData(inputVector[1]));
      const HullMesh hull = MeshHull(conversion.Soup,
        { { this->MergeTolerance, this->CountDuplicates },
          static_cast<insideout::Orientation>(this->Orientation),
          { this->TimeBudget, this->MemoryBudget,
            static_cast<TetrahedralizationEngine>(this->Engine) },
          this->QuadratureOrder },
        monitor);

      Stopwatch stopwatch;
      const std::vector<unsigned char> chosen = vtkInsideOutChosenFacets(input,
        this->ConstrainedFacetsArrayName ? this->ConstrainedFacetsArrayName : "", hull.Surface,
        conversion.GetCellOfTriangle());
      const MeshSegmentation segmentation =
        SegmentMesh(hull.Mesh, hull.W, PiecesOfFacets(hull.Mesh, chosen), seeds,
          { { this->Gamma, this->Sigma, static_cast<insideout::DataTerm>(this->DataTerm) },
            this->ConstrainFacets, this->ConstrainManifold },
          monitor);
      const double cutSeconds = stopwatch.Lap();
      const std::vector<BoundaryFace> faces = BoundaryFaces(hull.Mesh, segmentation.Inside);
      const std::vector<Id> outliers = OutlierFacets(hull.Surface, hull.Mesh, segmentation.Inside);

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
      statistics.insert(
        statistics.end(), segmentation.Statistics.begin(), segmentation.Statistics.end());
      statistics.emplace_back("InsideCells", insideCells);
      statistics.emplace_back("BoundaryFaces", faces.size());
      statistics.emplace_back("OutlierFacets", outliers.size());
      statistics.emplace_back("PeakMemory", PeakMemory());

      vtkUnstructuredGrid::GetData(outputVector, 0)->ShallowCopy(solid);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(MakeBoundary(conversion, hull, faces));
      vtkPolyData::GetData(outputVector, 2)
        ->ShallowCopy(conversion.MakeSurface(hull.Surface, outliers));
      vtkInsideOutAddStatistics(statistics, vtkUnstructuredGrid::GetData(outputVector, 0));
      conversion.AddLeftOutCells(hull.Surface, vtkUnstructuredGrid::GetData(outputVector, 0));
      vtkInsideOutWarn(this, hull.Warnings);
      vtkInsideOutWarn(this, segmentation.Warnings);
      vtkInsideOutWarn(this, conversion.Warnings);
      if (insideCells == 0)
      {
        vtkWarningMacro(<< NothingInside(hull.W));
      }
    });
}
