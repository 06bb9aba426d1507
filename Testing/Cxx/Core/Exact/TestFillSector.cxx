// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FillSector.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace testflips;

namespace
{
/** The sector of cells around a vertex. */
Sector SectorOf(const FlippableMesh& mesh, Id vertex, const std::vector<Id>& cells)
{
  Sector sector;
  for (const Id cell : cells)
  {
    const int k = mesh.CornerIndex(cell, vertex);
    Triangle wall;
    for (int j = 0; j < 3; ++j)
    {
      wall[j] = CellAt(mesh, cell).Corners[FaceSeenFrom[k][j]];
    }
    sector.Walls.push_back(wall);
    sector.Corners.insert(sector.Corners.end(), wall.begin(), wall.end());
  }
  std::sort(sector.Corners.begin(), sector.Corners.end());
  sector.Corners.erase(
    std::unique(sector.Corners.begin(), sector.Corners.end()), sector.Corners.end());
  return sector;
}

/** A mesh with vertex 0 inside, and the star around that. */
struct Star
{
  explicit Star(FlippableMesh mesh)
    : Mesh(std::move(mesh))
  {
    this->Mesh.Star(0, this->Cells);
    this->Walls = SectorOf(this->Mesh, 0, this->Cells);
  }

  /** Whether a corner sees all walls, in rational numbers. */
  bool HasCornerThatSeesAll() const
  {
    const MeshRecord record(this->Mesh);
    const auto& at = record.Places;
    return std::any_of(this->Walls.Corners.begin(), this->Walls.Corners.end(),
      [&](Id corner)
      {
        return std::all_of(this->Walls.Walls.begin(), this->Walls.Walls.end(),
          [&](const Triangle& w)
          {
            return std::find(w.begin(), w.end(), corner) != w.end() ||
              SixfoldVolume(at[w[0]], at[w[1]], at[w[2]], at[corner]) > 0;
          });
      });
  }

  bool Fill(VolumePoints volumePoints, std::vector<Tetrahedron>& fresh)
  {
    return FillSectors(
      this->Mesh, { this->Walls }, this->Mesh.Vertices().Nearest(0), volumePoints, fresh);
  }

  FlippableMesh Mesh;
  std::vector<Id> Cells;
  Sector Walls;
};

/** Points in all directions around vertex 0, near and far: seen from there alone. */
Star SpikyStar(unsigned seed, int spikes, double nearest, double thickness)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> radius(nearest, 1);
  std::vector<Point> directions = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { -1, 0, 0 } },
    { { 0, 1, 0 } }, { { 0, -1, 0 } }, { { 0, 0, 1 } }, { { 0, 0, -1 } } };
  for (int k = 6; k < spikes; ++k)
  {
    Point p = { { normal(random), normal(random), normal(random) } };
    const double length = std::hypot(p[0], p[1], p[2]);
    directions.push_back({ { p[0] / length, p[1] / length, p[2] / length } });
  }
  FlippableMesh mesh = DelaunayMesh(directions);
  for (Id p = 1; p <= spikes; ++p)
  {
    const double r = radius(random);
    const Point& d = directions[p];
    mesh.MoveVertex(p, Point{ { r * d[0], r * d[1], r * d[2] * thickness } });
  }
  return Star(std::move(mesh));
}

/** Expect that cells are positive and have the volume of others in whose place they can be. */
void ExpectFilled(
  FlippableMesh& mesh, const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh)
{
  const MeshRecord record(mesh);
  const auto volumeOf = [&record](const Tetrahedron& t)
  {
    const Rational volume = SixfoldVolume(
      record.Places[t[0]], record.Places[t[1]], record.Places[t[2]], record.Places[t[3]]);
    EXPECT_GT(volume, 0);
    return volume;
  };
  Rational before = 0;
  for (const Id cell : old)
  {
    before += volumeOf(record.Cells[cell].Corners);
  }
  Rational after = 0;
  for (const Tetrahedron& t : fresh)
  {
    after += volumeOf(t);
  }
  EXPECT_EQ(before, after);
  EXPECT_NO_THROW(mesh.Replace(old, fresh));
}
} // namespace

TEST(FillSector, FillsWhatACornerSeesFromThereWithoutANewPoint)
{
  int filled = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    Star star(DelaunayMesh(
      [seed]()
      {
        std::mt19937 random(seed);
        std::vector<Point> points = RandomPoints(random, 14);
        points[0] = { { 0.5, 0.5, 0.5 } };
        return points;
      }()));
    const MeshRecord before(star.Mesh);
    if (std::any_of(star.Cells.begin(), star.Cells.end(),
          [&](Id cell) { return star.Mesh.IsInfinite(cell); }) ||
      !star.HasCornerThatSeesAll())
    {
      continue;
    }
    std::vector<Tetrahedron> fresh;
    ASSERT_TRUE(star.Fill(VolumePoints::AsNeeded, fresh));
    EXPECT_EQ(star.Mesh.Vertices().Size(), static_cast<Id>(before.Places.size()));
    ExpectFilled(star.Mesh, star.Cells, fresh);
    EXPECT_FALSE(star.Mesh.HasVertex(0));
    ExpectFlippableMeshLaws(star.Mesh, before);
    ++filled;
  }
  EXPECT_GT(filled, 2);
}

TEST(FillSector, FillsWhatNoCornerSeesFromANewPointAndOnlyWhereThatIsAllowed)
{
  int withPoint = 0;
  int without = 0;
  for (unsigned seed = 1; seed <= 30; ++seed)
  {
    Star star = SpikyStar(seed, 40, 0.3, 1);
    const MeshRecord before(star.Mesh);
    const bool isSeen = star.HasCornerThatSeesAll();
    std::vector<Tetrahedron> fresh;
    EXPECT_EQ(star.Fill(VolumePoints::None, fresh), isSeen);
    ExpectUnchanged(star.Mesh, before);
    fresh.clear();
    ASSERT_TRUE(star.Fill(VolumePoints::AsNeeded, fresh));
    EXPECT_EQ(
      star.Mesh.Vertices().Size(), static_cast<Id>(before.Places.size()) + (isSeen ? 0 : 1));
    ExpectFilled(star.Mesh, star.Cells, fresh);
    (isSeen ? without : withPoint) += 1;
  }
  EXPECT_GT(withPoint, 10);
  EXPECT_GT(without, 0);
}

TEST(FillSector, FindsNewPointsInSectorsThatAreThin)
{
  for (const double thickness : { 1e-4, 1e-8, 1e-12 })
  {
    for (unsigned seed = 1; seed <= 8; ++seed)
    {
      Star star = SpikyStar(seed, 12, 0.3, thickness);
      std::vector<Tetrahedron> fresh;
      ASSERT_TRUE(star.Fill(VolumePoints::AsNeeded, fresh)) << seed << ' ' << thickness;
      ExpectFilled(star.Mesh, star.Cells, fresh);
    }
  }
}

TEST(FillSector, FillsNothingWhereNoPointSeesAll)
{
  // Two cells far apart are one sector; each alone can be filled.
  FlippableMesh mesh = DelaunayMesh(AnyPoints(2, 40));
  const std::vector<Id> cells = FiniteCells(mesh);
  const auto areApart = [&](Id a, Id b)
  {
    const Tetrahedron& t = CellAt(mesh, a).Corners;
    return std::none_of(t.begin(), t.end(), [&](Id corner) { return mesh.Has(b, corner); });
  };
  const Id other =
    *std::find_if(cells.begin(), cells.end(), [&](Id cell) { return areApart(cells[0], cell); });
  Sector both;
  for (const Id cell : { cells[0], other })
  {
    for (int k = 0; k < 4; ++k)
    {
      const Tetrahedron& t = CellAt(mesh, cell).Corners;
      both.Walls.push_back(
        { { t[FaceSeenFrom[k][0]], t[FaceSeenFrom[k][1]], t[FaceSeenFrom[k][2]] } });
      both.Corners.push_back(t[k]);
    }
  }
  Sector one = both;
  one.Walls.resize(4);
  one.Corners.resize(4);
  const MeshRecord before(mesh);
  const Point inside = mesh.Vertices().Nearest(one.Corners[0]);
  for (const VolumePoints volumePoints : { VolumePoints::None, VolumePoints::AsNeeded })
  {
    std::vector<Tetrahedron> fresh;
    EXPECT_FALSE(FillSectors(mesh, { both }, inside, volumePoints, fresh));
    ExpectUnchanged(mesh, before);
    fresh.clear();
    EXPECT_TRUE(FillSectors(mesh, { one }, inside, volumePoints, fresh));
    EXPECT_EQ(fresh.size(), 1u);
  }
}

TEST(FillSector, TakesNewPointsBackWhereALaterSectorCannotBeFilled)
{
  unsigned seed = 1;
  while (SpikyStar(seed, 40, 0.3, 1).HasCornerThatSeesAll())
  {
    ++seed;
  }
  Star star = SpikyStar(seed, 40, 0.3, 1);
  Sector turned = star.Walls;
  for (Triangle& wall : turned.Walls)
  {
    std::swap(wall[0], wall[1]);
  }
  const MeshRecord before(star.Mesh);
  std::vector<Tetrahedron> fresh;
  EXPECT_FALSE(FillSectors(
    star.Mesh, { star.Walls, star.Walls, turned }, { { 0, 0, 0 } }, VolumePoints::AsNeeded, fresh));
  ExpectUnchanged(star.Mesh, before);
}

TEST(FillSector, ConnectsWallsOfASectorBeyondTheHullWithInfinity)
{
  FlippableMesh mesh = DelaunayMesh(AnyPoints(2, 10));
  Sector sector;
  sector.IsInfinite = true;
  sector.Walls = { { { 0, 1, 2 } }, { { 2, 1, 3 } } };
  std::vector<Tetrahedron> fresh;
  ASSERT_TRUE(FillSectors(mesh, { sector }, { { 0, 0, 0 } }, VolumePoints::None, fresh));
  const Id infinite = mesh.Infinite();
  EXPECT_EQ(
    fresh, (std::vector<Tetrahedron>{ { { 0, 1, 2, infinite } }, { { 2, 1, 3, infinite } } }));
}
