// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LayerCells.h"
#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/Types.h"

#include <array>
#include <string>
#include <vector>

namespace insideout
{
/**
 * Numbers of cells that a finite element solver refuses or handles badly. All 0 if there are none.
 */
struct SolverFitness
{
  Id Cells = 0;

  /**
   * Cells with a Jacobian determinant at which a solver stops: below 1e-20, CalculiX's limit, at an
   * integration point, computed in doubles and in CalculiX's order.
   */
  Id RefusedCells = 0;

  /** Refused cells that are merely too small, not flat. In a smaller unit they pass. */
  Id TooSmallCells = 0;

  /**
   * Other tetrahedra with a dihedral angle below 1 degree, which cost a solver iterations and
   * accuracy.
   */
  Id PoorCells = 0;

  /** Poor cells with an angle whose sine is below FlatSine. */
  Id NearlyFlatCells = 0;

  /**
   * Refused and poor cells with a face on the boundary or between regions that is a needle itself:
   * no other cell on that face would be much better.
   */
  Id CellsOnNeedles = 0;

  /** Refused cells with such a face, whatever the reason. */
  Id RefusedOnNeedles = 0;

  /** Cells that make a solution impossible, or wrong in any unit. */
  Id UnfitCells() const { return this->RefusedCells + this->NearlyFlatCells; }

  bool IsGood() const { return this->RefusedCells == 0 && this->PoorCells == 0; }
};

/** Remedies already applied, which are not advised again. */
enum class CellTreatment
{
  None, ///< or unknown
  Refined,
  Remeshed ///< refined, with other triangles on the surface
};

/** CalculiX refuses smaller Jacobian determinants, in any unit. */
constexpr double SmallestJacobian = 1e-20;

/**
 * The least sine of a dihedral angle at which a solver keeps enough digits. The largest entries of
 * a cell's stiffness grow as its inverse, and their rounding acts like a load: at 1e-16 CalculiX
 * lost 0.4 % of a weight, at 1e-10 with quadratic cells 0.2 %.
 */
constexpr double FlatSine = 1e-8;

/** Whether a solver refuses a linear tetrahedron: its Jacobian determinant is below 1e-20. */
bool IsRefused(const std::array<Point, 4>& corners);

/**
 * Count the cells that are unfit for a solver.
 *
 * @param[in] points finite coordinates, with the digits and in the unit that the solver gets
 * @param[in] cells ids in range
 * @param[in] midpoints of each cell, on TetrahedronEdges; empty or None where cells are linear
 * @param[in] layers pyramids and prisms among them, as CalculiX's C3D6 (NodesOfC3D6)
 * @param[in] regions of each tetrahedron; empty where all are one
 * @throws Error Stopped
 */
SolverFitness FitnessForSolver(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<std::array<Id, 6>>& midpoints,
  const LayerCells& layers, const std::vector<Id>& regions, Monitor& monitor,
  const ProgressRange& progress);

/**
 * The numbers of cells that a solver refuses or suffers from, and the name of the option that
 * helps; empty if there are none.
 *
 * @param[in] mayRemesh whether other options allow SurfaceTreatment to remesh the surface
 */
std::string WordsOfFitness(const SolverFitness& fitness, CellTreatment done, bool mayRemesh = true);

/** Append RefusedCells and PoorCells by name, with a prefix ("Before"). */
void AppendFitness(
  const SolverFitness& fitness, Statistics& statistics, const std::string& prefix = "");
} // namespace insideout
