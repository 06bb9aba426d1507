// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Regions.h"

#include "Common/DisjointSets.h"
#include "Common/Error.h"
#include "Common/Stages.h"
#include "GraphCut/ConnectCells.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;
using testtetrahedra::RandomInside;

SolidRegions Find(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Monitor silent;
  return FindRegions(mesh, inside, silent, { Stages::Extracting, 0, 1 });
}

/** By the points of faces alone. */
std::vector<Id> RegionsByUnion(
  const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  DisjointSets sets(mesh.Cells.size());
  std::map<Triangle, Id> cellOfFace;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; inside[cell] != 0 && k < 4; ++k)
    {
      Triangle face = FaceOf(mesh.Cells[cell], k);
      std::sort(face.begin(), face.end());
      sets.Join(cellOfFace.insert({ face, cell }).first->second, cell);
    }
  }
  std::map<Id, Id> numbers;
  std::vector<Id> regions(mesh.Cells.size(), None);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (inside[cell] != 0)
    {
      const Id next = static_cast<Id>(numbers.size());
      regions[cell] = numbers.insert({ sets.Find(cell), next }).first->second;
    }
  }
  return regions;
}
} // namespace

TEST(Regions, AreWhatFacesConnectNumberedByTheirFirstCell)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 4);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    const SolidRegions found = Find(mesh, inside);
    EXPECT_EQ(found.OfCell, RegionsByUnion(mesh, inside));
    EXPECT_EQ(found.Count, *std::max_element(found.OfCell.begin(), found.OfCell.end()) + 1);
  }
}

TEST(Regions, CellsThatShareAnEdgeOrAPointAreTwo)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0, -1, 0 }, { 0, 0, -1 }, { -1, 0, 0 } };
  const Tetrahedron first = { 0, 1, 2, 3 };
  const auto count = [&](const Tetrahedron& second) {
    return Find(ConnectCells(points, { first, second }), { 1, 1 }).Count;
  };
  EXPECT_EQ(count({ 0, 3, 2, 6 }), 1) << "a face";
  EXPECT_EQ(count({ 0, 1, 4, 5 }), 2) << "an edge";
  EXPECT_EQ(count({ 0, 4, 5, 6 }), 2) << "a point";
}

TEST(Regions, LeavingOutTheOutsideChangesNoNumber)
{
  const TetrahedralMesh mesh = Grid(3, 4);
  const std::vector<unsigned char> inside = RandomInside(mesh, 4);
  const SolidRegions whole = Find(mesh, inside);
  std::vector<Tetrahedron> cells;
  std::vector<Id> expected;
  for (std::size_t cell = 0; cell < inside.size(); ++cell)
  {
    EXPECT_EQ(whole.OfCell[cell] == None, inside[cell] == 0);
    if (inside[cell] != 0)
    {
      cells.push_back(mesh.Cells[cell]);
      expected.push_back(whole.OfCell[cell]);
    }
  }
  const std::vector<unsigned char> all(cells.size(), 1);
  EXPECT_EQ(Find(ConnectCells(mesh.Points, cells), all).OfCell, expected);
}

TEST(Regions, OfNothingAreNone)
{
  const TetrahedralMesh mesh = Grid(1, 2);
  EXPECT_EQ(Find(mesh, std::vector<unsigned char>(mesh.Cells.size(), 0)).Count, 0);
  EXPECT_EQ(Find({}, {}).Count, 0);
  EXPECT_THROW(Find(mesh, {}), Error);
}

TEST(Regions, CanBeStopped)
{
  const TetrahedralMesh mesh = Grid(1, 12); // 10,368 cells
  const int reports =
    testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
      { FindRegions(mesh, std::vector<unsigned char>(mesh.Cells.size(), 1), monitor, range); });
  EXPECT_GT(reports, 1);
}
