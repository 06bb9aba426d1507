// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutConversion.h"

#include "Output/SplitSeams.h"
#include "vtkInsideOutArrays.h"
#include "vtkInsideOutAttributes.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkThreshold.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

using insideout::Error;
using insideout::ErrorCode;
using insideout::FacetComplex;
using insideout::Id;
using insideout::TetrahedralMesh;

vtkInsideOutConversion::vtkInsideOutConversion(
  vtkPolyData* input, const std::string& nonParticipating)
  : Input(input)
{
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  if (numberOfPoints > std::numeric_limits<Id>::max() ||
    input->GetNumberOfCells() > std::numeric_limits<Id>::max())
  {
    throw Error(ErrorCode::TooLarge,
      "the surface has " + std::to_string(numberOfPoints) + " points and " +
        std::to_string(input->GetNumberOfCells()) + " cells; at most " +
        std::to_string(std::numeric_limits<Id>::max()) + " of each can be handled");
  }
  if (input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    throw Error(ErrorCode::EmptySurface,
      input->GetNumberOfCells() == 0 ? "the surface is empty: it has no polygons"
                                     : "the surface has no polygons, only lines or vertices");
  }
  if (const vtkIdType ignored = input->GetNumberOfVerts() + input->GetNumberOfLines())
  {
    this->Warnings.push_back(
      std::to_string(ignored) + " vertices and lines are ignored: only polygons and strips count");
  }
  this->Soup.Points.resize(numberOfPoints);
  for (vtkIdType p = 0; p < numberOfPoints; ++p)
  {
    input->GetPoint(p, this->Soup.Points[p].data());
  }
  this->ReadPolygons(input);
  this->ReadStrips(input);
  this->ReadMultiplicity(input);
  if (!nonParticipating.empty())
  {
    this->ReadParticipation(input, nonParticipating);
  }
}

void vtkInsideOutConversion::CheckCell(vtkIdType cell, vtkIdType size, const vtkIdType* corners)
{
  const vtkIdType numberOfPoints = static_cast<vtkIdType>(this->Soup.Points.size());
  for (vtkIdType k = 0; k < size; ++k)
  {
    if (corners[k] < 0 || corners[k] >= numberOfPoints)
    {
      throw Error(ErrorCode::PointOutOfRange,
        "cell " + std::to_string(cell) + " refers to point " + std::to_string(corners[k]) + " of " +
          std::to_string(numberOfPoints));
    }
    const insideout::Point& x = this->Soup.Points[corners[k]];
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      throw Error(
        ErrorCode::PointNotFinite, "point " + std::to_string(corners[k]) + " is not finite");
    }
  }
}

void vtkInsideOutConversion::AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
{
  this->Soup.Triangles.push_back(
    { { static_cast<Id>(a), static_cast<Id>(b), static_cast<Id>(c) } });
  this->CellOfTriangle.push_back(cell);
}

bool vtkInsideOutConversion::AddPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* corners)
{
  // Polygons that are the same but for where they begin and which way they run have to give the
  // same triangles, or they are no duplicates: begin at the lowest point and run to its lower
  // neighbour.
  const auto at = [&](vtkIdType k) -> const insideout::Point&
  { return this->Soup.Points[corners[k]]; };
  vtkIdType lowest = 0;
  for (vtkIdType k = 1; k < size; ++k)
  {
    lowest = at(k) < at(lowest) ? k : lowest;
  }
  const bool reversed = at((lowest + size - 1) % size) < at((lowest + 1) % size);
  std::vector<vtkIdType> ordered(size);
  for (vtkIdType k = 0; k < size; ++k)
  {
    ordered[k] = corners[(lowest + (reversed ? size - k : k)) % size];
  }
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  { this->AddTriangle(cell, ordered[a], ordered[reversed ? c : b], ordered[reversed ? b : c]); };

  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> triangles;
  polygon->Initialize(static_cast<int>(size), ordered.data(), this->Input->GetPoints());
  if (polygon->Triangulate(triangles) && triangles->GetNumberOfIds() == 3 * (size - 2))
  {
    for (vtkIdType k = 0; k < triangles->GetNumberOfIds(); k += 3)
    {
      add(triangles->GetId(k), triangles->GetId(k + 1), triangles->GetId(k + 2));
    }
    return true;
  }
  // Where the polygon crosses itself ears run out. A fan then keeps at least its outline, so that a
  // closed surface stays closed.
  for (vtkIdType k = 1; k + 1 < size; ++k)
  {
    add(0, k, k + 1);
  }
  return false;
}

void vtkInsideOutConversion::ReadPolygons(vtkPolyData* input)
{
  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  vtkIdType tooSmall = 0;
  vtkIdType fans = 0;
  const auto polygons = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* corners;
    polygons->GetCurrentCell(size, corners);
    this->CheckCell(cell, size, corners);
    if (size == 3)
    {
      this->AddTriangle(cell, corners[0], corners[1], corners[2]);
    }
    else if (size > 3)
    {
      fans += !this->AddPolygon(cell, size, corners);
    }
    else
    {
      ++tooSmall;
    }
    ++cell;
  }
  if (fans > 0)
  {
    this->Warnings.push_back(std::to_string(fans) +
      " polygons cross or touch themselves and cannot be clipped into ears: they are cut into "
      "fans");
  }
  if (tooSmall > 0)
  {
    this->Warnings.push_back(
      std::to_string(tooSmall) + " polygons of fewer than three points are left out");
  }
}

void vtkInsideOutConversion::ReadStrips(vtkPolyData* input)
{
  vtkIdType cell =
    input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfPolys();
  const auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* corners;
    strips->GetCurrentCell(size, corners);
    this->CheckCell(cell, size, corners);
    for (vtkIdType k = 0; k + 2 < size; ++k)
    {
      const bool odd = k % 2 != 0; // every other triangle of a strip runs the other way
      this->AddTriangle(
        cell, corners[k], corners[odd ? k + 2 : k + 1], corners[odd ? k + 1 : k + 2]);
    }
    ++cell;
  }
}

void vtkInsideOutConversion::ReadMultiplicity(vtkPolyData* input)
{
  vtkDataArray* multiplicity = input->GetCellData()->GetArray("FacetMultiplicity");
  if (!multiplicity || multiplicity->GetNumberOfComponents() != 1 ||
    multiplicity->GetNumberOfTuples() != input->GetNumberOfCells() ||
    multiplicity->GetDataType() == VTK_DOUBLE || multiplicity->GetDataType() == VTK_FLOAT)
  {
    return; // not what vtkResolveSelfIntersections makes
  }
  for (const vtkIdType cell : this->CellOfTriangle)
  {
    const double count = multiplicity->GetComponent(cell, 0);
    if (std::abs(count) > std::numeric_limits<std::int16_t>::max())
    {
      throw Error(ErrorCode::TooLarge,
        "cell " + std::to_string(cell) + " has a FacetMultiplicity that 16 bits do not hold");
    }
    this->Soup.Multiplicity.push_back(static_cast<std::int16_t>(count));
  }
}

void vtkInsideOutConversion::ReadParticipation(vtkPolyData* input, const std::string& name)
{
  vtkDataArray* array = input->GetCellData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != input->GetNumberOfCells())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the surface has no cell array " + name + " of one number per cell");
  }
  for (const vtkIdType cell : this->CellOfTriangle)
  {
    this->Soup.NonParticipating.push_back(array->GetComponent(cell, 0) != 0);
  }
}

vtkIdType vtkInsideOutConversion::CellOfFacet(const FacetComplex& surface, Id facet, int side) const
{
  return this->CellOfTriangle[SourceOfFacet(surface, facet, side)]; // triangles are in cell order
}

void vtkInsideOutConversion::AddCellsOfFacets(const char* name, const FacetComplex& surface,
  const std::vector<Id>& facets, vtkDataSet* output) const
{
  std::set<vtkIdType> cells;
  for (const Id facet : facets)
  {
    for (Id s = surface.SourceOffsets[facet]; s < surface.SourceOffsets[facet + 1]; ++s)
    {
      cells.insert(this->CellOfTriangle[surface.Sources[s].Triangle]);
    }
  }
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  for (const vtkIdType cell : cells)
  {
    array->InsertNextValue(cell);
  }
  output->GetFieldData()->AddArray(array);
}

void vtkInsideOutConversion::AddLeftOutCells(const FacetComplex& surface, vtkDataSet* output) const
{
  std::vector<Id> leftOut(surface.NumberOfFacets() - surface.NumberOfConstraints);
  std::iota(leftOut.begin(), leftOut.end(), surface.NumberOfConstraints);
  this->AddCellsOfFacets("LeftOutCellIds", surface, leftOut, output);
}

vtkSmartPointer<vtkPolyData> vtkInsideOutConversion::CopySurface(
  std::initializer_list<const char*> added)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->CopyStructure(this->Input);
  vtkInsideOutAttributes::PassAll(this->Input->GetPointData(), this->Input->GetNumberOfPoints(), {},
    output->GetPointData(), this->Warnings);
  vtkInsideOutAttributes::PassAll(this->Input->GetCellData(), this->Input->GetNumberOfCells(),
    added, output->GetCellData(), this->Warnings);
  return output;
}

vtkSmartPointer<vtkPolyData> vtkInsideOutConversion::MakeSurface(
  const std::vector<insideout::Point>& points, const std::vector<insideout::PointOrigin>& origins,
  const std::vector<insideout::Triangle>& triangles, const std::vector<vtkIdType>& cells,
  std::initializer_list<const char*> added)
{
  std::vector<Id> index(points.size(), insideout::None);
  std::vector<insideout::Point> usedPoints;
  std::vector<insideout::PointOrigin> usedOrigins;
  std::vector<insideout::Triangle> renumbered = triangles;
  for (insideout::Triangle& triangle : renumbered)
  {
    for (const Id p : triangle)
    {
      index[p] = 0;
    }
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (index[p] != insideout::None)
    {
      index[p] = static_cast<Id>(usedPoints.size());
      usedPoints.push_back(points[p]);
      usedOrigins.push_back(origins[p]);
    }
  }
  for (insideout::Triangle& triangle : renumbered)
  {
    for (Id& p : triangle)
    {
      p = index[p];
    }
  }

  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(vtkInsideOutMakePoints(usedPoints));
  output->SetPolys(vtkInsideOutMakeCells(renumbered));
  vtkInsideOutAttributes::PassPointData(this->Input->GetPointData(),
    this->Input->GetNumberOfPoints(), usedOrigins, output->GetPointData(), this->Warnings);
  vtkInsideOutAttributes::PassCellData(this->Input->GetCellData(), this->Input->GetNumberOfCells(),
    cells, added, output->GetCellData(), this->Warnings);
  return output;
}

vtkSmartPointer<vtkPolyData> vtkInsideOutConversion::MakeSurface(
  const FacetComplex& surface, const std::vector<Id>& facets)
{
  std::vector<insideout::Triangle> triangles;
  std::vector<vtkIdType> cells;
  vtkNew<vtkShortArray> multiplicity;
  multiplicity->SetName("FacetMultiplicity");
  for (const Id f : facets)
  {
    triangles.push_back(surface.Facets[f]);
    cells.push_back(this->CellOfFacet(surface, f, +1));
    multiplicity->InsertNextValue(surface.Multiplicity[f]);
  }
  auto output = this->MakeSurface(surface.Points, surface.Origins, triangles, cells, {});
  output->GetCellData()->AddArray(multiplicity);
  return output;
}

vtkSmartPointer<vtkPolyData> vtkInsideOutConversion::MakeBoundary(
  const insideout::HullMesh& hull, const std::vector<insideout::BoundaryTriangle>& boundary)
{
  std::vector<insideout::Triangle> triangles;
  for (const insideout::BoundaryTriangle& triangle : boundary)
  {
    triangles.push_back(triangle.Corners);
  }
  return this->MakeSurface(
    hull.Mesh.Points, hull.Mesh.Origins, triangles, this->CellsOfBoundary(boundary), {});
}

vtkSmartPointer<vtkPolyData> vtkInsideOutConversion::MakeSeamedBoundary(
  const insideout::HullMesh& hull, const std::vector<insideout::BoundaryTriangle>& boundary,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress)
{
  if (this->Input->GetPointData()->GetNumberOfArrays() == 0)
  {
    return this->MakeBoundary(hull, boundary); // nothing differs anywhere
  }
  const insideout::SeamedSurface seamed =
    SplitSeams(boundary, this->Soup, TrianglesInMesh(this->Soup, hull.MergedInto, hull.Mesh),
      this->AlikePoints(hull), hull.Mesh, monitor, progress);
  std::vector<insideout::Point> points;
  for (const Id place : seamed.Places)
  {
    points.push_back(hull.Mesh.Points[place]);
  }
  return this->MakeSurface(
    points, seamed.Origins, seamed.Triangles, this->CellsOfBoundary(boundary), {});
}

std::vector<vtkIdType> vtkInsideOutConversion::CellsOfBoundary(
  const std::vector<insideout::BoundaryTriangle>& boundary) const
{
  std::vector<vtkIdType> cells;
  for (const insideout::BoundaryTriangle& triangle : boundary)
  {
    cells.push_back(
      triangle.Source == insideout::None ? -1 : this->CellOfTriangle[triangle.Source]);
  }
  return cells;
}

std::vector<Id> vtkInsideOutConversion::AlikePoints(const insideout::HullMesh& hull) const
{
  return vtkInsideOutAttributes::AlikePoints(
    this->Input->GetPointData(), this->Input->GetNumberOfPoints(), hull.MergedInto);
}

Id vtkInsideOutConversion::CountSeamPoints(const insideout::HullMesh& hull) const
{
  const std::vector<Id> alike = this->AlikePoints(hull);
  Id count = 0;
  for (std::size_t p = 0; p < alike.size(); ++p)
  {
    count += alike[p] != hull.MergedInto[p];
  }
  return count;
}

vtkSmartPointer<vtkPolyData> vtkInsideOutConversion::MakeOutliers(
  const insideout::HullMesh& hull, const std::vector<insideout::OutlierPiece>& pieces)
{
  // The corners of degenerate triangles may be no points of the mesh: they come behind.
  std::vector<insideout::Point> points = hull.Mesh.Points;
  std::vector<insideout::PointOrigin> origins = hull.Mesh.Origins;
  std::vector<insideout::Triangle> triangles;
  std::vector<vtkIdType> cells;
  vtkNew<vtkShortArray> multiplicity;
  multiplicity->SetName("FacetMultiplicity");
  vtkNew<vtkUnsignedCharArray> reasons;
  reasons->SetName("OutlierReason");
  const auto add = [&](const insideout::Triangle& triangle, vtkIdType cell, short count,
                     insideout::OutlierReason reason)
  {
    triangles.push_back(triangle);
    cells.push_back(cell);
    multiplicity->InsertNextValue(count);
    reasons->InsertNextValue(static_cast<unsigned char>(reason));
  };
  for (const insideout::OutlierPiece& piece : pieces)
  {
    add(piece.Corners, this->CellOfFacet(hull.Surface, piece.Facet, +1),
      hull.Surface.Multiplicity[piece.Facet], piece.Reason);
  }
  for (const Id t : hull.DegenerateTriangles)
  {
    const Id first = static_cast<Id>(points.size());
    for (const Id p : this->Soup.Triangles[t])
    {
      points.push_back(this->Soup.Points[p]);
      origins.push_back(insideout::PointOrigin::Input(p));
    }
    add({ { first, first + 1, first + 2 } }, this->CellOfTriangle[t], 0,
      insideout::OutlierReason::Degenerate);
  }

  vtkNew<vtkStringArray> names;
  names->SetName("OutlierReasonNames");
  for (const char* name : insideout::OutlierReasonNames)
  {
    names->InsertNextValue(name);
  }
  auto output = this->MakeSurface(points, origins, triangles, cells, { "OutlierReason" });
  output->GetCellData()->AddArray(multiplicity);
  output->GetCellData()->AddArray(reasons);
  output->GetFieldData()->AddArray(names);
  return output;
}

vtkSmartPointer<vtkUnstructuredGrid> vtkInsideOutConversion::MakeGrid(
  const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  vtkNew<vtkIdTypeArray> facetIds;
  facetIds->SetName("FacetIds");
  facetIds->SetNumberOfComponents(4);
  facetIds->SetNumberOfTuples(mesh.NumberOfCells());
  vtkNew<vtkShortArray> multiplicity;
  multiplicity->SetName("FacetMultiplicity");
  multiplicity->SetNumberOfComponents(4);
  multiplicity->SetNumberOfTuples(mesh.NumberOfCells());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = mesh.Facets[cell][k];
      facetIds->SetTypedComponent(cell, k,
        facet == insideout::None ? -1
                                 : this->CellOfFacet(surface, facet, mesh.FacetSides[cell][k]));
      multiplicity->SetTypedComponent(
        cell, k, static_cast<short>(MultiplicityOnEntering(surface, mesh, cell, k)));
    }
  }

  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(vtkInsideOutMakePoints(mesh.Points));
  grid->SetCells(VTK_TETRA, vtkInsideOutMakeCells(mesh.Cells));
  grid->GetCellData()->AddArray(facetIds);
  grid->GetCellData()->AddArray(multiplicity);
  vtkInsideOutAttributes::PassPointData(this->Input->GetPointData(),
    this->Input->GetNumberOfPoints(), mesh.Origins, grid->GetPointData(), this->Warnings);
  this->AddCellsOfFacets("LostCellIds", surface, mesh.LostFacets, grid);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> vtkInsideOutConversion::MakeGrid(
  const insideout::HullMesh& hull)
{
  auto grid = this->MakeGrid(hull.Surface, hull.Mesh);
  vtkNew<vtkDoubleArray> w;
  w->SetName("w");
  w->SetNumberOfValues(static_cast<vtkIdType>(hull.W.size()));
  std::copy(hull.W.begin(), hull.W.end(), w->GetPointer(0));
  grid->GetCellData()->SetScalars(w);
  return grid;
}

void vtkInsideOutAddInside(const std::vector<unsigned char>& inside, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("Inside");
  array->SetNumberOfValues(static_cast<vtkIdType>(inside.size()));
  std::copy(inside.begin(), inside.end(), array->GetPointer(0));
  grid->GetCellData()->AddArray(array);
}

vtkSmartPointer<vtkPolyData> vtkInsideOutMakeLines(const insideout::SurfaceDefects& defects)
{
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  for (const insideout::DefectLine& line : defects.Lines)
  {
    vtkCellArray* const cells = line.Points.size() > 1 ? lines : vertices;
    cells->InsertNextCell(static_cast<int>(line.Points.size()));
    for (const Id p : line.Points)
    {
      cells->InsertCellPoint(p);
    }
  }
  vtkNew<vtkIdTypeArray> inputPoints;
  inputPoints->SetName("vtkOriginalPointIds");
  inputPoints->SetNumberOfValues(static_cast<vtkIdType>(defects.InputPoints.size()));
  std::copy(defects.InputPoints.begin(), defects.InputPoints.end(), inputPoints->GetPointer(0));
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(vtkInsideOutMakePoints(defects.Points));
  output->SetVerts(vertices);
  output->SetLines(lines);
  output->GetPointData()->AddArray(inputPoints);
  return output;
}

void vtkInsideOutAddStatistics(const insideout::Statistics& statistics, vtkDataSet* output)
{
  vtkNew<vtkFieldData> fields;
  for (const auto& [name, value] : statistics)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(("Statistics_" + name).c_str());
    array->InsertNextValue(value);
    fields->AddArray(array);
  }
  vtkFieldData* others = output->GetFieldData();
  for (int i = 0; i < others->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* other = others->GetAbstractArray(i);
    if (!other->GetName() || !fields->HasArray(other->GetName()))
    {
      fields->AddArray(other);
    }
  }
  output->SetFieldData(fields);
}

namespace
{
/** What a VTK filter's own reports are passed on to. They do not tell how far it is. */
struct Watch
{
  insideout::Monitor& Monitor;
  const insideout::ProgressRange& Progress;
};

void PassOn(vtkObject* caller, unsigned long, void* data, void*)
{
  const auto* watch = static_cast<Watch*>(data);
  if (!watch->Monitor.Continue(watch->Progress.Stage, watch->Progress.Begin))
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
}
} // namespace

vtkSmartPointer<vtkUnstructuredGrid> vtkInsideOutExtractInside(
  vtkUnstructuredGrid* grid, insideout::Monitor& monitor, const insideout::ProgressRange& progress)
{
  Watch watch = { monitor, progress };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&watch);
  observer->SetCallback(PassOn);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(grid);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Inside");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(0.5);
  threshold->AddObserver(vtkCommand::ProgressEvent, observer);
  threshold->Update();
  monitor.Check(progress.Stage, progress.End);
  return threshold->GetOutput();
}
