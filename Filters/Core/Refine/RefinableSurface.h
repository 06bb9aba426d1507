// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Refine/RefinableMesh.h"

#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace insideout
{
/** The treatment of faces on the boundary and between regions. */
enum class SurfaceTreatment
{
  Kept,    ///< each stays bit by bit
  Split,   ///< points may be added on them; the pieces stay in their planes, up to rounding, where
           ///< facets of one label join (JoinCoplanar)
  Remeshed ///< replaced by others within a distance
};

/** A face of the input on the boundary or between regions. */
struct FacetOfInput
{
  std::array<Point, 3> Corners;
  std::array<Id, 2> Faces; ///< faces of the input, 4 * cell + face; the second None on the boundary
  Id Label;                ///< facets of one label may replace each other
};

/**
 * The facets of a refinable mesh: which of their edges are ridges, which must stay in place, and
 * how their points may move (PointKind).
 */
class RefinableSurface
{
public:
  /**
   * Sets the mesh's Kinds, where split surfaces have fixed points. Split: all edges between facets
   * are ridges. Remeshed: an edge is a ridge unless exactly two facets meet there, of one label and
   * the same regions, whose normals differ by at most an angle. Lines of ridges that end freely and
   * are below twice the angle are none: they are the edges of a coarse mesh of a round surface.
   *
   * @param[in] facets by their ids in the mesh; these, and `locked`, have to live as long
   * @param[in] locked per facet whether it stays as it is; empty: none does
   * @param[in] featureAngle in degrees
   */
  RefinableSurface(RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
    const std::vector<char>& locked, SurfaceTreatment treatment, double featureAngle);

  SurfaceTreatment Treatment() const { return this->How; }
  const FacetOfInput& Facet(Id facet) const { return this->Facets[facet]; }

  /** Whether an edge of facets is a ridge. */
  bool IsRidge(Id u, Id v) const { return this->Ridges.count(EdgeBetween(u, v)) > 0; }

  /** Whether a facet is locked. */
  bool IsLocked(Id facet) const
  {
    return this->How == SurfaceTreatment::Kept ||
      (!this->Locked.empty() && this->Locked[facet] != 0);
  }

  /** Whether an edge of facets must stay as it is: at a locked facet, and where more than two
   * facets of the boundary meet. */
  bool IsLocked(Id u, Id v) const;

  /** Whether the point is pinched: not all cells around it are connected through faces at it. */
  bool IsPinched(Id point) const
  {
    return point < static_cast<Id>(this->Pinched.size()) && this->Pinched[point] != 0;
  }

  /** Update: a point was inserted in an edge of facets. */
  void Split(Id u, Id v, Id middle);

  /** Whether a point may be contracted into a neighbor: within a facet, or along its ridge, unless
   * the edge is locked or the neighbor pinched. A ridge around three edges would collapse, with
   * everything within. */
  bool MayContract(Id point, Id target) const;

  /**
   * Whether a corner of ridges may be contracted: it is not pinched, and none of the ridges is
   * locked.
   */
  bool MayLeave(Id point) const;

  /** Update: a point is contracted into the next one; its ridges, if any, continue from there. */
  void Contract(Id point, Id target);

private:
  struct EdgeUse;
  std::vector<Id> RidgesFrom(Id point) const;
  void FindPinched();
  void FindRidges(double featureAngle);
  bool MustBeRidge(const EdgeUse* first, const EdgeUse* last, double cosine) const;
  void SetKinds(double featureAngle);
  void DropLooseEnds(const std::unordered_set<Edge, HashOfEdge>& blunt);
  void AddRidge(Id u, Id v, bool isLocked);
  void RemoveRidge(Id u, Id v);

  RefinableMesh& Mesh;
  const std::vector<FacetOfInput>& Facets;
  const std::vector<char>& Locked;
  const SurfaceTreatment How;
  std::unordered_map<Edge, bool, HashOfEdge> Ridges; ///< with whether they are locked
  std::unordered_map<Id, std::vector<Id>> RidgeEnds; ///< other ends of the ridges at a point
  std::vector<char> Pinched;
};
} // namespace insideout
