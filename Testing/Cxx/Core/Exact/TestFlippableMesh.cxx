// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlippableMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace insideout;

namespace
{
/** Points on a sphere and its centre, which has an edge to each: stars of all sizes. */
std::vector<Point> BallWithCentre(int size)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Point> points(1, { { 0, 0, 0 } });
  for (int k = 0; k < size; ++k)
  {
    Point p = { { normal(random), normal(random), normal(random) } };
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p)
    {
      x /= length;
    }
    points.push_back(p);
  }
  return points;
}
} // namespace

TEST(FlippableMesh, FindsAnEdgeWhereAndOnlyWhereACellHasBothEnds)
{
  Monitor monitor;
  WorkBudget work;
  std::vector<Id> same;
  const FlippableMesh mesh(BallWithCentre(150), same, work, monitor);
  std::set<std::array<Id, 2>> edges;
  for (Id id = 0; id < mesh.NumberOfCells(); ++id)
  {
    const FlippableCell& cell = mesh.Cell(id);
    for (int i = 0; !mesh.IsDead(id) && i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        edges.insert({ { cell.Corners[i], cell.Corners[j] } });
      }
    }
  }
  int found = 0;
  for (Id u = 0; u <= mesh.Infinite(); ++u)
  {
    for (Id v = 0; v <= mesh.Infinite(); ++v)
    {
      const Id cell = mesh.FindEdge(u, v);
      ASSERT_EQ(cell != None, edges.count({ { u, v } }) > 0) << u << ' ' << v;
      if (cell != None)
      {
        ++found;
        ASSERT_TRUE(mesh.Has(cell, u) && mesh.Has(cell, v));
      }
    }
  }
  EXPECT_EQ(found, static_cast<int>(edges.size()));
}

TEST(FlippableMesh, FindsManyFacesAsItFindsEachAlone)
{
  Monitor monitor;
  WorkBudget work;
  std::vector<Id> same;
  const FlippableMesh mesh(BallWithCentre(40), same, work, monitor);
  std::vector<Triangle> triangles;
  for (Id a = 0; a < mesh.Infinite(); ++a)
  {
    for (Id b = 0; b < a; ++b)
    {
      for (Id c = 0; c < b; ++c)
      {
        triangles.push_back({ { b, a, c } });
        triangles.push_back({ { c, b, a } });
      }
    }
  }
  const std::vector<MeshFace> together = mesh.FindFaces(triangles);
  ASSERT_EQ(together.size(), triangles.size());
  int found = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Triangle& t = triangles[i];
    Id cell;
    int face;
    const bool isFace = mesh.FindFace(t[0], t[1], t[2], cell, face);
    for (const MeshFace& one : { together[i], mesh.FindFaces({ t })[0] })
    {
      ASSERT_EQ(one.Cell != None, isFace) << t[0] << ' ' << t[1] << ' ' << t[2];
      for (const Id corner : t)
      {
        ASSERT_TRUE(!isFace || mesh.Has(one.Cell, corner));
        ASSERT_TRUE(!isFace || mesh.Cell(one.Cell).Corners[one.Face] != corner);
      }
    }
    found += isFace ? 1 : 0;
  }
  // Of each cell four faces, half of which are another's, twice each; and not the infinite ones.
  int faces = 0;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    faces += mesh.IsDead(cell) ? 0 : mesh.IsInfinite(cell) ? 1 : 4;
  }
  EXPECT_EQ(found, faces);
}
