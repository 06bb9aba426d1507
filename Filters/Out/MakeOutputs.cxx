// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeOutputs.h"

#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Data/FieldNames.h"
#include "Data/FileAttributes.h"
#include "Output/SplitSeams.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkThreshold.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace vtkInsideOut
{
using insideout::FacetComplex;
using insideout::Id;
using insideout::TetrahedralMesh;

/** Cell arrays added to the boundary of a solid. */
constexpr std::initializer_list<const char*> AddedToBoundary = { "Turned", "BoundaryTag" };

MakeOutputs::MakeOutputs(const vtkInsideOut::Surface& surface)
  : Warnings(surface.Warnings)
  , Surface(&surface)
{
}

void MakeOutputs::AddCellsOfFacets(const char* name, const FacetComplex& surface,
  const std::vector<Id>& facets, vtkDataSet* output) const
{
  std::set<vtkIdType> cells;
  for (const Id facet : facets)
  {
    for (Id s = surface.SourceOffsets[facet]; s < surface.SourceOffsets[facet + 1]; ++s)
    {
      cells.insert(this->Surface->CellOfTriangle[surface.Sources[s].Triangle]);
    }
  }
  output->GetFieldData()->AddArray(
    MakeArray<vtkIdTypeArray>(name, std::vector<vtkIdType>(cells.begin(), cells.end())));
}

void MakeOutputs::AddLeftOutCells(const FacetComplex& surface, vtkDataSet* output) const
{
  std::vector<Id> leftOut(surface.NumberOfFacets() - surface.NumberOfConstraints);
  std::iota(leftOut.begin(), leftOut.end(), surface.NumberOfConstraints);
  this->AddCellsOfFacets("LeftOutCellIds", surface, leftOut, output);
}

vtkSmartPointer<vtkPolyData> MakeOutputs::CopySurface(std::initializer_list<const char*> added)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->CopyStructure(this->Surface->Input);
  Attributes::PassAll(this->Surface->Input, added, output, this->Warnings);
  return output;
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeSurface(const std::vector<insideout::Point>& points,
  const std::vector<insideout::PointOrigin>& origins,
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
  output->SetPoints(MakePoints(usedPoints));
  output->SetPolys(MakeCells(renumbered));
  Attributes::PassPointData(
    this->Surface->Input, usedOrigins, output->GetPointData(), this->Warnings);
  Attributes::PassCellData(
    this->Surface->Input, cells, added, output->GetCellData(), this->Warnings);
  return output;
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeSurface(
  const FacetComplex& surface, const std::vector<Id>& facets)
{
  std::vector<insideout::Triangle> triangles;
  std::vector<vtkIdType> cells;
  std::vector<short> multiplicity;
  for (const Id f : facets)
  {
    triangles.push_back(surface.Facets[f]);
    cells.push_back(this->Surface->CellOfFacet(surface, f, +1));
    multiplicity.push_back(surface.Multiplicity[f]);
  }
  auto output = this->MakeSurface(surface.Points, surface.Origins, triangles, cells, {});
  output->GetCellData()->AddArray(MakeArray<vtkShortArray>("FacetMultiplicity", multiplicity));
  return output;
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeBoundary(const insideout::HullMesh& hull,
  const TetrahedralMesh& mesh, const std::vector<insideout::BoundaryTriangle>& boundary)
{
  return this->MakeBoundary(
    mesh.Points, mesh.Origins, boundary, hull.TurnedTriangles, AddedToBoundary);
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeBoundary(const std::vector<insideout::Point>& points,
  const std::vector<insideout::PointOrigin>& origins,
  const std::vector<insideout::BoundaryTriangle>& boundary, const std::vector<Id>& turned,
  std::initializer_list<const char*> added)
{
  std::vector<insideout::Triangle> triangles;
  for (const insideout::BoundaryTriangle& triangle : boundary)
  {
    triangles.push_back(triangle.Corners);
  }
  return this->MakeBoundary(points, origins, triangles, boundary, turned, added);
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeManifoldBoundary(const insideout::HullMesh& hull,
  const TetrahedralMesh& mesh, const insideout::ManifoldSurface& manifold,
  const std::vector<insideout::BoundaryTriangle>& boundary)
{
  std::vector<insideout::Point> points;
  std::vector<insideout::PointOrigin> origins;
  for (const Id place : manifold.Places)
  {
    points.push_back(mesh.Points[place]);
    origins.push_back(mesh.Origins[place]);
  }
  return this->MakeBoundary(
    points, origins, manifold.Triangles, boundary, hull.TurnedTriangles, AddedToBoundary);
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeSeamedBoundary(const insideout::HullMesh& hull,
  const std::vector<insideout::BoundaryTriangle>& boundary, insideout::Monitor& monitor,
  const insideout::ProgressRange& progress)
{
  if (this->Surface->Input->GetPointData()->GetNumberOfArrays() == 0)
  {
    return this->MakeBoundary(hull, hull.Mesh, boundary); // nothing differs anywhere
  }
  const insideout::SeamedSurface seamed = SplitSeams(boundary, this->Surface->Soup,
    TrianglesInMesh(this->Surface->Soup, hull.MergedInto, hull.Mesh.Origins),
    this->AlikePoints(hull), hull.Mesh, monitor, progress);
  std::vector<insideout::Point> points;
  for (const Id place : seamed.Places)
  {
    points.push_back(hull.Mesh.Points[place]);
  }
  return this->MakeBoundary(
    points, seamed.Origins, seamed.Triangles, boundary, hull.TurnedTriangles, AddedToBoundary);
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeBoundary(const std::vector<insideout::Point>& points,
  const std::vector<insideout::PointOrigin>& origins,
  const std::vector<insideout::Triangle>& triangles,
  const std::vector<insideout::BoundaryTriangle>& boundary, const std::vector<Id>& turned,
  std::initializer_list<const char*> added)
{
  std::vector<vtkIdType> cells;
  std::vector<unsigned char> isTurned;
  for (const insideout::BoundaryTriangle& triangle : boundary)
  {
    cells.push_back(
      triangle.Source == insideout::None ? -1 : this->Surface->CellOfTriangle[triangle.Source]);
    isTurned.push_back(std::binary_search(turned.begin(), turned.end(), triangle.Source));
  }
  auto output = this->MakeSurface(points, origins, triangles, cells, added);
  output->GetCellData()->AddArray(MakeArray<vtkUnsignedCharArray>("Turned", isTurned));
  return output;
}

std::vector<Id> MakeOutputs::AlikePoints(const insideout::HullMesh& hull) const
{
  return Attributes::AlikePoints(this->Surface->Input, hull.MergedInto);
}

Id MakeOutputs::CountSeamPoints(const insideout::HullMesh& hull) const
{
  const std::vector<Id> alike = this->AlikePoints(hull);
  Id count = 0;
  for (std::size_t p = 0; p < alike.size(); ++p)
  {
    count += alike[p] != hull.MergedInto[p];
  }
  return count;
}

vtkSmartPointer<vtkPolyData> MakeOutputs::MakeOutliers(
  const insideout::HullMesh& hull, const std::vector<insideout::OutlierPiece>& pieces)
{
  // The corners of degenerate triangles may not be points of the mesh: they are appended.
  std::vector<insideout::Point> points = hull.Mesh.Points;
  std::vector<insideout::PointOrigin> origins = hull.Mesh.Origins;
  std::vector<insideout::Triangle> triangles;
  std::vector<vtkIdType> cells;
  std::vector<short> multiplicity;
  std::vector<unsigned char> reasons;
  const auto add = [&](const insideout::Triangle& triangle, vtkIdType cell, short count,
                     insideout::OutlierReason reason)
  {
    triangles.push_back(triangle);
    cells.push_back(cell);
    multiplicity.push_back(count);
    reasons.push_back(static_cast<unsigned char>(reason));
  };
  for (const insideout::OutlierPiece& piece : pieces)
  {
    add(piece.Corners, this->Surface->CellOfFacet(hull.Surface, piece.Facet, +1),
      hull.Surface.Multiplicity[piece.Facet], piece.Reason);
  }
  for (const Id t : hull.DegenerateTriangles)
  {
    const Id first = static_cast<Id>(points.size());
    for (const Id p : this->Surface->Soup.Triangles[t])
    {
      points.push_back(this->Surface->Soup.Points[p]);
      origins.push_back(insideout::PointOrigin::Input(p));
    }
    add({ { first, first + 1, first + 2 } }, this->Surface->CellOfTriangle[t], 0,
      insideout::OutlierReason::Degenerate);
  }

  const auto& names = insideout::OutlierReasonNames;
  auto output = this->MakeSurface(points, origins, triangles, cells, { "OutlierReason" });
  output->GetCellData()->AddArray(MakeArray<vtkShortArray>("FacetMultiplicity", multiplicity));
  output->GetCellData()->AddArray(MakeArray<vtkUnsignedCharArray>("OutlierReason", reasons));
  output->GetFieldData()->AddArray(
    MakeStrings("OutlierReasonNames", { names.begin(), names.end() }));
  return output;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeOutputs::MakeGrid(
  const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  const auto facetIds = MakeArray<vtkIdTypeArray>("FacetIds", mesh.NumberOfCells(), 4);
  const auto multiplicity = MakeArray<vtkShortArray>("FacetMultiplicity", mesh.NumberOfCells(), 4);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = mesh.Facets[cell][k];
      facetIds->SetTypedComponent(cell, k,
        facet == insideout::None
          ? -1
          : this->Surface->CellOfFacet(surface, facet, mesh.FacetSides[cell][k]));
      multiplicity->SetTypedComponent(
        cell, k, static_cast<short>(MultiplicityOnEntering(surface, mesh, cell, k)));
    }
  }

  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(mesh.Points));
  grid->SetCells(VTK_TETRA, MakeCells(mesh.Cells));
  grid->GetCellData()->AddArray(facetIds);
  grid->GetCellData()->AddArray(multiplicity);
  Attributes::PassPointData(
    this->Surface->Input, mesh.Origins, grid->GetPointData(), this->Warnings);
  this->AddCellsOfFacets("LostCellIds", surface, mesh.LostFacets, grid);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeOutputs::MakeGrid(const insideout::HullMesh& hull)
{
  auto grid = this->MakeGrid(hull.Surface, hull.Mesh);
  grid->GetCellData()->SetScalars(MakeArray<vtkDoubleArray>("w", hull.W));
  this->AddTurnedCells(hull, grid);
  return grid;
}

void MakeOutputs::AddTurnedCells(const insideout::HullMesh& hull, vtkDataSet* output) const
{
  std::vector<vtkIdType> turned;
  for (const Id triangle : hull.TurnedTriangles)
  {
    turned.push_back(this->Surface->CellOfTriangle[triangle]);
  }
  turned.erase(std::unique(turned.begin(), turned.end()), turned.end()); // ascending, as triangles
  output->GetFieldData()->AddArray(MakeArray<vtkIdTypeArray>("TurnedCellIds", turned));
}

void AddInside(const std::vector<unsigned char>& inside, vtkUnstructuredGrid* grid)
{
  grid->GetCellData()->AddArray(MakeArray<vtkUnsignedCharArray>("Inside", inside));
}

void AddRegions(const insideout::SolidRegions& regions, vtkUnstructuredGrid* grid)
{
  grid->GetCellData()->AddArray(MakeArray<vtkIntArray>("RegionId", regions.OfCell));
}

void AddMasses(const std::vector<insideout::MassProperties>& masses, vtkDataSet* output)
{
  const auto count = static_cast<vtkIdType>(masses.size());
  const auto volumes = MakeArray<vtkDoubleArray>("RegionVolume", count);
  const auto centers = MakeArray<vtkDoubleArray>("RegionCenterOfMass", count, 3);
  const auto inertias = MakeArray<vtkDoubleArray>("RegionInertia", count, 6);
  for (vtkIdType region = 0; region < count; ++region)
  {
    volumes->SetTypedComponent(region, 0, masses[region].Volume);
    centers->SetTypedTuple(region, masses[region].CenterOfMass.data());
    inertias->SetTypedTuple(region, masses[region].Inertia.data());
  }
  const std::array<const char*, 6> axes = { { "XX", "YY", "ZZ", "XY", "YZ", "XZ" } };
  for (int k = 0; k < 6; ++k)
  {
    inertias->SetComponentName(k, axes[k]);
  }
  for (const auto& array : { volumes, centers, inertias })
  {
    output->GetFieldData()->AddArray(array);
  }
}

vtkSmartPointer<vtkPolyData> MakePolygons(const insideout::PolygonSurface& surface)
{
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(MakeArray<vtkIdTypeArray>(nullptr, surface.Offsets),
    MakeArray<vtkIdTypeArray>(nullptr, surface.Corners));
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(MakePoints(surface.Points));
  output->SetPolys(polygons);
  if (!surface.LineCorners.empty())
  {
    vtkNew<vtkCellArray> lines;
    lines->SetData(MakeArray<vtkIdTypeArray>(nullptr, surface.LineOffsets),
      MakeArray<vtkIdTypeArray>(nullptr, surface.LineCorners));
    output->SetLines(lines);
  }
  for (const insideout::Attribute& attribute : surface.PointAttributes)
  {
    AddAttribute(attribute, output->GetPointData());
  }
  for (const insideout::Attribute& attribute : surface.PolygonAttributes)
  {
    AddAttribute(attribute, output->GetCellData());
  }
  for (const insideout::AttributeNames& names : surface.Names)
  {
    output->GetFieldData()->AddArray(MakeStrings(names.Name.c_str(), names.Values));
  }
  return output;
}

vtkSmartPointer<vtkPolyData> MakeLines(const insideout::SurfaceDefects& defects)
{
  std::size_t corners = 0;
  for (const insideout::DefectLine& line : defects.Lines)
  {
    corners += line.Points.size() + 1;
  }
  // Growing arrays take twice the memory of their content, and for a while coexist with their
  // copies.
  RequireMemory(static_cast<vtkIdType>(4 * corners * sizeof(vtkIdType)));
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
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(MakePoints(defects.Points));
  output->SetVerts(vertices);
  output->SetLines(lines);
  output->GetPointData()->AddArray(
    MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", defects.InputPoints));
  return output;
}

namespace
{
/** Receives a VTK filter's own reports, whose progress is ignored. */
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

vtkSmartPointer<vtkUnstructuredGrid> ExtractInside(
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
} // namespace vtkInsideOut
