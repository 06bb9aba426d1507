// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "InsideBoundary.h"
#include "InteriorFaces.h"
#include "vtkInsideOutConversion.h"
#include "vtkInsideOutMemory.h"
#include "vtkInsideOutMonitor.h"
#include "vtkInsideOutWholeInput.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <tuple>

using namespace insideout;

vtkStandardNewMacro(vtkRobustTetrahedralize);

namespace
{
/** What decides about the hull, to be compared. Does not compile once a parameter is added: it may
 * not be missing here. */
auto AsTuple(const HullMeshParameters& parameters)
{
  const auto& [chain, orientation, budgets, quadratureOrder] = parameters;
  const auto& [mergeTolerance, countDuplicates] = chain;
  const auto& [seconds, mebibytes, engine] = budgets;
  return std::make_tuple(
    mergeTolerance, countDuplicates, orientation, seconds, mebibytes, engine, quadratureOrder);
}
} // namespace

/** The hull of an input, which the segmentation does not change. */
struct vtkRobustTetrahedralize::HullOfInput
{
  HullOfInput(vtkPolyData* input, const HullMeshParameters& parameters, Monitor& monitor)
    : Input(ShallowCopyOf(input))
    , Conversion(this->Input)
    , Hull(MeshHull(this->Conversion.Soup, parameters, monitor))
    , Faces(InteriorFaces(this->Hull.Mesh))
    , Grid(this->Conversion.MakeGrid(this->Hull))
    , Warnings(this->Conversion.Warnings)
  {
  }

  static vtkSmartPointer<vtkPolyData> ShallowCopyOf(vtkPolyData* input)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(input);
    return copy;
  }

  vtkSmartPointer<vtkPolyData> Input; ///< what the conversion reads from, however long it lives
  vtkInsideOutConversion Conversion;
  HullMesh Hull;
  std::vector<InteriorFace> Faces;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::vector<std::string> Warnings; ///< the conversion's so far
};

class vtkRobustTetrahedralize::Memory
  : public vtkInsideOutMemory<decltype(AsTuple(std::declval<HullMeshParameters>())), HullOfInput>
{
};

vtkRobustTetrahedralize::vtkRobustTetrahedralize()
  : Hulls(new Memory)
{
  this->SetNumberOfOutputPorts(3);
}

vtkRobustTetrahedralize::~vtkRobustTetrahedralize() = default;

void vtkRobustTetrahedralize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
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

int vtkRobustTetrahedralize::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOutRequestWhole(inputVector, outputVector);
  return 1;
}

int vtkRobustTetrahedralize::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  return vtkInsideOutRunOnWhole(this, outputVector,
    [&]()
    {
      vtkInsideOutMonitor monitor(this,
        { "validating", "finding self-intersections", "resolving self-intersections",
          "tetrahedralizing", "winding numbers", "segmenting" });
      const HullMeshParameters parameters = { { this->MergeTolerance, this->CountDuplicates },
        static_cast<insideout::Orientation>(this->Orientation),
        { this->TimeBudget, this->MemoryBudget,
          static_cast<TetrahedralizationEngine>(this->Engine) },
        this->QuadratureOrder };
      const std::shared_ptr<HullOfInput> kept = this->Hulls->Get(input, AsTuple(parameters),
        [&]() { return std::make_shared<HullOfInput>(input, parameters, monitor); });
      if (this->GetReleaseDataFlag())
      {
        this->Hulls->Forget();
      }
      const HullMesh& hull = kept->Hull;
      vtkInsideOutConversion& conversion = kept->Conversion;
      conversion.Warnings = kept->Warnings;

      Stopwatch stopwatch;
      const Segmentation segmentation =
        GraphCutSegmentation(hull.W, kept->Faces, { this->Gamma, this->Sigma }, monitor);
      const double cutSeconds = stopwatch.Lap();
      const std::vector<BoundaryFace> faces = BoundaryFaces(hull.Mesh, segmentation.Inside);
      const std::vector<Id> outliers = OutlierFacets(hull.Surface, hull.Mesh, segmentation.Inside);

      auto solid = vtkSmartPointer<vtkUnstructuredGrid>::New();
      solid->ShallowCopy(kept->Grid);
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
      vtkInsideOutWarn(this, conversion.Warnings);
      if (insideCells == 0)
      {
        vtkWarningMacro(<< NothingInside(hull.W));
      }
    });
}
