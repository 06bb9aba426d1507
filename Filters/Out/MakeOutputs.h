// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Makes VTK's data sets from the results of the stages. */
#pragma once

#include "Data/VtkClasses.h"
#include "Defects/SurfaceDefects.h"
#include "HullMesh.h"
#include "In/ReadSurface.h"
#include "Output/BoundaryTriangles.h"
#include "Output/ManifoldBoundary.h"
#include "Output/MassProperties.h"
#include "Output/Outliers.h"

#include <initializer_list>

namespace vtkInsideOut
{
/** Makes data sets with the point and cell data of the surface from which they were made. */
class MakeOutputs
{
public:
  /** @param[in] surface must live on */
  explicit MakeOutputs(const Surface& surface);

  /** Warnings of reading the surface and of making data sets. */
  std::vector<std::string> Warnings;

  /** The surface with its cells and data; cell arrays with names that the output adds are renamed.
   */
  vtkSmartPointer<vtkPolyData> CopySurface(std::initializer_list<const char*> added);

  /** Facets as a surface with FacetMultiplicity, vtkOriginalCellIds and vtkOriginalPointIds. */
  vtkSmartPointer<vtkPolyData> MakeSurface(
    const insideout::FacetComplex& surface, const std::vector<insideout::Id>& facets);

  /**
   * Triangles of the boundary with vtkOriginalCellIds (-1 where a hole was closed), Turned and
   * vtkOriginalPointIds; merged points have the lowest id's data.
   *
   * @param[in] mesh with the boundary's points: the hull's, or derived from that
   */
  vtkSmartPointer<vtkPolyData> MakeBoundary(const insideout::HullMesh& hull,
    const insideout::TetrahedralMesh& mesh,
    const std::vector<insideout::BoundaryTriangle>& boundary);

  /** The same with copies of points that would not be manifold. */
  vtkSmartPointer<vtkPolyData> MakeManifoldBoundary(const insideout::HullMesh& hull,
    const insideout::TetrahedralMesh& mesh, const insideout::ManifoldSurface& manifold,
    const std::vector<insideout::BoundaryTriangle>& boundary);

  /**
   * The same for triangles of points with origins.
   *
   * @param[in] turned the input triangles that were turned over, ascending
   * @param[in] added names of cell arrays that the output will have, Turned too: the input's are
   *   renamed
   */
  vtkSmartPointer<vtkPolyData> MakeBoundary(const std::vector<insideout::Point>& points,
    const std::vector<insideout::PointOrigin>& origins,
    const std::vector<insideout::BoundaryTriangle>& boundary,
    const std::vector<insideout::Id>& turned, std::initializer_list<const char*> added);

  /** The same with copies of points where the input's triangles differ in texture coordinates or
   * normals, or where triangles with point data cross. Can be stopped. */
  vtkSmartPointer<vtkPolyData> MakeSeamedBoundary(const insideout::HullMesh& hull,
    const std::vector<insideout::BoundaryTriangle>& boundary, insideout::Monitor& monitor,
    const insideout::ProgressRange& progress);

  /** The number of input points merged with one that has other texture coordinates or normals. */
  insideout::Id CountSeamPoints(const insideout::HullMesh& hull) const;

  /** Pieces of facets and the input's degenerate triangles, with OutlierReason, FacetMultiplicity,
   * vtkOriginalCellIds, vtkOriginalPointIds, and the reasons' names in the field array
   * OutlierReasonNames. */
  vtkSmartPointer<vtkPolyData> MakeOutliers(
    const insideout::HullMesh& hull, const std::vector<insideout::OutlierPiece>& pieces);

  /** The mesh with FacetIds, FacetMultiplicity, vtkOriginalPointIds and the input's point data, and
   * the input cells of facets that it lost in the field array LostCellIds. */
  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
    const insideout::FacetComplex& surface, const insideout::TetrahedralMesh& mesh);

  /** The same with w, and the input cells that were turned over in the field array TurnedCellIds.
   */
  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const insideout::HullMesh& hull);

  /**
   * Store the ids of input cells that were turned over in the field array TurnedCellIds of an
   * output.
   */
  void AddTurnedCells(const insideout::HullMesh& hull, vtkDataSet* output) const;

  /** Store the ids of input cells with facets that could not be resolved in the field array
   * LeftOutCellIds of an output: ascending, each once. */
  void AddLeftOutCells(const insideout::FacetComplex& surface, vtkDataSet* output) const;

private:
  std::vector<insideout::Id> AlikePoints(const insideout::HullMesh& hull) const;
  vtkSmartPointer<vtkPolyData> MakeBoundary(const std::vector<insideout::Point>& points,
    const std::vector<insideout::PointOrigin>& origins,
    const std::vector<insideout::Triangle>& triangles,
    const std::vector<insideout::BoundaryTriangle>& boundary,
    const std::vector<insideout::Id>& turned, std::initializer_list<const char*> added);
  /** A field array of the input cells that contain facets, each once, ascending. */
  void AddCellsOfFacets(const char* name, const insideout::FacetComplex& surface,
    const std::vector<insideout::Id>& facets, vtkDataSet* output) const;
  vtkSmartPointer<vtkPolyData> MakeSurface(const std::vector<insideout::Point>& points,
    const std::vector<insideout::PointOrigin>& origins,
    const std::vector<insideout::Triangle>& triangles, const std::vector<vtkIdType>& cells,
    std::initializer_list<const char*> added);

  const vtkInsideOut::Surface* Surface;
};

/** The polygons of a file, with their attributes, and the attributes' names as field arrays. */
vtkSmartPointer<vtkPolyData> MakePolygons(const insideout::PolygonSurface& surface);

/** The lines of a surface's defects with vtkOriginalPointIds: lines of one point become vertices,
 * which VTK numbers before the polylines. */
vtkSmartPointer<vtkPolyData> MakeLines(const insideout::SurfaceDefects& defects);

/** Store the labels as the cell array Inside of the grid. */
void AddInside(const std::vector<unsigned char>& inside, vtkUnstructuredGrid* grid);

/** Store the cells' regions as the cell array RegionId of the grid, -1 outside. */
void AddRegions(const insideout::SolidRegions& regions, vtkUnstructuredGrid* grid);

/** Store the regions' mass properties as the field arrays RegionVolume, RegionCenterOfMass and
 * RegionInertia, with a tuple for each region. */
void AddMasses(const std::vector<insideout::MassProperties>& masses, vtkDataSet* output);

/** The cells whose array Inside is 1, with the points they use. Can be stopped. */
vtkSmartPointer<vtkUnstructuredGrid> ExtractInside(
  vtkUnstructuredGrid* grid, insideout::Monitor& monitor, const insideout::ProgressRange& progress);
} // namespace vtkInsideOut
