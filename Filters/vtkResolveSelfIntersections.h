// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkResolveSelfIntersections
 * @brief   cuts a surface where it crosses itself, exactly
 *
 * Takes any polygonal surface and makes triangles of the same surface that meet only in shared
 * points and edges: facets are cut where they cross, touch or overlap, with exact arithmetic. New
 * points are rounded to doubles, and facets that cross after rounding are cut again, until a check
 * with exact predicates finds no crossing. Input points keep their coordinates to the last bit.
 *
 * Output: triangles with points in double precision. The input's point data are interpolated at new
 * points, its cell data are copied.
 * - vtkOriginalPointIds (vtkIdType, points): the input's point, -1 for a new one
 * - vtkOriginalCellIds (vtkIdType, cells): the input's cell, the lowest of several
 * - FacetMultiplicity (short, cells): number of input facets that cover the facet in its
 *   orientation, minus those in the opposite one; 0 if copies cancel
 * - LeftOutCellIds (vtkIdType, field data): the input cells of facets that are left out because
 *   they still cross others after the last round of rounding (with a warning; hardly any model has
 *   one)
 * - Statistics, StatisticsNames (double and string, field data): figures and their names
 *
 * Lines and vertices beside polygons are ignored with a warning, degenerate polygons are left out
 * and counted. Errors, with an empty output, name a point that is not finite or a cell with a point
 * out of range. Lines alone are an error, too: use vtkRobustTriangulate.
 *
 * @sa vtkConstrainedDelaunay3D
 */
#ifndef vtkResolveSelfIntersections_h
#define vtkResolveSelfIntersections_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkPolyDataAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSINSIDEOUT_EXPORT vtkResolveSelfIntersections : public vtkPolyDataAlgorithm
{
public:
  static vtkResolveSelfIntersections* New();
  vtkTypeMacro(vtkResolveSelfIntersections, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutMergeToleranceMacro() vtkInsideOutCountDuplicatesMacro()
    vtkInsideOutNonParticipatingMacro()
    ///@}

    protected : vtkResolveSelfIntersections();
  ~vtkResolveSelfIntersections() override = default;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkResolveSelfIntersections(const vtkResolveSelfIntersections&) = delete;
  void operator=(const vtkResolveSelfIntersections&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
