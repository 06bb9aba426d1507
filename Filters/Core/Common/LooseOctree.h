// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"

#include <array>
#include <vector>

namespace insideout
{
/**
 * Boxes that come and go, and which of them meet a box: each is in the smallest cube of an octree
 * that holds its center and is as wide (Ulrich 2000, Loose Octrees). BoxTree is faster for boxes
 * that stay.
 */
class LooseOctree
{
public:
  /** @param[in] space about which the boxes are; others may be farther away, at the cost of time */
  explicit LooseOctree(const Box& space);

  void Insert(Id item, const Box& box);

  /** @param[in] box as it was inserted */
  void Remove(Id item, const Box& box);

  /** Calls visit(item) for every box that meets this one, in an order that depends on what was
   * inserted and removed before. */
  template <class Visitor>
  void Visit(const Box& box, const Visitor& visit) const
  {
    std::array<Id, 8 * MostLevels> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0)
    {
      const Node& here = this->Nodes[stack[--size]];
      for (const Entry& entry : here.Entries)
      {
        if (entry.Bounds.Meets(box))
        {
          visit(entry.Item);
        }
      }
      for (const Id child : here.Children)
      {
        if (child != None && this->Nodes[child].Count > 0 && this->Nodes[child].Bounds.Meets(box))
        {
          stack[size++] = child;
        }
      }
    }
  }

private:
  static constexpr int MostLevels = 32;

  struct Entry
  {
    Id Item;
    Box Bounds;
  };

  struct Node
  {
    std::array<Id, 8> Children = { { None, None, None, None, None, None, None, None } };
    Box Bounds = Box::Empty(); ///< of all that ever were in it or below
    Id Count = 0;              ///< of those that are
    std::vector<Entry> Entries;
  };

  template <class Change>
  std::vector<Entry>& Descend(const Box& box, const Change& change);

  Point Centre;
  double HalfWidth;
  std::vector<Node> Nodes;
};
} // namespace insideout
