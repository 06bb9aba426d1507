// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSolidQuality
 * @brief finds the defects of tetrahedra, and their quality
 *
 * Takes a grid of tetrahedra, linear or quadratic (vtkTetra, vtkQuadraticTetra), and of linear
 * pyramids and prisms of boundary layers (vtkPyramid, vtkWedge). Mid-edge nodes of quadratic cells
 * count only for RefusedCells. Finds flat, negative and non-conforming cells by exact predicates,
 * and the quality of each tetrahedron. Nothing is changed. A pyramid or prism is classified by its
 * worst corner. Cells of lower dimension are skipped, with a warning.
 *
 * The output is the input with these cell arrays, which are 0 for other cells than tetrahedra:
 * - MinDihedralAngle, MaxDihedralAngle (double): the cell's least and largest angle between two of
 *   its faces, in degrees
 * - RadiusEdgeRatio (double): radius of the circumsphere over the shortest edge; 0.612 at best,
 *   infinite for a flat cell
 * - MeanRatio (double): 12 (3 V)^(2/3) over the sum of the squared edges, as in vtkMeshQuality: 1
 *   at best, 0 for a flat cell, negative for an inverted one
 * - Orientation (signed char), also of pyramids and prisms: the sign of the volume, 1, 0 or -1
 *
 * Statistics:
 *
 * - Cells; Regions, the parts connected through faces; NegativeCells, FlatCells; Pyramids and
 *   Prisms, if there are any
 * - BoundaryFaces, of one cell; CrowdedFaces, of more than two; OverlappingFaces, whose two cells
 *   lie on the same side; ContactPairs, pairs of boundary faces that meet beyond shared points and
 *   edges, for example where a point lies inside another cell's face. A quad that coincides with
 *   two triangles counts as two such pairs
 * - Conforms: 1 if there are no crowded or overlapping faces and no contacts; the boundary is
 *   watertight then
 * - MinDihedralAngle, MaxDihedralAngle and DihedralAngle1Percent, the first percentile of the six
 *   dihedral angles of all cells
 * - MaxRadiusEdgeRatio, and RadiusEdgeRatio99Percent, the 99th percentile
 * - MinMeanRatio, AverageMeanRatio
 * - RefusedCells, which have a Jacobian determinant below 1e-20 (CalculiX's limit), in doubles, at
 *   an integration point (prisms and pyramids as C3D6); PoorCells, other tetrahedra with a dihedral
 *   angle below 1 degree, for which a solver is slow and inaccurate. A warning counts both, and
 *   names the option that helps
 * - CellsUnder10Degrees and CellsUnder5Degrees, with a dihedral angle below that
 * - SurfaceEdgesUnder10Degrees and SurfaceEdgesUnder5Degrees, edges of the boundary where the solid
 *   itself is that sharp, so that cells there cannot be better
 * - topology of a conforming grid: SolidComponents, SolidTunnels, SolidCavities,
 *   SolidEulerCharacteristic, BoundaryComponents and so on, and Genus, as described at
 *   vtkRobustTetrahedralize
 *
 * - DihedralAngleHistogram (vtkIdType, field data, 36 values): number of angles per 5 degrees
 *
 * Errors, which name the culprit and leave the output empty: a point that is not finite, a cell
 * with a point out of range or repeated, and a volume of another type.
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
