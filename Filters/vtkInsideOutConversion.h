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

#include "HullMesh.h"
#include "SurfaceDefects.h"
#include "SurfaceFile.h"

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
   * @throws insideout::Error that names the cell or point at fault
   */
  explicit vtkInsideOutConversion(vtkPolyData* input);

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

  /** Triangles between points of the mesh, each with the input cell it lies on or -1, and the
   * input's data. */
  vtkSmartPointer<vtkPolyData> MakeSurface(const insideout::TetrahedralMesh& mesh,
    const std::vector<insideout::Triangle>& triangles, const std::vector<vtkIdType>& cells);

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
  /** A field array of the input cells that facets are pieces of, each once, ascending. */
  void AddCellsOfFacets(const char* name, const insideout::FacetComplex& surface,
    const std::vector<insideout::Id>& facets, vtkDataSet* output) const;
  void CheckCell(vtkIdType cell, vtkIdType size, const vtkIdType* corners);
  /** Clip a polygon into ears; false where it crosses itself, so that a fan has to do. */
  bool AddPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* corners);
  void AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c);
  vtkSmartPointer<vtkPolyData> MakeSurface(const std::vector<insideout::Point>& points,
    const std::vector<insideout::PointOrigin>& origins,
    const std::vector<insideout::Triangle>& triangles, const std::vector<vtkIdType>& cells);

  vtkPolyData* Input;
  std::vector<vtkIdType> CellOfTriangle;
};

/** The polygons of a file, with their attributes. */
vtkSmartPointer<vtkPolyData> vtkInsideOutMakePolyData(const insideout::PolygonSurface& surface);

/**
 * The polygons and strips of a surface, for a file: strips become triangles, lines and vertices
 * stay behind. VTK's normals, texture coordinates and colours (scalars of 3 or 4 unsigned char) are
 * called Normals, TCoords and Colors, whatever their name; other numeric arrays keep theirs.
 * Integers of other types become int, or double where they do not fit.
 *
 * @throws insideout::Error that names the cell whose point is out of range
 */
insideout::PolygonSurface vtkInsideOutReadPolyData(vtkPolyData* input);

/** The lines of a surface's defects with vtkOriginalPointIds: those of one point become vertices,
 * which VTK numbers before the polylines. */
vtkSmartPointer<vtkPolyData> vtkInsideOutMakeLines(const insideout::SurfaceDefects& defects);

/** Put each figure into the data set's field data, as a one-value array Statistics_NAME. */
void vtkInsideOutAddStatistics(const insideout::Statistics& statistics, vtkDataSet* output);

/** Put the labels on the grid as its cell array Inside. */
void vtkInsideOutAddInside(const std::vector<unsigned char>& inside, vtkUnstructuredGrid* grid);

/** The cells whose array Inside is 1, with the points they use. */
vtkSmartPointer<vtkUnstructuredGrid> vtkInsideOutExtractInside(vtkUnstructuredGrid* grid);

#endif
