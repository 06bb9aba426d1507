// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkGeneralizedWindingNumber
 * @brief   the winding number of a surface in tetrahedra of its convex hull
 *
 * Takes any triangle or polygon surface, however broken, resolves its self-intersections,
 * tetrahedralizes its convex hull and computes in each cell the generalized winding number w of
 * Jacobson, Kavan and Sorkine-Hornung (2013): how often the surface wraps around the cell. On a
 * closed surface w is an exact integer in every cell; holes make it a fraction that fades
 * smoothly.
 *
 * Output: as of vtkConstrainedDelaunay3D, and the cell array w (double). Field data:
 * Statistics_NAME, a double each, among them what was wrong with the surface and the seconds of
 * each stage, LeftOutCellIds (see vtkResolveSelfIntersections), LostCellIds (see
 * vtkConstrainedDelaunay3D) and TurnedCellIds: input cells that the orientation turned over.
 *
 * Statistics of the orientation: Shells (sets of facets that face one way together), of these
 * ClosedShells, HoledShells and SheetShells (which enclose nothing; SheetShare is their share of
 * the area, with facets that count 0) and Cavities (that face inward); TurnedShells and
 * TurnedFacets (that were turned over), TurnedShare (of the area), DisagreeingFacets (that were
 * given against their shells), UndecidedShells (that might as well face the other way);
 * EnclosedVolume (of all, holes capped) and OverlapVolume (of it, where w is 2 or more), the latter
 * from samples.
 *
 * Lines, and polygons in one plane without Thicken, are errors: they are for vtkRobustTriangulate.
 *
 * @sa vtkResolveSelfIntersections vtkConstrainedDelaunay3D vtkGraphCutSegmentation
 *
 */
#ifndef vtkGeneralizedWindingNumber_h
#define vtkGeneralizedWindingNumber_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

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
    /**
     * Give sheets, which enclose nothing, this thickness: a closed slab, half of it before the
     * facets and half behind, that joins what it touches; the facets stay as faces within. In units
     * of the surface. Default 0: sheets bound nothing. Range 0 to infinity.
     */
    vtkSetClampMacro(Thicken, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Thicken, double);
  ///@}

  ///@{
  /**
   * On: thicken every facet, and not only sheets. Default off.
   */
  vtkSetMacro(ThickenAll, bool);
  vtkGetMacro(ThickenAll, bool);
  vtkBooleanMacro(ThickenAll, bool);
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
    ENGINE_AUTOMATIC = 0, ///< exact flips and cuts, and TetGen should these lose a facet
    ENGINE_EXACT = 1,     ///< flips and cuts with exact predicates, in this process
    ENGINE_TETGEN = 2     ///< TetGen alone
  };

  ///@{
  /**
   * What makes the tetrahedra: ENGINE_AUTOMATIC (0) tries exact flips and cuts, and TetGen should
   * these lose a facet; ENGINE_EXACT (1) and ENGINE_TETGEN (2) only the one. Where neither keeps
   * every facet the mesh that loses fewest is taken. Default ENGINE_AUTOMATIC.
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
   * in turn. Default 0: no clock. Exact cuts are then limited by a count of their work, so that a
   * busy machine gives the same mesh; TetGen, should it have its turn, by 4 s of processor time in
   * each of its ways, and 0.3 ms for each point and facet. Range 0 to infinity.
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
  int Engine;
  double TimeBudget;
  double MemoryBudget;

private:
  vtkGeneralizedWindingNumber(const vtkGeneralizedWindingNumber&) = delete;
  void operator=(const vtkGeneralizedWindingNumber&) = delete;
};

#endif
