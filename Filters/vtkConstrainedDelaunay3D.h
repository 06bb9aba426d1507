// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkConstrainedDelaunay3D
 * @brief   tetrahedra of the convex hull of a surface that respect each of its facets
 *
 * Takes a surface whose facets do not cross (vtkResolveSelfIntersections makes one) and fills its
 * convex hull with tetrahedra. Every facet is a union of their faces, every vertex one of their
 * points. Steiner points are added only where necessary. By default the facets are recovered in
 * this process, by flips and cuts with exact predicates. If a facet is lost, or if Engine requires
 * it, TetGen is run in a separate program, insideout-tetgen, so that it cannot crash the host. The
 * environment variable INSIDEOUT_TETGEN can name another path of that program.
 *
 * The result is checked with exact predicates. If facets cross or a budget is used up, all methods
 * may lose facets. Then the mesh that loses the fewest is taken, as a last resort the Delaunay
 * tetrahedra of the points. Warnings name the method that made the mesh and the reasons against the
 * others; GetRungName(Rung), with the statistic Rung, names it, too.
 *
 * Output: positively oriented vtkTetra, with the input's point data: interpolated on facets, NaN (0
 * for integers) in the volume. Arrays of four components have one for each face in VTK's order.
 * - FacetIds (vtkIdType, cells, 4 components): the input cell that the face lies on, -1 for none;
 *   if there are several, one whose normal leaves the cell, else the lowest
 * - FacetMultiplicity (short, cells, 4 components): jump of the winding number on entering the cell
 *   through the face
 * - vtkOriginalPointIds (vtkIdType, points): the input's point, -1 for a Steiner point
 * - LostCellIds (vtkIdType, field data): input cells of facets that the mesh does not follow
 * - Statistics, StatisticsNames (double and string, field data): figures and their names: Rung,
 *   HullPoints, HullCells, SteinerPoints, SurfaceSteinerPoints, LostFacets, SecondsCDT
 *
 * Errors, with an empty output: facets that cross; points that are not finite; ids out of range;
 * lines, or polygons in one plane, which vtkRobustTriangulate takes.
 *
 * @sa vtkResolveSelfIntersections vtkGeneralizedWindingNumber
 */
#ifndef vtkConstrainedDelaunay3D_h
#define vtkConstrainedDelaunay3D_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkInsideOutEngine.h"        // for the options of engines
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSINSIDEOUT_EXPORT vtkConstrainedDelaunay3D : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkConstrainedDelaunay3D* New();
  vtkTypeMacro(vtkConstrainedDelaunay3D, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutMergeToleranceMacro() vtkInsideOutCountDuplicatesMacro()
    vtkInsideOutNonParticipatingMacro()
    ///@}

    ///@{
    /** The engine and its budgets: vtkInsideOutEngine.h describes these options. */
    vtkInsideOutEngineMacro() vtkInsideOutTimeBudgetMacro() vtkInsideOutMemoryBudgetMacro()
    ///@}

    /** Name of method 1, 2 ... in the order in which they are tried; nullptr after the last. */
    static const char* GetRungName(int rung);

protected:
  vtkConstrainedDelaunay3D();
  ~vtkConstrainedDelaunay3D() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkConstrainedDelaunay3D(const vtkConstrainedDelaunay3D&) = delete;
  void operator=(const vtkConstrainedDelaunay3D&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
