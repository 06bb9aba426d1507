// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkResolveSelfIntersections
 * @brief   cuts a surface where it crosses itself, exactly
 *
 * Takes any polygonal surface and gives the same surface in triangles of which no two meet
 * except in shared points and edges: what crosses, touches or overlaps is cut there, with exact
 * arithmetic. New points are rounded to doubles, and what crosses after rounding is cut again
 * until a check with exact predicates finds nothing. Points of the input keep their coordinates
 * to the last bit.
 *
 * Output: points are double, with vtkOriginalPointIds (input point, -1 for a new one). Cells
 * carry vtkOriginalCellIds (the input cell, the lowest of several) and FacetMultiplicity (short:
 * how often the input covers the facet along its own orientation, signed; 0 where it cancels).
 * The input's point data are interpolated at new points, its cell data are copied. Field data:
 * Statistics_NAME, a double each; LeftOutCellIds, the input cells of facets that still cross others
 * after the last round of rounding and are left out (a warning says so; hardly any model has one).
 *
 * Lines and vertices beside polygons are ignored with a warning, degenerate polygons are left out
 * and counted. Errors, with an empty output: a point that is not finite, a cell with a point out of
 * range, which they name; and lines alone, which are for vtkRobustTriangulate.
 *
 * @sa vtkConstrainedDelaunay3D
 *
 */
#ifndef vtkResolveSelfIntersections_h
#define vtkResolveSelfIntersections_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string>

class VTKFILTERSINSIDEOUT_EXPORT vtkResolveSelfIntersections : public vtkPolyDataAlgorithm
{
public:
  static vtkResolveSelfIntersections* New();
  vtkTypeMacro(vtkResolveSelfIntersections, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points at most this far apart become one, in units of the surface; of several the one with the
   * lowest id stays. Default 0: only points with equal coordinates are merged. Range 0 to infinity.
   */
  vtkSetClampMacro(MergeTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Count a polygon as often as it is given. Default off: triangles with the same three points
   * count once per orientation, and opposite ones cancel.
   */
  vtkSetMacro(CountDuplicates, bool);
  vtkGetMacro(CountDuplicates, bool);
  vtkBooleanMacro(CountDuplicates, bool);
  ///@}

  ///@{
  /**
   * Name of a cell array of the input, of one number per cell: where it is not 0 the cell does not
   * count in w, but still shapes the mesh, as accessories that are no part of the body should. Such
   * a cell cancels no other. Default empty: every cell counts.
   */
  vtkSetStdStringFromCharMacro(NonParticipatingArrayName);
  vtkGetCharFromStdStringMacro(NonParticipatingArrayName);
  ///@}

protected:
  vtkResolveSelfIntersections();
  ~vtkResolveSelfIntersections() override = default;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double MergeTolerance;
  bool CountDuplicates;
  std::string NonParticipatingArrayName;

private:
  vtkResolveSelfIntersections(const vtkResolveSelfIntersections&) = delete;
  void operator=(const vtkResolveSelfIntersections&) = delete;
};

#endif
