// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SegmentTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace insideout;

namespace
{
using Path = std::vector<Id>;

/** A tetrahedron's faces. */
const std::vector<Triangle> Faces = { { { 4, 7, 9 } }, { { 7, 4, 5 } }, { { 9, 7, 5 } },
  { { 4, 9, 5 } } };

/** Expect that just the pieces and points of the paths are found, under their segments' names. */
void ExpectPaths(const SegmentTable& table, const std::map<Id, Path>& paths, Id vertices)
{
  std::map<std::array<Id, 2>, Id> pieces;
  std::map<Id, Id> inner;
  for (const auto& [segment, path] : paths)
  {
    EXPECT_EQ(table.Path(segment), path);
    EXPECT_EQ(table.IsSplit(segment), path.size() > 2);
    for (std::size_t k = 1; k < path.size(); ++k)
    {
      pieces[{ { std::min(path[k - 1], path[k]), std::max(path[k - 1], path[k]) } }] = segment;
      if (k + 1 < path.size())
      {
        EXPECT_EQ(table.NeighborsOnPath(segment, path[k]),
          (std::array<Id, 2>{ { path[k - 1], path[k + 1] } }));
        inner[path[k]] = segment;
      }
    }
  }
  for (Id v = 0; v < vertices; ++v)
  {
    ASSERT_EQ(table.Around(v), inner.count(v) > 0 ? inner[v] : None) << v;
    for (Id u = 0; u < v; ++u)
    {
      const auto piece = pieces.find({ { u, v } });
      const Id expected = piece == pieces.end() ? None : piece->second;
      ASSERT_EQ(table.Find(u, v), expected) << u << ' ' << v;
      ASSERT_EQ(table.Find(v, u), expected) << v << ' ' << u;
    }
  }
}

std::map<Id, Path> WholePaths(const SegmentTable& table)
{
  std::map<Id, Path> paths;
  for (Id segment = 0; segment < table.Size(); ++segment)
  {
    paths[segment] = { table.EndsOf(segment)[0], table.EndsOf(segment)[1] };
  }
  return paths;
}
} // namespace

TEST(SegmentTable, HasEachEdgeOfFacetsOnceLowerEndFirst)
{
  const SegmentTable table(Faces);
  ASSERT_EQ(table.Size(), 6);
  for (std::size_t facet = 0; facet < Faces.size(); ++facet)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id u = Faces[facet][k];
      const Id v = Faces[facet][(k + 1) % 3];
      const Id segment = table.OfFacet(static_cast<Id>(facet), k);
      EXPECT_EQ(table.EndsOf(segment), (std::array<Id, 2>{ { std::min(u, v), std::max(u, v) } }));
      EXPECT_EQ(table.Find(u, v), segment);
    }
  }
  ExpectPaths(table, WholePaths(table), 12);
}

TEST(SegmentTable, SplitsAndJoinsInAnyOrder)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    std::mt19937 random(seed);
    SegmentTable table(Faces);
    std::map<Id, Path> paths = WholePaths(table);
    Id vertices = 10;
    int joins = 0;
    for (int k = 0; k < 60; ++k)
    {
      const Id segment = static_cast<Id>(random() % 6);
      Path& path = paths[segment];
      if (random() % 5 < 3 || path.size() == 2)
      {
        const auto at = static_cast<std::ptrdiff_t>(random() % (path.size() - 1));
        const bool turned = random() % 2 == 0;
        table.Split(segment, path[at + turned], path[at + !turned], vertices);
        path.insert(path.begin() + at + 1, vertices++);
      }
      else
      {
        const auto at = static_cast<std::ptrdiff_t>(1 + random() % (path.size() - 2));
        table.Join(segment, path[at]);
        path.erase(path.begin() + at);
        ++joins;
      }
      ExpectPaths(table, paths, vertices);
    }
    EXPECT_GT(joins, 5);
  }
}

TEST(SegmentTable, LetsGoOfASegmentWithAllItsPiecesAndHasItAgainWhole)
{
  SegmentTable table(Faces);
  const std::map<Id, Path> whole = WholePaths(table);
  const Id segment = table.Find(7, 9);
  table.Split(segment, 9, 7, 10);
  table.Split(segment, 7, 10, 11);
  std::map<Id, Path> rest = whole;
  rest[segment] = { 7, 11, 10, 9 };
  ExpectPaths(table, rest, 12);
  table.Release(segment);
  rest.erase(segment);
  ExpectPaths(table, rest, 12);
  table.Restore(segment);
  ExpectPaths(table, whole, 12);
}

TEST(SegmentTable, RestoringASegmentThatIsThereChangesNothing)
{
  SegmentTable table(Faces);
  std::map<Id, Path> paths = WholePaths(table);
  const Id segment = table.Find(4, 5);
  table.Split(segment, 4, 5, 10);
  paths[segment] = { 4, 10, 5 };
  for (Id s = 0; s < table.Size(); ++s)
  {
    table.Restore(s);
  }
  ExpectPaths(table, paths, 11);
}

TEST(SegmentTable, ReleasingASegmentTwiceChangesNothing)
{
  SegmentTable table(Faces);
  std::map<Id, Path> paths = WholePaths(table);
  const Id segment = table.Find(4, 9);
  paths.erase(segment);
  table.Release(segment);
  table.Release(segment);
  ExpectPaths(table, paths, 10);
}

TEST(SegmentTable, CopiesGoTheirOwnWays)
{
  SegmentTable table(Faces);
  const std::map<Id, Path> whole = WholePaths(table);
  const SegmentTable before = table;
  table.Split(table.Find(4, 7), 4, 7, 10);
  table.Release(table.Find(5, 9));
  ExpectPaths(before, whole, 11);
  table = before;
  ExpectPaths(table, whole, 11);
}
