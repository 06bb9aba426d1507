// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceDefects.h"

#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "Data/StatisticsArrays.h"
#include "In/Partitions.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Out/MarkCurve.h"
#include "Planar/CurveDefects.h"
#include "Planar/PlanarHull.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"
#include "Verdict.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace insideout;

static_assert(vtkSurfaceDefects::OPEN_END ==
  vtkInsideOut::FirstPointType + static_cast<int>(CurveDefect::OpenEnd));
static_assert(vtkSurfaceDefects::CROSSING ==
  vtkInsideOut::FirstPointType + static_cast<int>(CurveDefect::Crossing));
static_assert(vtkSurfaceDefects::T_JUNCTION ==
  vtkInsideOut::FirstPointType + static_cast<int>(CurveDefect::TJunction));

vtkStandardNewMacro(vtkSurfaceDefects);

vtkSurfaceDefects::vtkSurfaceDefects()
{
  this->SetNumberOfOutputPorts(2);
}

void vtkSurfaceDefects::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
}

vtkPolyData* vtkSurfaceDefects::GetLines()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

std::string vtkSurfaceDefects::GetVerdict()
{
  return vtkSurfaceDefects::GetVerdictOf(this->GetOutput()->GetFieldData());
}

std::string vtkSurfaceDefects::GetVerdictOf(vtkFieldData* statistics)
{
  return Verdict(vtkInsideOut::StatisticsOf(statistics));
}

std::string vtkSurfaceDefects::GetVolumeInWords(double volume, double low, double high)
{
  return VolumeInWords(volume, low, high);
}

namespace
{
using Color = std::array<unsigned char, 3>;

// Colors that color-blind readers can distinguish, by M. Okabe and K. Ito (2008). Facets that meet
// others have a light shade of their curves' color; curves stand out where facets are large.
constexpr Color CrossingColor = { { 250, 204, 168 } };
constexpr Color TurnedColor = { { 86, 180, 233 } };

struct TypeOfLine
{
  const char* Name;
  Color LineColor;
};

/** By DefectType. */
constexpr std::array<TypeOfLine, 4> TypesOfLines = { {
  { "open boundary", { { 0, 114, 178 } } },
  { "non-manifold edge", { { 204, 121, 167 } } },
  { "inconsistent edge", { { 0, 158, 115 } } },
  { "intersection curve", { { 213, 94, 0 } } },
} };

/** Light colors, consecutive ones far apart, and none similar to a defect's. */
Color ColorOfComponent(Id component)
{
  if (component == None)
  {
    return { { 128, 128, 128 } };
  }
  // Hues from yellow to green, by steps of the golden ratio, in three shades.
  constexpr double FirstHue = 60.0 / 360, HueRange = 100.0 / 360, GoldenRatio = 0.6180339887498949;
  const double hue = FirstHue + HueRange * std::fmod(0.8 + GoldenRatio * component, 1.0);
  const double value = 0.95 - 0.12 * (component % 3);
  constexpr double Saturation = 0.4;
  Color color;
  for (int k = 0; k < 3; ++k)
  {
    // The distance of the hue from the k-th primary color, in sixths of the circle.
    const double turn = std::abs(std::remainder(6 * hue - 2 * k, 6.0));
    const double strength = std::min(std::max(2 - turn, 0.0), 1.0);
    color[k] =
      static_cast<unsigned char>(std::lround(255 * value * (1 - Saturation * (1 - strength))));
  }
  return color;
}

void SetColor(vtkUnsignedCharArray* colors, vtkIdType cell, const Color& color)
{
  for (int k = 0; k < 3; ++k)
  {
    colors->SetTypedComponent(cell, k, color[k]);
  }
}

/** The combined defects of each cell's triangles, in the order of the cells. */
std::vector<TriangleDefects> DefectsOfCells(
  const SurfaceDefects& defects, const std::vector<vtkIdType>& cells, vtkIdType numberOfCells)
{
  std::vector<TriangleDefects> result(numberOfCells);
  for (std::size_t t = 0; t < cells.size(); ++t)
  {
    const TriangleDefects& triangle = defects.Triangles[t];
    TriangleDefects& cell = result[cells[t]];
    if (triangle.Component != None &&
      (cell.Component == None || triangle.Component < cell.Component))
    {
      cell.Component = triangle.Component;
    }
    if (triangle.Shell != None && (cell.Shell == None || triangle.Shell < cell.Shell))
    {
      cell.Shell = triangle.Shell;
    }
    cell.SelfIntersections += triangle.SelfIntersections;
    cell.Degenerate |= triangle.Degenerate;
    cell.Duplicate |= triangle.Duplicate;
    cell.Inconsistent |= triangle.Inconsistent;
    cell.TwoSided |= triangle.TwoSided;
    cell.Turned |= triangle.Turned;
    cell.Sheet |= triangle.Sheet;
    cell.Membrane |= triangle.Membrane;
  }
  return result;
}

void MarkCells(const std::vector<TriangleDefects>& cells, vtkCellData* data)
{
  const vtkIdType size = static_cast<vtkIdType>(cells.size());
  const auto component = vtkInsideOut::MakeArray<vtkIntArray>("ComponentId", size);
  const auto shell = vtkInsideOut::MakeArray<vtkIntArray>("ShellId", size);
  const auto crossings = vtkInsideOut::MakeArray<vtkIntArray>("SelfIntersections", size);
  const auto degenerate = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("Degenerate", size);
  const auto duplicate = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("Duplicate", size);
  const auto inconsistent = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("Inconsistent", size);
  const auto twoSided = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("TwoSided", size);
  const auto turned = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("Turned", size);
  const auto sheet = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("Sheet", size);
  const auto membrane = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("Membrane", size);
  const auto color = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("DefectColor", size, 3);
  for (vtkIdType c = 0; c < size; ++c)
  {
    const TriangleDefects& cell = cells[c];
    component->SetValue(c, cell.Component);
    shell->SetValue(c, cell.Shell);
    crossings->SetValue(c, cell.SelfIntersections);
    degenerate->SetValue(c, cell.Degenerate);
    duplicate->SetValue(c, cell.Duplicate);
    inconsistent->SetValue(c, cell.Inconsistent);
    twoSided->SetValue(c, cell.TwoSided);
    turned->SetValue(c, cell.Turned);
    sheet->SetValue(c, cell.Sheet);
    membrane->SetValue(c, cell.Membrane);
    SetColor(color, c,
      cell.SelfIntersections > 0 ? CrossingColor
        : cell.Turned            ? TurnedColor
                                 : ColorOfComponent(cell.Component));
  }
  data->AddArray(component);
  data->AddArray(shell);
  data->AddArray(crossings);
  data->AddArray(degenerate);
  data->AddArray(duplicate);
  data->AddArray(inconsistent);
  data->AddArray(twoSided);
  data->AddArray(turned);
  data->AddArray(sheet);
  data->AddArray(membrane);
  data->AddArray(color);
}

/** The type of each cell of output 1, in VTK's order: vertices, then lines. */
std::vector<DefectType> TypesOfCells(const std::vector<DefectLine>& lines)
{
  std::vector<DefectType> types;
  for (const bool isLine : { false, true })
  {
    for (const DefectLine& line : lines)
    {
      if ((line.Points.size() > 1) == isLine)
      {
        types.push_back(line.Type);
      }
    }
  }
  return types;
}

void NameLines(const std::vector<DefectType>& types, vtkCellData* data)
{
  const vtkIdType size = static_cast<vtkIdType>(types.size());
  const auto type = vtkInsideOut::MakeArray<vtkIntArray>("DefectType", size);
  const auto name = vtkInsideOut::MakeArray<vtkStringArray>("DefectName", size);
  const auto color = vtkInsideOut::MakeArray<vtkUnsignedCharArray>("DefectColor", size, 3);
  for (vtkIdType c = 0; c < size; ++c)
  {
    using Filter = vtkSurfaceDefects;
    static_assert(Filter::OPEN_BOUNDARY == static_cast<int>(DefectType::OpenBoundary));
    static_assert(Filter::NON_MANIFOLD_EDGE == static_cast<int>(DefectType::NonManifoldEdge));
    static_assert(Filter::INCONSISTENT_EDGE == static_cast<int>(DefectType::InconsistentEdge));
    static_assert(Filter::INTERSECTION_CURVE == static_cast<int>(DefectType::IntersectionCurve));
    const int value = static_cast<int>(types[c]);
    type->SetValue(c, value);
    name->SetValue(c, TypesOfLines[value].Name);
    SetColor(color, c, TypesOfLines[value].LineColor);
  }
  data->AddArray(type);
  data->AddArray(name);
  data->AddArray(color);
}
} // namespace

int vtkSurfaceDefects::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector);
  return 1;
}

namespace
{
PlanarHullParameters PlanarParameters(vtkSurfaceDefects* filter)
{
  PlanarHullParameters parameters;
  parameters.Chain.MergeTolerance = filter->GetMergeTolerance();
  parameters.Orientation = vtkInsideOut::OrientationOf(filter);
  return parameters;
}

/** The area covered by polygons in one plane. Its stages are reported as the last one. */
double AreaInAPlane(vtkPolyData* input, PlanarHullParameters parameters, Monitor& caller)
{
  struct AtTheEnd : Monitor
  {
    Monitor& Caller;
    explicit AtTheEnd(Monitor& caller)
      : Caller(caller)
    {
    }
    bool Continue(const char*, double) override
    {
      return this->Caller.Continue(Stages::TracingIntersections, 1);
    }
  };
  AtTheEnd monitor(caller);
  const vtkInsideOut::Curve curve = vtkInsideOut::ReadCurve(input, parameters.Orientation, "");
  parameters.Orientation = insideout::Orientation::AsGiven; // they were turned when read
  return MeshPlanarHull(curve.Soup, curve.Plane, parameters, monitor).Areas.Winding;
}
} // namespace

int vtkSurfaceDefects::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputSurface(this);
      if (vtkInsideOut::AreLines(input))
      {
        vtkInsideOut::AlgorithmMonitor monitor(this,
          { Stages::Validating, Stages::FindingIntersections, Stages::Resolving,
            Stages::Triangulating, Stages::Orienting, Stages::WindingNumbers });
        const PlanarHullParameters parameters = PlanarParameters(this);
        const vtkInsideOut::MarkedCurve marked = vtkInsideOut::MarkCurve(
          vtkInsideOut::ReadCurve(input, parameters.Orientation, ""), parameters, monitor);
        vtkPolyData::GetData(outputVector, 0)->ShallowCopy(marked.Curve);
        vtkPolyData::GetData(outputVector, 1)->ShallowCopy(marked.Points);
        vtkInsideOut::Warn(this, marked.Warnings);
        return;
      }
      vtkInsideOut::AlgorithmMonitor monitor(this,
        { Stages::Validating, Stages::Orienting, Stages::FindingIntersections, Stages::Resolving,
          Stages::WindingNumbers, Stages::TracingIntersections });
      const vtkInsideOut::Surface given = vtkInsideOut::ReadSurface(input);
      const SurfaceDefects defects = FindSurfaceDefects(
        given.Soup, this->MergeTolerance, vtkInsideOut::OrientationOf(this), monitor);

      vtkInsideOut::MakeOutputs outputs(given);
      const auto surface =
        outputs.CopySurface({ "ComponentId", "ShellId", "SelfIntersections", "Degenerate",
          "Duplicate", "Inconsistent", "TwoSided", "Turned", "Sheet", "Membrane", "DefectColor" });
      MarkCells(DefectsOfCells(defects, given.CellOfTriangle, input->GetNumberOfCells()),
        surface->GetCellData());
      surface->GetFieldData()->AddArray(
        vtkInsideOut::MakeArray<vtkDoubleArray>("ShellVolumes", defects.Turns.ShellVolumes));
      const auto lines = vtkInsideOut::MakeLines(defects);
      NameLines(TypesOfCells(defects.Lines), lines->GetCellData());

      Statistics statistics;
      AddDefects(defects, statistics);
      if (defects.Planar)
      {
        statistics.emplace_back("Area", AreaInAPlane(input, PlanarParameters(this), monitor));
      }
      for (int port = 0; port < 2; ++port)
      {
        vtkPolyData* output = vtkPolyData::GetData(outputVector, port);
        output->ShallowCopy(port == 0 ? surface : lines);
        vtkInsideOut::AddStatistics(statistics, output);
      }
      vtkInsideOut::Warn(this, defects.Warnings);
      vtkInsideOut::Warn(this, outputs.Warnings);
    });
}
