// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkBoundaryLayers
 * @brief   layers of prisms, or of quads in a plane, at the walls of a solid, for flow
 *
 * Takes a conforming grid of tetrahedra, as vtkRobustTetrahedralize and vtkRefineTetrahedra make
 * it, and the triangles of its boundary. Puts layers of prisms behind the wall, the triangles with
 * one of LayerTags. The wall stays, bit by bit; the tetrahedra behind the layers move away and are
 * improved.
 *
 * All layers at a point of the wall have the same direction. They shrink alike where there is no
 * room for them: in gaps to a third of the width, where the wall is bent inward, and in sharp
 * corners. They continue with full height along planar parts of the rest of the boundary, such as
 * inlets: these get quads next to the wall, and their triangles become narrower in their plane.
 * Layers end, with height 0, at other parts, which stay; at faces between regions; at edges between
 * tags of one plane; and where no direction leads away from all triangles of a point. A prism that
 * loses one edge becomes a pyramid, one that loses two a tetrahedron. So the grid conforms: faces
 * are shared by two cells.
 *
 * Every cell is positive at its corners, by exact predicates: each tetrahedron has a positive
 * volume, and so has the tetrahedron of each corner of a prism or pyramid and its three neighbors.
 * The layers cross neither each other nor the wall. The same input gives the same output, on any
 * number of threads.
 *
 * In a plane: takes triangles, as vtkRobustTriangulate makes them, and the polylines of their
 * boundary, with the triangles on their left. Layers are of quads, and of triangles where they end;
 * they continue along straight parts of the boundary, and end at lines within the solid that
 * FacetIds gives. The triangles behind are made anew around the input's points that are not close
 * to the layers.
 *
 * Output: vtkTetra, then vtkPyramid, then vtkWedge. The cell array Layer counts from 1 at the wall;
 * it is 0 behind the layers. Other cell data are those of the input's cell at the same place, but
 * without FacetIds and FacetMultiplicity, which have a value for each face of a tetrahedron. Point
 * data are interpolated (0 in integer arrays); vtkOriginalPointIds is -1 for points that are new or
 * have moved. Field data: the input's, and Statistics (named by StatisticsNames): Layers, Prisms,
 * Pyramids, LayerTetrahedra and SecondsLayers. The wall has WallTriangles and WallPoints.
 * ReducedPoints have layers lower than requested, BarePoints none. NarrowPoints are where the solid
 * is narrower than three times the layers, EndPoints where no direction leads inward, as above.
 * FullHeightShare is the share of the wall with full height at all three points,
 * MeanHeightShare the mean height over the requested one. The quality of cells is that of the
 * tetrahedra behind. A warning gives the share of the wall with full height, unless it is 1. In a
 * plane the cells are vtkTriangle, then vtkQuad, and Statistics has Quads, LayerTriangles and
 * WallEdges.
 *
 * The second output is the boundary of the grid with layers, if the second input is given: its
 * triangles, and each quad as two triangles, with the data of a triangle of the same part; in a
 * plane its polylines. vtkSolidWriter writes quads.
 *
 * Errors name the culprit (an unknown tag, a cell other than a linear tetrahedron or triangle, a
 * triangle that is no face), and leave the outputs empty.
 *
 * @sa vtkRefineTetrahedra vtkRobustTriangulate
 */
#ifndef vtkBoundaryLayers_h
#define vtkBoundaryLayers_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutRange.h"         // for setters with a range
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKFILTERSINSIDEOUT_EXPORT vtkBoundaryLayers : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkBoundaryLayers* New();
  vtkTypeMacro(vtkBoundaryLayers, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Number of layers of prisms, in a plane of quads, at the wall. Default 3. Range 1 to 1000. */
  vtkInsideOutSetRangeMacro(Layers, int, 1, 1000);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /** Height of the layer at the wall, in units of the input. Default 0: none, which is an error.
   * Range 0 to infinity. */
  vtkInsideOutSetRangeMacro(FirstHeight, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FirstHeight, double);
  ///@}

  ///@{
  /** Ratio of a layer's height to that of the next one nearer to the wall. Default 1.2. Range 0.1
   * to 10. */
  vtkInsideOutSetRangeMacro(Growth, double, 0.1, 10.0);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /** Names of the tags that form the wall, separated by commas. Default empty: the whole boundary.
   * A comma within a name is written \, and a backslash \\. Triangles between regions get no
   * layers, with a warning. */
  vtkSetStdStringFromCharMacro(LayerTags);
  virtual const char* GetLayerTags() const { return this->LayerTags.c_str(); }
  ///@}

  ///@{
  /** The second input: the triangles of the boundary, with the cell array BoundaryTag and the field
   * array BoundaryTagNames. Optional where LayerTags is empty. */
  void SetBoundaryConnection(vtkAlgorithmOutput* boundary);
  void SetBoundaryData(vtkPolyData* boundary);
  ///@}

  /** The second output: the boundary of the solid with layers, where a boundary was given. */
  vtkPolyData* GetBoundary();

protected:
  vtkBoundaryLayers();
  ~vtkBoundaryLayers() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Layers;
  double FirstHeight;
  double Growth;
  std::string LayerTags;

private:
  vtkBoundaryLayers(const vtkBoundaryLayers&) = delete;
  void operator=(const vtkBoundaryLayers&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
