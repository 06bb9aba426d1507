// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/SortedTriangle.h"
#include "Refine/BoundaryPieces.h"
#include "Refine/RefinableSurface.h"
#include "Refine/TriangleTree.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace insideout
{
/**
 * Says which pieces of a surface may take the place of others: of the boundary those that cross no
 * other piece of it. Where it is remeshed it stays near the input's, too, both ways: no point of it
 * is farther than the tolerance. Neither are the corners, edge middles and centers of the input's
 * facets from it (each of them is followed to the piece that it is next to; as Hu et al. 2017,
 * Error-Bounded and Feature Preserving Surface Remeshing with Minimal Angle Improvement).
 */
class SurfaceBound
{
public:
  /** @param[in] tolerance positive where the surface is remeshed */
  SurfaceBound(const RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
    SurfaceTreatment treatment, double tolerance);

  /**
   * Whether other pieces may take the place of some: crossing none, not turned over, and where the
   * surface is remeshed near enough to facets of their labels.
   *
   * @param[in,out] fresh each with a facet of its label; then with one that it is near, where the
   *   surface is remeshed
   */
  bool Allows(const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh);

  /** The same where each of the fresh pieces comes in the place of one, and is not turned from
   * that.
   * @param[in] moved of those that are gone, one for each fresh one */
  bool AllowsEach(const std::vector<SurfacePiece>& moved, const std::vector<SurfacePiece>& gone,
    std::vector<SurfacePiece>& fresh);

  /** Whether others that differ only in how they are cut, but for rounding, may. */
  bool AllowsCut(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);

  /** The step that was allowed last was done. */
  void Replace();

  /** The point of the input's surface that is nearest to a place near a facet: only where it is
   * remeshed. */
  Point PlaceOn(const Point& place, Id facet) const;

private:
  using Samples = std::vector<Id>;
  bool StaysNear(const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh);
  void TakeSamples(const std::vector<SurfacePiece>& pieces);
  double PutDown(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);
  bool Accepts(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);
  std::vector<SurfacePiece> OnBoundary(const std::vector<SurfacePiece>& pieces) const;

  TriangleTree::Nearest NearestTo(Id point, const Point& place, Id facet);

  /** The facet that a point was nearest to when last asked for. */
  struct NearestToPoint
  {
    Point Place;
    Id Label;
    TriangleTree::Nearest Nearest;
  };

  const std::vector<FacetOfInput>& Facets;
  double Tolerance;
  BoundaryPieces Boundary;
  std::unique_ptr<TriangleTree> Input; ///< where the surface is remeshed
  std::vector<NearestToPoint> AtPoints;
  std::vector<Point> Places; ///< of the samples
  std::unordered_map<Triangle, Samples, HashOfTriangle> AtPieces;

  /** The step that was allowed last. */
  std::vector<SurfacePiece> Gone;
  std::vector<SurfacePiece> Fresh;
  std::vector<Samples> AtFresh;
};
} // namespace insideout
