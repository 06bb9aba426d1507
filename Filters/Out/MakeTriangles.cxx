// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeTriangles.h"

#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Data/StatisticsArrays.h"
#include "In/ReadSurface.h"
#include "Out/MakeOutputs.h"
#include "Out/MixInCells.h"

#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Planar/PlanarOutputs.h"
#include "Planar/SegmentTriangles.h"
#include "Planar/WindingNumberOfTriangles.h"
#include "Refine/RefineTriangles.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <tuple>

namespace vtkInsideOut
{
using insideout::Id;
using insideout::None;
using insideout::OutlierReason;
using insideout::PlanarHull;
using insideout::Point;
using insideout::PointOrigin;
using insideout::Segment;
using insideout::Stages::Extracting;

namespace
{
template <typename Value>
std::vector<Value> ChosenOf(const std::vector<Value>& values, const std::vector<Id>& chosen)
{
  std::vector<Value> result;
  result.reserve(chosen.size());
  for (const Id i : chosen)
  {
    result.push_back(values[i]);
  }
  return result;
}

/** The refined part of a hull: its points are interpolated between those of a grid. */
struct RefinedHull
{
  PlanarHull Hull; ///< of the inside cells
  std::vector<Attributes::Mixture> Mixtures;
  vtkSmartPointer<vtkUnstructuredGrid> Before;
};

/** Makes data sets with the input's point and cell data. */
class Maker
{
public:
  Maker(const Curve& curve, const PlanarHull& hull)
    : Curve(curve)
    , Hull(hull)
    , Origins(hull.Curve.Origins)
  {
    for (std::size_t p = 0; p < hull.Curve.Points.size(); ++p)
    {
      const PointOrigin& origin = hull.Curve.Origins[p];
      this->Points.push_back(origin.IsInput() ? curve.Soup.Points[origin.Points[0]]
                                              : hull.Plane.Lift(hull.Curve.Points[p]));
    }
    for (const Id segment : hull.TurnedSegments)
    {
      this->TurnedCells.push_back(curve.CellOfSegment[segment]);
    }
    this->TurnedCells.insert(
      this->TurnedCells.end(), curve.TurnedCells.begin(), curve.TurnedCells.end());
    insideout::SortUniquely(this->TurnedCells);
  }

  Maker(const Curve& curve, const RefinedHull& refined)
    : Maker(curve, refined.Hull)
  {
    this->Refined = &refined;
  }

  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid();
  vtkSmartPointer<vtkPolyData> MakeResolved();
  vtkSmartPointer<vtkPolyData> MakeBoundary(const std::vector<unsigned char>& inside);
  vtkSmartPointer<vtkPolyData> MakeOutliers(const std::vector<insideout::OutlierSegment>& outliers);
  void AddLeftOutCells(vtkDataSet* output) const;

  std::vector<std::string> Warnings;

private:
  vtkIdType CellOf(Id segment, int side) const
  {
    return this->Curve.CellOfSegment[SourceOfSegment(this->Hull.Curve, segment, side)];
  }
  bool IsTurned(vtkIdType cell) const
  {
    return std::binary_search(this->TurnedCells.begin(), this->TurnedCells.end(), cell);
  }
  void AddPointData(const std::vector<Id>& points, vtkDataSet* output);
  vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<Segment>& segments,
    const std::vector<std::vector<Id>>& lines, const std::vector<vtkIdType>& cells,
    std::initializer_list<const char*> added);

  const vtkInsideOut::Curve& Curve;
  const PlanarHull& Hull;
  std::vector<Point> Points; ///< of the mesh, in space; then ends of degenerate segments
  std::vector<PointOrigin> Origins;
  std::vector<vtkIdType> TurnedCells;
  const RefinedHull* Refined = nullptr;
};

/** The origins of some of the points. */
void Maker::AddPointData(const std::vector<Id>& points, vtkDataSet* output)
{
  if (!this->Refined)
  {
    Attributes::PassPointData(
      this->Curve.Input, ChosenOf(this->Origins, points), output->GetPointData(), this->Warnings);
    return;
  }
  Attributes::MixPointData(this->Refined->Before, ChosenOf(this->Refined->Mixtures, points), {},
    output->GetPointData(), this->Warnings);
}

vtkSmartPointer<vtkUnstructuredGrid> Maker::MakeGrid()
{
  const insideout::PlanarMesh& mesh = this->Hull.Mesh;
  const auto facetIds = MakeArray<vtkIdTypeArray>("FacetIds", mesh.NumberOfCells(), 3);
  const auto multiplicity = MakeArray<vtkShortArray>("FacetMultiplicity", mesh.NumberOfCells(), 3);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id segment = mesh.Segments[cell][k];
      facetIds->SetTypedComponent(
        cell, k, segment == None ? -1 : this->CellOf(segment, mesh.SegmentSides[cell][k]));
      multiplicity->SetTypedComponent(
        cell, k, static_cast<short>(MultiplicityOnEntering(this->Hull.Curve, mesh, cell, k)));
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(this->Points));
  grid->SetCells(VTK_TRIANGLE, MakeCells(mesh.Cells));
  grid->GetCellData()->AddArray(facetIds);
  grid->GetCellData()->AddArray(multiplicity);
  if (!this->Hull.W.empty())
  {
    grid->GetCellData()->SetScalars(MakeArray<vtkDoubleArray>("w", this->Hull.W));
  }
  std::vector<Id> points(this->Points.size());
  std::iota(points.begin(), points.end(), 0);
  this->AddPointData(points, grid);
  grid->GetFieldData()->AddArray(MakeArray<vtkIdTypeArray>("TurnedCellIds", this->TurnedCells));
  return grid;
}

/** Lines of segments, each with the data of an input cell, and the points that they use. */
vtkSmartPointer<vtkPolyData> Maker::MakeLines(const std::vector<Segment>& segments,
  const std::vector<std::vector<Id>>& lines, const std::vector<vtkIdType>& cells,
  std::initializer_list<const char*> added)
{
  std::vector<Id> index(this->Points.size(), None);
  for (const Segment& segment : segments)
  {
    index[segment[0]] = index[segment[1]] = 0;
  }
  std::vector<Id> used;
  for (std::size_t p = 0; p < index.size(); ++p)
  {
    if (index[p] != None)
    {
      index[p] = static_cast<Id>(used.size());
      used.push_back(static_cast<Id>(p));
    }
  }
  RequireMemory(static_cast<vtkIdType>(8 * segments.size() * sizeof(vtkIdType)));
  vtkNew<vtkCellArray> polylines;
  for (const std::vector<Id>& line : lines)
  {
    polylines->InsertNextCell(static_cast<int>(line.size()) + 1);
    polylines->InsertCellPoint(index[segments[line.front()][0]]);
    for (const Id s : line)
    {
      polylines->InsertCellPoint(index[segments[s][1]]);
    }
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(MakePoints(ChosenOf(this->Points, used)));
  output->SetLines(polylines);
  this->AddPointData(used, output);
  Attributes::PassCellData(this->Curve.Input, cells, added, output->GetCellData(), this->Warnings);
  return output;
}

vtkSmartPointer<vtkPolyData> Maker::MakeResolved()
{
  const insideout::SegmentComplex& curve = this->Hull.Curve;
  using Key = std::pair<vtkIdType, short>;
  std::vector<Segment> segments;
  std::vector<Key> keys;
  std::map<Key, Id> numbers;
  std::vector<Id> numberOf;
  for (Id s = 0; s < curve.NumberOfConstraints; ++s)
  {
    segments.push_back(curve.Segments[s]);
    keys.emplace_back(this->CellOf(s, +1), curve.Multiplicity[s]);
    numberOf.push_back(numbers.emplace(keys.back(), static_cast<Id>(numbers.size())).first->second);
  }
  const std::vector<std::vector<Id>> lines = insideout::JoinAlong(segments, numberOf);
  std::vector<vtkIdType> cells;
  std::vector<short> multiplicity;
  for (const std::vector<Id>& line : lines)
  {
    cells.push_back(keys[line.front()].first);
    multiplicity.push_back(keys[line.front()].second);
  }
  auto output = this->MakeLines(segments, lines, cells, {});
  output->GetCellData()->AddArray(MakeArray<vtkShortArray>("FacetMultiplicity", multiplicity));
  return output;
}

vtkSmartPointer<vtkPolyData> Maker::MakeBoundary(const std::vector<unsigned char>& inside)
{
  std::vector<Segment> segments;
  std::vector<Id> keys;
  for (const insideout::BoundaryEdge& edge : BoundaryEdges(this->Hull.Mesh, inside))
  {
    segments.push_back(edge.Ends);
    keys.push_back(edge.Segment == None
        ? None
        : static_cast<Id>(this->CellOf(edge.Segment, edge.IsAlong ? 1 : -1)));
  }
  const std::vector<std::vector<Id>> lines = insideout::JoinAlong(segments, keys);
  std::vector<vtkIdType> cells;
  std::vector<unsigned char> turned;
  for (const std::vector<Id>& line : lines)
  {
    cells.push_back(keys[line.front()]);
    turned.push_back(this->IsTurned(cells.back()));
  }
  auto output = this->MakeLines(segments, lines, cells, { "Turned", "BoundaryTag" });
  output->GetCellData()->AddArray(MakeArray<vtkUnsignedCharArray>("Turned", turned));
  return output;
}

vtkSmartPointer<vtkPolyData> Maker::MakeOutliers(
  const std::vector<insideout::OutlierSegment>& outliers)
{
  using Key = std::tuple<vtkIdType, short, OutlierReason>;
  std::vector<Segment> segments;
  std::vector<Key> keys;
  for (const insideout::OutlierSegment& outlier : outliers)
  {
    segments.push_back(this->Hull.Curve.Segments[outlier.Segment]);
    keys.emplace_back(this->CellOf(outlier.Segment, +1),
      this->Hull.Curve.Multiplicity[outlier.Segment], outlier.Reason);
  }
  for (const Id s : this->Hull.DegenerateSegments)
  {
    const Id first = static_cast<Id>(this->Points.size());
    for (const Id p : this->Curve.Soup.Segments[s])
    {
      this->Points.push_back(this->Curve.Soup.Points[p]);
      this->Origins.push_back(PointOrigin::Input(p));
    }
    segments.push_back({ { first, first + 1 } });
    keys.emplace_back(this->Curve.CellOfSegment[s], 0, OutlierReason::Degenerate);
  }
  std::map<Key, Id> numbers;
  std::vector<Id> numberOf;
  for (const Key& key : keys)
  {
    numberOf.push_back(numbers.emplace(key, static_cast<Id>(numbers.size())).first->second);
  }
  const std::vector<std::vector<Id>> lines = insideout::JoinAlong(segments, numberOf);
  std::vector<vtkIdType> cells;
  std::vector<short> multiplicity;
  std::vector<unsigned char> reasons;
  for (const std::vector<Id>& line : lines)
  {
    const auto& [cell, count, reason] = keys[line.front()];
    cells.push_back(cell);
    multiplicity.push_back(count);
    reasons.push_back(static_cast<unsigned char>(reason));
  }
  const auto& names = insideout::OutlierReasonNames;
  auto output = this->MakeLines(segments, lines, cells, { "OutlierReason" });
  output->GetCellData()->AddArray(MakeArray<vtkShortArray>("FacetMultiplicity", multiplicity));
  output->GetCellData()->AddArray(MakeArray<vtkUnsignedCharArray>("OutlierReason", reasons));
  output->GetFieldData()->AddArray(
    MakeStrings("OutlierReasonNames", { names.begin(), names.end() }));
  return output;
}

void Maker::AddLeftOutCells(vtkDataSet* output) const
{
  const insideout::SegmentComplex& curve = this->Hull.Curve;
  std::vector<vtkIdType> cells;
  for (Id i = curve.SourceOffsets[curve.NumberOfConstraints];
       i < static_cast<Id>(curve.Sources.size()); ++i)
  {
    cells.push_back(this->Curve.CellOfSegment[curve.Sources[i].Segment]);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  output->GetFieldData()->AddArray(MakeArray<vtkIdTypeArray>("LeftOutCellIds", cells));
}

/** For each segment 1 if it is a piece of a cell with a nonzero value in an array. */
std::vector<unsigned char> ChosenSegments(
  const Curve& curve, const PlanarHull& hull, const std::string& name)
{
  std::vector<unsigned char> chosen;
  if (name.empty())
  {
    return chosen;
  }
  vtkDataArray* array = FindCellArray(curve.Input, name.c_str());
  if (!array)
  {
    throw insideout::Error(insideout::ErrorCode::InvalidParameter,
      "the surface has no cell array " + name +
        " of one value per cell, which is to choose facets");
  }
  chosen.assign(hull.Curve.Segments.size(), 0);
  for (Id s = 0; s < hull.Curve.NumberOfSegments(); ++s)
  {
    for (Id i = hull.Curve.SourceOffsets[s]; i < hull.Curve.SourceOffsets[s + 1]; ++i)
    {
      const vtkIdType cell = curve.CellOfSegment[hull.Curve.Sources[i].Segment];
      chosen[s] = chosen[s] || array->GetComponent(cell, 0) != 0;
    }
  }
  return chosen;
}

/** The total mass properties of the regions, as statistics. */
void AddArea(
  const std::vector<insideout::AreaProperties>& regions, insideout::Statistics& statistics)
{
  insideout::AreaProperties all;
  for (const insideout::AreaProperties& region : regions)
  {
    all.Area += region.Area;
    for (int k = 0; k < 3; ++k)
    {
      all.Center[k] += region.Area * region.Center[k];
    }
  }
  statistics.emplace_back("Regions", regions.size());
  statistics.emplace_back("Area", all.Area);
  for (int k = 0; k < 3; ++k)
  {
    statistics.emplace_back(
      std::string("CenterOfMass") + "XYZ"[k], all.Area > 0 ? all.Center[k] / all.Area : 0);
  }
}

/** Store the regions' mass properties, warnings and statistics in a grid's field data. */
void AddFieldData(const std::vector<insideout::AreaProperties>& regions,
  const insideout::Statistics& statistics, const Maker& maker, vtkUnstructuredGrid* grid)
{
  const auto count = static_cast<vtkIdType>(regions.size());
  const auto areas = MakeArray<vtkDoubleArray>("RegionArea", count);
  const auto centers = MakeArray<vtkDoubleArray>("RegionCenterOfMass", count, 3);
  for (vtkIdType region = 0; region < count; ++region)
  {
    areas->SetTypedComponent(region, 0, regions[region].Area);
    centers->SetTypedTuple(region, regions[region].Center.data());
  }
  grid->GetFieldData()->AddArray(areas);
  grid->GetFieldData()->AddArray(centers);
  AddStatistics(statistics, grid);
  maker.AddLeftOutCells(grid);
}

/** A grid of the maker's triangles with their labels. */
vtkSmartPointer<vtkUnstructuredGrid> MakeLabelledGrid(
  Maker& maker, const std::vector<unsigned char>& inside, const insideout::SolidRegions& regions)
{
  auto grid = maker.MakeGrid();
  AddInside(inside, grid);
  AddRegions(regions, grid);
  return grid;
}

/** The refined inside cells with their properties.
 * @param[in] w one value per refined cell */
RefinedHull HullOf(const insideout::RefinedTriangles& refined, const PlanarHull& hull,
  std::vector<double> w, vtkUnstructuredGrid* grid)
{
  RefinedHull result;
  result.Hull.Plane = hull.Plane;
  result.Hull.Curve = refined.Curve;
  result.Hull.Mesh = refined.Mesh;
  result.Hull.W = std::move(w);
  result.Hull.TurnedSegments = hull.TurnedSegments;
  result.Before = grid;
  for (std::size_t p = 0; p < refined.OriginalPoints.size(); ++p)
  {
    const Id original = refined.OriginalPoints[p];
    result.Mixtures.push_back(original == None
        ? MixInTriangle(
            hull.Curve.Points, hull.Mesh.Cells[refined.CellsOfPoints[p]], refined.Curve.Points[p])
        : Attributes::Mixture{
            { { original, original, original, original } }, { { 1, 0, 0, 0 } }, false });
  }
  return result;
}

std::string NothingInside(const PlanarHull& hull)
{
  const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
  char range[80];
  std::snprintf(range, sizeof(range), "from %.3g to %.3g", *least, *most);
  return std::string("no triangle is inside: the winding number w goes ") + range +
    ". The lines enclose too little, or run clockwise: Orientation turns them over";
}
} // namespace

KeptPlanarHull::KeptPlanarHull(vtkPolyData* input,
  const insideout::PlanarHullParameters& parameters, const std::string& nonParticipating,
  insideout::Monitor& monitor)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(input);
  this->Curve = ReadCurve(copy, parameters.Orientation, nonParticipating);
  insideout::PlanarHullParameters turned = parameters;
  if (this->Curve.ArePolygons)
  {
    turned.Orientation = insideout::Orientation::AsGiven; // they were turned when read
  }
  this->Hull = MeshPlanarHull(this->Curve.Soup, this->Curve.Plane, turned, monitor);
}

namespace
{
/** w of an open curve varies within the hull's cells; a closed one's is theirs. */
std::vector<double> WOfRefined(
  const PlanarHull& hull, const insideout::RefinedTriangles& refined, insideout::Monitor& monitor)
{
  if (NumberOfOpenEnds(hull.Curve) == 0)
  {
    return ChosenOf(hull.W, refined.OriginalCells);
  }
  return WindingNumberOfOtherTriangles(hull.Curve, refined.Curve.Points, refined.Mesh.Cells,
    hull.Plane.Metric, monitor, { insideout::Stages::Refining, 1, 1 });
}

/** The inside cells in better triangles, and their boundary.
 * @param[in] hull the kept one, or with split points */
void RefineTo(const KeptPlanarHull& kept, const PlanarHull& hull,
  const std::vector<unsigned char>& inside, const insideout::SolidRegions& regions,
  const insideout::RefinementParameters& parameters, insideout::Monitor& monitor, Triangles& made,
  insideout::Statistics& statistics)
{
  insideout::Stopwatch stopwatch;
  const insideout::RefinedTriangles refined =
    RefineTriangles(hull.Curve, hull.Mesh, inside, hull.Plane, parameters, monitor);
  const RefinedHull better =
    HullOf(refined, hull, WOfRefined(kept.Hull, refined, monitor), made.Grid);
  Maker maker(kept.Curve, better);
  const std::vector<unsigned char> all(refined.Mesh.Cells.size(), 1);
  made.Grid = MakeLabelledGrid(
    maker, all, { ChosenOf(regions.OfCell, refined.OriginalCells), regions.Count });
  made.Boundary = maker.MakeBoundary(all);
  statistics.insert(statistics.end(), refined.Statistics.begin(), refined.Statistics.end());
  statistics.emplace_back("SecondsRefine", stopwatch.Lap());
  made.Warnings = refined.Warnings;
}

/** The outputs before the cut, with its labels. */
void MakeHull(const KeptPlanarHull& kept, const std::vector<unsigned char>& inside,
  const insideout::Statistics& statistics, insideout::Monitor& monitor, Triangles& made)
{
  const PlanarHull& hull = kept.Hull;
  Maker maker(kept.Curve, hull);
  const insideout::SolidRegions regions =
    FindRegions(hull.Mesh, inside, monitor, { Extracting, 1, 1 });
  made.Hull = MakeLabelledGrid(maker, inside, regions);
  AddFieldData(
    MeasureRegions(hull.Curve, hull.Mesh, hull.Plane, regions), statistics, maker, made.Hull);
  made.Resolved = maker.MakeResolved();
  AddStatistics(statistics, made.Resolved);
  maker.AddLeftOutCells(made.Resolved);
}
} // namespace

Triangles MakeTriangles(const KeptPlanarHull& kept, const std::vector<insideout::Seed>& seeds,
  const Tags& tags, const PlanarOptions& options, insideout::Monitor& monitor)
{
  const Curve& curve = kept.Curve;
  insideout::Stopwatch stopwatch;
  const insideout::MeshSegmentation segmentation =
    SegmentTriangles(kept.Hull.Curve, kept.Hull.Mesh, kept.Hull.Plane, kept.Hull.W,
      PiecesOfSegments(kept.Hull.Mesh, ChosenSegments(curve, kept.Hull, options.ConstrainedArray)),
      seeds, options.Segment, monitor);
  insideout::Statistics statistics = { { "Dimension", 2 } };
  statistics.insert(statistics.end(), kept.Hull.Statistics.begin(), kept.Hull.Statistics.end());
  statistics.emplace_back("SecondsCut", stopwatch.Lap());
  statistics.insert(
    statistics.end(), segmentation.Statistics.begin(), segmentation.Statistics.end());

  monitor.Check(Extracting, 0);
  PlanarHull split;
  if (options.SplitPoints)
  {
    split = kept.Hull;
    statistics.emplace_back("SplitPoints",
      SplitPoints(split.Curve, split.Mesh, segmentation.Inside, monitor, { Extracting, 0, 0.1 }));
  }
  const PlanarHull& hull = options.SplitPoints ? split : kept.Hull;
  Maker maker(curve, hull);
  Triangles made;
  const insideout::SolidRegions regions =
    FindRegions(hull.Mesh, segmentation.Inside, monitor, { Extracting, 0.1, 0.2 });
  made.Grid = MakeLabelledGrid(maker, segmentation.Inside, regions);
  const auto outliers = OutlierSegments(hull.Curve, hull.Mesh, segmentation.Inside);
  made.Outliers = maker.MakeOutliers(outliers);
  statistics.emplace_back(
    "InsideCells", std::count(segmentation.Inside.begin(), segmentation.Inside.end(), 1));
  statistics.emplace_back("OutlierSegments", outliers.size() + hull.DegenerateSegments.size());
  if (options.Refine && regions.Count > 0)
  {
    RefineTo(
      kept, hull, segmentation.Inside, regions, options.Refinement, monitor, made, statistics);
  }
  else
  {
    made.Grid = ExtractInside(made.Grid, monitor, { Extracting, 0.2, 0.8 });
    made.Boundary = maker.MakeBoundary(segmentation.Inside);
    monitor.Check(Extracting, 1);
  }
  AddTags(tags, made.Boundary);

  const std::vector<insideout::AreaProperties> areas =
    MeasureRegions(hull.Curve, hull.Mesh, hull.Plane, regions);
  AddArea(areas, statistics);
  statistics.emplace_back("PeakMemory", insideout::PeakMemory());
  AddFieldData(areas, statistics, maker, made.Grid);
  if (options.GenerateHull)
  {
    MakeHull(kept, segmentation.Inside, statistics, monitor, made);
  }
  for (const auto& warnings :
    { curve.Warnings, hull.Warnings, segmentation.Warnings, maker.Warnings })
  {
    made.Warnings.insert(made.Warnings.end(), warnings.begin(), warnings.end());
  }
  if (regions.Count == 0 &&
    !insideout::DropsRegions(segmentation.Statistics)) // otherwise a warning reports it
  {
    made.Warnings.push_back(NothingInside(hull));
  }
  return made;
}
} // namespace vtkInsideOut
