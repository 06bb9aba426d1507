// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/SortedTriangle.h"
#include "Refine/BoundaryPieces.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBudget.h"
#include "Refine/TriangleTree.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace insideout
{
class SurfaceBound;

/** Base of the operators that change a mesh with its surface. */
class SurfaceOperator
{
public:
  SurfaceOperator(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound)
    : Mesh(mesh)
    , Surface(surface)
    , Bound(bound)
  {
  }

protected:
  /** Whether each label of a piece that vanishes remains on another one nearby, where its area is
   * more than a rounding error. */
  bool KeepsLabels(
    const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& moved) const;

  RefinableMesh& Mesh;
  RefinableSurface& Surface;
  SurfaceBound& Bound;
};

/** The facets for a TriangleTree. */
std::vector<LabelledTriangle> TrianglesOf(const std::vector<FacetOfInput>& facets);

/**
 * Decides which pieces of a surface may replace others: on the boundary, pieces that cross no
 * other. A remeshed surface also crosses itself nowhere between regions, and stays near the
 * input's, both ways: no point of it is farther from the input than the tolerance, nor are the
 * corners, midpoints of edges and centers of the input's facets from it. Each of these samples is
 * tracked to its nearest piece (Hu et al. 2017, Error-Bounded and Feature Preserving Surface
 * Remeshing with Minimal Angle Improvement).
 */
class SurfaceBound
{
public:
  /**
   * @param[in] tolerance positive if the surface is remeshed
   * @param[in] budget of areas and volumes; null: none
   */
  SurfaceBound(const RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
    SurfaceTreatment treatment, double tolerance, SurfaceBudget* budget = nullptr);

  /**
   * Whether fresh pieces may replace others: they cross none, keep the orientation, and, if the
   * surface is remeshed, are near enough to facets of their labels.
   *
   * @param[in,out] fresh each with a facet of its label; replaced by one that it is near, if the
   * surface is remeshed
   */
  bool Allows(const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh);

  /** The same if each fresh piece replaces one, and keeps its orientation.
   * @param[in] moved gone pieces, one for each fresh one
   * @param[in] share of the tolerance within which they have to stay
   */
  bool AllowsEach(const std::vector<SurfacePiece>& moved, const std::vector<SurfacePiece>& gone,
    std::vector<SurfacePiece>& fresh, double share = 1);

  /** The same if only points of the pieces move. If there is a budget, pieces lower than the
   * tolerance may turn. */
  bool AllowsMove(const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh);

  /** Whether pieces that differ only in their triangulation, up to rounding, may replace others. */
  bool AllowsCut(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);

  /** Notification: the last allowed step was done. */
  void Replace();

  /** The nearest point of the input's surface to a place near a facet; only if it is remeshed. */
  Point PlaceOn(const Point& place, Id facet) const;

private:
  using Samples = std::vector<Id>;
  bool StaysNear(
    const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh, double tolerance);
  void TakeSamples(const std::vector<SurfacePiece>& pieces);
  bool PutDown(
    const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh, double most);
  bool Accepts(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);
  std::vector<SurfacePiece> Watched(const std::vector<SurfacePiece>& pieces) const;

  TriangleTree::Nearest NearestTo(Id point, const Point& place, Id facet);

  /** The facet that was nearest to a point at the last query. */
  struct NearestToPoint
  {
    Point Place;
    Id Label;
    TriangleTree::Nearest Nearest;
  };

  const std::vector<FacetOfInput>& Facets;
  double Tolerance;
  SurfaceBudget* Budget;
  bool WatchesAll; ///< pieces between regions, too: a remeshed surface has no cells that do
  BoundaryPieces Boundary;
  std::unique_ptr<TriangleTree> Input; ///< if the surface is remeshed
  std::vector<NearestToPoint> AtPoints;
  std::vector<Point> Places; ///< of the samples
  std::unordered_map<Triangle, Samples, HashOfTriangle> AtPieces;

  /** The last allowed step. */
  std::vector<SurfacePiece> Gone;
  std::vector<SurfacePiece> Fresh;
  std::vector<Samples> AtFresh;
};
} // namespace insideout
