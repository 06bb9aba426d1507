// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/BodyRegions.h"

#include "Common/Error.h"

#include <algorithm>
#include <array>
#include <map>

namespace insideout
{
namespace
{
/** A region for each body; each cell goes to its first body in the order. */
BodyRegions RegionsByPriority(const std::vector<std::vector<unsigned char>>& inside,
  const std::vector<Id>& priority, const LoopProgress& progress)
{
  BodyRegions result;
  result.Regions.OfCell.assign(inside.front().size(), None);
  result.Regions.Count = static_cast<Id>(inside.size());
  for (Id b = 0; b < result.Regions.Count; ++b)
  {
    result.Bodies.push_back({ b });
  }
  for (std::size_t cell = 0; cell < inside.front().size(); ++cell)
  {
    progress.Check(cell);
    const auto first = std::find_if(
      priority.begin(), priority.end(), [&](Id body) { return inside[body][cell] != 0; });
    result.Regions.OfCell[cell] = first == priority.end() ? None : *first;
  }
  return result;
}

/** The bodies that have a cell, ascending. */
void BodiesOfCell(
  const std::vector<std::vector<unsigned char>>& inside, std::size_t cell, std::vector<Id>& bodies)
{
  bodies.clear();
  for (std::size_t b = 0; b < inside.size(); ++b)
  {
    if (inside[b][cell] != 0)
    {
      bodies.push_back(static_cast<Id>(b));
    }
  }
}

/** A region for each set of bodies that has cells. */
BodyRegions RegionsOfAll(
  const std::vector<std::vector<unsigned char>>& inside, const LoopProgress& progress)
{
  std::vector<const std::vector<Id>*> setOf(inside.front().size(), nullptr);
  std::map<std::vector<Id>, Id> regionOf;
  std::vector<Id> bodies;
  for (std::size_t cell = 0; cell < setOf.size(); ++cell)
  {
    progress.Check(cell);
    BodiesOfCell(inside, cell, bodies);
    if (!bodies.empty())
    {
      setOf[cell] = &regionOf.insert({ bodies, None }).first->first;
    }
  }
  BodyRegions result;
  for (auto& [set, region] : regionOf)
  {
    region = result.Regions.Count++;
    result.Bodies.push_back(set);
  }
  for (const std::vector<Id>* set : setOf)
  {
    result.Regions.OfCell.push_back(set ? regionOf.at(*set) : None);
  }
  return result;
}

/** Per body, the bodies nested in it: it has all their cells, and more. */
std::vector<std::vector<Id>> FindNested(const std::vector<std::vector<unsigned char>>& inside)
{
  std::vector<std::size_t> cells(inside.size(), 0);
  std::map<std::array<Id, 2>, std::size_t> shared;
  std::vector<Id> bodies;
  for (std::size_t cell = 0; !inside.empty() && cell < inside.front().size(); ++cell)
  {
    BodiesOfCell(inside, cell, bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      ++cells[bodies[i]];
      for (std::size_t j = i + 1; j < bodies.size(); ++j)
      {
        ++shared[{ bodies[i], bodies[j] }];
      }
    }
  }
  std::vector<std::vector<Id>> within(inside.size());
  for (const auto& [pair, count] : shared)
  {
    const auto [a, b] = pair;
    if (cells[a] != cells[b] && (count == cells[a] || count == cells[b]))
    {
      count == cells[a] ? within[b].push_back(a) : within[a].push_back(b);
    }
  }
  for (std::vector<Id>& inner : within)
  {
    std::sort(inner.begin(), inner.end());
  }
  return within;
}
} // namespace

std::vector<Id> PriorityOf(
  const std::vector<std::string>& bodies, const std::vector<std::string>& first)
{
  std::vector<Id> order;
  for (const std::string& name : first)
  {
    const auto found = std::find(bodies.begin(), bodies.end(), name);
    if (found == bodies.end())
    {
      std::string all;
      for (const std::string& body : bodies)
      {
        all += (all.empty() ? "" : ", ") + body;
      }
      throw Error(ErrorCode::InvalidParameter,
        "Priority names " + name + ", which is not a body; there are " + all);
    }
    order.push_back(static_cast<Id>(found - bodies.begin()));
    if (std::find(order.begin(), order.end() - 1, order.back()) != order.end() - 1)
    {
      throw Error(ErrorCode::InvalidParameter, "Priority names " + name + " twice");
    }
  }
  for (Id b = 0; b < static_cast<Id>(bodies.size()); ++b)
  {
    if (std::find(order.begin(), order.end(), b) == order.end())
    {
      order.push_back(b);
    }
  }
  return order;
}

BodyOrder InnerFirst(const std::vector<std::vector<unsigned char>>& inside,
  const std::vector<Id>& given, std::size_t named)
{
  BodyOrder order = { {}, given, named, FindNested(inside) };
  const auto isWithin = [&](Id inner, Id outer)
  {
    const std::vector<Id>& within = order.Within[outer];
    return std::binary_search(within.begin(), within.end(), inner);
  };
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    const Id body = given[i];
    auto before = order.Priority.end();
    if (i >= named)
    {
      before = std::find_if(order.Priority.begin() + static_cast<std::ptrdiff_t>(named),
        order.Priority.end(), [&](Id other) { return isWithin(body, other); });
    }
    order.Priority.insert(before, body);
  }
  return order;
}

BodyRegions FindBodyRegions(const std::vector<std::vector<unsigned char>>& inside, RegionRule rule,
  const std::vector<Id>& priority, Monitor& monitor, const ProgressRange& progress)
{
  if (inside.empty())
  {
    return {};
  }
  const LoopProgress cells(monitor, progress, inside.front().size());
  return rule == RegionRule::Priority ? RegionsByPriority(inside, priority, cells)
                                      : RegionsOfAll(inside, cells);
}

std::vector<std::string> NamesOfRegions(
  const BodyRegions& regions, const std::vector<std::string>& bodies)
{
  std::vector<std::string> names;
  for (const std::vector<Id>& set : regions.Bodies)
  {
    std::string name;
    for (const Id body : set)
    {
      name += (name.empty() ? "" : "+") + bodies[body];
    }
    names.push_back(name);
  }
  return names;
}
} // namespace insideout
