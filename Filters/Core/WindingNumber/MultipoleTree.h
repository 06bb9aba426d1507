// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"
#include "WindingNumber/Multipole.h"
#include "WindingNumber/SolidAngleTiles.h"

namespace insideout
{
struct Ball
{
  Point Centre;
  double Radius;
};

/** Centered at the middle of the sites' box. */
Ball BallAround(const SiteBlock& sites);
Ball BallAround(const SiteProducts* first, const SiteProducts* last);

/** Coordinates are below 2^50, so that their squares do not overflow. */
double QuickDistance(const Point& a, const Point& b);

/** The area of triangles, counted as often as they, rounded up. */
double AreaOf(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles);

/**
 * Groups of triangles in a binary tree. Far from a node its winding number is a Multipole, which
 * leaves out less than 2^-51 of it; sums over many nodes are right to some 1e-14. So the far groups
 * cost a site as much as the logarithm of their number. Sites in a small ball share one field in
 * place of most nodes, as in fast multipole methods (Greengard, Rokhlin 1987); it leaves out less
 * than another 2^-51 of each. The near groups are left to the caller.
 */
class MultipoleTree
{
public:
  /**
   * @param[in] groups in an order in which neighbors are near each other; their triangles are not
   * degenerate
   * @param[in] sites how many will be asked for; if these are few, all groups count as near
   * @param[in] progress reported all the time is its begin
   * @throws Error (Stopped)
   */
  MultipoleTree(const std::vector<Point>& points,
    const std::vector<std::vector<CountedTriangle>>& groups, std::size_t sites, Monitor& monitor,
    const ProgressRange& progress);

  /** Nodes, each with its descendants: those of all groups. */
  std::vector<Id> Roots() const;

  /** One field for all sites in a ball, in place of most nodes. */
  struct Local
  {
    Ball Sites;
    int Degree = -1; ///< -1: there is no field
    Multipole Field = {};
    std::vector<Id> Rest; ///< the other nodes, each with its descendants
  };

  /**
   * Expand the fields of nodes in the sites' ball, where this leaves out as little as the nodes'
   * multipoles do. It pays off for some 100 sites.
   *
   * @param[in] nodes each with its descendants
   */
  Local Around(const Ball& sites, const std::vector<Id>& nodes) const;

  /** How many blocks of sites, near each other, share a field best: none where there is no tree. */
  static constexpr std::size_t BlocksPerRun = 16;
  std::size_t RunsPerCall() const { return this->Nodes.empty() ? 1 : 8; }

  /** The nodes that take the place of all groups but the near ones, for some sites. */
  struct Selection
  {
    struct Part
    {
      Id Node;
      int Degree;
    };
    std::vector<Part> Far;
    std::vector<Id> Near; ///< groups, in their order
  };

  /** @param[in] nodes each with its descendants */
  void Select(const Ball& sites, const std::vector<Id>& nodes, Selection& selection) const;

  /** Add the field to the value of each site; these are in its ball. */
  void Add(const Local& local, const SiteBlock& sites, double (&w)[Lanes]) const;

  /** Add the far part to each site's value. */
  void Add(const Selection& selection, const SiteBlock& sites, double (&w)[Lanes]) const;

private:
  struct Node
  {
    std::size_t First, Last; ///< of its groups
    Id Next;                 ///< the node after this one's descendants
    Ball Around;
    double Area;
    std::array<double, MultipoleDegree + 1> Reach; ///< distance from which each degree serves
    Multipole Field;                               ///< in units of the last one of these
    double Largest; ///< bound of the field, two radii from the center
  };

  void Build(const std::vector<Point>& points,
    const std::vector<std::vector<CountedTriangle>>& groups, std::size_t first, std::size_t last);
  void SetReach(Node& node) const;
  static int DegreeAt(const Node& node, double distance);
  static int LocalDegree(const Node& node, double distance, double radius);
  template <typename Far, typename Near>
  void VisitNodes(
    const Ball& sites, const std::vector<Id>& nodes, const Far& far, const Near& near) const;
  static void SharpenReach(Node& node);
  static void Expand(const std::vector<Point>& points, const std::vector<CountedTriangle>& group,
    const Sites& samples, const std::vector<SiteProducts>& blocks, Node& node);
  static void Join(
    const std::vector<SiteProducts>& blocks, Node& node, const Node& left, const Node& right);

  std::size_t NumberOfGroups;
  std::vector<Node> Nodes;
};
} // namespace insideout
