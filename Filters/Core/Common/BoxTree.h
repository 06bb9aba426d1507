// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"

#include <vector>

namespace insideout
{
/** A binary tree over boxes that finds those which meet. Split at medians. */
class BoxTree
{
public:
  explicit BoxTree(std::vector<Box> boxes);

  /** Calls visit(i) for every box i that meets `box`, in an order that is always the same. */
  template <class Visitor>
  void Visit(const Box& box, const Visitor& visit) const
  {
    this->VisitWhere([&](const Box& other) { return other.Meets(box); }, visit);
  }

  /** The same for boxes that `meets` is true for, as it has to be for all boxes around them. */
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

  /** The number of parts that VisitPairs can be asked for. */
  Id NumberOfParts() const { return static_cast<Id>(this->Nodes.size()); }

  /**
   * Calls visit(i, j) for boxes i and j that meet. All parts together give each pair once, in an
   * order that is always the same.
   */
  template <class Visitor>
  void VisitPairs(Id part, const Visitor& visit) const
  {
    const Node& leaf = this->Nodes[part];
    for (Id k = leaf.Begin; k < leaf.End; ++k)
    {
      this->VisitLeaf(k, k + 1, leaf.End, visit);
    }
    // What stands before this leaf has met it already.
    for (std::size_t node = leaf.Begin < leaf.End ? part + 1 : this->Nodes.size();
         node < this->Nodes.size();)
    {
      const Node& other = this->Nodes[node];
      if (!other.Bounds.Meets(leaf.Bounds))
      {
        node = other.Next;
        continue;
      }
      for (Id k = leaf.Begin; other.Begin < other.End && k < leaf.End; ++k)
      {
        this->VisitLeaf(k, other.Begin, other.End, visit);
      }
      ++node;
    }
  }

private:
  /** Nodes stand in depth-first order; an inner node holds no boxes itself (Begin = End). */
  struct Node
  {
    Box Bounds;
    Id Begin;
    Id End;
    std::size_t Next; ///< the node to go on with where this one is passed over
  };

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
  struct NumberedBox;
  bool Divide(std::vector<NumberedBox>& boxes, const Part& part);
  void Build(std::vector<NumberedBox>& boxes, const Part& part);

  std::vector<Id> Order;  ///< of the boxes in the leaves
  std::vector<Box> Boxes; ///< in that order
  std::vector<Node> Nodes;
};
} // namespace insideout
