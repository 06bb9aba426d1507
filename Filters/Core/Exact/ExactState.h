// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/Cone.h"
#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"
#include "Mesh/RingTriangulation.h"

#include <random>
#include <set>
#include <vector>

namespace insideout
{
/** The segment or facets that a Steiner point lies on. */
struct PointSupport
{
  Id Segment = None;      ///< that the point is within, None for none
  std::vector<Id> Facets; ///< whose faces have the point, ascending

  bool IsNothing() const { return this->Segment == None && this->Facets.empty(); }
};

/**
 * The state of the exact engine, which its functions take and change: a mesh whose facets are being
 * recovered. A facet is *present* when faces of the mesh are marked as its pieces, and *lost* when
 * none is.
 */
struct ExactState
{
  /**
   * The Delaunay tetrahedralization, without any facet.
   * @param[in] work, monitor have to live as long as the state
   * @throws Error Planar, Stopped
   */
  ExactState(const std::vector<Point>& points, std::vector<Triangle> facets, WorkBudget& work,
    Monitor& monitor);

  /** An existing mesh, and facets between its vertices. */
  ExactState(FlippableMesh mesh, std::vector<Triangle> facets, Monitor& monitor);

  FlippableMesh Mesh;
  std::vector<Triangle> Facets;
  SegmentTable Segments;
  Monitor* Progress;
  std::mt19937 Random; ///< one generator for all attempts, so that no two are alike

  /** Scratch of the operator at work, kept for its memory. */
  struct
  {
    EdgeRing Ring;
    RingTriangulation<int> Triangulation;
    Cone Moved;
    std::vector<Id> SectorOf; ///< per cell
  } Scratch;

  /** Report progress to the monitor, which may throw to stop the engine. */
  void Report(const ProgressRange& phase, double part = 0) const
  {
    this->Progress->Check(phase, part);
  }

  /** Per facet, whether the mesh has marked faces of it. */
  std::vector<bool> FacetsThatAreThere() const;

  /** The segments of facets, each once, ascending. */
  std::vector<Id> SegmentsOf(const std::vector<Id>& facets) const;

  /**
   * The Steiner points that are in the mesh, ascending.
   * @param[in] since without those around which nothing has changed since
   *            (FlippableMesh::NumberOfChanges)
   */
  std::vector<Id> SteinerPoints(std::int64_t since) const;

  PointSupport SupportOf(Id point) const;

  /** The facets of the points, and those of cells within this number of rings around the points. */
  std::set<Id> FacetsAround(const std::vector<Id>& points, int rings) const;

  /**
   * Release facets: their faces lose the mark, so flips may change them. Segments that no present
   * facet has are released, too.
   */
  void LetGo(const std::set<Id>& facets);
};
} // namespace insideout
