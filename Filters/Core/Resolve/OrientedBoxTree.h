// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"
#include "Common/RawVector.h"

#include <array>
#include <vector>

namespace insideout
{
/** A box around points, along axes of its own. */
struct OrientedBox
{
  Point Center;
  std::array<Point, 3> Axes; ///< orthonormal up to rounding
  Point Half;                ///< half the extent along each axis
  double Error;              ///< bound of the rounding errors in AreApart due to this box
};

/**
 * Whether boxes are certainly apart: along an axis of one of them, or along one across the first
 * axes of both.
 */
bool AreApart(const OrientedBox& a, const OrientedBox& b);

/** Whether a plane through a point certainly separates boxes, and so what joins them to it. */
bool AreApartSeenFrom(const Point& tip, const OrientedBox& a, const OrientedBox& b);

/**
 * A binary tree over triangles that finds those that may meet. Among needles, whose bounding boxes
 * meet far more often than they do, this is faster than a BoxTree; elsewhere, slower.
 *
 * The facets of a node have an oriented box. They are halved at the median along that axis of it on
 * which their centers extend farthest, as a multiple of the facets' mean extent: needles side by
 * side are separated across their length. Needles of a fan are apart if their other corners are,
 * seen from the common one.
 */
class OrientedBoxTree
{
public:
  /** Nodes whose facets are compared with each other; twice the same for those within a node. */
  using Task = std::array<std::size_t, 2>;

  /**
   * @param[in] points the tree keeps a reference to them
   * @param[in] facets at least one
   * @param[in] setOf one per facet, not None
   */
  OrientedBoxTree(const std::vector<Point>& points, const std::vector<Triangle>& facets,
    const std::vector<Id>& setOf);

  /** Tasks, at least a given number if possible, that together visit all pairs. */
  std::vector<Task> Tasks(std::size_t number) const;

  /**
   * Call visit(i, j) for facets i and j of different sets whose bounding boxes meet, unless nodes
   * that hold them are apart beyond common corners. All tasks together give no pair twice.
   */
  template <class Visitor>
  void VisitPairs(const Task& task, const Visitor& visit) const
  {
    std::vector<Task> open = { task };
    while (!open.empty())
    {
      const Task now = open.back();
      open.pop_back();
      if (!this->MayMeet(now))
      {
        continue;
      }
      if (this->IsLeaf(now[0]) && this->IsLeaf(now[1]))
      {
        this->VisitLeaves(now, visit);
      }
      else
      {
        this->Divide(now, open);
      }
    }
  }

private:
  struct Node
  {
    Box Bounds;
    OrientedBox Own;
    Id Tip;           ///< a corner of all its facets, or None
    OrientedBox Base; ///< of their other corners, if there is a tip
    double Size;      ///< the largest half extent of the oriented box
    Id Begin;         ///< of its facets in the order
    Id End;
    Id Set; ///< the common set of its facets, or None
  };

  bool IsLeaf(std::size_t node) const { return node >= this->FirstLeaf; }
  bool MayMeet(const Task& task) const;
  void Divide(const Task& task, std::vector<Task>& parts) const;
  void Build(const std::vector<Triangle>& facets, const std::vector<Id>& setOf, std::size_t node);

  template <class Visitor>
  void VisitLeaves(const Task& task, const Visitor& visit) const
  {
    const Node& a = this->Nodes[task[0]];
    const Node& b = this->Nodes[task[1]];
    for (Id i = a.Begin; i < a.End; ++i)
    {
      for (Id j = task[0] == task[1] ? i + 1 : b.Begin; j < b.End; ++j)
      {
        if (this->Boxes[i].Meets(this->Boxes[j]) && this->Sets[i] != this->Sets[j])
        {
          visit(this->Order[i], this->Order[j]);
        }
      }
    }
  }

  const std::vector<Point>& Points;
  std::vector<Id> Order; ///< of the facets in the leaves
  RawVector<Box> Boxes;  ///< in that order
  RawVector<Id> Sets;    ///< in that order
  RawVector<Node> Nodes; ///< node n has the children 2 n + 1 and 2 n + 2
  std::size_t FirstLeaf;
};
} // namespace insideout
