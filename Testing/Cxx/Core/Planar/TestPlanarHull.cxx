// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarHull.h"

#include "Planar/CurveWindingNumber.h"
#include "Planar/ResolveSegments.h"
#include "Support/AllowedThreads.h"
#include "Support/PlanarLaws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace testplanar;

/** The area where w is a number, in the plane z = 0. */
double AreaWhere(const PlanarHull& hull, double w)
{
  double area = 0;
  for (std::size_t c = 0; c < hull.Mesh.Cells.size(); ++c)
  {
    const Triangle& cell = hull.Mesh.Cells[c];
    const auto& points = hull.Curve.Points;
    area += hull.W[c] != w
      ? 0
      : AreaOf(points[cell[0]], points[cell[1]], points[cell[2]], hull.Plane.Metric);
  }
  return std::ldexp(area, 2 * hull.Plane.Exponent);
}

TEST(PlanarHull, KeepsTheLawsOnRandomClosedAndOpenWalks)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const SegmentSoup soup = RandomWalk(seed, 7, 5 + static_cast<int>(seed) / 2, seed % 2 == 0);
    EXPECT_EQ(BrokenLaws(soup, MeshHullOf(soup)), "") << "seed " << seed;
  }
}

TEST(PlanarHull, KeepsTheLawsOnRandomSegments)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    const SegmentSoup soup = RandomSegments(seed, 25);
    EXPECT_EQ(BrokenLaws(soup, MeshHullOf(soup)), "") << "seed " << seed;
  }
}

/** Lines through nearly one place: crossings that rounding cannot tell apart. */
TEST(PlanarHull, KeepsTheLawsWhereManySegmentsCrossInNearlyOnePlace)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    std::mt19937 random(seed);
    SegmentSoup soup;
    for (int i = 0; i < 16; ++i)
    {
      const double angle = 0.37 * i + 1e-3 * seed;
      const double offset = 1e-16 * static_cast<double>(random() % 10);
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      soup.Points.push_back({ { 0.1 + x, 0.1 + offset + y, 0 } });
      soup.Points.push_back({ { 0.1 - x, 0.1 + offset - y, 0 } });
      soup.Segments.push_back({ { 2 * i, 2 * i + 1 } });
    }
    EXPECT_EQ(BrokenByResolving(soup, MeshHullOf(soup)), "") << "seed " << seed;
    EXPECT_EQ(BrokenByTriangles(MeshHullOf(soup)), "") << "seed " << seed;
  }
}

TEST(PlanarHull, ResolvesAThousandRandomSegments)
{
  const SegmentSoup soup = RandomSegments(1, 1000);
  Monitor monitor;
  const Plane plane = FindPlane(soup.Points);
  const CountedCurve counted = CountSegments(soup, plane, {}, monitor);
  const ResolvedCurve resolved = ResolveSegments(counted.Curve, monitor);
  EXPECT_EQ(resolved.Curve.NumberOfConstraints, resolved.Curve.NumberOfSegments());
  // No three cross in one place: each pair adds a point and two pieces.
  EXPECT_GT(resolved.IntersectingPairs, 50000u);
  EXPECT_EQ(resolved.Curve.Points.size(), 2000 + resolved.IntersectingPairs);
  EXPECT_EQ(resolved.Curve.Segments.size(), 1000 + 2 * resolved.IntersectingPairs);
}

/** Points some units in the last place apart: rounding turns what there is between them, and w is
 * that of what it has become. */
TEST(PlanarHull, GivesTheWindingNumberOfTheResolvedImageInTheThinnestTriangles)
{
  std::size_t cells = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    std::mt19937 random(seed);
    const std::array<double, 3> near{ { 0.5 + random() * 0x1p-34, 0.5 + random() * 0x1p-34,
      0.5 + random() * 0x1p-34 } };
    SegmentSoup soup = Lines({ { 0.95, 0.9 }, { 0.9, 0.1 } }, { { 0, 1 } });
    for (Id i = 0; i < 10; ++i)
    {
      for (int end = 0; end < 2; ++end)
      {
        const double x = near[random() % 3] + 0x1p-53 * (random() % 5);
        soup.Points.push_back({ { x, near[random() % 3] + 0x1p-53 * (random() % 5), 0 } });
      }
      soup.Segments.push_back({ { 2 * i + 2, 2 * i + 3 } });
    }
    const PlanarHull hull = MeshHullOf(soup);
    const SegmentComplex& curve = hull.Curve;
    SegmentSoup image; // each segment as often as it counts
    for (const PlanarPoint& p : curve.Points)
    {
      image.Points.push_back({ { p[0], p[1], 0 } });
    }
    for (std::size_t c = 0; c < hull.Mesh.Cells.size(); ++c, ++cells)
    {
      std::array<__float128, 2> middle{ { 0, 0 } };
      for (const Id p : hull.Mesh.Cells[c])
      {
        middle[0] += static_cast<__float128>(curve.Points[p][0]) / 3;
        middle[1] += static_cast<__float128>(curve.Points[p][1]) / 3;
      }
      double wanted = 0;
      for (Id s = 0; s < curve.NumberOfSegments(); ++s)
      {
        image.Segments = { curve.Segments[s] };
        wanted += curve.Multiplicity[s] * WindingNumberInQuads(image, middle);
      }
      EXPECT_NEAR(hull.W[c], wanted, 1e-12) << "seed " << seed << ", cell " << c;
    }
  }
  EXPECT_GT(cells, 1000u);
}

TEST(PlanarHull, CountsTwoWhereACurveOverlapsItself)
{
  // Twice around: a large square and a smaller one within, in one stroke.
  const SegmentSoup soup = Lines({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 1 }, { 3, 1 },
                                   { 3, 3 }, { 1, 3 }, { 1, 0.5 }, { 0, 0.5 } },
    { { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0 } });
  const PlanarHull hull = MeshHullOf(soup);
  EXPECT_EQ(BrokenLaws(soup, hull), "");
  EXPECT_DOUBLE_EQ(AreaWhere(hull, 2), 4);
  EXPECT_DOUBLE_EQ(AreaWhere(hull, 1), 16 - 4 - 0.5);
}

TEST(PlanarHull, LeavesTheHoleOfRingsOfOppositeOrientation)
{
  const std::vector<PlanarPoint> points = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 }, { 1, 1 },
    { 2, 1 }, { 2, 2 }, { 1, 2 } };
  const SegmentSoup good = Lines(points, { { 0, 1, 2, 3, 0 }, { 4, 7, 6, 5, 4 } });
  const SegmentSoup insideOut = Lines(points, { { 0, 3, 2, 1, 0 }, { 4, 5, 6, 7, 4 } });
  const SegmentSoup twoOutward = Lines(points, { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 } });
  for (const SegmentSoup& soup : { good, insideOut })
  {
    const PlanarHull hull = MeshHullOf(soup, Orientation::Automatic);
    EXPECT_DOUBLE_EQ(AreaWhere(hull, 1), 8);
    EXPECT_DOUBLE_EQ(AreaWhere(hull, 0), 1);
  }
  EXPECT_EQ(MeshHullOf(insideOut, Orientation::Automatic).TurnedSegments.size(), 8u);
  EXPECT_DOUBLE_EQ(AreaWhere(MeshHullOf(insideOut), -1), 8);
  EXPECT_DOUBLE_EQ(AreaWhere(MeshHullOf(insideOut, Orientation::Reverse), 1), 8);
  EXPECT_DOUBLE_EQ(AreaWhere(MeshHullOf(good, Orientation::Outward), 2), 1);
  EXPECT_DOUBLE_EQ(AreaWhere(MeshHullOf(twoOutward, Orientation::Automatic), 2), 1);
}

TEST(PlanarHull, MakesSegmentsAgreeAndTurnsOnlyTheClosedCurveThatIsInsideOut)
{
  // A square of four lines, one of them against the others, a clockwise one beside it, a gap.
  const SegmentSoup soup =
    Lines({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 3, 0 }, { 4, 0 }, { 4, 1 }, { 3, 1 },
            { 6, 0 }, { 7, 0 }, { 7, 1 }, { 6, 1 }, { 6, 0.25 } },
      { { 0, 1 }, { 2, 1 }, { 2, 3 }, { 3, 0 }, { 4, 7, 6, 5, 4 }, { 12, 11, 10, 9, 8 } });
  const PlanarHull hull = MeshHullOf(soup, Orientation::Automatic);
  EXPECT_EQ(hull.TurnedSegments, (std::vector<Id>{ 1, 4, 5, 6, 7, 8, 9, 10, 11 }));
  EXPECT_EQ(hull.Warnings.size(), 2u);
  for (std::size_t c = 0; c < hull.W.size(); ++c)
  {
    EXPECT_GT(hull.W[c], -0.5);
  }
}

TEST(PlanarHull, AddsWhatCoincidesAlongALineAndCancelsDuplicates)
{
  // Two squares side by side that share a part of an edge, which each runs its own way.
  const SegmentSoup soup =
    Lines({ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 2, 1 }, { 4, 1 }, { 4, 3 }, { 2, 3 } },
      { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 }, { 0, 1 }, { 1, 0 } });
  const PlanarHull hull = MeshHullOf(soup);
  EXPECT_EQ(BrokenByResolving(soup, hull), "");
  EXPECT_EQ(hull.Counts.DuplicateSegments, 2);
  EXPECT_EQ(hull.Counts.CancelledSegments, 1);
  int cancelled = 0;
  for (Id s = 0; s < hull.Curve.NumberOfSegments(); ++s)
  {
    cancelled += hull.Curve.Multiplicity[s] == 0;
  }
  EXPECT_EQ(cancelled, 2); // given both ways, and where the squares touch
}

TEST(PlanarHull, KeepsClosedCurvesOnceThatAreGivenBothWays)
{
  // A square both ways, two triangles at a point both ways, a line both ways; and a square both
  // ways with a tail that is given once, so that it stays cancelled.
  const SegmentSoup soup =
    Lines({ { 0, 0 }, { 0, 2 }, { 2, 2 }, { 2, 0 }, { 4, 0 }, { 5, 0 }, { 5, 1 }, { 3, 0 },
            { 3, -1 }, { 7, 0 }, { 8, 0 }, { 9, 0 }, { 10, 0 }, { 10, 1 }, { 9, 1 }, { 9, 4 } },
      { { 0, 1, 2, 3, 0, 3, 2, 1, 0 }, { 4, 5, 6, 4, 6, 5, 4, 7, 8, 4, 8, 7, 4 }, { 9, 10, 9 },
        { 11, 12, 13, 14, 11, 14, 13, 12, 11 }, { 15, 14 } });
  const PlanarHull hull = MeshHullOf(soup);
  EXPECT_EQ(hull.Counts.TwoSidedCurves, 3);
  EXPECT_EQ(hull.Counts.OpenEnds, 2);
  ASSERT_EQ(hull.Warnings.size(), 1u);
  EXPECT_NE(hull.Warnings[0].find("3 closed curves"), std::string::npos);
  // Without the open tail w is a whole number.
  SegmentSoup closed = soup;
  closed.Segments.pop_back();
  EXPECT_EQ(MeshHullOf(closed).Counts.TwoSidedCurves, 4);
  EXPECT_DOUBLE_EQ(AreaWhere(MeshHullOf(closed), 1), 4 + 0.5 + 0.5 + 1);
  // Turned over or not: they are outward as they are.
  EXPECT_DOUBLE_EQ(AreaWhere(MeshHullOf(closed, Orientation::Automatic), 1), 6);
  EXPECT_DOUBLE_EQ(AreaWhere(MeshHullOf(closed, Orientation::Reverse), -1), 6);
  // What does not participate does not make a curve one-sided.
  SegmentSoup marked = soup;
  marked.NonParticipating.assign(soup.Segments.size(), 0);
  marked.NonParticipating.back() = 1;
  EXPECT_EQ(MeshHullOf(marked).Counts.TwoSidedCurves, 4);
}

TEST(PlanarHull, IsTheSameInAnyPlane)
{
  const SegmentSoup flat = RandomWalk(4, 9, 30, false);
  const PlanarHull wanted = MeshHullOf(flat);
  // Whole numbers turned by a rational rotation stay in a plane exactly: columns (2, -2, 1) ...
  SegmentSoup tilted = flat;
  for (Point& p : tilted.Points)
  {
    p = { { 2 * p[0] + p[1] + 5, p[0] + 2 * p[1] - 3, 2 * p[1] - 2 * p[0] + 7 } };
  }
  const PlanarHull hull = MeshHullOf(tilted);
  EXPECT_EQ(hull.Plane.Distance, 0);
  EXPECT_EQ(BrokenByResolving(tilted, hull), "");
  EXPECT_EQ(BrokenByTriangles(hull), "");
  // The area of the plane is nine times as large; w is the same in any direction and size.
  const auto integral = [](const PlanarHull& of)
  {
    double sum = 0;
    for (const double w : { -2.0, -1.0, 1.0, 2.0, 3.0 })
    {
      sum += w * AreaWhere(of, w);
    }
    return sum;
  };
  const SegmentSoup closed = RandomWalk(6, 9, 30, true);
  SegmentSoup closedTilted = closed;
  for (Point& p : closedTilted.Points)
  {
    p = { { 2 * p[0] + p[1] + 5, p[0] + 2 * p[1] - 3, 2 * p[1] - 2 * p[0] + 7 } };
  }
  EXPECT_NEAR(
    std::abs(integral(MeshHullOf(closedTilted))), 9 * std::abs(integral(MeshHullOf(closed))), 1e-9);
  EXPECT_NE(wanted.Mesh.NumberOfCells(), 0);
}

/** For an open curve, whose w depends on angles: the sum of angles in space, about the normal. */
TEST(PlanarHull, MeasuresAnglesInATiltedPlane)
{
  SegmentSoup soup = RandomWalk(8, 9, 12, false);
  for (Point& p : soup.Points)
  {
    p = { { 2 * p[0] + p[1], p[0] + 2 * p[1], 2 * p[1] - 2 * p[0] } };
  }
  const PlanarHull hull = MeshHullOf(soup);
  ASSERT_EQ(hull.Counts.DuplicateSegments, 0);
  for (std::size_t c = 0; c < hull.Mesh.Cells.size(); ++c)
  {
    Point middle{ { 0, 0, 0 } };
    for (const Id p : hull.Mesh.Cells[c])
    {
      const Point corner = hull.Plane.Lift(hull.Curve.Points[p]);
      for (int k = 0; k < 3; ++k)
      {
        middle[k] += corner[k] / 3;
      }
    }
    double sum = 0;
    for (const Segment& segment : soup.Segments)
    {
      Point u, v;
      for (int k = 0; k < 3; ++k)
      {
        u[k] = soup.Points[segment[0]][k] - middle[k];
        v[k] = soup.Points[segment[1]][k] - middle[k];
      }
      const Point& n = hull.Plane.Normal;
      const double det = n[0] * (u[1] * v[2] - u[2] * v[1]) + n[1] * (u[2] * v[0] - u[0] * v[2]) +
        n[2] * (u[0] * v[1] - u[1] * v[0]);
      sum += std::atan2(det, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
    }
    EXPECT_NEAR(hull.W[c], sum / (2 * std::acos(-1)), 1e-9);
  }
}

TEST(PlanarHull, IsTheSameForAnyNumberOfThreads)
{
  const SegmentSoup soup = RandomSegments(5, 150);
  const PlanarHull first = MeshHullOf(soup);
  for (const int threads : { 1, 3, 8 })
  {
    const testthreads::Allowed allowed(threads);
    const PlanarHull again = MeshHullOf(soup);
    EXPECT_EQ(again.Curve.Points, first.Curve.Points);
    EXPECT_EQ(again.Curve.Segments, first.Curve.Segments);
    EXPECT_EQ(again.Mesh.Cells, first.Mesh.Cells);
    EXPECT_EQ(again.W, first.W);
  }
}

TEST(CurveWindingNumber, IsThatOfTheFootAndItsGradientThatOfDifferences)
{
  SegmentSoup soup = RandomWalk(11, 9, 14, false);
  for (Point& p : soup.Points)
  {
    p = { { 20 * p[0] + 10 * p[1] + 7, 10 * p[0] + 20 * p[1], 20 * p[1] - 20 * p[0] } };
  }
  const PlanarHull hull = MeshHullOf(soup);
  const CurveWindingNumber w(hull);
  Monitor monitor;
  std::vector<Point> places;
  for (std::size_t c = 0; c < hull.Mesh.Cells.size(); ++c)
  {
    PlanarPoint middle = { 0, 0 };
    for (const Id p : hull.Mesh.Cells[c])
    {
      middle[0] += hull.Curve.Points[p][0] / 3;
      middle[1] += hull.Curve.Points[p][1] / 3;
    }
    places.push_back(hull.Plane.Lift(middle));
    EXPECT_NEAR(w.At(places.back()), hull.W[c], 1e-9);
    const Point gradient = w.Gradient(places.back());
    double onNormal = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double step = 1e-4;
      Point before = places.back();
      Point behind = places.back();
      before[k] -= step;
      behind[k] += step;
      EXPECT_NEAR(gradient[k], (w.At(behind) - w.At(before)) / (2 * step), 1e-6);
      onNormal += gradient[k] * hull.Plane.Normal[k];
    }
    for (int k = 0; k < 3; ++k)
    {
      places.back()[k] += 50 * hull.Plane.Normal[k];
    }
    EXPECT_NEAR(onNormal, 0, 1e-12);
  }
  const std::vector<double> above = w.At(places, monitor, { "", 0, 1 });
  for (std::size_t c = 0; c < places.size(); ++c)
  {
    EXPECT_NEAR(above[c], hull.W[c], 1e-9);
  }
}

TEST(PlanarHull, NamesWhatIsWrong)
{
  const auto messageOf = [](const SegmentSoup& soup)
  {
    try
    {
      MeshHullOf(soup);
    }
    catch (const Error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(messageOf({}), "the curve has no points");
  EXPECT_EQ(messageOf(Lines({ { 0, 0 }, { 1, 1 }, { 2, 2 } }, { { 0, 1, 2 } })),
    "all points lie on one line: there is no area to enclose");
  EXPECT_EQ(messageOf(Lines({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 3 } })),
    "segment 0 refers to point 3 of 3");
  EXPECT_EQ(messageOf(Lines({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 1, 1 } })),
    "all 1 segments are degenerate (without length)");
}
} // namespace
