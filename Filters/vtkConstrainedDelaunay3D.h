// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkConstrainedDelaunay3D
 * @brief   tetrahedra of the convex hull of a surface that respect each of its facets
 *
 * Takes a surface whose facets do not cross (vtkResolveSelfIntersections makes one) and fills
 * its convex hull with tetrahedra so that every facet is a union of their faces and every vertex
 * one of their points. Steiner points are added only where there is no other way. Flips and cuts
 * decided by exact predicates do the work in this process. Should they lose a facet, or as Engine
 * says, TetGen does it in a program of its own, insideout-tetgen, so that nothing it does can take
 * the host down; the environment variable INSIDEOUT_TETGEN names another place for that program.
 *
 * What comes back is checked with exact predicates. Where no way keeps every facet, for facets
 * cross or the budgets are used up, the mesh that loses fewest is taken, if need be the Delaunay
 * tetrahedra of the points alone. Warnings say which way gave the mesh and why the others did not;
 * GetRungName of the statistic Rung names the way.
 *
 * Output: positively oriented vtkTetra with two cell arrays of four components, one for each face
 * in VTK's order: FacetIds (vtkIdType: the input cell that the face lies on, -1 for none; of
 * several one whose normal leaves the cell, else the lowest) and FacetMultiplicity (short: by how
 * much the winding number rises when entering the cell there). Points carry vtkOriginalPointIds (-1
 * for Steiner points) and the input's point data: interpolated on facets, NaN (0 for integers) in
 * the volume. Field data: Statistics with StatisticsNames (Rung, HullPoints, HullCells,
 * SteinerPoints, SurfaceSteinerPoints, LostFacets, SecondsCDT), and LostCellIds (vtkIdType): the
 * input cells of facets that are lost, empty where none is.
 *
 * Errors, with an empty output: facets that cross, points not finite or ids out of range; lines,
 * and polygons in one plane, which are for vtkRobustTriangulate.
 *
 * @sa vtkResolveSelfIntersections vtkGeneralizedWindingNumber
 *
 */
#ifndef vtkConstrainedDelaunay3D_h
#define vtkConstrainedDelaunay3D_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

class VTKFILTERSINSIDEOUT_EXPORT vtkConstrainedDelaunay3D : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkConstrainedDelaunay3D* New();
  vtkTypeMacro(vtkConstrainedDelaunay3D, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What tetrahedralizes in rung 1, 2 ... of the ladder, in words; nullptr beyond its end. */
  static const char* GetRungName(int rung);

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutMergeToleranceMacro() vtkInsideOutCountDuplicatesMacro()
    vtkInsideOutNonParticipatingMacro()
    ///@}

    /** What makes the tetrahedra. */
    enum EngineType {
      ENGINE_AUTOMATIC = 0, ///< exact flips and cuts, and TetGen should these lose a facet
      ENGINE_EXACT = 1,     ///< flips and cuts with exact predicates, in this process
      ENGINE_TETGEN = 2     ///< TetGen alone
    };

  ///@{
  /**
   * Engine that makes the tetrahedra. ENGINE_EXACT flips and cuts, ENGINE_TETGEN runs TetGen,
   * ENGINE_AUTOMATIC runs TetGen only where the exact engine loses a facet. Default
   * ENGINE_AUTOMATIC. The mesh that loses the fewest facets is taken where none keeps all.
   */
  vtkInsideOutSetRangeMacro(Engine, int, ENGINE_AUTOMATIC, ENGINE_TETGEN);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(ENGINE_AUTOMATIC); }
  void SetEngineToExact() { this->SetEngine(ENGINE_EXACT); }
  void SetEngineToTetGen() { this->SetEngine(ENGINE_TETGEN); }
  ///@}

  ///@{
  /**
   * Seconds that tetrahedralizing may take, in all attempts together. Default 0: limited by work,
   * not by the clock, so that a busy machine gives the same mesh. Range 0 to infinity. Each kind of
   * attempt gets an equal part. With 0 each of TetGen's attempts takes at most 4 s of processor
   * time, and 0.3 ms for each point and facet.
   */
  vtkInsideOutSetRangeMacro(TimeBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeBudget, double);
  ///@}

  ///@{
  /**
   * MiB of memory that TetGen's process may hold. Default 0: limited by the size of the surface.
   * Range 0 to infinity. Beyond it the next attempt begins. With 0 the limit is 1024 MiB, and 16
   * KiB for each point and facet, but at most three quarters of the machine's memory.
   */
  vtkInsideOutSetRangeMacro(MemoryBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryBudget, double);
  ///@}

protected:
  vtkConstrainedDelaunay3D();
  ~vtkConstrainedDelaunay3D() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Engine;
  double TimeBudget;
  double MemoryBudget;

private:
  vtkConstrainedDelaunay3D(const vtkConstrainedDelaunay3D&) = delete;
  void operator=(const vtkConstrainedDelaunay3D&) = delete;
};

#endif
