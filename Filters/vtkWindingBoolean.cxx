// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkWindingBoolean.h"

#include "Boolean/CellsOfExpression.h"
#include "Boolean/FindGaps.h"
#include "Boolean/SurfaceOfExpression.h"
#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Data/StatisticsArrays.h"
#include "In/FollowTime.h"
#include "In/ReadInputs.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Output/MergePieces.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <optional>

using namespace insideout;

vtkStandardNewMacro(vtkWindingBoolean);

vtkWindingBoolean::vtkWindingBoolean()
{
  this->SetNumberOfOutputPorts(2);
  this->Operation = static_cast<int>(SetOperation::Union);
}

void vtkWindingBoolean::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Expression: " << this->Expression << "\n";
  os << indent << "Operation: " << this->Operation << "\n";
  os << indent << "BodyNames:";
  for (const std::string& name : this->BodyNames)
  {
    os << " \"" << name << "\"";
  }
  os << "\n";
  os << indent << "Tetrahedra: " << this->Tetrahedra << "\n";
  os << indent << "MergeCoplanarPieces: " << this->MergeCoplanarPieces << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "TouchTolerance: " << this->TouchTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
}

void vtkWindingBoolean::AddBodyName(const char* name)
{
  this->BodyNames.emplace_back(name ? name : "");
  this->Modified();
}

void vtkWindingBoolean::ClearBodyNames()
{
  if (!this->BodyNames.empty())
  {
    this->BodyNames.clear();
    this->Modified();
  }
}

const char* vtkWindingBoolean::GetBodyName(int body) const
{
  return body >= 0 && body < this->GetNumberOfBodyNames() ? this->BodyNames[body].c_str() : nullptr;
}

int vtkWindingBoolean::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkWindingBoolean::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkUnstructuredGrid");
  return 1;
}

vtkUnstructuredGrid* vtkWindingBoolean::GetTetrahedraOutput()
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkWindingBoolean::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

int vtkWindingBoolean::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector);
  return 1;
}

namespace
{
BodyParameters ParametersOf(vtkWindingBoolean* filter)
{
  BodyParameters parameters;
  parameters.Chain = vtkInsideOut::ChainParametersOf(filter);
  parameters.Orientation = vtkInsideOut::OrientationOf(filter);
  parameters.TouchTolerance = filter->GetTouchTolerance();
  return parameters;
}

/** The inputs by the user's names. */
std::vector<vtkInsideOut::NamedSurface> NamedSurfaces(
  vtkWindingBoolean* filter, vtkInformationVector* inputs)
{
  std::vector<vtkInsideOut::NamedSurface> surfaces = vtkInsideOut::FindInputs(inputs);
  const std::size_t named = static_cast<std::size_t>(filter->GetNumberOfBodyNames());
  for (std::size_t body = 0; body < std::min(named, surfaces.size()); ++body)
  {
    const std::string name = filter->GetBodyName(static_cast<int>(body));
    surfaces[body].Name = name.empty() ? surfaces[body].Name : name;
  }
  return surfaces;
}

SetExpression ExpressionOf(vtkWindingBoolean* filter, const std::vector<std::string>& names)
{
  static_assert(vtkWindingBoolean::UNION == static_cast<int>(SetOperation::Union));
  static_assert(vtkWindingBoolean::INTERSECTION == static_cast<int>(SetOperation::Intersection));
  static_assert(vtkWindingBoolean::DIFFERENCE == static_cast<int>(SetOperation::Difference));
  static_assert(
    vtkWindingBoolean::SYMMETRIC_DIFFERENCE == static_cast<int>(SetOperation::SymmetricDifference));
  const std::string text = filter->GetExpression();
  if (text.empty())
  {
    return { static_cast<SetOperation>(filter->GetOperation()), static_cast<Id>(names.size()) };
  }
  return { text, names };
}

std::vector<std::string> NamesIn(
  const SetExpression& expression, const std::vector<std::string>& names)
{
  std::vector<std::string> named;
  for (const Id body : expression.Bodies())
  {
    named.push_back(names[body]);
  }
  return named;
}

/** The bodies named in the expression. The others' soups are released. */
std::vector<Body> TakeNamed(const SetExpression& expression, vtkInsideOut::Inputs& bodies)
{
  std::vector<Body> named;
  std::vector<char> isNamed(bodies.Bodies.size(), 0);
  for (const Id b : expression.Bodies())
  {
    isNamed[b] = 1;
    named.push_back(std::move(bodies.Bodies[b]));
    bodies.Bodies[b].Name = named.back().Name;
  }
  for (std::size_t b = 0; b < isNamed.size(); ++b)
  {
    if (!isNamed[b])
    {
      bodies.Surface.Warnings.push_back(
        "body " + bodies.Bodies[b].Name + " is not in the expression");
    }
  }
  return named;
}

/** Convert an id in the concatenation of all bodies to a body and the id in it; -1 stays. */
void SplitIds(const char* name, const std::vector<vtkIdType>& first, vtkDataSetAttributes* data)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(name));
  const auto bodies = vtkInsideOut::MakeArray<vtkIntArray>("BodyId", ids->GetNumberOfTuples());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const vtkIdType id = ids->GetValue(i);
    const auto next = std::upper_bound(first.begin(), first.end(), id);
    const auto body = id < 0 ? -1 : next - first.begin() - 1;
    bodies->SetValue(i, static_cast<int>(body));
    ids->SetValue(i, id < 0 ? -1 : id - first[body]);
  }
  data->AddArray(bodies);
}

Statistics FiguresOf(const ResolvedBodies& resolved, const std::vector<BoundaryTriangle>& boundary,
  const std::vector<Point>& points)
{
  const FacetComplex& surface = resolved.Surface;
  Statistics statistics;
  statistics.emplace_back("Bodies", resolved.NumberOfBodies());
  statistics.emplace_back("IntersectingPairs", resolved.IntersectingPairs);
  statistics.emplace_back("ResolvedPoints", surface.Points.size());
  statistics.emplace_back("ResolvedFacets", surface.NumberOfFacets());
  AddTouches(resolved, statistics);
  statistics.emplace_back("LeftOutFacets", surface.NumberOfFacets() - surface.NumberOfConstraints);
  statistics.emplace_back("BoundaryFaces", boundary.size());
  statistics.emplace_back("Volume", VolumeWithin(points, boundary));
  return statistics;
}

/** The cells of the result with their components: RegionId. */
vtkSmartPointer<vtkUnstructuredGrid> MakeSolid(const ResolvedBodies& resolved,
  const CellsOfExpression& cells, const vtkInsideOut::Inputs& inputs,
  vtkInsideOut::MakeOutputs& outputs, Monitor& monitor)
{
  const auto hull = outputs.MakeGrid(resolved.Surface, cells.Mesh);
  hull->GetCellData()->RemoveArray("FacetIds"); // they would number the cells of all inputs
  hull->GetCellData()->RemoveArray("FacetMultiplicity"); // a sum over bodies
  hull->GetFieldData()->Initialize();
  SplitIds("vtkOriginalPointIds", inputs.FirstPoint, hull->GetPointData());
  vtkInsideOut::AddInside(cells.Inside, hull);
  vtkInsideOut::AddRegions(
    FindRegions(cells.Mesh, cells.Inside, monitor, { Stages::Extracting, 1, 1 }), hull);
  return vtkInsideOut::ExtractInside(hull, monitor, { Stages::Extracting, 1, 1 });
}
} // namespace

int vtkWindingBoolean::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      vtkInsideOut::AlgorithmMonitor monitor(this,
        { Stages::Validating, Stages::FindingIntersections, Stages::Orienting, Stages::Resolving,
          Stages::Tetrahedralizing, Stages::WindingNumbers, Stages::Segmenting,
          Stages::Extracting });
      vtkInsideOut::RefuseSpreadParts(this);
      Stopwatch stopwatch;
      vtkInsideOut::Inputs inputs = vtkInsideOut::ReadInputs(NamedSurfaces(this, inputVector[0]));
      const std::vector<std::string> names = inputs.Names();
      const insideout::SetExpression expression = ExpressionOf(this, names);
      const ResolvedBodies resolved =
        ResolveBodies(TakeNamed(expression, inputs), ParametersOf(this), monitor);
      std::optional<ExpressionSurface> surface;
      std::optional<CellsOfExpression> cells;
      const bool hasGaps =
        this->MergeTolerance > 0 && MayHaveGaps(resolved, this->MergeTolerance, monitor);
      if (!this->Tetrahedra && !hasGaps)
      {
        surface = SurfaceOfExpression(resolved, expression, monitor);
      }
      if (!surface)
      {
        cells = FindCellsOfExpression(
          resolved, NamesIn(expression, names), expression, this->MergeTolerance, monitor);
      }

      vtkInsideOut::MakeOutputs outputs(inputs.Surface);
      const auto& points = cells ? cells->Mesh.Points : resolved.Surface.Points;
      const auto& origins = cells ? cells->Mesh.Origins : resolved.Surface.Origins;
      auto& boundary = surface ? surface->Boundary : cells->Boundary;
      if (this->MergeCoplanarPieces)
      {
        boundary =
          MergePieces(boundary, TrianglesInMesh(inputs.Surface.Soup, resolved.MergedInto, origins),
            monitor, { Stages::Extracting, 0, 1 });
      }
      output->ShallowCopy(
        outputs.MakeBoundary(points, origins, boundary, resolved.TurnedTriangles, {}));
      SplitIds("vtkOriginalCellIds", inputs.FirstCell, output->GetCellData());
      SplitIds("vtkOriginalPointIds", inputs.FirstPoint, output->GetPointData());
      for (const vtkInsideOut::SharedTags& tags : inputs.Tags)
      {
        if (tags.Names)
        {
          output->GetFieldData()->AddArray(tags.Names);
        }
      }
      vtkInsideOut::TagHoles(inputs.Tags, output);
      output->GetFieldData()->AddArray(vtkInsideOut::MakeStrings("BodyNames", names));
      Statistics statistics = FiguresOf(resolved, boundary, points);
      statistics.emplace_back("Tetrahedra", cells ? 1 : 0);
      if (cells)
      {
        statistics.insert(statistics.end(), cells->Statistics.begin(), cells->Statistics.end());
        vtkUnstructuredGrid::GetData(outputVector, 1)
          ->ShallowCopy(MakeSolid(resolved, *cells, inputs, outputs, monitor));
        vtkInsideOut::Warn(this, cells->Warnings);
      }
      statistics.emplace_back("SecondsBoolean", stopwatch.Lap());
      vtkInsideOut::AddStatistics(statistics, output);
      vtkInsideOut::Warn(this, resolved.Warnings);
      vtkInsideOut::Warn(this, outputs.Warnings);
    });
}
