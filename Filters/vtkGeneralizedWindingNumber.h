// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkGeneralizedWindingNumber
 * @brief   the winding number of a surface in tetrahedra of its convex hull
 *
 * Takes any triangle or polygon surface, however broken. Resolves its self-intersections,
 * tetrahedralizes its convex hull and computes in each cell the generalized winding number w of
 * Jacobson, Kavan and Sorkine-Hornung (2013): the number of times the surface wraps around the
 * cell. For a closed surface w is an exact integer in every cell; near holes it is a fraction that
 * varies smoothly.
 *
 * Output: that of vtkConstrainedDelaunay3D with its arrays, LeftOutCellIds of
 * vtkResolveSelfIntersections, statistics of the surface's defects and the seconds of each stage,
 * and
 * - w (double, cells): the winding number: an integer where the surface is closed, a fraction near
 *   holes
 * - TurnedCellIds (vtkIdType, field data): input cells that the orientation turned over
 *
 * Statistics of the orientation: Shells (sets of connected facets with consistent orientation),
 * divided into ClosedShells, HoledShells and SheetShells (which enclose nothing, and count only if
 * they seal off space). SheetShare is the area share of sheets and of facets that do not count.
 * Membranes are sheets within the solid or across it, which do not count (with MembraneFacets, and
 * MembraneShare of the area). UncountedSheets lie outside and seal off no space. Cavities are
 * shells that face inward. TurnedShells and TurnedFacets were turned over (TurnedShare of the
 * area). DisagreeingFacets were oriented against their shells; UndecidedShells fit either way. If
 * facets disagree, DoubtfulCopies counts duplicates that do not count, cancel or face both ways.
 *
 * Lines, and polygons in one plane without Thicken, are errors: use vtkRobustTriangulate.
 *
 * @sa vtkResolveSelfIntersections vtkConstrainedDelaunay3D vtkGraphCutSegmentation
 */
#ifndef vtkGeneralizedWindingNumber_h
#define vtkGeneralizedWindingNumber_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkInsideOutEngine.h"        // for the options of engines
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSINSIDEOUT_EXPORT vtkGeneralizedWindingNumber : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGeneralizedWindingNumber* New();
  vtkTypeMacro(vtkGeneralizedWindingNumber, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro()
    vtkInsideOutCountDuplicatesMacro() vtkInsideOutNonParticipatingMacro()
    ///@}

    ///@{
    /** The engine and its budgets: vtkInsideOutEngine.h describes these options. */
    vtkInsideOutEngineMacro() vtkInsideOutTimeBudgetMacro() vtkInsideOutMemoryBudgetMacro()
    ///@}

    ///@{
    /**
     * Thickness of the slabs that sheets become, in units of the surface. Default 0: sheets bound
     * nothing. Range 0 to infinity. A sheet is an open shell that encloses nothing. It becomes a
     * closed slab, half in front of the facets and half behind, joined with the solid that it
     * touches; the facets stay as faces within.
     */
    vtkInsideOutSetRangeMacro(Thicken, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Thicken, double);
  ///@}

  ///@{
  /** Thicken every facet, not only sheets. Default off. Without effect where Thicken is 0. */
  vtkSetMacro(ThickenAll, bool);
  vtkGetMacro(ThickenAll, bool);
  vtkBooleanMacro(ThickenAll, bool);
  ///@}

  ///@{
  /**
   * Degree of the quadrature that averages w over a cell; it matters only near the holes of open
   * surfaces. Default 1: w at the barycenter. Range 1 to 5. Orders 2 to 5 evaluate w at 4, 8, 14
   * and 14 points. Next to an open edge w depends on the direction from the edge, and high orders
   * gain little there.
   */
  vtkInsideOutSetRangeMacro(QuadratureOrder, int, 1, 5);
  vtkGetMacro(QuadratureOrder, int);
  ///@}

protected:
  vtkGeneralizedWindingNumber();
  ~vtkGeneralizedWindingNumber() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Thicken;
  bool ThickenAll;
  int QuadratureOrder;

private:
  vtkGeneralizedWindingNumber(const vtkGeneralizedWindingNumber&) = delete;
  void operator=(const vtkGeneralizedWindingNumber&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
