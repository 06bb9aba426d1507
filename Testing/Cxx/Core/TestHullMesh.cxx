// SPDX-License-Identifier: GPL-3.0-or-later
#include "HullMesh.h"

#include "Common/Team.h"
#include "GraphCut/SegmentMesh.h"
#include "Support/AllowedThreads.h"
#include "Support/BodiesOfSoups.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

/** Everything that a mesh says, once it is labelled. */
struct Whole
{
  Whole(const std::vector<TriangleSoup>& soups)
  {
    Monitor monitor;
    this->Hull = MeshHull(BodiesOf(soups), {}, monitor);
    this->Inside = SegmentMesh(this->Hull.Mesh, this->Hull.W, {}, {}, {}, monitor).Inside;
  }

  HullMesh Hull;
  std::vector<unsigned char> Inside;
};

void ExpectSame(const Whole& a, const Whole& b)
{
  EXPECT_EQ(a.Hull.Surface.Points, b.Hull.Surface.Points);
  EXPECT_EQ(a.Hull.Surface.Facets, b.Hull.Surface.Facets);
  EXPECT_EQ(a.Hull.Surface.Multiplicity, b.Hull.Surface.Multiplicity);
  EXPECT_EQ(a.Hull.Surface.SourceOffsets, b.Hull.Surface.SourceOffsets);
  EXPECT_EQ(a.Hull.Mesh.Points, b.Hull.Mesh.Points);
  EXPECT_EQ(a.Hull.Mesh.Cells, b.Hull.Mesh.Cells);
  EXPECT_EQ(a.Hull.Mesh.Neighbors, b.Hull.Mesh.Neighbors);
  EXPECT_EQ(a.Hull.Mesh.Facets, b.Hull.Mesh.Facets);
  EXPECT_EQ(a.Hull.Mesh.FacetSides, b.Hull.Mesh.FacetSides);
  EXPECT_EQ(a.Hull.W, b.Hull.W);
  EXPECT_EQ(a.Inside, b.Inside);
}

/** Boxes that cross, touch, and have facets in common, some twice and some turned. */
TriangleSoup RandomBoxes(unsigned seed)
{
  std::mt19937 random(seed);
  TriangleSoup all;
  for (int k = 0; k < 5; ++k)
  {
    const Point low = { static_cast<double>(random() % 4), static_cast<double>(random() % 4),
      static_cast<double>(random() % 8) / 2 };
    const TriangleSoup box = Box(low, { low[0] + 1 + random() % 2, low[1] + 1, low[2] + 1.25 });
    all = Join(all, random() % 3 == 0 ? Reversed(box) : box);
  }
  return all;
}

TEST(HullMesh, IsTheSameForAnyNumberOfThreads)
{
  const WholeTeams teams;
  for (const std::vector<TriangleSoup>& soups :
    { std::vector<TriangleSoup>{ RandomBoxes(1) }, std::vector<TriangleSoup>{ RandomSoup(2, 25) },
      std::vector<TriangleSoup>{ RandomBoxes(3), RandomBoxes(4) } })
  {
    const auto meshed = [&soups](int threads)
    {
      const testthreads::Allowed allowed(threads);
      return Whole(soups);
    };
    const Whole one = meshed(1);
    EXPECT_FALSE(one.Hull.Mesh.Cells.empty());
    for (const int threads : { 2, 8 })
    {
      ExpectSame(meshed(threads), one);
    }
  }
}
} // namespace
