// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"

#include <vector>

namespace insideout
{
struct RefinementParameters
{
  SizingParameters Sizes;
  SurfaceTreatment Surface = SurfaceTreatment::Kept;

  /** Where lengths are asked for that would make more cells, by estimate, nothing is made; 0: no
   * limit. */
  Id MaximumCells = 10000000;

  /** Remeshed: how far the new surface may be from the old one, both ways; 0: DefaultTolerance of
   * the longest edge of the points' bounding box. */
  double SurfaceTolerance = 0;
  static constexpr double DefaultTolerance = 1e-3;

  /** Remeshed: edges stay where the normals differ by more, but for those of steps lower than the
   * tolerance; in degrees. */
  double FeatureAngle = 30;

  /** Remeshed: per face of each cell, a number; edges between faces of different ones stay. Empty:
   * all faces have the same. */
  std::vector<std::array<Id, 4>> Labels;
};

/** Better cells of the same solid. */
struct RefinedMesh
{
  std::vector<Point> Points;
  std::vector<Tetrahedron> Cells;
  std::vector<Id>
    OriginalPoints; ///< per point, the one of the input that it is, None for a new one

  /** Per cell, the one of the input that holds its barycenter, or is near it; of the same region.
   */
  std::vector<Id> OriginalCells;

  /** The input's face, as 4 * cell + face, for each face of each cell on the boundary or between
   * regions: the one, on the same side, that it is a piece of, or (Remeshed) nearest to. None for
   * other faces. */
  std::vector<std::array<Id, 4>> OriginalFaces;

  /** Per point, a cell of the input that holds it, or is near it. */
  std::vector<Id> CellsOfPoints;

  insideout::Statistics Statistics;
};

/**
 * Tetrahedra of the same solid that are better and as large as asked for. Faces of the boundary,
 * and between two regions, stay as they are, bit by bit, or are treated as asked for
 * (RemeshSurface). Delaunay refinement by lengths (FillWithPoints), then the worst cells are
 * improved (ImproveCells). Every cell has a positive volume, exactly, and no faces of the boundary
 * cross; the same result for the same input, always.
 *
 * Statistics: AddedPoints and RemovedPoints, CellsAboveMaximumVolume, where that is given; of a
 * surface that is not kept SurfacePoints, how many of the added ones are on it, and KeptFacets, how
 * many facets stay as they are since they cross others; and of a remeshed one
 * SurfaceTolerance, SurfaceDistance, how far it is from the input's at most, and InputDistance, how
 * far that is from it.
 *
 * @param[in] mesh of any solid; its facets do not matter
 * @param[in] regions one per cell; empty: all are one
 * @throws Error InvalidParameter, which names the culprit: a cell without volume, two that overlap
 * at a face, a length that is not positive; TooLarge when there would be more cells than can be
 * counted or than MaximumCells; Stopped
 */
RefinedMesh RefineTetrahedra(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const RefinementParameters& parameters, Monitor& monitor);
} // namespace insideout
