// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkRobustTetrahedralize
 * @brief   from a broken surface to tetrahedra of the solid that it means
 *
 * Takes any triangle or polygon surface, with holes, self-intersections, duplicates or non-
 * manifold edges, and gives tetrahedra of the solid that it most likely means. Facets are cut
 * where they cross, the convex hull is tetrahedralized so that each of them is a union of faces,
 * and the tetrahedra are labelled inside or outside by the surface's generalized winding number
 * and a graph cut (Jacobson, Kavan and Sorkine-Hornung 2013). Every input vertex is a point of
 * the hull, with its exact coordinates.
 *
 * Output 0, the solid: vtkTetra with the cell arrays w, Inside, FacetIds and FacetMultiplicity
 * (see vtkConstrainedDelaunay3D), and with field data Statistics_NAME, LeftOutCellIds (see
 * vtkResolveSelfIntersections) and LostCellIds (see vtkConstrainedDelaunay3D). Output 1, its
 * boundary: triangles, oriented outward and watertight, with vtkOriginalCellIds (the input cell
 * each lies on, -1 where a hole was closed). Output 2, the outliers: the pieces of input facets
 * that are no face of a cell inside. All carry the input's point data and vtkOriginalPointIds, the
 * surfaces its cell data.
 *
 * When no cell is inside there is a warning that gives the range of w. Errors, which name the
 * culprit, leave all outputs empty.
 *
 * @sa vtkGeneralizedWindingNumber vtkGraphCutSegmentation
 *
 */
#ifndef vtkRobustTetrahedralize_h
#define vtkRobustTetrahedralize_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class vtkPolyData;

class VTKFILTERSINSIDEOUT_EXPORT vtkRobustTetrahedralize : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkRobustTetrahedralize* New();
  vtkTypeMacro(vtkRobustTetrahedralize, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The boundary of the solid (output 1) and the facets that are not part of it (output 2). */
  vtkPolyData* GetBoundary();
  vtkPolyData* GetOutliers();
  ///@}

  ///@{
  /**
   * Weight of a smooth boundary against the winding number, without unit. 0 is thresholding: inside
   * where w > 1/2. Larger values cut off and fill up thin parts where w is unsure. Default 1, range
   * 0 to infinity.
   */
  vtkSetClampMacro(Gamma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * How large a step in w may be noise. Steps between two cells that are several times larger cost
   * nothing to cut along, smaller ones cost up to Gamma. Default 0.1, range 1e-6 to infinity.
   */
  vtkSetClampMacro(Sigma, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  ///@{
  /**
   * On: the output holds only the cells inside. Off: all cells of the hull, with the array Inside
   * to tell them apart. Default on.
   */
  vtkSetMacro(ExtractInside, bool);
  vtkGetMacro(ExtractInside, bool);
  vtkBooleanMacro(ExtractInside, bool);
  ///@}

  /** Which way the surface faces. */
  enum OrientationType
  {
    AUTOMATIC = 0, ///< turned over, with a warning, when it is inside out as a whole
    AS_GIVEN = 1,
    REVERSE = 2
  };

  ///@{
  /**
   * Which way the surface as a whole is meant to face: AUTOMATIC (0) turns it over when the sum of
   * w times volume over the hull is negative, AS_GIVEN (1) never, REVERSE (2) always. Default
   * AUTOMATIC.
   */
  vtkSetClampMacro(Orientation, int, AUTOMATIC, REVERSE);
  vtkGetMacro(Orientation, int);
  ///@}

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
   * How w is averaged over a cell: at the barycentre (1), or by quadrature that integrates
   * polynomials up to this degree exactly, of 4 (2), 8 (3) or 14 places (4 and 5). Matters on open
   * surfaces only: on a closed one w is constant in a cell. Next to an open edge w depends on the
   * direction from the edge, and high order gains little there. Default 1, range 1 to 5.
   */
  vtkSetClampMacro(QuadratureOrder, int, 1, 5);
  vtkGetMacro(QuadratureOrder, int);
  ///@}

  /** What makes the tetrahedra. */
  enum EngineType
  {
    ENGINE_AUTOMATIC = 0, ///< TetGen; where it would put points on facets or fails, exact flips
    ENGINE_EXACT = 1,     ///< flips and cuts with exact predicates, in this process
    ENGINE_TETGEN = 2     ///< TetGen alone
  };

  ///@{
  /**
   * What makes the tetrahedra: ENGINE_AUTOMATIC (0) tries exact flips and cuts, and
   * TetGen where these lose facets or take too long; ENGINE_EXACT (1) and ENGINE_TETGEN (2) only
   * the one. Where neither keeps every facet the mesh that loses fewest is taken. Default
   * ENGINE_AUTOMATIC.
   */
  vtkSetClampMacro(Engine, int, ENGINE_AUTOMATIC, ENGINE_TETGEN);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(ENGINE_AUTOMATIC); }
  void SetEngineToExact() { this->SetEngine(ENGINE_EXACT); }
  void SetEngineToTetGen() { this->SetEngine(ENGINE_TETGEN); }
  ///@}

  ///@{
  /**
   * Seconds that tetrahedralizing may take, an equal part of it in each of the ways that are tried
   * in turn. Default 0: in each 4 s of processor time, and 0.3 ms for each point and facet, or five
   * times that for exact flips. Range 0 to infinity.
   */
  vtkSetClampMacro(TimeBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeBudget, double);
  ///@}

  ///@{
  /**
   * MiB of memory that TetGen's process may hold; beyond it the next way is tried. Default 0: 1024
   * MiB, and 16 KiB for each point and facet, but at most three quarters of the machine's memory.
   * Range 0 to infinity.
   */
  vtkSetClampMacro(MemoryBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryBudget, double);
  ///@}

protected:
  vtkRobustTetrahedralize();
  ~vtkRobustTetrahedralize() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Gamma = 1.0;
  double Sigma = 0.1;
  bool ExtractInside = true;
  int Orientation = AUTOMATIC;
  double MergeTolerance = 0.0;
  bool CountDuplicates = false;
  int QuadratureOrder = 1;
  int Engine = ENGINE_AUTOMATIC;
  double TimeBudget = 0.0;
  double MemoryBudget = 0.0;

private:
  vtkRobustTetrahedralize(const vtkRobustTetrahedralize&) = delete;
  void operator=(const vtkRobustTetrahedralize&) = delete;
};

#endif
