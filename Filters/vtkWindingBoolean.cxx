// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkWindingBoolean.h"

#include "Boolean/SurfaceOfExpression.h"
#include "Common/Stages.h"
#include "Private/vtkInsideOutArrays.h"
#include "Private/vtkInsideOutMakeOutputs.h"
#include "Private/vtkInsideOutMonitor.h"
#include "Private/vtkInsideOutOptions.h"
#include "Private/vtkInsideOutReadBodies.h"
#include "Private/vtkInsideOutRun.h"
#include "Private/vtkInsideOutWholeInput.h"

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

using namespace insideout;

vtkStandardNewMacro(vtkWindingBoolean);

vtkWindingBoolean::vtkWindingBoolean()
{
  this->SetNumberOfOutputPorts(2);
  this->Operation = static_cast<int>(SetOperation::Union);
  const BodyParameters parameters;
  this->Orientation = static_cast<int>(parameters.Orientation);
  this->MergeTolerance = parameters.Chain.MergeTolerance;
  this->CountDuplicates = parameters.Chain.CountDuplicates;
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
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
}

void vtkWindingBoolean::SetBodyName(int body, const char* name)
{
  const std::string given = name ? name : "";
  if (body < 0 || given == this->GetBodyName(body))
  {
    return;
  }
  this->BodyNames.resize(std::max<std::size_t>(this->BodyNames.size(), body + 1));
  this->BodyNames[body] = given;
  this->Modified();
}

const char* vtkWindingBoolean::GetBodyName(int body) const
{
  return body >= 0 && body < this->GetNumberOfBodyNames() ? this->BodyNames[body].c_str() : "";
}

int vtkWindingBoolean::GetNumberOfBodyNames() const
{
  return static_cast<int>(this->BodyNames.size());
}

void vtkWindingBoolean::ClearBodyNames()
{
  if (!this->BodyNames.empty())
  {
    this->BodyNames.clear();
    this->Modified();
  }
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

int vtkWindingBoolean::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOutRequestWhole(inputVector, outputVector);
  return 1;
}

namespace
{
BodyParameters ParametersOf(vtkWindingBoolean* filter)
{
  BodyParameters parameters;
  parameters.Chain = vtkInsideOutChainParameters(filter);
  parameters.Orientation = vtkInsideOutOrientation(filter);
  return parameters;
}

SetExpression ExpressionOf(vtkWindingBoolean* filter, const vtkInsideOutBodies& bodies)
{
  static_assert(vtkWindingBoolean::UNION == static_cast<int>(SetOperation::Union));
  static_assert(vtkWindingBoolean::INTERSECTION == static_cast<int>(SetOperation::Intersection));
  static_assert(vtkWindingBoolean::DIFFERENCE == static_cast<int>(SetOperation::Difference));
  static_assert(
    vtkWindingBoolean::SYMMETRIC_DIFFERENCE == static_cast<int>(SetOperation::SymmetricDifference));
  const std::string text = filter->GetExpression();
  if (text.empty())
  {
    return { static_cast<SetOperation>(filter->GetOperation()),
      static_cast<Id>(bodies.Bodies.size()) };
  }
  return { text, bodies.Names() };
}

/** Those that the expression names. The others' soups are gone then. */
std::vector<Body> TakeNamed(const SetExpression& expression, vtkInsideOutBodies& bodies)
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

/** Say of an id in the row of all bodies' of which body it is and which of that; -1 stays. */
void SplitIds(const char* name, const std::vector<vtkIdType>& first, vtkDataSetAttributes* data)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(name));
  const auto bodies = vtkInsideOutMakeArray<vtkIntArray>("BodyId", ids->GetNumberOfTuples());
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
} // namespace

int vtkWindingBoolean::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return vtkInsideOutRunOnWhole(this, outputVector,
    [&]()
    {
      vtkInsideOutMonitor monitor(this,
        { Stages::Validating, Stages::Orienting, Stages::FindingIntersections, Stages::Resolving,
          Stages::WindingNumbers, Stages::Extracting });
      Stopwatch stopwatch;
      std::vector<vtkInsideOutNamedSurface> surfaces = vtkInsideOutFindBodies(inputVector[0]);
      for (std::size_t b = 0; b < surfaces.size() && b < this->BodyNames.size(); ++b)
      {
        surfaces[b].Name = this->BodyNames[b].empty() ? surfaces[b].Name : this->BodyNames[b];
      }
      vtkInsideOutBodies bodies = vtkInsideOutReadBodies(surfaces);
      const std::vector<std::string> names = bodies.Names();
      const insideout::SetExpression expression = ExpressionOf(this, bodies);
      const ResolvedBodies resolved =
        ResolveBodies(TakeNamed(expression, bodies), ParametersOf(this), monitor);
      const auto triangles = SurfaceOfExpression(resolved, expression, monitor);
      if (!triangles)
      {
        throw Error(ErrorCode::InvalidParameter, "a body is open");
      }
      vtkInsideOutMakeOutputs outputs(bodies.Surface);
      output->ShallowCopy(outputs.MakeBoundary(
        resolved.Surface.Points, resolved.Surface.Origins, *triangles, resolved.TurnedTriangles));
      SplitIds("vtkOriginalCellIds", bodies.FirstCell, output->GetCellData());
      SplitIds("vtkOriginalPointIds", bodies.FirstPoint, output->GetPointData());
      output->GetFieldData()->AddArray(vtkInsideOutMakeStrings("BodyNames", names));

      Statistics statistics;
      statistics.emplace_back("Bodies", resolved.NumberOfBodies());
      statistics.emplace_back("IntersectingPairs", resolved.IntersectingPairs);
      statistics.emplace_back("ResolvedFacets", resolved.Surface.NumberOfFacets());
      statistics.emplace_back("Tetrahedra", 0);
      statistics.emplace_back("BoundaryFaces", triangles->size());
      statistics.emplace_back("Volume", VolumeWithin(resolved.Surface.Points, *triangles));
      statistics.emplace_back("SecondsBoolean", stopwatch.Lap());
      vtkInsideOutAddStatistics(statistics, output);
      vtkInsideOutWarn(this, resolved.Warnings);
      vtkInsideOutWarn(this, outputs.Warnings);
    });
}
