// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/BodyRegions.h"

#include "Common/Error.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

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
    bodies.clear();
    for (std::size_t b = 0; b < inside.size(); ++b)
    {
      if (inside[b][cell] != 0)
      {
        bodies.push_back(static_cast<Id>(b));
      }
    }
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
        "Priority names " + name + ", which is no body; there are " + all);
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

std::vector<std::string> WarningsOfCoveredBodies(
  const std::vector<std::vector<unsigned char>>& inside, const BodyRegions& regions,
  const std::vector<std::string>& bodies)
{
  std::vector<std::string> warnings;
  for (std::size_t b = 0; b < inside.size(); ++b)
  {
    std::set<Id> covering;
    bool hasOwn = false;
    for (std::size_t cell = 0; cell < inside[b].size() && !hasOwn; ++cell)
    {
      if (inside[b][cell] != 0)
      {
        const std::vector<Id>& of = regions.Bodies[regions.Regions.OfCell[cell]];
        hasOwn = std::find(of.begin(), of.end(), static_cast<Id>(b)) != of.end();
        covering.insert(of.front());
      }
    }
    if (hasOwn || covering.empty())
    {
      continue;
    }
    std::string names;
    for (const Id body : covering)
    {
      names += (names.empty() ? "" : ", ") + bodies[body];
    }
    warnings.push_back("body " + bodies[b] +
      " has no cell: all of its places are of bodies before it (" + names + "); set Priority to " +
      bodies[b] + ", or RegionRule to all");
  }
  return warnings;
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
