// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkProbeWindingNumber
 * @brief   the winding number of a surface at the points or cells of any data set
 *
 * Takes any data set (port 0) and any triangle or polygon surface (port 1), however broken.
 * Evaluates at each point, or at the center of each cell, the generalized winding number w of
 * Jacobson, Kavan and Sorkine-Hornung (2013): the number of times the surface wraps around it. The
 * surface is neither resolved nor meshed. It may cross itself, and it may be open: w is then a
 * fraction that varies smoothly near the holes, and w > 1/2 still distinguishes inside from
 * outside. Ray casting, as in vtkSelectEnclosedPoints, depends on the ray. The class replaces that
 * filter: SetSurfaceData, SetSurfaceConnection, InsideOut, IsInside and IsInsideSurface are the
 * same.
 *
 * Output: the input with all its data, and these arrays on its points or cells:
 * - w (double, points or cells): the winding number; on the surface itself the mean of its values
 *   around the point, weighted by solid angle: on a polygon of a closed surface the mean of both
 *   sides, a half
 * - Inside (unsigned char, points or cells): 1 where w is above Threshold, else 0
 * - Distance (double, points or cells): with Distance, the distance of the nearest polygon;
 *   negative inside
 * - ClosestPoint (double, points or cells, 3 components): with ClosestPoints, the nearest point on
 *   the surface
 * - ClosestCellId (vtkIdType, points or cells): with ClosestPoints, the cell of that point
 *
 * Images and rectilinear grids are fastest, because whole rows are evaluated at once: an image of
 * 300 by 300 by 300 points takes a second.
 *
 * Inverted parts are turned over (see Orientation). Duplicates, two-sided parts and degenerate
 * polygons count as in vtkGeneralizedWindingNumber: both give the same result. A point of the input
 * that is not finite has w = NaN and is not inside. A point of the surface that is not finite, or a
 * cell with a point out of range, is an error that names it.
 *
 * For lines without polygons, which have to lie in one plane, it is the winding number of the curve
 * there: 1 inside one that runs counter-clockwise seen from where the largest component of the
 * plane's normal is positive. A query point off the plane has the w of its projection onto the
 * plane.
 *
 * Points with normals, without polygons and lines, are a point cloud, such as a scan (vertices are
 * ignored). It has the winding number of Barill, Dickson, Schmidt, Levin and Jacobson (2018): with
 * areas a, unit normals n and positions p of the points
 *
 *     w(q) = sum of a n . (p - q) / (4 pi |p - q|^3).
 *
 * Areas are those of AreaArrayName, or those of each point's Voronoi cell among its 20 nearest
 * neighbors in its tangent plane. A term is unbounded near its point, so it is damped to 0 within
 * the radius of a disk of the point's area. So w changes smoothly from 1 to 0 across a layer as
 * thick as the spacing of points, and has no further meaning in this layer. Sums are by a tree of
 * expansions that err by 1e-2 of the sum of a / (4 pi |p - q|^2) at most, in practice by some 1e-4;
 * Method NAIVE adds all points up. Orientation REVERSE reverses all normals; its other values
 * reverse none. All other options apply to polygons only. A point of the cloud that is not finite,
 * or has a normal of length 0 or an area below 0, is an error that names it.
 *
 * Each of several processes (MPI) evaluates w at its own piece of the data set, for the whole
 * surface, with the same values as a single process. Pieces of the surface (ghost cells apart) are
 * gathered in the first process, which validates and turns it as a whole. One of up to FacetsAtOnce
 * polygons is then sent to all; a larger one is cut into chunks of at most that many facets, which
 * all processes get in turn. So only the first holds more than a chunk and its own query points.
 * Lines and clouds are sent to all. Field data: the statistic SurfacePieces, the number of chunks,
 * 1 for a whole surface. ClosestCellId then counts the cells of all MPI pieces in sequence. If an
 * input fails in one process, no process has an output, and an error in each names the failed one.
 * If an input is composite, each process requests the whole surface instead.
 *
 * @sa vtkImplicitWindingNumber vtkGeneralizedWindingNumber vtkSelectEnclosedPoints
 */
#ifndef vtkProbeWindingNumber_h
#define vtkProbeWindingNumber_h

#include "vtkDataSetAlgorithm.h"
#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkSmartPointer.h"           // for the controller

#include <memory>
#include <string>

namespace vtkInsideOut
{
class FailTogether;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;
class vtkDataObject;
class vtkPolyData;

class VTKFILTERSINSIDEOUT_EXPORT vtkProbeWindingNumber : public vtkDataSetAlgorithm
{
public:
  static vtkProbeWindingNumber* New();
  vtkTypeMacro(vtkProbeWindingNumber, vtkDataSetAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surface: polygons and strips (lines and vertices beside them are ignored with a warning),
   * or lines alone, or points with normals alone. The blocks of a composite data set are one
   * surface, whose ClosestCellId counts the cells of all blocks: vertices, then lines, polygons and
   * strips. GetSurface returns nullptr for a composite data set.
   */
  void SetSurfaceData(vtkDataObject* surface);
  void SetSurfaceConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetSurface();
  ///@}

  /** Where w is evaluated. */
  enum AssociationType
  {
    POINTS = 0, ///< at the points
    CELLS = 1   ///< at the cells' parametric centers
  };

  ///@{
  /** Where w is evaluated: at POINTS, or at the centers of CELLS. Default POINTS. */
  vtkInsideOutSetRangeMacro(Association, int, POINTS, CELLS);
  vtkGetMacro(Association, int);
  ///@}

  ///@{
  /** Winding number above which a point is inside. Default 0.5. Range minus infinity to
   * infinity. */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /** Mark the points outside, instead of those inside, in the array Inside; w stays the same.
   * Default off. */
  vtkSetMacro(InsideOut, bool);
  vtkGetMacro(InsideOut, bool);
  vtkBooleanMacro(InsideOut, bool);
  ///@}

  ///@{
  /** Output the array w, too. Off: only Inside, in an eighth of the memory. Default on. */
  vtkSetMacro(OutputWindingNumber, bool);
  vtkGetMacro(OutputWindingNumber, bool);
  vtkBooleanMacro(OutputWindingNumber, bool);
  ///@}

  ///@{
  /**
   * Output the array Distance: the distance to the nearest polygon, in units of the surface,
   * negative where w is above Threshold. Default off. All polygons count for the distance,
   * including those that do not count in w. An error for lines.
   */
  vtkSetMacro(Distance, bool);
  vtkGetMacro(Distance, bool);
  vtkBooleanMacro(Distance, bool);
  ///@}

  ///@{
  /** Output the arrays ClosestPoint and ClosestCellId, the nearest point on the surface and its
   * cell; takes effect with Distance. Default off. */
  vtkSetMacro(ClosestPoints, bool);
  vtkGetMacro(ClosestPoints, bool);
  vtkBooleanMacro(ClosestPoints, bool);
  ///@}

  /** How w is evaluated. */
  enum MethodType
  {
    EXACT = 0,        ///< exact up to rounding, and fastest
    NAIVE = 1,        ///< the sum over all facets
    HIERARCHICAL = 2, ///< the hierarchy of Jacobson et al. (2013)
    APPROXIMATE = 3   ///< far-field expansion
  };

  ///@{
  /**
   * Method that evaluates w. EXACT is exact up to rounding and fastest; the others are for
   * comparison. NAIVE sums over all facets, HIERARCHICAL uses a hierarchy of them, APPROXIMATE a
   * far-field expansion with an error of some 1e-3. Default EXACT. NAIVE and HIERARCHICAL
   * (Jacobson, Kavan and Sorkine-Hornung, 2013) are exact, too; APPROXIMATE is by Barill et al.
   * (2018).
   */
  vtkInsideOutSetRangeMacro(Method, int, EXACT, APPROXIMATE);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /** Order of the far-field expansion of APPROXIMATE. Default 2. Range 1 to 3. */
  vtkInsideOutSetRangeMacro(ApproximationOrder, int, 1, 3);
  vtkGetMacro(ApproximationOrder, int);
  ///@}

  ///@{
  /** Distance from which APPROXIMATE expands a group of facets, in radii of the group. Larger
   * values are slower and more accurate. Default 2. Range 1 to infinity. */
  vtkInsideOutSetRangeMacro(Accuracy, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Accuracy, double);
  ///@}

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro()
    vtkInsideOutCountDuplicatesMacro() vtkInsideOutNonParticipatingMacro()
    ///@}

    ///@{
    /** Point array of the areas that a cloud's points stand for, in squared units of the surface.
     * Default "Area"; without it the areas are estimated. Areas are at least 0. */
    vtkSetStdStringFromCharMacro(AreaArrayName);
  vtkGetCharFromStdStringMacro(AreaArrayName);
  ///@}

  ///@{
  /**
   * The controller of the processes that hold pieces of the surface. They work together if each
   * requests its own piece of the output, as in pvserver and pvbatch, or by UpdatePiece(rank,
   * ranks, 0). Default vtkMultiProcessController's global one; null: this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /**
   * Number of pieces in which the surface is requested, one after the other, so that a surface that
   * does not fit in memory can be read from files. Default 1: the whole at once. Range 1 to
   * infinity. Each piece is validated by itself, so Orientation has to be AS_GIVEN or REVERSE, and
   * MergeTolerance, Distance and Method APPROXIMATE are errors above 1. Each polygon counts as
   * often as it is given, so that copies add up and two-sided parts cancel. Then the array w is
   * that of the whole surface: bit by bit with Method EXACT off the surface, else up to rounding.
   * Lines and points do not count. Open edges of the pieces stay in memory. A source that makes no
   * pieces is an error; vtkXMLPPolyDataReader makes them.
   */
  vtkInsideOutSetRangeMacro(SurfacePieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(SurfacePieces, int);
  ///@}

  ///@{
  /**
   * Largest number of the surface's facets that each of several processes (MPI) holds at once.
   * Fewer take less memory, some 400 bytes per facet, and more time. Default 4194304. Range 1 to
   * infinity. A larger surface is cut into chunks of at most this size, which all processes visit
   * in turn; a smaller one is whole in each process. The default takes some 1.7 GB.
   */
  vtkInsideOutSetRangeMacro(FacetsAtOnce, int, 1, VTK_INT_MAX);
  vtkGetMacro(FacetsAtOnce, int);
  ///@}

  /**
   * Whether a point of the input (with Association CELLS, a cell) is marked in the array Inside of
   * the last update: 0 or 1; 0 for an id out of range.
   */
  int IsInside(vtkIdType id);

  ///@{
  /**
   * Whether a query point would be marked in the array Inside by the last update: 0 or 1.
   */
  int IsInsideSurface(double x, double y, double z);
  int IsInsideSurface(double x[3]);
  ///@}

  int ModifyRequest(vtkInformation* request, int when) override;

protected:
  vtkProbeWindingNumber();
  ~vtkProbeWindingNumber() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Association = POINTS;
  double Threshold = 0.5;
  bool InsideOut = false;
  bool OutputWindingNumber = true;
  bool Distance = false;
  bool ClosestPoints = false;
  int Method;
  int ApproximationOrder;
  double Accuracy;
  std::string AreaArrayName;
  int SurfacePieces = 1;
  int FacetsAtOnce = 1 << 22;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  vtkProbeWindingNumber(const vtkProbeWindingNumber&) = delete;
  void operator=(const vtkProbeWindingNumber&) = delete;

  class Internal;
  Internal* Last; ///< state of the last update, for IsInsideSurface
  const std::unique_ptr<vtkInsideOut::FailTogether> Failures;
};
VTK_ABI_NAMESPACE_END

#endif
