// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkRefineTetrahedra
 * @brief better tetrahedra of the same solid, of the requested size
 *
 * Takes any conforming grid of tetrahedra, for example from vtkRobustTetrahedralize, and makes
 * other tetrahedra of the same solid: points are added where edges are longer than requested, and
 * thin cells are improved as far as movable points allow. Without a length every triangle of the
 * boundary, and between cells of different RegionId (an optional cell array of integers), stays bit
 * for bit, with its points; with a length the surface is remeshed within a tolerance.
 * SurfaceTreatment has further choices. Every cell has an exactly positive volume, and no triangles
 * of the boundary cross; inverted cells of the input are corrected. The same input gives the same
 * output, on any number of threads.
 *
 * An optional second input, any data set, is a background: its point array SizingArrayName has the
 * wanted edge lengths, linear between its points. Outside it no length is wanted.
 *
 * Output: vtkTetra, or with QuadraticCells vtkQuadraticTetra. Each cell has the cell data of the
 * input cell that contains its barycenter. FacetIds and FacetMultiplicity (4 components, one value
 * per face) are exceptions: a face on the boundary or between regions has the values of the input
 * face that it lies on, or that is nearest where the surface is remeshed. All other faces have -1
 * and 0, even if the input had facets within a region. If the surface is kept, cells of different
 * InBody (integers) belong to different regions, too. Points that stay keep their point data; new
 * points interpolate them in the input cell that contains them (0 in integer arrays).
 * vtkOriginalPointIds of a point that stays is its value in the input's array of that name, else
 * the input's point id; -1 for a new one. Field data: the input's, and Statistics (named by
 * StatisticsNames): AddedPoints and RemovedPoints (a point that moved counts in both; without
 * mid-edge nodes), RefinedCells, CellsAboveMaximumVolume if MaximumVolume is given, and
 * SecondsRefine. If the surface is not kept: SurfacePoints (points added on it) and KeptFacets
 * (facets left unchanged because they cross others). If it is remeshed: SurfaceTolerance and, by
 * samples, SurfaceDistance (of the new surface from the old) and InputDistance (of the old one from
 * the new). If needles or flat cells of a kept surface are mended: MendedNeedles, the changes, and
 * SurfaceTolerance.
 *
 * The statistics include the quality of the cells by the names of vtkSolidQuality, from
 * MinDihedralAngle to SurfaceEdgesUnder5Degrees, RefusedCells and PoorCells; and the quality of the
 * input, by the same names with the prefix Before.
 *
 * Warnings count the cells that stay larger than MaximumVolume, and the triangles that could not be
 * split or remeshed. Another warning says that edges of the surface are longer than twice
 * EdgeLength, or that half of them are shorter than half of it. Errors, which name the culprit,
 * leave the output empty.
 *
 * @sa vtkRobustTetrahedralize
 */
#ifndef vtkRefineTetrahedra_h
#define vtkRefineTetrahedra_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutRange.h"         // for setters with a range
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKFILTERSINSIDEOUT_EXPORT vtkRefineTetrahedra : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkRefineTetrahedra* New();
  vtkTypeMacro(vtkRefineTetrahedra, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Target length of edges, in units of the input; some are longer. Edges of faces that stay may
   * be much longer. Default 0: lengths follow from the edges of the surface. Range 0 to
   * infinity. */
  vtkInsideOutSetRangeMacro(EdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /** Growth of the edge length per unit of distance from the boundary. Small values make many cells
   * of nearly the same size. Default 0.35. Range 1e-6 to infinity. */
  vtkInsideOutSetRangeMacro(Grading, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Grading, double);
  ///@}

  ///@{
  /** Upper limit on the volume of cells, in a plane on their area, in units of the input. Default
   * 0: any size. Range 0 to infinity. */
  vtkInsideOutSetRangeMacro(MaximumVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  ///@{
  /** Limit on the number of cells: if an estimate of the requested lengths exceeds it, there is an
   * error and no output. Default 10000000. 0: no limit. Range 0 to the largest int. */
  vtkInsideOutSetRangeMacro(MaximumCells, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumCells, int);
  ///@}

  ///@{
  /** Point array of edge lengths: of the input, of the background, or of both. Default empty: none.
   * Lengths are positive; NaN requests none. The smallest of all lengths counts. */
  vtkSetStdStringFromCharMacro(SizingArrayName);
  virtual const char* GetSizingArrayName() const { return this->SizingArrayName.c_str(); }
  ///@}

  ///@{
  /**
   * Edge lengths by place, "WHAT=NUMBER; WHAT=NUMBER" and so on. The least of all lengths counts.
   * The rule "curvature=24" asks for 24 edges per full turn of curved surfaces, between edges above
   * FeatureAngle; "gap=3" for 3 cells across each wall. Lengths are those of "tag NAME=LENGTH", a
   * tag of the boundary, "region NAME=LENGTH", a region's name or RegionId, and "point X Y Z
   * [RADIUS]=LENGTH", a ball. Default empty: none. Tags are those of vtkRobustTetrahedralize. From
   * there lengths grow by Grading. Without EdgeLength and "curvature", shorter edges of the surface
   * stay short.
   */
  vtkSetStdStringFromCharMacro(SizeRules);
  vtkGetCharFromStdStringMacro(SizeRules);
  ///@}

  /** Treatment of the surface. */
  enum SurfaceTreatmentType
  {
    KEPT,
    SPLIT,
    REMESHED,
    AUTOMATIC
  };

  ///@{
  /**
   * Treatment of the triangles of the boundary and between regions. KEPT: each stays, bit by bit.
   * SPLIT: they are divided, so that long and thin ones do not make thin cells. REMESHED: they are
   * replaced, within SurfaceTolerance, by triangles of the requested edge length. AUTOMATIC:
   * REMESHED if EdgeLength, SizeRules or SizingArrayName is given, else KEPT. Default AUTOMATIC. A
   * surface kept so may leave cells that a solver refuses, or at which it loses half its digits:
   * the sine of a dihedral angle is below 1e-8. Then AUTOMATIC removes needles and spikes, and
   * moves corners of flat cells. The surface moves by at most a millionth of the longest edge of
   * its box; in small solids by 4e-7 in the unit of the coordinates, up to a thousandth of that
   * edge. Areas by tag and volumes by region stay within a millionth. If such cells are left, it
   * takes REMESHED, unless areas and volumes have names (two tags beside that of holes; named or
   * touching regions) or there are more than 100,000 cells. It does each if fewer such cells are
   * left, with a warning. Cells that a smaller unit mends do not count if some are left anyway.
   * SPLIT keeps all points; the pieces lie in the triangles' planes, within rounding, where
   * coplanar triangles with the same cell data join. If at least half of their corners are floats
   * or have at most nine digits, a file rounded them. Then triangles within 0.1 degrees join up to
   * a millionth of the longest edge of the box; areas by tag and volumes by region stay within a
   * millionth. REMESHED keeps edges above FeatureAngle, but joins corners of theirs that are
   * closer than the requested length and need not stay for SurfaceTolerance. Triangles that close
   * holes and are within it of others join these. Triangles stay whose replacement would touch
   * another part of the boundary.
   */
  vtkInsideOutSetRangeMacro(SurfaceTreatment, int, KEPT, AUTOMATIC);
  vtkGetMacro(SurfaceTreatment, int);
  ///@}

  ///@{
  /**
   * Limit on the distance between a remeshed boundary and the old one, both ways, in units of the
   * input. Default 0: a thousandth of the longest edge of the bounding box. Range 0 to infinity.
   */
  vtkInsideOutSetRangeMacro(SurfaceTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SurfaceTolerance, double);
  ///@}

  ///@{
  /** Angle between normals above which edges of a remeshed boundary stay, in degrees. Default 30.
   * Range 0 to 180. Lines of such edges that end freely stay only above twice the angle. Edges of
   * steps lower than SurfaceTolerance are removed. */
  vtkInsideOutSetRangeMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /** Make cells of second order (vtkQuadraticTetra), with mid-edge nodes on the straight edges.
   * Default off. Neighbors share the mid-edge nodes, whose ids follow those of the corners. */
  vtkSetMacro(QuadraticCells, bool);
  vtkGetMacro(QuadraticCells, bool);
  vtkBooleanMacro(QuadraticCells, bool);
  ///@}

  ///@{
  /** The optional second input: a background with the point array SizingArrayName. The blocks of a
   * composite data set are one background. */
  void SetBackgroundData(vtkDataObject* background);
  void SetBackgroundConnection(vtkAlgorithmOutput* output);
  ///@}

protected:
  vtkRefineTetrahedra();
  ~vtkRefineTetrahedra() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double EdgeLength;
  double Grading;
  double MaximumVolume;
  int MaximumCells;
  std::string SizingArrayName;
  std::string SizeRules;
  int SurfaceTreatment;
  double SurfaceTolerance;
  double FeatureAngle;
  bool QuadraticCells = false;

private:
  vtkRefineTetrahedra(const vtkRefineTetrahedra&) = delete;
  void operator=(const vtkRefineTetrahedra&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
