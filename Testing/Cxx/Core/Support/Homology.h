// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/Topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

/** Betti numbers by linear algebra, from nothing but which points cells have. */
namespace testhomology
{
using namespace insideout;
using Simplex = std::vector<Id>;

/** The rank of a matrix of 0 and 1, of numbers modulo 2, by its columns' rows that hold 1. */
inline int RankModulo2(std::vector<std::set<int>> columns)
{
  std::map<int, std::set<int>> byLowest;
  for (std::set<int>& column : columns)
  {
    while (!column.empty() && byLowest.count(*column.rbegin()) > 0)
    {
      for (const int row : byLowest[*column.rbegin()])
      {
        if (!column.insert(row).second)
        {
          column.erase(row);
        }
      }
    }
    if (!column.empty())
    {
      byLowest[*column.rbegin()] = column;
    }
  }
  return static_cast<int>(byLowest.size());
}

/** By the ranks of the boundary maps of all simplices. */
inline BettiNumbers ByHomology(const std::vector<Simplex>& tops)
{
  std::array<std::map<Simplex, int>, 4> simplices;
  for (Simplex top : tops)
  {
    std::sort(top.begin(), top.end());
    for (unsigned subset = 1; subset < 1u << top.size(); ++subset)
    {
      Simplex part;
      for (std::size_t k = 0; k < top.size(); ++k)
      {
        if (subset >> k & 1u)
        {
          part.push_back(top[k]);
        }
      }
      auto& ofDimension = simplices[part.size() - 1];
      ofDimension.insert({ part, static_cast<int>(ofDimension.size()) });
    }
  }
  std::array<int, 5> ranks = { 0, 0, 0, 0, 0 }; // of the map from dimension d to d - 1
  for (std::size_t d = 1; d < 4; ++d)
  {
    std::vector<std::set<int>> columns;
    for (const auto& [simplex, number] : simplices[d])
    {
      columns.emplace_back();
      for (std::size_t k = 0; k <= d; ++k)
      {
        Simplex face = simplex;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
        columns.back().insert(simplices[d - 1].at(face));
      }
    }
    ranks[d] = RankModulo2(columns);
  }
  const auto betti = [&](std::size_t d)
  { return static_cast<Id>(simplices[d].size()) - ranks[d] - ranks[d + 1]; };
  EXPECT_EQ(betti(3), 0);
  return { betti(0), betti(1), betti(2) };
}
} // namespace testhomology
