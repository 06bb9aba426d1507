// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Types.h"

#include <vector>

namespace insideout
{
/** An axis-aligned box, boundary included. */
struct Box
{
  Point Low;
  Point High;

  bool Meets(const Box& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
      this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }

  void Add(const Box& other);
};

/** The bounding box of a triangle with finite corners; exact, for it only compares. */
Box BoundingBox(const std::vector<Point>& points, const Triangle& triangle);

/** A binary tree over boxes that finds those which meet a given box. Split at medians. */
class BoxTree
{
public:
  explicit BoxTree(std::vector<Box> boxes);

  /** Calls visit(i) for every box i that meets `box`, in an order that is always the same. */
  template <class Visitor>
  void Visit(const Box& box, const Visitor& visit) const
  {
    std::size_t node = 0;
    while (node < this->Nodes.size())
    {
      const Node& here = this->Nodes[node];
      if (!here.Bounds.Meets(box))
      {
        node = here.Next;
        continue;
      }
      for (Id k = here.Begin; k < here.End; ++k)
      {
        if (this->Boxes[this->Order[k]].Meets(box))
        {
          visit(this->Order[k]);
        }
      }
      ++node;
    }
  }

  const Box& operator[](Id i) const { return this->Boxes[i]; }

private:
  /** Nodes stand in depth-first order; an inner node holds no boxes itself (Begin = End). */
  struct Node
  {
    Box Bounds;
    Id Begin;
    Id End;
    std::size_t Next; ///< the node to go on with where this one is passed over
  };

  void Build(Id begin, Id end);

  std::vector<Box> Boxes;
  std::vector<Id> Order;
  std::vector<Node> Nodes;
};
} // namespace insideout
