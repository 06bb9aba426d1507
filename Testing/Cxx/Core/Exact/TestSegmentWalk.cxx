// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SegmentWalk.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace testflips;

namespace
{
using testmeshes::Cross;
using testmeshes::Dot;
using testmeshes::Minus;

std::vector<Crossing> Walk(const FlippableMesh& mesh, Id a, Id b)
{
  std::vector<Crossing> crossings(1, FirstCrossing(mesh, a, b));
  while (crossings.back().Kind == Crossing::ThroughFace ||
    crossings.back().Kind == Crossing::ThroughEdge)
  {
    crossings.push_back(NextCrossing(mesh, a, b, crossings.back()));
  }
  return crossings;
}

std::vector<Crossing::KindOfCrossing> KindsOf(const FlippableMesh& mesh, Id a, Id b)
{
  std::vector<Crossing::KindOfCrossing> kinds;
  for (const Crossing& crossing : Walk(mesh, a, b))
  {
    kinds.push_back(crossing.Kind);
  }
  return kinds;
}

using Kinds = std::vector<Crossing::KindOfCrossing>;

/** A straight way through a mesh, in rational numbers. */
struct Way
{
  const FlippableMesh& Mesh;
  const MeshRecord& Record;
  Id A;
  Id B;

  Vector At(const Rational& share) const
  {
    const Vector along = Minus(this->Record.Places[this->B], this->Record.Places[this->A]);
    Vector at = this->Record.Places[this->A];
    for (int k = 0; k < 3; ++k)
    {
      at[k] += share * along[k];
    }
    return at;
  }

  /** How a point of the way lies to the faces of a cell: positive within. */
  std::array<Rational, 4> Heights(Id cell, const Vector& point) const
  {
    std::array<Rational, 4> heights;
    for (int k = 0; k < 4; ++k)
    {
      std::array<Vector, 4> corners;
      for (int j = 0; j < 4; ++j)
      {
        corners[j] = j == k ? point : this->Record.Places[CellAt(this->Mesh, cell).Corners[j]];
      }
      heights[k] = SixfoldVolume(corners[0], corners[1], corners[2], corners[3]);
    }
    return heights;
  }

  /** Whether a point is in a cell, its boundary included. */
  bool IsIn(Id cell, const Vector& point) const
  {
    const std::array<Rational, 4> heights = this->Heights(cell, point);
    return std::all_of(
      heights.begin(), heights.end(), [](const Rational& height) { return height >= 0; });
  }

  /** The share of the way at which it passes the plane of a face. */
  Rational ShareAt(Id cell, int face) const
  {
    const Rational atA = this->Heights(cell, this->Record.Places[this->A])[face];
    const Rational atB = this->Heights(cell, this->Record.Places[this->B])[face];
    EXPECT_NE(atA, atB);
    return atA / (atA - atB);
  }

  /** The share at which it is nearest to an edge that it crosses. */
  Rational ShareAtEdge(Id u, Id v) const
  {
    const Vector along = Minus(this->Record.Places[this->B], this->Record.Places[this->A]);
    const Vector edge = Minus(this->Record.Places[v], this->Record.Places[u]);
    const Vector normal = Cross(along, edge);
    EXPECT_NE(Dot(normal, normal), 0);
    const Vector toEdge = Minus(this->Record.Places[u], this->Record.Places[this->A]);
    return Dot(Cross(toEdge, edge), normal) / Dot(normal, normal);
  }

  /** Whether a vertex lies within the way. */
  bool HasWithin(Id vertex) const
  {
    const Vector along = Minus(this->Record.Places[this->B], this->Record.Places[this->A]);
    const Vector to = Minus(this->Record.Places[vertex], this->Record.Places[this->A]);
    const Vector aside = Cross(along, to);
    return Dot(aside, aside) == 0 && Dot(to, along) > 0 && Dot(to, along) < Dot(along, along);
  }

  bool PassesVertex() const
  {
    bool passes = false;
    for (Id vertex = 0; vertex < this->Record.Infinite; ++vertex)
    {
      passes = passes || this->HasWithin(vertex);
    }
    return passes;
  }
};

/** Expect that each crossing is one, that nothing is between two of them, and the right end. */
void ExpectRightWay(const Way& way)
{
  const std::vector<Crossing> crossings = Walk(way.Mesh, way.A, way.B);
  Rational before = 0;
  for (std::size_t k = 0; k < crossings.size(); ++k)
  {
    const Crossing& crossing = crossings[k];
    Rational share = 1;
    if (crossing.Kind == Crossing::ThroughFace)
    {
      share = way.ShareAt(crossing.Cell, crossing.Face);
      const std::array<Rational, 4> heights = way.Heights(crossing.Cell, way.At(share));
      for (int j = 0; j < 4; ++j)
      {
        ASSERT_TRUE(j == crossing.Face ? heights[j] == 0 : heights[j] > 0);
      }
      ASSERT_TRUE(way.IsIn(crossing.Cell, way.At((before + share) / 2))) << "it comes from there";
    }
    else if (crossing.Kind == Crossing::ThroughEdge)
    {
      share = way.ShareAtEdge(crossing.U, crossing.V);
      ASSERT_TRUE(
        way.Mesh.Has(crossing.Cell, crossing.U) && way.Mesh.Has(crossing.Cell, crossing.V));
      const std::array<Rational, 4> heights = way.Heights(crossing.Cell, way.At(share));
      for (int j = 0; j < 4; ++j)
      {
        const Id corner = CellAt(way.Mesh, crossing.Cell).Corners[j];
        const bool isEnd = corner == crossing.U || corner == crossing.V;
        ASSERT_TRUE(isEnd ? heights[j] > 0 : heights[j] == 0);
      }
      ASSERT_TRUE(way.IsIn(crossing.Cell, way.At((before + share) / 2))) << "it comes from there";
    }
    else if (crossing.Kind == Crossing::AtEnd)
    {
      ASSERT_TRUE(way.Mesh.Has(crossing.Cell, way.B));
      ASSERT_FALSE(way.PassesVertex());
      ASSERT_TRUE(
        way.Mesh.IsInfinite(crossing.Cell) || way.IsIn(crossing.Cell, way.At((before + 1) / 2)));
    }
    else
    {
      ASSERT_TRUE(way.PassesVertex());
      ASSERT_TRUE(crossing.U == None || way.HasWithin(crossing.U));
    }
    ASSERT_TRUE(share > before && share <= 1);
    before = share;
  }
}
} // namespace

TEST(SegmentWalk, PassesThroughTheFaceBetweenTwoCells)
{
  const FlippableMesh mesh = MeshOfCells(
    { { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } }, { { 2, 2, 9 } }, { { 3, 3, -9 } } },
    Pyramids({ { { 0, 1, 2 } } }, { 3, 4 }));
  EXPECT_EQ(KindsOf(mesh, 3, 4), (Kinds{ Crossing::ThroughFace, Crossing::AtEnd }));
  const Crossing first = FirstCrossing(mesh, 3, 4);
  EXPECT_EQ(CellAt(mesh, first.Cell).Corners[first.Face], 3);
  EXPECT_EQ(KindsOf(mesh, 0, 4), (Kinds{ Crossing::AtEnd }));
}

TEST(SegmentWalk, PassesOverEdgesOfAPlane)
{
  // A hexagon in fans from corner 0, with a pyramid on either side: from 1 to 5 over three edges.
  const FlippableMesh mesh =
    MeshOfCells({ { { 0, 3, 0 } }, { { 3, 2, 0 } }, { { 3, -2, 0 } }, { { 0, -3, 0 } },
                  { { -3, -2, 0 } }, { { -3, 2, 0 } }, { { 0, 0, 4 } }, { { 0, 0, -4 } } },
      Pyramids({ { { 0, 1, 2 } }, { { 0, 2, 3 } }, { { 0, 3, 4 } }, { { 0, 4, 5 } } }, { 6, 7 }));
  EXPECT_EQ(KindsOf(mesh, 1, 5),
    (Kinds{
      Crossing::ThroughEdge, Crossing::ThroughEdge, Crossing::ThroughEdge, Crossing::AtEnd }));
  for (const Crossing& crossing : Walk(mesh, 1, 5))
  {
    if (crossing.Kind == Crossing::ThroughEdge)
    {
      EXPECT_EQ(std::min(crossing.U, crossing.V), 0);
    }
  }
  // From above to below through the middle, where an edge is.
  EXPECT_EQ(KindsOf(mesh, 6, 7), (Kinds{ Crossing::ThroughEdge, Crossing::AtEnd }));
}

TEST(SegmentWalk, EndsWhereAVertexIsInTheWay)
{
  // The center of a cube, and corners across from each other: along two edges.
  std::vector<Point> points(1, { { 4, 4, 4 } });
  for (int k = 0; k < 8; ++k)
  {
    points.push_back({ { 8.0 * (k & 1), 8.0 * (k >> 1 & 1), 8.0 * (k >> 2) } });
  }
  const FlippableMesh mesh = DelaunayMesh(points);
  for (Id corner = 1; corner <= 8; ++corner)
  {
    const Crossing first = FirstCrossing(mesh, corner, 9 - corner);
    EXPECT_EQ(first.Kind, Crossing::AtVertex);
    EXPECT_EQ(first.U, 0);
  }
}

TEST(SegmentWalk, EndsAtAVertexBehindAFace)
{
  // The way from 3 passes through the face 0 1 2 and then through the vertex 4, on to 5.
  const FlippableMesh mesh = MeshOfCells({ { { 6, 0, 0 } }, { { -6, 6, 0 } }, { { -6, -6, 0 } },
                                           { { 0, 0, 4 } }, { { 0, 0, -2 } }, { { 0, 0, -8 } } },
    { { { 0, 1, 2, 3 } }, { { 0, 1, 2, 4 } }, { { 0, 1, 4, 5 } }, { { 1, 2, 4, 5 } },
      { { 0, 2, 4, 5 } } });
  EXPECT_EQ(KindsOf(mesh, 3, 5), (Kinds{ Crossing::ThroughFace, Crossing::AtVertex }));
  EXPECT_EQ(KindsOf(mesh, 5, 3), (Kinds{ Crossing::AtVertex }));
  EXPECT_EQ(FirstCrossing(mesh, 5, 3).U, 4);
}

TEST(SegmentWalk, FromAVertexThatIsInNoCellLeadsNowhere)
{
  FlippableMesh mesh = DelaunayMesh(AnyPoints(2, 8));
  const Id vertex = mesh.AddVertex({ { 0.5, 0.5, 0.5 } });
  const Crossing crossing = FirstCrossing(mesh, vertex, 0);
  EXPECT_EQ(crossing.Kind, Crossing::AtVertex);
  EXPECT_EQ(crossing.Cell, None);
}

TEST(SegmentWalk, CrossesWhatIsThereAndNothingElse)
{
  int ends = 0;
  int vertices = 0;
  std::size_t longest = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    MeshWithFacets mesh(DelaunayMesh(AnyPoints(seed, 18)), {});
    std::mt19937 random(seed);
    mesh.FlipAtRandom(random, 40);
    const MeshRecord record(mesh.Mesh);
    for (int k = 0; k < 40; ++k)
    {
      const Id a = static_cast<Id>(random() % 18);
      const Id b = static_cast<Id>((a + 1 + random() % 17) % 18);
      const Way way = { mesh.Mesh, record, a, b };
      ExpectRightWay(way);
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << seed << ": " << a << ' ' << b;
      const std::vector<Crossing> crossings = Walk(mesh.Mesh, a, b);
      ends += crossings.back().Kind == Crossing::AtEnd ? 1 : 0;
      vertices += crossings.back().Kind == Crossing::AtVertex ? 1 : 0;
      longest = std::max(longest, crossings.size());
    }
  }
  EXPECT_GT(ends, 200);
  EXPECT_GT(vertices, 5);
  EXPECT_GT(longest, 6u);
}
