// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/LooseOctree.h"

#include <algorithm>

namespace insideout
{
LooseOctree::LooseOctree(const Box& space)
  : HalfWidth(space.Extent(space.LongestAxis()) / 2)
  , Nodes(1)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = space.Low[axis] / 2 + space.High[axis] / 2;
  }
}

/** Call change(node) for each node down to that of a box. @return the boxes there */
template <class Change>
std::vector<LooseOctree::Entry>& LooseOctree::Descend(const Box& box, const Change& change)
{
  const double width = box.Extent(box.LongestAxis());
  Point centre = this->Centre;
  double half = this->HalfWidth;
  Id node = 0;
  for (int level = 1;; ++level)
  {
    change(this->Nodes[node]);
    if (level == MostLevels || !(width <= half))
    {
      return this->Nodes[node].Entries;
    }
    half /= 2;
    int octant = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isUpper = box.Low[axis] / 2 + box.High[axis] / 2 > centre[axis];
      octant |= isUpper ? 1 << axis : 0;
      centre[axis] += isUpper ? half : -half;
    }
    if (this->Nodes[node].Children[octant] == None)
    {
      this->Nodes[node].Children[octant] = static_cast<Id>(this->Nodes.size());
      this->Nodes.emplace_back();
    }
    node = this->Nodes[node].Children[octant];
  }
}

void LooseOctree::Insert(Id item, const Box& box)
{
  this
    ->Descend(box,
      [&](Node& node)
      {
        node.Bounds.Add(box);
        ++node.Count;
      })
    .push_back({ item, box });
}

void LooseOctree::Remove(Id item, const Box& box)
{
  std::vector<Entry>& entries = this->Descend(box, [](Node& node) { --node.Count; });
  const auto found = std::find_if(
    entries.begin(), entries.end(), [item](const Entry& entry) { return entry.Item == item; });
  *found = entries.back();
  entries.pop_back();
}
} // namespace insideout
