// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlipRounds.h"
#include "Exact/SteinerPoints.h"

namespace insideout
{
/** Makes facets, whose edges the mesh has, unions of faces of the mesh, and marks these. */
class FacetRecovery
{
public:
  FacetRecovery(FlippableMesh& mesh, const SegmentTable& segments,
    const std::vector<Triangle>& facets, Monitor& monitor)
    : Mesh(mesh)
    , Segments(segments)
    , Facets(facets)
    , Progress(monitor)
    , Flips(mesh, segments)
  {
  }

  /** Mark every facet that is one face between segments none of which is split. @return the others
   */
  std::vector<Id> MarkWholeFacets(const std::vector<Id>& facets);

  /** Recover facets by flips alone. @return the ones that are still missing */
  std::vector<Id> RecoverByFlips(const std::vector<Id>& missing);

  /**
   * Recover facets by putting a Steiner point on each where an edge crosses it. Edges get no end
   * beyond the facet by that, so it is done once per edge.
   * @return facets of which an edge is missing
   */
  std::vector<Id> RecoverBySplits(const std::vector<Id>& missing, SteinerPoints& steiner);

private:
  struct MeshEdge
  {
    Id U;
    Id V;
  };
  enum class Search
  {
    Found,
    Crossed,
    Impossible
  };

  Search FindFaces(Id facet, std::vector<MeshFace>& faces, MeshEdge& crossing) const;
  Search FaceBeside(
    Id facet, Id x, Id y, Id off, MeshFace& face, Id& apex, MeshEdge& crossing) const;
  std::vector<MeshEdge> BoundaryOf(Id facet) const;
  std::vector<MeshEdge> AllCrossings(Id facet, const MeshEdge& first) const;
  void Mark(Id facet, const std::vector<MeshFace>& faces);
  bool SplitOnFacet(Id facet, const MeshEdge& edge);
  bool Recover(Id facet, const FlipEffort& effort);

  FlippableMesh& Mesh;
  const SegmentTable& Segments;
  const std::vector<Triangle>& Facets;
  Monitor& Progress;
  FlipOperator Flips;
};
} // namespace insideout
