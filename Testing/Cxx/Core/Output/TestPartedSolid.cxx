// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/ManifoldBoundary.h"

#include "Common/Error.h"
#include "Common/Stages.h"
#include "GraphCut/ConnectCells.h"
#include "Support/CutReference.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace
{
using namespace insideout;
using testtetrahedra::EvenGrid;
using testtetrahedra::Grid;
using testtetrahedra::RandomInside;

const ProgressRange Whole = { Stages::Extracting, 0, 1 };

struct Split
{
  PartedSolid Solid;
  std::vector<BoundaryFace> Faces;
  ManifoldSurface Boundary;
};

Split SplitAll(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Monitor silent;
  Split split;
  split.Solid = UnpartedSolid(mesh, inside);
  PartPoints(split.Solid, std::vector<unsigned char>(mesh.Points.size(), 1), silent, Whole);
  split.Faces = BoundaryFaces(split.Solid.Mesh, inside, silent, Whole);
  split.Boundary = ManifoldBoundary(split.Solid, split.Faces, silent, Whole);
  return split;
}

/** Every edge has two triangles, which run through it in opposite directions; those at every point
 * are one fan. */
void ExpectManifold(const std::vector<Triangle>& triangles)
{
  std::set<std::pair<Id, Id>> edges;
  std::map<Id, std::map<Id, Id>> around; // per point from one neighbor to the next
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(edges.insert({ t[k], t[(k + 1) % 3] }).second);
      around[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
    }
  }
  for (const auto& [p, q] : edges)
  {
    EXPECT_EQ(edges.count({ q, p }), 1);
  }
  for (const auto& [point, next] : around)
  {
    std::size_t length = 0;
    Id at = next.begin()->first;
    do
    {
      ++length;
      at = next.at(at);
    } while (at != next.begin()->first && length <= next.size());
    EXPECT_EQ(length, next.size());
  }
}

/** Which pairs of cells have a face in common, of cells inside. */
std::set<std::pair<Id, Id>> Connections(
  const std::vector<Tetrahedron>& cells, const std::vector<unsigned char>& inside)
{
  std::map<std::set<Id>, Id> first;
  std::set<std::pair<Id, Id>> pairs;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (int k = 0; inside[c] != 0 && k < 4; ++k)
    {
      const Triangle face = FaceOf(cells[c], k);
      const auto [found, isNew] =
        first.insert({ { face.begin(), face.end() }, static_cast<Id>(c) });
      if (!isNew)
      {
        pairs.insert({ found->second, static_cast<Id>(c) });
      }
    }
  }
  return pairs;
}

/** The cubes of a grid (all six tetrahedra of each) whose corners nearest to 0 are given, in
 * hundreds. */
std::vector<unsigned char> InsideCubes(
  const TetrahedralMesh& mesh, const std::set<std::array<int, 3>>& cubes)
{
  std::vector<unsigned char> inside;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    std::array<int, 3> low = { 1000, 1000, 1000 };
    for (const Id p : cell)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], static_cast<int>(mesh.Points[p][axis]) / 100);
      }
    }
    inside.push_back(cubes.count(low) != 0);
  }
  return inside;
}

std::vector<unsigned char> AllButCubes(
  const TetrahedralMesh& mesh, const std::set<std::array<int, 3>>& cubes)
{
  std::vector<unsigned char> inside = InsideCubes(mesh, cubes);
  for (unsigned char& label : inside)
  {
    label = !label;
  }
  return inside;
}

Id Copies(const Split& split, const TetrahedralMesh& mesh)
{
  return static_cast<Id>(split.Solid.Mesh.Points.size() - mesh.Points.size());
}
} // namespace

TEST(PartedSolid, HasAManifoldBoundaryWhateverIsInside)
{
  int copies = 0;
  int shared = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 3 + seed % 3);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    const Split split = SplitAll(mesh, inside);
    ExpectManifold(split.Boundary.Triangles);
    EXPECT_EQ(split.Boundary.LeftEdges, 0);
    copies += Copies(split, mesh);
    shared += split.Boundary.SharedPoints;
  }
  EXPECT_GT(copies, 1000);
  EXPECT_GT(shared, 400);
}

TEST(PartedSolid, IsTheSameButForPointIds)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 4);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    const Split split = SplitAll(mesh, inside);
    std::vector<Tetrahedron> placed = split.Solid.Mesh.Cells;
    for (Tetrahedron& cell : placed)
    {
      for (Id& p : cell)
      {
        EXPECT_EQ(split.Solid.Mesh.Points[p], mesh.Points[split.Solid.Places[p]]);
        p = split.Solid.Places[p];
      }
    }
    EXPECT_EQ(placed, mesh.Cells);
    EXPECT_EQ(Connections(split.Solid.Mesh.Cells, inside), Connections(mesh.Cells, inside));
    for (std::size_t f = 0; f < split.Faces.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Id p = split.Boundary.Triangles[f][k];
        EXPECT_EQ(split.Boundary.Places[p], split.Faces[f].Corners[k]);
      }
    }
  }
}

/** Points of which a copy would part nothing have none. */
TEST(PartedSolid, CopiesNothingThatIsManifold)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 3);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    const Split once = SplitAll(mesh, inside);
    PartedSolid twice = once.Solid;
    Monitor silent;
    PartPoints(twice, std::vector<unsigned char>(twice.Mesh.Points.size(), 1), silent, Whole);
    EXPECT_EQ(twice.Mesh.Cells, once.Solid.Mesh.Cells);
    const testcut::NotManifold left = testcut::CountNotManifold(once.Solid.Mesh.Cells, inside);
    EXPECT_EQ(left.Edges + left.Points == 0, once.Boundary.SharedPoints == 0);
  }
  const TetrahedralMesh mesh = EvenGrid(3);
  const Split whole = SplitAll(mesh, std::vector<unsigned char>(mesh.Cells.size(), 1));
  EXPECT_EQ(Copies(whole, mesh), 0);
  EXPECT_EQ(whole.Boundary.SharedPoints, 0);
}

TEST(PartedSolid, CubesThatTouchAreTwo)
{
  const TetrahedralMesh mesh = EvenGrid(2);
  const Split inEdge = SplitAll(mesh, InsideCubes(mesh, { { 0, 0, 0 }, { 1, 1, 0 } }));
  EXPECT_EQ(Copies(inEdge, mesh), 2) << "an edge";
  EXPECT_EQ(inEdge.Boundary.SharedPoints, 0);
  const Split inPoint = SplitAll(mesh, InsideCubes(mesh, { { 0, 0, 0 }, { 1, 1, 1 } }));
  EXPECT_EQ(Copies(inPoint, mesh), 1) << "a point";
  EXPECT_EQ(inPoint.Boundary.SharedPoints, 0);
}

/** Cells all around: only the surface can be parted. */
TEST(PartedSolid, CavitiesThatTouchAreTwoSurfaces)
{
  const TetrahedralMesh mesh = EvenGrid(4);
  const Split inPoint = SplitAll(mesh, AllButCubes(mesh, { { 1, 1, 1 }, { 2, 2, 2 } }));
  EXPECT_EQ(Copies(inPoint, mesh), 0);
  EXPECT_EQ(inPoint.Boundary.SharedPoints, 1);
  ExpectManifold(inPoint.Boundary.Triangles);
  const Split inEdge = SplitAll(mesh, AllButCubes(mesh, { { 1, 1, 1 }, { 2, 2, 1 } }));
  EXPECT_EQ(Copies(inEdge, mesh), 0);
  EXPECT_EQ(inEdge.Boundary.SharedPoints, 2);
  ExpectManifold(inEdge.Boundary.Triangles);
}

/** Two notches in the hull's surface meet in an edge: beyond the hull is one space. */
TEST(PartedSolid, KnowsTheSpaceBeyondTheHull)
{
  const TetrahedralMesh mesh = EvenGrid(3);
  const Split split = SplitAll(mesh, AllButCubes(mesh, { { 1, 1, 2 }, { 2, 2, 2 }, { 0, 1, 1 } }));
  ExpectManifold(split.Boundary.Triangles);
  EXPECT_EQ(split.Boundary.LeftEdges, 0);
}

TEST(PartedSolid, NeedsALabelPerCell)
{
  EXPECT_THROW(UnpartedSolid(EvenGrid(1), {}), Error);
}

TEST(PartedSolid, CanBeStopped)
{
  const TetrahedralMesh mesh = Grid(1, 10);
  const std::vector<unsigned char> inside = RandomInside(mesh, 2);
  const int reports = testmeshes::StopAtEveryReport(
    [&](Monitor& monitor, const ProgressRange& range)
    {
      PartedSolid solid = UnpartedSolid(mesh, inside);
      PartPoints(solid, std::vector<unsigned char>(mesh.Points.size(), 1), monitor,
        { range.Stage, range.Begin, range.At(0.5) });
      Monitor silent;
      ManifoldBoundary(solid, BoundaryFaces(solid.Mesh, inside, silent, Whole), monitor,
        { range.Stage, range.At(0.5), range.End });
    });
  EXPECT_GT(reports, 2);
}
