// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Topology.h"

#include "Common/Stages.h"
#include "Output/Regions.h"
#include "Support/Homology.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

namespace
{
using namespace insideout;
using testhomology::ByHomology;
using testhomology::Simplex;
using testtetrahedra::Cubes;

SolidTopology Find(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Monitor silent;
  const ProgressRange progress = { Stages::Extracting, 0, 1 };
  return FindTopology(
    mesh, inside, BoundaryFaces(mesh, inside, silent, progress), silent, progress);
}

/** The same from the boundary of the inside cells only. */
void ExpectTheSameWithoutTheHull(
  const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside, const SolidTopology& found)
{
  Monitor silent;
  const ProgressRange progress = { Stages::Extracting, 0, 1 };
  std::vector<Tetrahedron> cells;
  std::vector<Triangle> boundary;
  for (std::size_t cell = 0; cell < inside.size(); ++cell)
  {
    if (inside[cell])
    {
      cells.push_back(mesh.Cells[cell]);
    }
  }
  for (const BoundaryFace& face : BoundaryFaces(mesh, inside, silent, progress))
  {
    boundary.push_back(face.Corners);
  }
  const SolidTopology alone = FindTopology(
    mesh.Points.size(), cells, boundary, FindRegions(mesh, inside, silent, progress).Count);
  EXPECT_EQ(alone.Solid.Components, found.Solid.Components);
  EXPECT_EQ(alone.Solid.Tunnels, found.Solid.Tunnels);
  EXPECT_EQ(alone.Solid.Cavities, found.Solid.Cavities);
  EXPECT_EQ(alone.Boundary.Tunnels, found.Boundary.Tunnels);
  EXPECT_EQ(alone.Boundary.Cavities, found.Boundary.Cavities);
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
  ExpectTheSameWithoutTheHull(mesh, inside, found);
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
