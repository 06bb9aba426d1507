// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutConversion
 * @brief   The one place where VTK's data become InsideOut's and back.
 *
 * Reads a vtkPolyData into plain triangles, checked as far as VTK's structures need it, and
 * remembers where they came from; then makes VTK data sets of the stages' results that carry the
 * input's point and cell data along.
 */
#ifndef vtkInsideOutConversion_h
#define vtkInsideOutConversion_h

#include "Defects/SurfaceDefects.h"
#include "HullMesh.h"
#include "Output/BoundaryTriangles.h"
#include "Output/Outliers.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <initializer_list>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

class vtkInsideOutConversion
{
public:
  /**
   * Read the polygons and strips of a surface. Polygons are triangulated by ear clipping. A cell
   * array FacetMultiplicity (short, as vtkResolveSelfIntersections makes it) says how often a cell
   * counts.
   *
   * @param nonParticipating a cell array of one number per cell, which is not 0 for cells that do
   * not count in w; none where the name is empty
   * @throws insideout::Error that names the cell, point or array at fault
   */
  explicit vtkInsideOutConversion(
    vtkPolyData* input, const std::string& nonParticipating = std::string());

  /** The input's triangles. Their points have the input's ids. */
  insideout::TriangleSoup Soup;

  /** What was passed over or looks wrong, one line each. */
  std::vector<std::string> Warnings;

  /** The input cell that each triangle of the soup is a part of. */
  const std::vector<vtkIdType>& GetCellOfTriangle() const { return this->CellOfTriangle; }

  /** The input cell of a facet: of several the lowest, of those along `side` (+1 or -1) if there is
   * one. */
  vtkIdType CellOfFacet(
    const insideout::FacetComplex& surface, insideout::Id facet, int side) const;

  /** Name the input cells of facets that could not be resolved in the field array LeftOutCellIds of
   * an output: ascending, each once. */
  void AddLeftOutCells(const insideout::FacetComplex& surface, vtkDataSet* output) const;

  /** The input with its cells and data as they are, but for cell arrays of the names that the
   * output adds: those are renamed. */
  vtkSmartPointer<vtkPolyData> CopySurface(std::initializer_list<const char*> added);

  /** Facets as a surface with FacetMultiplicity, vtkOriginalCellIds, vtkOriginalPointIds and the
   * input's data. */
  vtkSmartPointer<vtkPolyData> MakeSurface(
    const insideout::FacetComplex& surface, const std::vector<insideout::Id>& facets);

  /** Triangles of the boundary with vtkOriginalCellIds (-1 where a hole was closed),
   * vtkOriginalPointIds and the input's data; merged points have the lowest id's. */
  vtkSmartPointer<vtkPolyData> MakeBoundary(
    const insideout::HullMesh& hull, const std::vector<insideout::BoundaryTriangle>& boundary);

  /** The same with several points in a place where the input's triangles differ in texture
   * coordinates or normals, or where triangles cross that have point data at all. Can be stopped.
   */
  vtkSmartPointer<vtkPolyData> MakeSeamedBoundary(const insideout::HullMesh& hull,
    const std::vector<insideout::BoundaryTriangle>& boundary, insideout::Monitor& monitor,
    const insideout::ProgressRange& progress);

  /** How many input points were merged with one that has other texture coordinates or normals. */
  insideout::Id CountSeamPoints(const insideout::HullMesh& hull) const;

  /** Pieces of facets and the input's degenerate triangles, with OutlierReason, FacetMultiplicity,
   * vtkOriginalCellIds, vtkOriginalPointIds, the input's data, and the reasons' names in the field
   * array OutlierReasonNames. */
  vtkSmartPointer<vtkPolyData> MakeOutliers(
    const insideout::HullMesh& hull, const std::vector<insideout::OutlierPiece>& pieces);

  /** The mesh with FacetIds, FacetMultiplicity, vtkOriginalPointIds and the input's point data, and
   * the input cells of facets that it lost in the field array LostCellIds. */
  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
    const insideout::FacetComplex& surface, const insideout::TetrahedralMesh& mesh);

  /** The same with w. */
  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const insideout::HullMesh& hull);

private:
  void ReadPolygons(vtkPolyData* input);
  void ReadStrips(vtkPolyData* input);
  void ReadMultiplicity(vtkPolyData* input);
  void ReadParticipation(vtkPolyData* input, const std::string& name);
  std::vector<insideout::Id> AlikePoints(const insideout::HullMesh& hull) const;
  std::vector<vtkIdType> CellsOfBoundary(
    const std::vector<insideout::BoundaryTriangle>& boundary) const;
  /** A field array of the input cells that facets are pieces of, each once, ascending. */
  void AddCellsOfFacets(const char* name, const insideout::FacetComplex& surface,
    const std::vector<insideout::Id>& facets, vtkDataSet* output) const;
  void CheckCell(vtkIdType cell, vtkIdType size, const vtkIdType* corners);
  /** Clip a polygon into ears; false where it crosses itself, so that a fan has to do. */
  bool AddPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* corners);
  void AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c);
  vtkSmartPointer<vtkPolyData> MakeSurface(const std::vector<insideout::Point>& points,
    const std::vector<insideout::PointOrigin>& origins,
    const std::vector<insideout::Triangle>& triangles, const std::vector<vtkIdType>& cells,
    std::initializer_list<const char*> added);

  vtkPolyData* Input;
  std::vector<vtkIdType> CellOfTriangle;
};

/** The lines of a surface's defects with vtkOriginalPointIds: those of one point become vertices,
 * which VTK numbers before the polylines. */
vtkSmartPointer<vtkPolyData> vtkInsideOutMakeLines(const insideout::SurfaceDefects& defects);

/**
 * Put each figure into the data set's field data, as a one-value array Statistics_NAME. They come
 * first: ParaView's Information panel shows no field data whose first array is empty.
 */
void vtkInsideOutAddStatistics(const insideout::Statistics& statistics, vtkDataSet* output);

/** Put the labels on the grid as its cell array Inside. */
void vtkInsideOutAddInside(const std::vector<unsigned char>& inside, vtkUnstructuredGrid* grid);

/** The cells whose array Inside is 1, with the points they use. Can be stopped. */
vtkSmartPointer<vtkUnstructuredGrid> vtkInsideOutExtractInside(
  vtkUnstructuredGrid* grid, insideout::Monitor& monitor, const insideout::ProgressRange& progress);

#endif
