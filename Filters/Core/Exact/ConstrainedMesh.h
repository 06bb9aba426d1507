// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"

#include <set>
#include <vector>

namespace insideout
{
/**
 * A mesh on its way to having facets: the mesh, the facets between its vertices, and their
 * segments. A facet is *there* when faces of the mesh are marked as its pieces, *lost* when none
 * is.
 */
class ConstrainedMesh
{
public:
  /** The Delaunay tetrahedralization, without any facet. @throws Error Planar, Stopped */
  ConstrainedMesh(const std::vector<Point>& points, const std::vector<Triangle>& facets,
    WorkBudget& work, Monitor& monitor);

  FlippableMesh Mesh;
  std::vector<Triangle> Facets;
  SegmentTable Segments;

  /** The facets missing in the mesh, after a search for those that are faces by chance. */
  std::vector<Id> FindLost(Monitor& monitor);

  /** The segments of facets, each once, ascending. */
  std::vector<Id> SegmentsOf(const std::vector<Id>& facets) const;

  /**
   * The Steiner points that are in the mesh, ascending.
   * @param[in] since without those around which nothing has changed since
   *            (FlippableMesh::NumberOfChanges)
   */
  std::vector<Id> SteinerPoints(std::int64_t since) const;

  /** The facets that have one of the points, or a cell within this number of cells of it. */
  std::set<Id> FacetsAround(const std::vector<Id>& points, int rings) const;

  /** Let facets go: no face is a piece of them any more, and flips may change what was. So are the
   * segments that no facet has which is there. */
  void LetGo(const std::set<Id>& facets);

private:
  ConstrainedMesh(const std::vector<Point>& points, const std::vector<Triangle>& facets,
    std::vector<Id> same, WorkBudget& work, Monitor& monitor);

  std::vector<bool> AreThere() const;
};
} // namespace insideout
