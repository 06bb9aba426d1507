// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Topology.h"

#include "Common/Stages.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{
using namespace insideout;
using Simplex = std::vector<Id>;

/** The rank of a matrix of 0 and 1, of numbers modulo 2, by its columns' rows that hold 1. */
int RankModulo2(std::vector<std::set<int>> columns)
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
BettiNumbers ByHomology(const std::vector<Simplex>& tops)
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

SolidTopology Find(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Monitor silent;
  const ProgressRange progress = { Stages::Extracting, 0, 1 };
  return FindTopology(
    mesh, inside, BoundaryFaces(mesh, inside, silent, progress), silent, progress);
}

void ExpectThatOfHomology(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Monitor silent;
  std::vector<Simplex> cells;
  std::vector<Simplex> faces;
  for (std::size_t cell = 0; cell < inside.size(); ++cell)
  {
    if (inside[cell])
    {
      cells.emplace_back(mesh.Cells[cell].begin(), mesh.Cells[cell].end());
    }
  }
  for (const BoundaryFace& face : BoundaryFaces(mesh, inside, silent, { Stages::Extracting, 0, 1 }))
  {
    faces.emplace_back(face.Corners.begin(), face.Corners.end());
  }
  const SolidTopology found = Find(mesh, inside);
  const BettiNumbers solid = ByHomology(cells);
  const BettiNumbers boundary = ByHomology(faces);
  EXPECT_EQ(found.Solid.Components, solid.Components);
  EXPECT_EQ(found.Solid.Tunnels, solid.Tunnels);
  EXPECT_EQ(found.Solid.Cavities, solid.Cavities);
  EXPECT_EQ(found.Boundary.Components, boundary.Components);
  EXPECT_EQ(found.Boundary.Tunnels, boundary.Tunnels);
  EXPECT_EQ(found.Boundary.Cavities, boundary.Cavities);
}
} // namespace

TEST(Topology, IsThatOfHomologyWhateverTouches)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const TetrahedralMesh mesh = testtetrahedra::Grid(seed, 3);
    ExpectThatOfHomology(mesh, testtetrahedra::RandomInside(mesh, seed));
  }
}

/** Of 5 x 5 x 5 cubes those that `isInside` is true for, by the middles of their cells. */
template <typename Predicate>
std::vector<unsigned char> Cubes(const TetrahedralMesh& mesh, const Predicate& isInside)
{
  std::vector<unsigned char> inside;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    std::array<int, 3> cube;
    for (int axis = 0; axis < 3; ++axis)
    {
      double sum = 0;
      for (const Id p : cell)
      {
        sum += mesh.Points[p][axis] / 4;
      }
      cube[axis] = static_cast<int>(sum / 100);
    }
    inside.push_back(isInside(cube[0], cube[1], cube[2]) ? 1 : 0);
  }
  return inside;
}

TEST(Topology, OfARingAHollowBallAndTwoParts)
{
  const TetrahedralMesh mesh = testtetrahedra::EvenGrid(5);
  const auto within = [](int i) { return i > 0 && i < 4; };
  const SolidTopology ring = Find(mesh,
    Cubes(mesh,
      [&](int i, int j, int k)
      { return within(i) && within(j) && k == 2 && !(i == 2 && j == 2); }));
  EXPECT_EQ(ring.Solid.Components, 1);
  EXPECT_EQ(ring.Solid.Tunnels, 1);
  EXPECT_EQ(ring.Solid.Cavities, 0);
  EXPECT_EQ(ring.Boundary.Tunnels, 2);
  const SolidTopology hollow = Find(mesh,
    Cubes(mesh,
      [&](int i, int j, int k)
      { return within(i) && within(j) && within(k) && !(i == 2 && j == 2 && k == 2); }));
  EXPECT_EQ(hollow.Solid.Tunnels, 0);
  EXPECT_EQ(hollow.Solid.Cavities, 1);
  EXPECT_EQ(hollow.Solid.EulerCharacteristic(), 2);
  EXPECT_EQ(hollow.Boundary.Components, 2);
  const SolidTopology parts =
    Find(mesh, Cubes(mesh, [](int i, int j, int k) { return (i == 0 || i == 3) && j + k < 2; }));
  EXPECT_EQ(parts.Solid.Components, 2);
  const SolidTopology nothing = Find(mesh, std::vector<unsigned char>(mesh.Cells.size(), 0));
  EXPECT_EQ(nothing.Solid.EulerCharacteristic(), 0);
  EXPECT_EQ(nothing.Solid.Cavities, 0);
}
