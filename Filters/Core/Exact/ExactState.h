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
 * The state of the exact engine, which its functions take and change: a mesh on its way to having
 * facets. A facet is *there* when faces of the mesh are marked as its pieces, *lost* when none is.
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

  /** A mesh that is there already, and facets between its vertices. */
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

  /** Tell the monitor, which may stop all by throwing. */
  void Report(const ProgressRange& phase, double part = 0) const
  {
    this->Progress->Check(phase, part);
  }

  /** Whether faces are pieces of it, per facet. */
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

  /** The facets that have one of the points, or a cell within this number of cells of it. */
  std::set<Id> FacetsAround(const std::vector<Id>& points, int rings) const;

  /** Release facets: no face is a piece of them any more, and flips may change their former pieces.
   * So are the segments that no facet has which is there. */
  void LetGo(const std::set<Id>& facets);
};
} // namespace insideout
