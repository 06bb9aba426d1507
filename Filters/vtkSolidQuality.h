// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSolidQuality
 * @brief finds the defects of tetrahedra, and their quality
 *
 * Takes a grid of tetrahedra, of first or second order (vtkTetra, vtkQuadraticTetra; the corners of
 * the latter count, but for RefusedCells), and of linear pyramids and prisms of boundary layers
 * (vtkPyramid, vtkWedge). Finds cells that are flat or negative, where cells do not fit together,
 * and the quality of each tetrahedron. Nothing is changed. Exact predicates find flat, negative and
 * non-conforming cells; a pyramid or prism is as its worst corner. Cells of lower dimension are
 * skipped, with a warning.
 *
 * The output is the input with these cell arrays, 0 where a cell is no tetrahedron:
 * - MinDihedralAngle, MaxDihedralAngle (double): the cell's least and largest angle between two of
 *   its faces, in degrees
 * - RadiusEdgeRatio (double): the radius of its circumsphere over its shortest edge, 0.612 at best,
 *   infinite where it is flat
 * - MeanRatio (double): 12 (3 V)^(2/3) over the sum of its squared edges, as vtkMeshQuality has it:
 *   1 at best, 0 where it is flat, negative where it is inverted
 * - Orientation (signed char), of pyramids and prisms, too: 1 where the volume is positive, 0 where
 *   it is flat, -1 where it is negative
 *
 * Statistics:
 *
 * - Cells; Regions, the parts that are joined through faces; NegativeCells, FlatCells; Pyramids and
 *   Prisms, where there are any
 * - BoundaryFaces, of one cell; CrowdedFaces, of more than two; OverlappingFaces, whose two cells
 *   lie on the same side; ContactPairs, pairs of boundary faces that meet beyond the points and
 *   edges that they share, as where a point lies in the middle of another cell's face. A quad
 * beside two triangles counts as two such pairs
 * - Conforms: 1 without crowded or overlapping faces and contacts; the boundary is watertight then
 * - MinDihedralAngle, MaxDihedralAngle and DihedralAngle1Percent, the least angle that is no less
 *   than a hundredth of all six angles of all cells
 * - MaxRadiusEdgeRatio, and RadiusEdgeRatio99Percent, the least that is no less than 99 % of them
 * - MinMeanRatio, AverageMeanRatio
 * - RefusedCells, whose Jacobian determinants are below 1e-20 (CalculiX's limit), in doubles at
 *   the integration points of linear or quadratic cells, of prisms and pyramids as C3D6; PoorCells,
 *   other tetrahedra with a dihedral angle below 1 degree, from which a solver suffers. A warning
 * counts both, and names the option that helps
 * - CellsUnder10Degrees and CellsUnder5Degrees, which have a dihedral angle below
 * - SurfaceEdgesUnder10Degrees and SurfaceEdgesUnder5Degrees, edges of the boundary where the solid
 *   itself is that sharp, so that some cells have to be
 * - where it conforms, its topology: SolidComponents, SolidTunnels, SolidCavities,
 *   SolidEulerCharacteristic, BoundaryComponents and so on, and Genus, as vtkRobustTetrahedralize
 *   has them
 *
 * - DihedralAngleHistogram (vtkIdType, field data, 36 values): how many angles are in each 5
 *   degrees
 *
 * A point that is not finite, a cell with a point out of range or one twice, and a volume of
 * another kind are errors that name them; the output is then empty.
 *
 * @sa vtkSurfaceDefects, vtkMeshQuality
 */
#ifndef vtkSolidQuality_h
#define vtkSolidQuality_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSINSIDEOUT_EXPORT vtkSolidQuality : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSolidQuality* New();
  vtkTypeMacro(vtkSolidQuality, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSolidQuality() = default;
  ~vtkSolidQuality() override = default;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSolidQuality(const vtkSolidQuality&) = delete;
  void operator=(const vtkSolidQuality&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
