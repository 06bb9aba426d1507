// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactVertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace insideout;

namespace
{
/** Doubles, and Steiner points on edges and in planes of them, some of them a rounding error apart.
 */
class Vertices
{
public:
  /** @param[in] exponents of two that coordinates have at most, up and down */
  Vertices(unsigned seed, int exponents)
    : Random(seed)
    , Exact(Points(exponents), this->Work)
  {
    for (int k = 0; k < 8; ++k)
    {
      this->AddOnEdge();
      this->AddInPlane();
    }
    for (int k = 0; k < 20; ++k)
    {
      this->AddBeside(this->Any());
    }
  }

  ExactVertices& Get() { return this->Exact; }

  Id Any() { return this->Any(this->Exact.Size()); }

  /** Any four vertices, or of those that lie nearly in one plane. */
  Tetrahedron Four()
  {
    const std::vector<Id>* group =
      this->Random() % 2 == 0 ? &this->Groups[this->Random() % this->Groups.size()] : nullptr;
    Tetrahedron four;
    for (Id& v : four)
    {
      v = group == nullptr ? this->Any() : (*group)[this->Random() % group->size()];
    }
    return four;
  }

private:
  static constexpr Id NumberOfDoubles = 12;

  std::vector<Point> Points(int exponents)
  {
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::uniform_int_distribution<int> exponent(-exponents, exponents);
    std::vector<Point> points;
    for (Id p = 0; p < NumberOfDoubles; ++p)
    {
      points.emplace_back();
      for (double& x : points.back())
      {
        x = std::ldexp(coordinate(this->Random), exponent(this->Random));
      }
      if (p % 4 == 3)
      {
        points.back()[p % 3] = points[p - 1][p % 3];
      }
    }
    return points;
  }

  Id Any(Id below) { return static_cast<Id>(this->Random() % static_cast<unsigned>(below)); }

  DyadicNumber Part() { return DyadicNumber(static_cast<double>(1 + this->Random() % 1000000)); }

  void AddOnEdge()
  {
    const Id a = this->Any(NumberOfDoubles);
    const Id b = (a + 1 + this->Any(NumberOfDoubles - 1)) % NumberOfDoubles;
    this->Exact.AddBetween(a, b, this->Part(), this->Part(), { { a, b, b } });
  }

  void AddInPlane()
  {
    const Id f = this->Any(NumberOfDoubles - 2);
    const Id u = this->Any();
    const Id v = this->Any();
    const DyadicNumber atU = this->Exact.Determinant(f, f + 1, f + 2, u);
    const DyadicNumber atV = this->Exact.Determinant(f, f + 1, f + 2, v);
    if (atU.sign() * atV.sign() < 0)
    {
      this->Exact.AddBetween(u, v, DyadicNumber(0) - atV, atU, { { f, f + 1, f + 2 } });
    }
  }

  /** A vertex's nearest double, points of edges from there, and what all of them lie beside. */
  void AddBeside(Id vertex)
  {
    const Id near = this->Exact.Add(this->Exact.Nearest(vertex));
    const Id f = this->Any(NumberOfDoubles - 2);
    std::vector<Id> group = { f, f + 1, f + 2, vertex, near };
    for (Id corner = f; corner < f + 3; ++corner)
    {
      group.push_back(this->Exact.AddBetween(
        near, corner, this->Part(), this->Part(), { { near, corner, corner } }));
      group.push_back(this->Exact.Add(this->Exact.Nearest(group.back())));
    }
    this->Groups.push_back(group);
  }

  std::mt19937 Random;
  WorkBudget Work;
  ExactVertices Exact;
  std::vector<std::vector<Id>> Groups;
};

/** @return how often the four were in one plane */
int CheckOrientations(unsigned seed, int exponents)
{
  Vertices vertices(seed, exponents);
  const ExactVertices& exact = vertices.Get();
  int coplanar = 0;
  for (int trial = 0; trial < 4000; ++trial)
  {
    const Tetrahedron v = vertices.Four();
    const int expected = exact.Determinant(v[0], v[1], v[2], v[3]).sign();
    EXPECT_EQ(exact.Orient(v[0], v[1], v[2], v[3]), expected)
      << "seed " << seed << ": " << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3];
    coplanar += expected == 0 ? 1 : 0;
  }
  return coplanar;
}

/** Expect the plane that exact determinants tell, to a few units in the last place. */
void ExpectPlane(Vertices& vertices, const Triangle& v, const Point& origin)
{
  ExactVertices& exact = vertices.Get();
  const Id at = exact.Add(origin);
  const DyadicNumber offset = DyadicNumber(0) - exact.Determinant(v[0], v[1], v[2], at);
  exact.RemoveLast();
  std::array<DyadicNumber, 3> normal;
  double size = 0;
  for (int k = 0; k < 3; ++k)
  {
    std::array<Id, 2> ends;
    for (const int end : { 0, 1 })
    {
      Point onAxis = { { 0, 0, 0 } };
      onAxis[k] = end;
      ends[end] = exact.Add(onAxis);
    }
    normal[k] =
      exact.Determinant(v[0], v[1], v[2], ends[1]) - exact.Determinant(v[0], v[1], v[2], ends[0]);
    exact.RemoveLast();
    exact.RemoveLast();
    size = std::max(size, std::abs(CGAL::to_double(normal[k])));
  }
  const ExactVertices::Plane plane = exact.PlaneThrough(v[0], v[1], v[2], origin);
  double planesSize = 0;
  for (const double x : plane.Normal)
  {
    planesSize = std::max(planesSize, std::abs(x));
  }
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(plane.Normal[k] / planesSize, CGAL::to_double(normal[k]) / size, 1e-15);
  }
  const double expected = CGAL::to_double(offset) / size;
  EXPECT_NEAR(plane.Offset / planesSize, expected, 2e-15 * std::abs(expected))
    << v[0] << ' ' << v[1] << ' ' << v[2];
}
} // namespace

TEST(ExactVertices, APlaneHasAllDigitsHoweverNearItsPointsAreToALineOrToTheOrigin)
{
  int planes = 0;
  int throughOrigin = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    Vertices vertices(seed, 0);
    for (int trial = 0; trial < 400; ++trial)
    {
      const Tetrahedron v = vertices.Four();
      const Point origin = vertices.Get().Nearest(v[3]);
      // Four points of a line have no plane.
      const Id any = vertices.Any();
      if (vertices.Get().Orient(v[0], v[1], v[2], any) != 0)
      {
        ExpectPlane(vertices, { { v[0], v[1], v[2] } }, origin);
        ++planes;
        throughOrigin += vertices.Get().Orient(v[0], v[1], v[2], v[3]) == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(planes, 2000);
  EXPECT_GT(throughOrigin, 100);
}

TEST(ExactVertices, ForgettingWhatIsNotInUseChangesNoPredicateOfTheRest)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    Vertices vertices(seed, 0);
    ExactVertices& exact = vertices.Get();
    const auto isInUse = [seed](Id vertex)
    { return vertex < 12 || (static_cast<unsigned>(vertex) + seed) % 3 != 0; };
    std::vector<Tetrahedron> cells;
    std::vector<int> signs;
    while (cells.size() < 500)
    {
      const Tetrahedron v = vertices.Four();
      if (std::all_of(v.begin(), v.end(), isInUse))
      {
        cells.push_back(v);
        signs.push_back(exact.Orient(v[0], v[1], v[2], v[3]));
      }
    }
    exact.ForgetExactly(isInUse);
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
      const Tetrahedron& v = cells[k];
      EXPECT_EQ(exact.Orient(v[0], v[1], v[2], v[3]), signs[k]);
      EXPECT_EQ(exact.Determinant(v[0], v[1], v[2], v[3]).sign(), signs[k]);
    }
    const Id size = exact.Size();
    const Id added = exact.AddBetween(0, 1, DyadicNumber(2), DyadicNumber(1), { { 0, 1, 1 } });
    EXPECT_EQ(exact.Orient(0, 1, 2, added), 0);
    while (exact.Size() > size - 5)
    {
      exact.RemoveLast();
    }
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
      const Tetrahedron& v = cells[k];
      if (*std::max_element(v.begin(), v.end()) < exact.Size())
      {
        EXPECT_EQ(exact.Orient(v[0], v[1], v[2], v[3]), signs[k]);
      }
    }
  }
}

/** So near to a plane or line that only exact numbers tell the side. */
constexpr double Tiny = 1e-100;

TEST(ExactVertices, AVertexThatLeavesAPlaneIsNoLongerCoplanarWithTheOthersThere)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
  WorkBudget work;
  ExactVertices exact(points, work);
  const Id third = exact.AddBetween(0, 1, DyadicNumber(2), DyadicNumber(1), { { 0, 1, 1 } });
  const Id other = exact.Add({ { 0.25, 0.5, 0 } });
  ASSERT_FALSE(exact.IsDouble(third));
  const auto expectSide = [&](int side)
  {
    EXPECT_EQ(exact.Orient(third, 3, 2, other), side);
    EXPECT_EQ(exact.Orient(3, third, 2, other), -side);
  };
  expectSide(0);
  expectSide(0);
  exact.StartJournal();
  exact.MoveTo(other, { { 0.25, 0.5, Tiny } });
  expectSide(1);
  exact.MoveTo(other, { { 0.25, 0.5, 0 } });
  expectSide(0);
  exact.MoveTo(other, { { 0.25, 0.5, -Tiny } });
  expectSide(-1);
  exact.GoBack();
  expectSide(0);
  exact.RemoveLast();
  EXPECT_EQ(exact.Add({ { 0.25, 0.5, Tiny } }), other);
  expectSide(1);
}

TEST(ExactVertices, AVertexThatLeavesALineIsNoLongerCoplanarWithAllOthers)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  WorkBudget work;
  ExactVertices exact(points, work);
  const Id third = exact.AddBetween(0, 1, DyadicNumber(2), DyadicNumber(1), { { 0, 1, 1 } });
  const Id other = exact.Add({ { 0.25, 0, 0 } });
  EXPECT_EQ(exact.Orient(0, third, other, 2), 0);
  EXPECT_EQ(exact.Orient(other, 3, 0, third), 0);
  exact.MoveTo(other, { { 0.25, -Tiny, -Tiny } });
  EXPECT_EQ(exact.Orient(0, third, 2, other), -1);
  EXPECT_EQ(exact.Orient(0, third, 3, other), 1);
}

TEST(ExactVertices, OrientIsTheSignOfTheDeterminantOfPointsOnEdgesAndPlanesAndBesideThem)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const int coplanar = CheckOrientations(seed, 0);
    EXPECT_GT(coplanar, 100);
    EXPECT_LT(coplanar, 3500);
  }
}

TEST(ExactVertices, OrientIsTheSignOfTheDeterminantHoweverLargeOrSmallCoordinatesAre)
{
  for (const int exponents : { 10, 60, 200, 330 })
  {
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
      CheckOrientations(seed, exponents);
    }
  }
}

TEST(ExactVertices, OrientsPointsOfTheSmallestDoubles)
{
  constexpr double Least = 5e-324;
  WorkBudget work;
  ExactVertices exact({ { { 0, 0, 0 } }, { { Least, 0, 0 } }, { { 0, Least, 0 } },
                        { { 0, 0, Least } }, { { 0, 1, 0 } } },
    work);
  const Id third = exact.AddBetween(0, 1, DyadicNumber(2), DyadicNumber(1), { { 0, 1, 1 } });
  const Id high = exact.AddBetween(0, 3, DyadicNumber(2), DyadicNumber(1), { { 0, 3, 3 } });
  EXPECT_FALSE(exact.IsDouble(third));
  EXPECT_EQ(exact.Orient(0, third, 4, high), exact.Determinant(0, third, 4, high).sign());
  EXPECT_NE(exact.Orient(0, third, 4, high), 0);
}

TEST(ExactVertices, APointThatIsADoubleBecomesOne)
{
  WorkBudget work;
  ExactVertices exact({ { { 0, 0, 0 } }, { { 3, 1, -5 } } }, work);
  const Id middle = exact.AddBetween(0, 1, DyadicNumber(7), DyadicNumber(7), { { 0, 1, 1 } });
  EXPECT_TRUE(exact.IsDouble(middle));
  EXPECT_EQ(exact.Nearest(middle), (Point{ { 1.5, 0.5, -2.5 } }));
  const Id third = exact.AddBetween(0, 1, DyadicNumber(2), DyadicNumber(1), { { 0, 1, 1 } });
  EXPECT_FALSE(exact.IsDouble(third));
  EXPECT_DOUBLE_EQ(exact.Nearest(third)[1], 1.0 / 3);
}

TEST(ExactVertices, OrientsPointsWithMoreDigitsThanDoublesHaveExponentsFor)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Point> points(6);
  for (Point& p : points)
  {
    p = { { coordinate(random), coordinate(random), coordinate(random) } };
  }
  for (const double size : { 0x1p300, 0x1p-300 })
  {
    WorkBudget work;
    ExactVertices exact(points, work);
    Id last = 0;
    for (Id k = 0; k < 24; ++k)
    {
      // Weights that are long, and beyond all doubles after a few steps.
      const DyadicNumber a = DyadicNumber(size) * DyadicNumber(1 + k % 5) + DyadicNumber(1);
      const DyadicNumber b = DyadicNumber(size) * DyadicNumber(3);
      const Id corner = 1 + k % 2;
      last = exact.AddBetween(last, corner, a, b, { { 0, 1, 2 } });
      EXPECT_EQ(exact.Orient(0, 1, 2, last), 0);
      for (Id p = 0; p < 5; ++p)
      {
        const Tetrahedron v = { { p, p + 1, k % 3, last } };
        EXPECT_EQ(
          exact.Orient(v[0], v[1], v[2], v[3]), exact.Determinant(v[0], v[1], v[2], v[3]).sign());
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_LE(std::abs(exact.Nearest(last)[axis]), 1);
      }
    }
  }
}
