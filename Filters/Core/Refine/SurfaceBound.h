// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/SortedTriangle.h"
#include "Refine/RefinableSurface.h"
#include "Refine/TriangleTree.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace insideout
{
/** A piece of the surface, by its points' ids and places. */
struct SurfacePiece
{
  Triangle Corners;
  std::array<Point, 3> Places;
  Id Facet; ///< of the input
};

/** As long as twice its area. */
Point NormalOf(const SurfacePiece& piece);

/** Whether pieces of one plane, all seen from one side, look where a normal does. Where cells are
 * flat their signs do not tell. */
bool AreUnfolded(const std::vector<SurfacePiece>& pieces, const Point& normal);

/**
 * Keeps a remeshed surface near the input's, both ways: no point of it is farther than the
 * tolerance, and neither are the corners, the amids of the edges and the centres of the input's
 * facets from it (each of them is followed to the piece that it is next to; as Hu et al. 2017,
 * Error-Bounded and Feature Preserving Surface Remeshing with Minimal Angle Improvement).
 */
class SurfaceBound
{
public:
  /** That allows nothing, for surfaces that are not remeshed. */
  SurfaceBound() = default;

  /** @param[in] tolerance positive */
  SurfaceBound(
    const RefinableMesh& mesh, const std::vector<FacetOfInput>& facets, double tolerance);

  /**
   * Whether other pieces may take the place of some: near enough to facets of their labels, and
   * none turned over.
   *
   * @param[in,out] fresh each with a facet of its label; then with the one that it is nearest to
   */
  bool Allows(const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh);

  /** What was allowed last was done. */
  void Replace();

  /** A piece was cut into two. */
  void Halve(const Triangle& piece, const Triangle& first, const Triangle& second);

  /** The point of the input's surface that is nearest to a place near a facet. */
  Point PlaceOn(const Point& place, Id facet) const;

private:
  using Samples = std::vector<Id>;
  double PutDown(const Samples& samples, const std::vector<SurfacePiece>& fresh);

  double Tolerance = 0;
  const RefinableMesh* Mesh = nullptr;
  const std::vector<FacetOfInput>* Facets = nullptr;
  std::unique_ptr<TriangleTree> Input;
  std::vector<Point> Places; ///< of the samples
  std::unordered_map<Triangle, Samples, HashOfTriangle> AtPieces;

  std::vector<Triangle> Gone; ///< what was allowed last
  std::vector<std::pair<Triangle, Samples>> Fresh;
};
} // namespace insideout
