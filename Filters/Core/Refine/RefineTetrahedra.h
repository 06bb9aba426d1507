// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"

#include <functional>
#include <vector>

namespace insideout
{
struct RefinedMesh;

struct RefinementParameters
{
  SizingParameters Sizes;
  SurfaceTreatment Surface = SurfaceTreatment::Kept;

  /** Kept: whether messages advise another treatment. */
  bool CouldBeTreated = true;

  /**
   * Kept: whether the caller chooses another treatment where cells are left that are unfit for a
   * solver.
   */
  bool TreatsNeedles = false;

  /**
   * Kept: called with the result. If it returns true, the surface is mended: needles of its
   * triangles and flat cells at it are replaced (MendNeedles, MendRefusedCells), at first in that
   * result if there are few. This is called again with the result of that; if it returns true
   * again, the input is mended and refined anew, which replaces more needles. The surface moves,
   * both ways, by at most MendingTolerance times the longest edge of the points' bounding box. In
   * small solids that is the edge of the smallest cell that a solver accepts, up to
   * DefaultTolerance. Areas by label and volumes by region stay (SurfaceBudget). Empty: never.
   */
  std::function<bool(const RefinedMesh& result)> MendsSurface;
  static constexpr double MendingTolerance = 1e-6; // STL's decimals and floats are as coarse

  /** Limit of the estimated number of cells: beyond it nothing is refined; 0: no limit. */
  Id MaximumCells = 10000000;

  /** Remeshed: the largest distance between the new and the old surface, both ways; 0:
   * DefaultTolerance times the longest edge of the points' bounding box. */
  double SurfaceTolerance = 0;
  static constexpr double DefaultTolerance = 1e-3;

  /** Remeshed: edges stay where the normals' angle exceeds this, except where they are shorter than
   * wanted and need not stay for the tolerance; in degrees. */
  double FeatureAngle = 30;

  /** For Remeshed, mended surfaces and size rules, a label per face of each cell; edges between
   * faces with different labels stay. Empty: all faces have the same number. */
  std::vector<std::array<Id, 4>> Labels;

  /** The label of faces that close holes, if any. Remeshed: those within the tolerance of others
   * join these (JoinThinHoles). */
  Id LabelOfHoles = None;

  /** The same for Split: coplanar faces with different numbers do not join. */
  std::vector<std::array<Id, 4>> Attributes;
};

/** Better cells of the same solid. */
struct RefinedMesh
{
  std::vector<Point> Points;
  std::vector<Tetrahedron> Cells;
  std::vector<Id> OriginalPoints; ///< per point, the input point that it is, None for a new one

  /** Per cell, the input cell that contains its barycenter, or is near it; of the same region. */
  std::vector<Id> OriginalCells;

  /** The input's face, as 4 * cell + face, for each face of each cell on the boundary or between
   * regions: the face on the same side that is nearest to it (Kept: is the same). None for other
   * faces. */
  std::vector<std::array<Id, 4>> OriginalFaces;

  /** Per point, an input cell that contains it, or is near it. */
  std::vector<Id> CellsOfPoints;

  /**
   * Per point, the length that is wanted there, except by arrays at the input's points; infinite
   * for none. Empty without rules.
   */
  std::vector<double> LengthsByRules;

  insideout::Statistics Statistics;
};

/**
 * Refine the solid to better tetrahedra of the requested sizes. Faces of the boundary, and between
 * two regions, stay bit by bit, or are treated as requested (RemeshPieces, RemeshSurface). Delaunay
 * refinement by lengths (FillWithPoints), then the worst cells are improved (ImproveCells). Every
 * cell has an exactly positive volume, and no faces of the boundary cross. The result is
 * deterministic.
 *
 * Statistics: AddedPoints, RemovedPoints, and CellsAboveMaximumVolume if that is given. If the
 * surface is not kept: SurfacePoints, the added points on it, and KeptFacets, the facets that stay
 * because they cross others. If it is remeshed: SurfaceTolerance, SurfaceDistance, its largest
 * distance from the input's, and InputDistance, the reverse. If mending changed it:
 * SurfaceTolerance and MendedNeedles, the number of changes.
 *
 * @param[in] mesh of any solid; its facets do not matter
 * @param[in] regions one per cell; empty: all are one
 * @throws Error InvalidParameter, which names the culprit: a cell without volume, two that overlap
 * at a face, a length that is not positive; TooLarge if there would be more cells than can be
 * counted or than MaximumCells; Stopped
 */
RefinedMesh RefineTetrahedra(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const RefinementParameters& parameters, Monitor& monitor);
} // namespace insideout
