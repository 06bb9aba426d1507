// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"

#include <array>
#include <vector>

namespace insideout
{
/**
 * A dynamic set of boxes with intersection queries: each box is in the smallest cube of an octree
 * that contains its center and is at least as wide (Ulrich 2000, Loose Octrees). BoxTree is faster
 * for a fixed set.
 */
class LooseOctree
{
public:
  /** @param[in] space approximate extent of the boxes; boxes farther away cost time */
  explicit LooseOctree(const Box& space);

  void Insert(Id item, const Box& box);

  /** @param[in] box as inserted */
  void Remove(Id item, const Box& box);

  /** Call visit(item) for every box that meets this one; the order depends on earlier insertions
   * and removals. */
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
    Box Bounds = Box::Empty(); ///< box of all items that ever were in it or below
    Id Count = 0;              ///< number of the present ones
    std::vector<Entry> Entries;
  };

  template <class Change>
  std::vector<Entry>& Descend(const Box& box, const Change& change);

  Point Centre;
  double HalfWidth;
  std::vector<Node> Nodes;
};
} // namespace insideout
