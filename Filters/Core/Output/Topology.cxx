// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Topology.h"

#include "Common/Buckets.h"
#include "Common/DisjointSets.h"
#include "Common/ParallelLoop.h"
#include "Output/Regions.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <set>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerPoint = 400;

/** The number of distinct edges of triangles or tetrahedra. */
template <std::size_t Size>
Id CountEdges(std::size_t points, const std::vector<std::array<Id, Size>>& cells)
{
  Buckets<Id> ends(points,
    [&](const auto& visit)
    {
      for (const std::array<Id, Size>& cell : cells)
      {
        for (std::size_t i = 0; i < Size; ++i)
        {
          for (std::size_t j = i + 1; j < Size; ++j)
          {
            const auto [low, high] = std::minmax(cell[i], cell[j]);
            visit(static_cast<std::size_t>(low), high);
          }
        }
      }
    });
  std::atomic<Id> edges{ 0 };
  ParallelLoop(points, NanosecondsPerPoint,
    [&](std::size_t p)
    {
      ends.Sort(p, std::less<Id>());
      const auto higher = ends[p];
      Id different = 0;
      for (const Id* end = higher.begin(); end != higher.end(); ++end)
      {
        different += end == higher.begin() || *end != end[-1];
      }
      edges += different;
    });
  return edges;
}

struct PointCounts
{
  Id Used = 0;
  Id Components = 0; ///< components of the points that cells use
};

template <std::size_t Size>
PointCounts CountPoints(std::size_t points, const std::vector<std::array<Id, Size>>& cells)
{
  DisjointSets sets(points);
  std::vector<unsigned char> isUsed(points, 0);
  for (const std::array<Id, Size>& cell : cells)
  {
    for (const Id p : cell)
    {
      isUsed[p] = 1;
      sets.Join(cell[0], p);
    }
  }
  PointCounts counts;
  for (std::size_t p = 0; p < points; ++p)
  {
    const Id id = static_cast<Id>(p);
    counts.Used += isUsed[p];
    counts.Components += isUsed[p] && sets.Find(id) == id;
  }
  return counts;
}

/** The components of the outside, connected through faces, that do not reach beyond the hull. */
Id CountCavities(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<unsigned char> isOpen =
    FindOutside(mesh.Neighbors, inside, monitor, progress).IsOpen;
  return static_cast<Id>(std::count(isOpen.begin(), isOpen.end(), 0));
}

SolidTopology FromCounts(std::size_t points, const std::vector<Tetrahedron>& cells,
  const std::vector<Triangle>& boundary, Id regions, Id cavities)
{
  SolidTopology topology;
  const PointCounts ofSolid = CountPoints(points, cells);
  const Id tetrahedra = static_cast<Id>(cells.size());
  const Id triangles = static_cast<Id>(boundary.size());
  topology.Solid.Components = ofSolid.Components;
  topology.Solid.Cavities = cavities;
  // Each face of a cell is another's, too, or on the boundary.
  const Id eulerOfSolid =
    ofSolid.Used - CountEdges(points, cells) + (4 * tetrahedra + triangles) / 2 - tetrahedra;
  topology.Solid.Tunnels = topology.Solid.Components + cavities - eulerOfSolid;

  const PointCounts ofBoundary = CountPoints(points, boundary);
  topology.Boundary.Components = ofBoundary.Components;
  topology.Boundary.Cavities = regions + cavities;
  const Id eulerOfBoundary = ofBoundary.Used - CountEdges(points, boundary) + triangles;
  topology.Boundary.Tunnels =
    topology.Boundary.Components + topology.Boundary.Cavities - eulerOfBoundary;
  return topology;
}

/** The triangles at each edge with more than two; edges of two join their triangles into sets. */
std::vector<std::vector<Id>> JoinAtEdges(const std::vector<Triangle>& triangles, DisjointSets& sets)
{
  using EdgeOfTriangle = std::array<Id, 3>; // its points, and the triangle
  std::vector<EdgeOfTriangle> edges;
  for (Id t = 0; t < static_cast<Id>(triangles.size()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      edges.push_back({ { low, high, t } });
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::vector<Id>> crowded;
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last = std::find_if(first, edges.end(),
      [&](const EdgeOfTriangle& edge) { return edge[0] != (*first)[0] || edge[1] != (*first)[1]; });
    if (last - first == 2)
    {
      sets.Join((*first)[2], first[1][2]);
    }
    else
    {
      crowded.emplace_back();
      std::for_each(first, last, [&](const EdgeOfTriangle& e) { crowded.back().push_back(e[2]); });
    }
    first = last;
  }
  return crowded;
}

/**
 * The dimension of the space of 2-cycles modulo 2 (sets of triangles with an even number at every
 * edge): the second Betti number. Triangles joined by edges of two are all in a cycle or none is;
 * each edge of more triangles is an equation between these groups, and each independent equation
 * reduces the dimension by one.
 */
Id CountClosedSurfaces(const std::vector<Triangle>& triangles)
{
  DisjointSets sets(triangles.size());
  const std::vector<std::vector<Id>> crowded = JoinAtEdges(triangles, sets);
  Id closed = 0;
  for (Id t = 0; t < static_cast<Id>(triangles.size()); ++t)
  {
    closed += sets.Find(t) == t;
  }
  std::map<Id, std::set<Id>> equations; // by their last group
  for (const std::vector<Id>& edge : crowded)
  {
    std::set<Id> equation;
    const auto add = [&](Id whole)
    {
      if (!equation.insert(whole).second)
      {
        equation.erase(whole);
      }
    };
    std::for_each(edge.begin(), edge.end(), [&](Id triangle) { add(sets.Find(triangle)); });
    for (auto known = equations.end();
         !equation.empty() && (known = equations.find(*equation.rbegin())) != equations.end();)
    {
      std::for_each(known->second.begin(), known->second.end(), add);
    }
    if (!equation.empty())
    {
      equations[*equation.rbegin()] = equation;
      --closed;
    }
  }
  return closed;
}

void Append(const std::string& prefix, const BettiNumbers& numbers, Statistics& statistics)
{
  statistics.emplace_back(prefix + "Components", numbers.Components);
  statistics.emplace_back(prefix + "Tunnels", numbers.Tunnels);
  statistics.emplace_back(prefix + "Cavities", numbers.Cavities);
  statistics.emplace_back(prefix + "EulerCharacteristic", numbers.EulerCharacteristic());
}
} // namespace

SolidTopology FindTopology(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  const std::vector<BoundaryFace>& boundary, Monitor& monitor, const ProgressRange& progress)
{
  const Id regions =
    FindRegions(mesh, inside, monitor, { progress.Stage, progress.Begin, progress.At(0.3) }).Count;
  std::vector<Tetrahedron> cells;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (inside[cell])
    {
      cells.push_back(mesh.Cells[cell]);
    }
  }
  std::vector<Triangle> faces;
  for (const BoundaryFace& face : boundary)
  {
    faces.push_back(face.Corners);
  }
  const Id cavities =
    CountCavities(mesh, inside, monitor, { progress.Stage, progress.At(0.3), progress.At(0.6) });
  const SolidTopology topology = FromCounts(mesh.Points.size(), cells, faces, regions, cavities);
  monitor.Check(progress, 1);
  return topology;
}

SolidTopology FindTopology(std::size_t points, const std::vector<Tetrahedron>& cells,
  const std::vector<Triangle>& boundary, Id regions)
{
  return FromCounts(points, cells, boundary, regions, CountClosedSurfaces(boundary) - regions);
}

void AppendTopology(const SolidTopology& topology, Statistics& statistics)
{
  Append("Solid", topology.Solid, statistics);
  Append("Boundary", topology.Boundary, statistics);
  statistics.emplace_back("Genus", topology.Boundary.Tunnels / 2.0);
}
} // namespace insideout
