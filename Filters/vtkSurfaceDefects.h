// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSurfaceDefects
 * @brief marks and draws the defects of a surface
 *
 * Takes any polygonal surface and shows where it crosses itself, is open, non-manifold, turned the
 * wrong way, doubled or degenerate: what the table 8.1 of Jacobson's thesis (2013) counts and its
 * figure 8.22 draws. Nothing is changed or cut. Facets meet exactly where exact predicates say so.
 *
 * Output 0, the surface: the input with these cell arrays. Where a cell has several triangles, it
 * sums up SelfIntersections, has the lowest ComponentId that is not -1, and is marked when one of
 * them is. Lines and vertices have no marks.
 * - ComponentId (int): components of facets joined through edges, numbered from 0 by first cell; -1
 *   for cells with no area
 * - ShellId (int): shells, sets of facets that face one way together, from 0; -1 for cells that
 *   count nothing
 * - ShellVolumes (double, field data): the volume that each shell encloses once it is turned as
 *   the orientation asks, holes capped: negative for a cavity, 0 for a sheet
 * - SelfIntersections (int): how many facets it meets beyond shared corners and edges
 * - Degenerate (unsigned char): 1 where a triangle has no area
 * - Duplicate (unsigned char): 1 where an earlier triangle has the same three points
 * - Inconsistent (unsigned char): 1 where a neighbor across an edge of exactly two facets faces the
 *   other way
 * - TwoSided (unsigned char): 1 where the whole component is given in both orientations
 * - Turned (unsigned char): 1 where the orientation asks to turn a triangle over
 * - Sheet (unsigned char): 1 where a triangle is of a shell that encloses nothing, or counts 0
 * - Membrane (unsigned char): 1 where it is of a sheet within the solid or across it, which does
 *   not count
 * - DefectColor (3 unsigned char): light vermilion where SelfIntersections is above 0, else sky
 *   blue where Turned is 1, else a light color per component, from yellow to green
 *
 * Output 1, the lines: polylines, and vertices where facets only touch, with the point array
 * vtkOriginalPointIds (-1 on intersection curves) and the cell arrays
 * - DefectType (int): a DefectTypes
 * - DefectName (string): the same in words
 * - DefectColor (3 unsigned char): open boundary blue, non-manifold reddish purple,
 *   inconsistent bluish green, intersection curves vermilion
 *
 * Both carry field data Statistics, named by StatisticsNames: the counts of
 * vtkResolveSelfIntersections, and IntersectingFacets, InconsistentEdges, UnbalancedEdges (edges on
 * which the facets' signed sum is not 0; without any the surface is closed), Planar (1: all facets
 * lie in one plane); NearPoints (points nearer than NearDistance, a millionth of the size, to
 * another); EnclosedVolume (of the solid that a mesh would have) and OverlapVolume (where w is 2 or
 * more). EnclosedVolumeLow, EnclosedVolumeHigh, OverlapVolumeLow and OverlapVolumeHigh are bounds
 * that hold these volumes in 95 of 100 cases; they are equal if a volume is exact. A solid that was
 * made has the OverlapVolume of its cells, without bounds. The statistics of orientation are
 * explained at vtkGeneralizedWindingNumber.
 *
 * Lines without polygons, which have to lie in one plane, have the same in two dimensions:
 * ComponentId, SelfIntersections, Degenerate, Duplicate and Turned per line, and output 1 has
 * vertices with DefectType, DefectName and DefectColor where lines end, cross, or have a point of
 * others within. Statistics: OpenEnds, IntersectingPairs, Crossings, TJunctions, DuplicateSegments
 * and the like, and Area, where w is above 1/2 once lines are turned as the orientation asks.
 * AreaByEvenOdd, AreaByWindingNumber and AreaAsGiven are there if these rules differ, for a hole
 * crosses its outline or runs the same way. Polygons in one plane have an Area, too.
 *
 * A point that is not finite or a cell with a point out of range is an error that names it; the
 * outputs are then empty.
 *
 * @sa vtkResolveSelfIntersections
 */
#ifndef vtkSurfaceDefects_h
#define vtkSurfaceDefects_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the verdict

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;

class VTKFILTERSINSIDEOUT_EXPORT vtkSurfaceDefects : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceDefects* New();
  vtkTypeMacro(vtkSurfaceDefects, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The values of DefectType. */
  enum DefectTypes
  {
    OPEN_BOUNDARY = 0,      ///< edges of exactly one facet
    NON_MANIFOLD_EDGE = 1,  ///< edges of more than two facets
    INCONSISTENT_EDGE = 2,  ///< edges along which exactly two facets run the same way
    INTERSECTION_CURVE = 3, ///< where facets cross or touch; the boundary of overlaps in a plane
    OPEN_END = 4,           ///< of lines: more of them begin than end there, or the other way round
    CROSSING = 5,           ///< of lines: they cross
    T_JUNCTION = 6 ///< of lines: a point lies within another line, or lines overlap from there on
  };

  /** The lines (output 1). */
  vtkPolyData* GetLines();

  ///@{
  /**
   * GetVerdict says in one sentence whether the surface bounds a solid, and of what volume.
   * GetVerdictOf says the same by field data with the statistics of any filter; those of a solid
   * give its volume. GetVolumeInWords rounds a volume to the digits that its bounds support.
   */
  std::string GetVerdict();
  static std::string GetVerdictOf(vtkFieldData* statistics);
  static std::string GetVolumeInWords(double volume, double low, double high);
  ///@}

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. Turned marks the
   * facets that Orientation would turn over. */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro()
    ///@}

    protected : vtkSurfaceDefects();
  ~vtkSurfaceDefects() override = default;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSurfaceDefects(const vtkSurfaceDefects&) = delete;
  void operator=(const vtkSurfaceDefects&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
