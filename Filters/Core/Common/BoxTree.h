// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"
#include "Common/RawVector.h"

#include <array>
#include <utility>
#include <vector>

namespace insideout
{
/** A binary tree over boxes that finds intersecting boxes. Split at medians. */
class BoxTree
{
public:
  explicit BoxTree(const std::vector<Box>& boxes)
    : BoxTree(boxes.data(), boxes.size())
  {
  }
  explicit BoxTree(const RawVector<Box>& boxes)
    : BoxTree(boxes.data(), boxes.size())
  {
  }

  /** The same over points. */
  static BoxTree OfPoints(const std::vector<Point>& points);

  /** Call visit(i) for every box i that meets `box`, in a deterministic order. */
  template <class Visitor>
  void Visit(const Box& box, const Visitor& visit) const
  {
    this->VisitWhere([&](const Box& other) { return other.Meets(box); }, visit);
  }

  /** The same for boxes with meets(box) true, which must also hold for all boxes around them. */
  template <class Meets, class Visitor>
  void VisitWhere(const Meets& meets, const Visitor& visit) const
  {
    for (std::size_t node = 0; node < this->Nodes.size();)
    {
      const Node& here = this->Nodes[node];
      if (!meets(here.Bounds))
      {
        node = here.Next;
        continue;
      }
      for (Id k = here.Begin; k < here.End; ++k)
      {
        if (meets(this->Boxes[k]))
        {
          visit(this->Order[k]);
        }
      }
      ++node;
    }
  }

  /**
   * Call visit(i) for boxes i with distance(box) at most bound(), which visit may lower; nearer
   * nodes come first. No box may be nearer than a box around it.
   */
  template <class DistanceOf, class Bound, class Visitor>
  void VisitNearestFirst(const DistanceOf& distance, const Bound& bound, const Visitor& visit) const
  {
    this->VisitNearFirst<double>([&](const Box& box, double& found) { found = distance(box); },
      [&](double found) { return found <= bound(); }, [](double a, double b) { return a <= b; },
      [&](Id i, double) { visit(i); });
  }

  /**
   * The same for distances of any type, such as those of several points at once.
   *
   * Call visit(i, distance) for boxes i whose distance, set by measure(box, distance), isNear; of
   * two nodes the one that isNearer comes first.
   */
  template <class Distance, class Measure, class IsNear, class IsNearer, class Visitor>
  void VisitNearFirst(const Measure& measure, const IsNear& isNear, const IsNearer& isNearer,
    const Visitor& visit) const
  {
    struct Waiting
    {
      std::size_t Node;
      Distance From;
    };
    std::array<Waiting, 64> stack; // of fewer than 2^32 boxes; each level halves
    std::size_t size = 0;
    if (!this->Nodes.empty())
    {
      stack[0].Node = 0;
      measure(this->Nodes[0].Bounds, stack[0].From);
      size = 1;
    }
    while (size > 0)
    {
      --size;
      if (!isNear(stack[size].From))
      {
        continue;
      }
      const std::size_t node = stack[size].Node;
      const Node& here = this->Nodes[node];
      for (Id k = here.Begin; k < here.End; ++k)
      {
        Distance from;
        measure(this->Boxes[k], from);
        if (isNear(from))
        {
          visit(this->Order[k], from);
        }
      }
      if (here.Begin == here.End)
      {
        Waiting& second = stack[size];
        Waiting& first = stack[size + 1];
        second.Node = this->Nodes[node + 1].Next;
        first.Node = node + 1;
        measure(this->Nodes[second.Node].Bounds, second.From);
        measure(this->Nodes[first.Node].Bounds, first.From);
        if (!isNearer(first.From, second.From))
        {
          std::swap(first, second);
        }
        size += 2;
      }
    }
  }

  /** Call visit(i) for every box i of a node; the first node holds all. */
  template <class Visitor>
  void VisitPart(Id part, const Visitor& visit) const
  {
    for (std::size_t node = part; node < this->Nodes[part].Next; ++node)
    {
      for (Id k = this->Nodes[node].Begin; k < this->Nodes[node].End; ++k)
      {
        visit(this->Order[k]);
      }
    }
  }

  /** Call visit(i) for the boxes of the smallest nodes with opens(node) true, as it must be for all
   * their ancestors. */
  template <class Opens, class Visitor>
  void VisitOpened(const Opens& opens, const Visitor& visit) const
  {
    for (std::size_t node = 0; node < this->Nodes.size();)
    {
      const Node& here = this->Nodes[node];
      if (!opens(static_cast<Id>(node)))
      {
        node = here.Next;
        continue;
      }
      for (Id k = here.Begin; k < here.End; ++k)
      {
        visit(this->Order[k]);
      }
      ++node;
    }
  }

  /** The number of nodes, as arguments of VisitPairs and others. */
  Id NumberOfParts() const { return static_cast<Id>(this->Nodes.size()); }

  /** Whether a node has no children; else the next node is the first of two. */
  bool IsLeaf(Id part) const { return this->Nodes[part].Begin < this->Nodes[part].End; }

  /**
   * Call visit(i, j) for boxes i and j that meet. All nodes together give each pair once, in a
   * deterministic order.
   */
  template <class Visitor>
  void VisitPairs(Id part, const Visitor& visit) const
  {
    this->VisitPairsWith(
      part, [](std::size_t) { return true; }, visit);
  }

  /** Per node the common set of its boxes, or None. @param[in] setOf one per box */
  std::vector<Id> SetsOfParts(const std::vector<Id>& setOf) const;

  /**
   * The same for pairs of boxes of different sets only.
   *
   * @param[in] setOf one per box, not None
   * @param[in] setsOfParts from SetsOfParts
   */
  template <class Visitor>
  void VisitPairsBetween(Id part, const std::vector<Id>& setOf, const std::vector<Id>& setsOfParts,
    const Visitor& visit) const
  {
    const Id own = setsOfParts[part];
    this->VisitPairsWith(
      part, [&](std::size_t other) { return own == None || setsOfParts[other] != own; },
      [&](Id i, Id j)
      {
        if (setOf[i] != setOf[j])
        {
          visit(i, j);
        }
      });
  }

private:
  /** Nodes stand in depth-first order; an inner node holds no boxes itself (Begin = End). */
  struct Node
  {
    Box Bounds;
    Id Begin;
    Id End;
    std::size_t Next; ///< the next node when this one is skipped
  };

  /** Skip nodes with isWanted(node) false, and their descendants. */
  template <class IsWanted, class Visitor>
  void VisitPairsWith(Id part, const IsWanted& isWanted, const Visitor& visit) const
  {
    const Node& leaf = this->Nodes[part];
    for (Id k = leaf.Begin; isWanted(part) && k < leaf.End; ++k)
    {
      this->VisitLeaf(k, k + 1, leaf.End, visit);
    }
    // Leaves before this one have been paired with it already.
    for (std::size_t node = leaf.Begin < leaf.End ? part + 1 : this->Nodes.size();
         node < this->Nodes.size();)
    {
      const Node& other = this->Nodes[node];
      if (!other.Bounds.Meets(leaf.Bounds) || !isWanted(node))
      {
        node = other.Next;
        continue;
      }
      for (Id k = leaf.Begin; other.Begin < other.End && k < leaf.End; ++k)
      {
        if (this->Boxes[k].Meets(other.Bounds))
        {
          this->VisitLeaf(k, other.Begin, other.End, visit);
        }
      }
      ++node;
    }
  }

  template <class Visitor>
  void VisitLeaf(Id k, Id begin, Id end, const Visitor& visit) const
  {
    for (Id other = begin; other < end; ++other)
    {
      if (this->Boxes[k].Meets(this->Boxes[other]))
      {
        visit(this->Order[k], this->Order[other]);
      }
    }
  }

  struct Part;
  struct Centre;
  BoxTree(const Box* given, std::size_t count);
  static void Divide(RawVector<Centre>& centres, const Part& part);
  void Build(RawVector<Centre>& centres, const Box* given, const Part& part);
  void Join(const Part& part);

  RawVector<Id> Order;  ///< of the boxes in the leaves
  RawVector<Box> Boxes; ///< in that order
  RawVector<Node> Nodes;
};
} // namespace insideout
