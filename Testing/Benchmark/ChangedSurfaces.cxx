// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChangedSurfaces.h"

#include <algorithm>
#include <map>
#include <random>

namespace benchmark
{
using namespace insideout;

TriangleSoup Subdivided(const TriangleSoup& soup)
{
  TriangleSoup fine;
  fine.Points = soup.Points;
  std::map<std::array<Id, 2>, Id> midpoints;
  const auto between = [&](Id p, Id q)
  {
    const Id next = static_cast<Id>(fine.Points.size());
    const auto inserted = midpoints.insert({ { std::min(p, q), std::max(p, q) }, next });
    if (inserted.second)
    {
      Point middle;
      for (int k = 0; k < 3; ++k)
      {
        middle[k] = (soup.Points[p][k] + soup.Points[q][k]) / 2;
      }
      fine.Points.push_back(middle);
    }
    return inserted.first->second;
  };
  for (const Triangle& t : soup.Triangles)
  {
    const Triangle m = { between(t[0], t[1]), between(t[1], t[2]), between(t[2], t[0]) };
    fine.Triangles.insert(fine.Triangles.end(),
      { { t[0], m[0], m[2] }, { t[1], m[1], m[0] }, { t[2], m[2], m[1] }, m });
  }
  return fine;
}

TriangleSoup WithHoles(const TriangleSoup& soup, int holes, std::size_t edgesPerHole)
{
  std::map<std::array<Id, 2>, std::vector<std::size_t>> trianglesOfEdge;
  const auto edge = [&](std::size_t t, int k)
  {
    const Triangle& corners = soup.Triangles[t];
    return std::array<Id, 2>{ std::min(corners[k], corners[(k + 1) % 3]),
      std::max(corners[k], corners[(k + 1) % 3]) };
  };
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      trianglesOfEdge[edge(t, k)].push_back(t);
    }
  }
  std::vector<char> gone(soup.Triangles.size(), 0);
  std::mt19937 random(1);
  for (int hole = 0; hole < holes; ++hole)
  {
    std::vector<std::size_t> patch = { random() % soup.Triangles.size() };
    std::map<std::array<Id, 2>, int> rim; // its edges, with how many of the patch's triangles
    std::vector<char> seen(soup.Triangles.size(), 0);
    seen[patch[0]] = 1;
    std::size_t edges = 0;
    for (std::size_t next = 0; next < patch.size() && edges < edgesPerHole; ++next)
    {
      gone[patch[next]] = 1;
      for (int k = 0; k < 3; ++k)
      {
        edges += ++rim[edge(patch[next], k)] == 1 ? 1 : -1;
        for (const std::size_t t : trianglesOfEdge[edge(patch[next], k)])
        {
          if (!seen[t])
          {
            seen[t] = 1;
            patch.push_back(t);
          }
        }
      }
    }
  }
  TriangleSoup rest;
  rest.Points = soup.Points;
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    if (!gone[t])
    {
      rest.Triangles.push_back(soup.Triangles[t]);
    }
  }
  return rest;
}
} // namespace benchmark
