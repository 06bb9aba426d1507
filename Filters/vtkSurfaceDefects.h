// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSurfaceDefects
 * @brief marks and draws the defects of a surface
 *
 * Takes any polygonal surface and shows where it crosses itself, is open, non-manifold, inverted,
 * duplicated or degenerate. Table 8.1 of Jacobson's thesis (2013) counts these defects, its figure
 * 8.22 draws them. Nothing is changed or cut. Exact predicates decide where facets meet.
 *
 * Output 0, the surface: the input with these cell arrays. A cell of several triangles has the sum
 * of their SelfIntersections and the lowest ComponentId that is not -1, and is marked if one of
 * them is. Lines and vertices have no marks.
 * - ComponentId (int): components of facets joined through edges, numbered from 0 by first cell; -1
 *   for cells with no area
 * - ShellId (int): shells, sets of connected facets with consistent orientation, from 0; -1 for
 *   cells that do not count
 * - ShellVolumes (double, field data): the volume that each shell encloses after it is turned and
 *   its holes are capped: negative for a cavity, 0 for a sheet
 * - SelfIntersections (int): number of facets that it meets beyond shared corners and edges
 * - Degenerate (unsigned char): 1 where a triangle has no area
 * - Duplicate (unsigned char): 1 where an earlier triangle has the same three points
 * - Inconsistent (unsigned char): 1 where a neighbor across an edge of exactly two facets has the
 *   opposite orientation
 * - TwoSided (unsigned char): 1 where each facet of the component is given in both orientations
 * - Turned (unsigned char): 1 where Orientation turns a triangle over
 * - Sheet (unsigned char): 1 where a triangle belongs to a shell that encloses nothing, or does not
 *   count
 * - Membrane (unsigned char): 1 where it belongs to a sheet within the solid or across it, which
 *   does not count
 * - DefectColor (3 unsigned char): light vermilion where SelfIntersections is above 0, else sky
 *   blue where Turned is 1, else a light color per component, from yellow to green
 *
 * Output 1, the lines: polylines, and vertices where facets only touch, with the point array
 * vtkOriginalPointIds (-1 on intersection curves) and the cell arrays
 * - DefectType (int): the kind of defect, a value of DefectTypes
 * - DefectName (string): the same in words
 * - DefectColor (3 unsigned char): open boundary blue, non-manifold reddish purple, inconsistent
 *   bluish green, intersection curves vermilion
 *
 * Both outputs have the field data Statistics, named by StatisticsNames: the counts of
 * vtkResolveSelfIntersections, and IntersectingFacets, InconsistentEdges, UnbalancedEdges (edges
 * whose facets' signed sum is not 0; without such edges the surface is closed), Planar (1 if all
 * facets lie in one plane). NearPoints are points within NearDistance, a millionth of the size, of
 * another one. EnclosedVolume is that of the solid that would be meshed, OverlapVolume that where w
 * is 2 or more. EnclosedVolumeLow, EnclosedVolumeHigh, OverlapVolumeLow and OverlapVolumeHigh bound
 * these volumes in 95 of 100 cases; they are equal if a volume is exact. The OverlapVolume of a
 * solid that was meshed is that of its cells, without bounds. The statistics of orientation are
 * described at vtkGeneralizedWindingNumber.
 *
 * Lines without polygons, which have to lie in one plane, are checked in two dimensions. Output 0
 * has ComponentId, SelfIntersections, Degenerate, Duplicate and Turned per line; output 1 has
 * vertices with DefectType, DefectName and DefectColor where lines end or cross, and where a point
 * lies within another line. Statistics: OpenEnds, IntersectingPairs, Crossings, TJunctions,
 * DuplicateSegments and the like, and Area, the area where w is above 1/2 after lines are turned.
 * AreaByEvenOdd, AreaByWindingNumber and AreaAsGiven exist if these rules differ, because a hole
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
    OPEN_END = 4,           ///< of lines: different numbers of them begin and end there
    CROSSING = 5,           ///< of lines: they cross
    T_JUNCTION = 6 ///< of lines: a point lies within another line, or lines overlap from there on
  };

  /** The lines (output 1). */
  vtkPolyData* GetLines();

  ///@{
  /**
   * GetVerdict returns one sentence: whether the surface bounds a solid, and its volume.
   * GetVerdictOf returns the same from field data with the statistics of any filter; statistics of
   * a solid give its volume. GetVolumeInWords rounds a volume to the digits that its bounds
   * support.
   */
  std::string GetVerdict();
  static std::string GetVerdictOf(vtkFieldData* statistics);
  static std::string GetVolumeInWords(double volume, double low, double high);
  ///@}

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. The array Turned
   * marks the facets that Orientation would turn over. */
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
