// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MarkCurve.h"

#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Data/StatisticsArrays.h"
#include "Out/MakeOutputs.h"

#include "Planar/CurveDefects.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace vtkInsideOut
{
using insideout::CurveDefect;
using insideout::CurveDefects;
using insideout::Id;
using insideout::None;

namespace
{
struct TypeOfPoint
{
  const char* Name;
  std::array<unsigned char, 3> Color;
};

/** By CurveDefect; colors as those of a surface's lines. */
constexpr std::array<TypeOfPoint, 3> TypesOfPoints = { {
  { "open end", { { 110, 0, 0 } } },
  { "crossing", { { 0, 0, 0 } } },
  { "T-junction", { { 150, 0, 200 } } },
} };

vtkSmartPointer<vtkPolyData> MarkedCells(
  const Curve& curve, const CurveDefects& defects, std::vector<std::string>& warnings)
{
  const vtkIdType size = curve.Input->GetNumberOfCells();
  const auto component = MakeArray<vtkIntArray>("ComponentId", size);
  const auto crossings = MakeArray<vtkIntArray>("SelfIntersections", size);
  const auto degenerate = MakeArray<vtkUnsignedCharArray>("Degenerate", size);
  const auto duplicate = MakeArray<vtkUnsignedCharArray>("Duplicate", size);
  const auto turned = MakeArray<vtkUnsignedCharArray>("Turned", size);
  component->FillValue(None);
  crossings->FillValue(0);
  degenerate->FillValue(0);
  duplicate->FillValue(0);
  turned->FillValue(0);
  for (const Id s : defects.TurnedSegments)
  {
    turned->SetValue(curve.CellOfSegment[s], 1);
  }
  for (std::size_t s = 0; s < defects.Segments.size(); ++s)
  {
    const insideout::SegmentDefects& segment = defects.Segments[s];
    const vtkIdType cell = curve.CellOfSegment[s];
    if (segment.Component != None &&
      (component->GetValue(cell) == None || segment.Component < component->GetValue(cell)))
    {
      component->SetValue(cell, segment.Component);
    }
    crossings->SetValue(cell, crossings->GetValue(cell) + segment.SelfIntersections);
    degenerate->SetValue(cell, degenerate->GetValue(cell) | segment.Degenerate);
    duplicate->SetValue(cell, duplicate->GetValue(cell) | segment.Duplicate);
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->CopyStructure(curve.Input);
  Attributes::PassAll(curve.Input,
    { "ComponentId", "SelfIntersections", "Degenerate", "Duplicate", "Turned" }, output, warnings);
  output->GetCellData()->AddArray(component);
  output->GetCellData()->AddArray(crossings);
  output->GetCellData()->AddArray(degenerate);
  output->GetCellData()->AddArray(duplicate);
  output->GetCellData()->AddArray(turned);
  return output;
}

vtkSmartPointer<vtkPolyData> MarkedPoints(const Curve& curve, const CurveDefects& defects)
{
  const vtkIdType size = static_cast<vtkIdType>(defects.Points.size());
  const auto type = MakeArray<vtkIntArray>("DefectType", size);
  const auto name = MakeArray<vtkStringArray>("DefectName", size);
  const auto color = MakeArray<vtkUnsignedCharArray>("DefectColor", size, 3);
  std::vector<insideout::Point> points;
  std::vector<Id> original;
  std::vector<std::array<Id, 1>> vertices;
  for (vtkIdType p = 0; p < size; ++p)
  {
    const insideout::CurveDefectPoint& point = defects.Points[p];
    const TypeOfPoint& of = TypesOfPoints[static_cast<std::size_t>(point.Type)];
    points.push_back(point.InputPoint == None ? curve.Plane.Lift(point.Place)
                                              : curve.Soup.Points[point.InputPoint]);
    original.push_back(point.InputPoint);
    vertices.push_back({ { static_cast<Id>(p) } });
    type->SetValue(p, FirstPointType + static_cast<int>(point.Type));
    name->SetValue(p, of.Name);
    color->SetTypedTuple(p, of.Color.data());
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(MakePoints(points));
  output->SetVerts(MakeCells(vertices));
  output->GetPointData()->AddArray(MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", original));
  output->GetCellData()->AddArray(type);
  output->GetCellData()->AddArray(name);
  output->GetCellData()->AddArray(color);
  return output;
}
} // namespace

MarkedCurve MarkCurve(const Curve& curve, const insideout::PlanarHullParameters& parameters,
  insideout::Monitor& monitor)
{
  const CurveDefects defects = FindCurveDefects(curve.Soup, curve.Plane, parameters, monitor);
  MarkedCurve marked;
  marked.Warnings = curve.Warnings;
  marked.Warnings.insert(marked.Warnings.end(), defects.Warnings.begin(), defects.Warnings.end());
  marked.Curve = MarkedCells(curve, defects, marked.Warnings);
  marked.Points = MarkedPoints(curve, defects);
  insideout::Statistics statistics = { { "Dimension", 2 } };
  AddCounts(defects.Counts, statistics);
  statistics.emplace_back("IntersectingPairs", defects.IntersectingPairs);
  statistics.emplace_back("TurnedSegments", defects.TurnedSegments.size());
  statistics.emplace_back("Area", defects.Areas.Winding);
  AddAreas(defects.Areas, statistics);
  for (const auto& [type, key] : { std::pair(CurveDefect::Crossing, "Crossings"),
         std::pair(CurveDefect::TJunction, "TJunctions") })
  {
    statistics.emplace_back(key,
      std::count_if(defects.Points.begin(), defects.Points.end(),
        [type = type](const insideout::CurveDefectPoint& point) { return point.Type == type; }));
  }
  for (const auto& output : { marked.Curve, marked.Points })
  {
    AddStatistics(statistics, output);
  }
  return marked;
}
} // namespace vtkInsideOut
