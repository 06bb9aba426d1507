// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlipTarget.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace testflips;

namespace
{
using testmeshes::Clip;
using testmeshes::Cross;
using testmeshes::Dot;
using testmeshes::Minus;

constexpr int CostOfEdge = 3;

/** The part of the way from a to b in a triangle's plane and within its edges. */
std::vector<Vector> PartInTriangle(const std::vector<Vector>& way, const std::array<Vector, 3>& t)
{
  const Vector normal = Cross(Minus(t[1], t[0]), Minus(t[2], t[0]));
  std::vector<Vector> part = Clip(way, t[0], normal);
  part = Clip(part, t[0], Minus({ Rational(0), Rational(0), Rational(0) }, normal));
  for (int k = 0; k < 3; ++k)
  {
    part = Clip(part, t[k], Cross(normal, Minus(t[(k + 1) % 3], t[k])));
  }
  return part;
}

/** Where two points lie on either side of a plane. */
bool AreApart(const Vector& a, const Vector& b, const Vector& on, const Vector& normal)
{
  return Dot(Minus(a, on), normal) * Dot(Minus(b, on), normal) < 0;
}

/** Whether the way from one to the other passes from one side of the triangle to the other. */
bool Pierces(const Vector& a, const Vector& b, const std::array<Vector, 3>& t)
{
  const Vector normal = Cross(Minus(t[1], t[0]), Minus(t[2], t[0]));
  return AreApart(a, b, t[0], normal) && !PartInTriangle({ a, b }, t).empty();
}

/** Whether two segments have one point in common, within both. */
bool Cross(const Vector& a, const Vector& b, const Vector& x, const Vector& y)
{
  const Vector normal = testmeshes::Cross(Minus(b, a), Minus(y, x));
  return Dot(normal, normal) != 0 && Dot(Minus(x, a), normal) == 0 &&
    AreApart(a, b, x, testmeshes::Cross(normal, Minus(y, x))) &&
    AreApart(x, y, a, testmeshes::Cross(normal, Minus(b, a)));
}

/** Vertices of a small grid, where everything degenerate happens. */
struct Vertices
{
  explicit Vertices(unsigned seed)
    : Mesh(DelaunayMesh(AnyPoints(seed, 24)))
    , Places(MeshRecord(Mesh).Places)
    , Random(seed)
  {
  }

  Id Any()
  {
    return static_cast<Id>(this->Random() % static_cast<unsigned>(this->Mesh.Infinite()));
  }

  Id AnyBut(const std::vector<Id>& others)
  {
    Id vertex = this->Any();
    while (std::find(others.begin(), others.end(), vertex) != others.end())
    {
      vertex = this->Any();
    }
    return vertex;
  }

  FlippableMesh Mesh;
  std::vector<Vector> Places;
  std::mt19937 Random;
};
} // namespace

TEST(FlipTarget, ASegmentIsBarredByFacesThatItPassesThroughAndByEdgesThatItCrosses)
{
  int faces = 0;
  int edges = 0;
  for (const unsigned seed : { 1u, 3u, 5u, 2u })
  {
    Vertices v(seed);
    for (int k = 0; k < 1200; ++k)
    {
      const Id a = v.Any();
      const Id b = v.AnyBut({ a });
      const Id x = v.AnyBut({ a, b });
      const Id y = v.AnyBut({ a, b, x });
      const Id z = v.AnyBut({ a, b, x, y });
      const FlipTarget target = FlipTarget::Segment(v.Mesh, a, b);
      const bool pierces =
        Pierces(v.Places[a], v.Places[b], { v.Places[x], v.Places[y], v.Places[z] });
      ASSERT_EQ(target.CostOfFace(x, y, z), pierces ? 1 : 0)
        << seed << ": " << a << ' ' << b << ' ' << x << ' ' << y << ' ' << z;
      const bool crosses = Cross(v.Places[a], v.Places[b], v.Places[x], v.Places[y]);
      ASSERT_EQ(target.CostOfEdge(x, y), crosses ? CostOfEdge : 0)
        << seed << ": " << a << ' ' << b << ' ' << x << ' ' << y;
      faces += pierces ? 1 : 0;
      edges += crosses ? 1 : 0;
      // Cells at its ends do not obstruct it.
      EXPECT_EQ(target.CostOfFace(a, y, z), 0);
      EXPECT_EQ(target.CostOfFace(x, b, z), 0);
      EXPECT_EQ(target.CostOfEdge(a, y), 0);
      EXPECT_EQ(target.CostOfEdge(x, b), 0);
    }
  }
  EXPECT_GT(faces, 100);
  EXPECT_GT(edges, 20);
}

TEST(FlipTarget, AFacetIsBarredByEdgesThatPassThroughItAndByNoFace)
{
  int edges = 0;
  int onBoundary = 0;
  for (const unsigned seed : { 1u, 3u, 5u, 2u })
  {
    Vertices v(seed);
    for (int k = 0; k < 1200; ++k)
    {
      const Id a = v.Any();
      const Id b = v.AnyBut({ a });
      const Id c = v.AnyBut({ a, b });
      const Id x = v.AnyBut({ a, b, c });
      const Id y = v.AnyBut({ a, b, c, x });
      const FlipTarget target = FlipTarget::Facet(v.Mesh, { { a, b, c } });
      const bool pierces =
        Pierces(v.Places[x], v.Places[y], { v.Places[a], v.Places[b], v.Places[c] });
      ASSERT_EQ(target.CostOfEdge(x, y), pierces ? CostOfEdge : 0)
        << seed << ": " << a << ' ' << b << ' ' << c << ' ' << x << ' ' << y;
      edges += pierces ? 1 : 0;
      onBoundary += pierces && Cross(v.Places[a], v.Places[b], v.Places[x], v.Places[y]) ? 1 : 0;
      EXPECT_EQ(target.CostOfEdge(a, y), 0);
      EXPECT_EQ(target.CostOfFace(x, y, a), 0);
    }
  }
  EXPECT_GT(edges, 100);
  EXPECT_GT(onBoundary, 5);
}

TEST(FlipTarget, NothingIsInTheWayOfNoTargetNorWhatIsInfiniteOfAny)
{
  Vertices v(1);
  const FlipTarget nothing(v.Mesh);
  const Id infinite = v.Mesh.Infinite();
  for (int k = 0; k < 300; ++k)
  {
    const Id a = v.Any();
    const Id b = v.AnyBut({ a });
    const Id c = v.AnyBut({ a, b });
    const Id x = v.AnyBut({ a, b, c });
    const Id y = v.AnyBut({ a, b, c, x });
    EXPECT_EQ(nothing.CostOfEdge(x, y), 0);
    EXPECT_EQ(nothing.CostOfFace(x, y, a), 0);
    for (const FlipTarget& target :
      { FlipTarget::Segment(v.Mesh, a, b), FlipTarget::Facet(v.Mesh, { { a, b, c } }) })
    {
      EXPECT_EQ(target.CostOfEdge(x, infinite), 0);
      EXPECT_EQ(target.CostOfFace(x, infinite, y), 0);
    }
  }
}
