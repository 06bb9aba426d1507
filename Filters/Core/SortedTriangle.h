// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Types.h"

#include <utility>

namespace insideout
{
/** A triangle's points in ascending order, and whether that order turned it over. */
struct SortedTriangle
{
  explicit SortedTriangle(Triangle t)
  {
    const auto order = [&](int i, int j)
    {
      if (t[i] > t[j])
      {
        std::swap(t[i], t[j]);
        this->Turned = !this->Turned;
      }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    this->Points = t;
  }

  Triangle Points;
  bool Turned = false;
};

/** For tables of triangles. */
struct HashOfTriangle
{
  std::size_t operator()(const Triangle& t) const
  {
    std::size_t hash = 0;
    for (const Id point : t)
    {
      hash = (hash ^ static_cast<std::size_t>(point)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};
} // namespace insideout
