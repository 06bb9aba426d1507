// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkBoundaryLayers
 * @brief   layers of prisms at the walls of a solid, for flow
 *
 * Takes a conforming grid of tetrahedra, as vtkRobustTetrahedralize and vtkRefineTetrahedra make
 * it, and the triangles of its boundary, and puts layers of prisms behind those that have one of
 * LayerTags. These triangles stay as they are, bit by bit; tetrahedra behind the layers move away
 * and are improved.
 *
 * All layers at a point of the wall go the same way, and shrink alike where there is no room for
 * them: in gaps to a third of the width, where the wall is bent inward, and in sharp corners. Along
 * planar parts of the rest of the boundary, such as inlets, they go on with full height: quads are
 * there at the wall, and the triangles behind get narrower in their plane. The rest stays, too,
 * where it is not planar. Layers end there, with height 0, and at faces between regions, at edges
 * between tags of one plane, and where no direction leads away from all triangles of a point. A
 * prism that has lost one edge is a pyramid, and one that has lost two a tetrahedron. By this the
 * grid conforms: faces are shared by two cells.
 *
 * Every cell is positive at its corners, by exact predicates: a tetrahedron has a positive volume,
 * and so have the corners of prisms and pyramids with the three edges there. The layers cross
 * neither each other nor the wall. The same input gives the same output, on any number of threads.
 *
 * Output: vtkTetra, then vtkPyramid, then vtkWedge. The cell array Layer counts from 1 at the wall;
 * it is 0 behind the layers. Other cell data are those of the input's cell at the same place, but
 * without FacetIds and FacetMultiplicity, which have a value for each face of a tetrahedron. Point
 * data are interpolated (0 in integer arrays); vtkOriginalPointIds is -1 for points that are new or
 * have moved. Field data: the input's, and Statistics (named by StatisticsNames) of Layers, Prisms,
 * Pyramids, LayerTetrahedra; of the wall WallTriangles, WallPoints, ReducedPoints, whose layers are
 * lower than asked for, and BarePoints without any, NarrowPoints, where
 * the solid is narrower than three times the layers; FullHeightShare, the share of its area whose
 * three points have full height, MeanHeightShare, the mean of the heights' shares over it, and
 * SecondsLayers. The quality of cells is that of the tetrahedra behind. A warning gives the share
 * of the wall with full height, unless it is 1.
 *
 * The second output is the boundary of this grid, if one is given: its triangles, and each quad as
 * two, with the data of a triangle of the same part. vtkSolidWriter writes quads.
 *
 * Errors, which name the culprit (an unknown tag, a cell that is no linear tetrahedron, a triangle
 * that is no face), leave the outputs empty.
 *
 * @sa vtkRefineTetrahedra
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
  /** Number of layers of prisms at the wall. Default 3. Range 1 to 1000. */
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
  /** Height of a layer over that of the one before it, nearer to the wall. Default 1.2. Range 0.1
   * to 10. */
  vtkInsideOutSetRangeMacro(Growth, double, 0.1, 10.0);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /** Names of the tags of the boundary that are the wall, separated by commas. Default empty: all
   * of it. A comma within a name is written \, and a backslash \\. Triangles between regions get no
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
