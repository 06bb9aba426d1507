// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefineTriangles.h"

#include "Planar/PlanarOutputs.h"
#include "Planar/SegmentTriangles.h"
#include "Support/PlanarLaws.h"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{
using namespace testplanar;
using Rational = CGAL::Exact_rational;

struct Refinement
{
  PlanarHull Hull;
  std::vector<unsigned char> Inside;
  RefinedTriangles Refined;
};

RefinementParameters Split(double edgeLength = 0)
{
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Split;
  parameters.Sizes.EdgeLength = edgeLength;
  return parameters;
}

Refinement RefineHull(PlanarHull hull, const RefinementParameters& parameters)
{
  Monitor monitor;
  Refinement result;
  result.Hull = std::move(hull);
  result.Inside = SegmentTriangles(
    result.Hull.Curve, result.Hull.Mesh, result.Hull.Plane, result.Hull.W, {}, {}, {}, monitor)
                    .Inside;
  result.Refined = RefineTriangles(
    result.Hull.Curve, result.Hull.Mesh, result.Inside, result.Hull.Plane, parameters, monitor);
  return result;
}

Rational TwiceArea(const std::vector<PlanarPoint>& points, Id a, Id b, Id c)
{
  const auto x = [&](Id p) { return Rational(points[p][0]); };
  const auto y = [&](Id p) { return Rational(points[p][1]); };
  return (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a));
}

/** Directed edges, and the corner across from each; empty where two cells are on one side. */
std::map<Segment, Id> EdgesOf(const std::vector<Triangle>& cells)
{
  std::map<Segment, Id> edges;
  for (const Triangle& cell : cells)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (!edges.emplace(Segment{ { cell[k], cell[(k + 1) % 3] } }, cell[(k + 2) % 3]).second)
      {
        return {};
      }
    }
  }
  return edges;
}

/** A chain of edges from an end to the other one, along the straight way but for rounding. */
bool LeadsAlong(const std::vector<PlanarPoint>& points, const std::map<Id, Id>& next, Id from,
  Id to, std::size_t& used)
{
  const double length =
    std::hypot(points[to][0] - points[from][0], points[to][1] - points[from][1]);
  std::size_t steps = 0;
  for (Id at = from; at != to; at = next.at(at), ++steps)
  {
    if (next.count(at) == 0 || steps > next.size() ||
      std::abs(CGAL::to_double(TwiceArea(points, from, to, at))) > 1e-14 * length)
    {
      return false;
    }
  }
  used += steps;
  return true;
}

double LeastAngle(const std::vector<PlanarPoint>& points, const Triangle& cell)
{
  double least = 180;
  for (int k = 0; k < 3; ++k)
  {
    const PlanarPoint &p = points[cell[k]], &q = points[cell[(k + 1) % 3]],
                      &r = points[cell[(k + 2) % 3]];
    const double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1];
    least = std::min(least, std::atan2(ux * vy - uy * vx, ux * vx + uy * vy) * 180 / std::acos(-1));
  }
  return least;
}

/** Constraints by their directed edges: the segment, None for none, and what it counts. */
using Constraints = std::map<Segment, std::pair<Id, int>>;

/** Edges of the input, as far as they are inside. */
Constraints ConstraintsOf(const PlanarHull& hull, const std::vector<unsigned char>& inside)
{
  Constraints constraints;
  const PlanarMesh& mesh = hull.Mesh;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; inside[c] != 0 && k < 3; ++k)
    {
      const Id beyond = mesh.Neighbors[c][k];
      if (mesh.Segments[c][k] != None || beyond == None || inside[beyond] == 0)
      {
        constraints[EdgeOf(mesh.Cells[c], k)] = { mesh.Segments[c][k],
          MultiplicityOnEntering(hull.Curve, mesh, c, k) };
      }
    }
  }
  return constraints;
}

/** Edges of the result on the boundary or a segment, each side separately. */
Constraints ConstraintsOf(const RefinedTriangles& refined)
{
  Constraints constraints;
  for (Id c = 0; c < refined.Mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id segment = refined.Mesh.Segments[c][k];
      if (segment != None || refined.Mesh.Neighbors[c][k] == None)
      {
        constraints[EdgeOf(refined.Mesh.Cells[c], k)] = { segment,
          MultiplicityOnEntering(refined.Curve, refined.Mesh, c, k) };
      }
    }
  }
  return constraints;
}

/** Triangles are positive, edge to edge with the neighbors that they name, and cover the inside.
 */
std::string BrokenByCells(const Refinement& all)
{
  const RefinedTriangles& refined = all.Refined;
  Rational area = 0;
  for (const Triangle& cell : refined.Mesh.Cells)
  {
    const Rational twice = TwiceArea(refined.Curve.Points, cell[0], cell[1], cell[2]);
    if (twice <= 0)
    {
      return "a triangle is not positive";
    }
    area += twice;
  }
  const std::map<Segment, Id> edges = EdgesOf(refined.Mesh.Cells);
  if (edges.size() != 3 * refined.Mesh.Cells.size())
  {
    return "two triangles are on one side of an edge";
  }
  for (Id c = 0; c < refined.Mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Segment edge = EdgeOf(refined.Mesh.Cells[c], k);
      if ((refined.Mesh.Neighbors[c][k] == None) != (edges.count({ { edge[1], edge[0] } }) == 0))
      {
        return "a neighbour is missing";
      }
    }
  }
  for (std::size_t c = 0; c < all.Inside.size(); ++c)
  {
    const Triangle& cell = all.Hull.Mesh.Cells[c];
    area -= all.Inside[c] == 0 ? Rational(0)
                               : TwiceArea(all.Hull.Curve.Points, cell[0], cell[1], cell[2]);
  }
  return std::abs(CGAL::to_double(area)) > 1e-14 ? "the area is another" : "";
}

/** Input points stay, and the pieces of each constraint lead from its one end to its other one. */
std::string BrokenByConstraints(const Refinement& all, bool isKept)
{
  const RefinedTriangles& refined = all.Refined;
  const std::vector<PlanarPoint>& points = refined.Curve.Points;
  std::map<Id, Id> numbers; // of input points in the result
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const Id original = refined.OriginalPoints[p];
    if (original != None)
    {
      numbers[original] = static_cast<Id>(p);
      if (points[p] != all.Hull.Curve.Points[original])
      {
        return "a point has moved";
      }
    }
  }
  const Constraints constraints = ConstraintsOf(all.Hull, all.Inside);
  const Constraints made = ConstraintsOf(refined);
  std::size_t used = 0;
  for (const auto& [edge, what] : constraints)
  {
    const Id from = numbers[edge[0]], to = numbers[edge[1]];
    const double x = points[to][0] - points[from][0], y = points[to][1] - points[from][1];
    const auto isAlong = [&](Id p) {
      return std::abs(CGAL::to_double(TwiceArea(points, from, to, p))) <= 1e-14 * std::hypot(x, y);
    };
    std::map<Id, Id> next;
    for (const auto& [piece, ofPiece] : made)
    {
      const bool isOfSegment = what.first == None
        ? ofPiece.first == None
        : ofPiece.first != None && ofPiece.second == what.second &&
          SourceOfSegment(refined.Curve, ofPiece.first, 1) ==
            SourceOfSegment(all.Hull.Curve, what.first, 1);
      const double along = (points[piece[1]][0] - points[piece[0]][0]) * x +
        (points[piece[1]][1] - points[piece[0]][1]) * y;
      if (isOfSegment && along > 0 && isAlong(piece[0]) && isAlong(piece[1]))
      {
        next[piece[0]] = piece[1];
      }
    }
    if (!LeadsAlong(points, next, from, to, used))
    {
      return "the pieces of a constraint do not lead to its end";
    }
  }
  return used != made.size() || (isKept && made.size() != constraints.size())
    ? "there are other constraints than pieces of the input's"
    : "";
}

/** Edges that are no constraints are Delaunay. */
std::string BrokenByCircles(const Refinement& all)
{
  const std::vector<PlanarPoint>& points = all.Refined.Curve.Points;
  const Constraints made = ConstraintsOf(all.Refined);
  const std::map<Segment, Id> edges = EdgesOf(all.Refined.Mesh.Cells);
  for (const auto& [edge, apex] : edges)
  {
    const auto beyond = edges.find({ { edge[1], edge[0] } });
    if (beyond == edges.end() || made.count(edge) > 0 || !all.Hull.Plane.Metric.IsPerpendicular())
    {
      continue;
    }
    const auto lifted = [&, opposite = beyond->second](Id p)
    {
      const Rational x = Rational(points[p][0]) - Rational(points[opposite][0]);
      const Rational y = Rational(points[p][1]) - Rational(points[opposite][1]);
      return std::array<Rational, 3>{ { x, y, Rational(x * x + y * y) } };
    };
    const auto u = lifted(edge[0]), v = lifted(edge[1]), w = lifted(apex);
    if (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
        u[2] * (v[0] * w[1] - v[1] * w[0]) >
      0)
    {
      return "an edge is not Delaunay";
    }
  }
  return "";
}

/** w is that of the cells before, so that across each segment it still jumps by what that counts.
 */
std::string BrokenByCellsBefore(const Refinement& all)
{
  const RefinedTriangles& refined = all.Refined;
  for (Id c = 0; c < refined.Mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; all.Hull.Counts.OpenEnds == 0 && k < 3; ++k)
    {
      const Id beyond = refined.Mesh.Neighbors[c][k];
      if (beyond != None &&
        all.Hull.W[refined.OriginalCells[c]] - all.Hull.W[refined.OriginalCells[beyond]] !=
          MultiplicityOnEntering(refined.Curve, refined.Mesh, c, k))
      {
        return "w does not jump by what an edge counts";
      }
    }
  }
  return "";
}

/** Which law is broken, empty for none. */
std::string Broken(const Refinement& all, bool isKept)
{
  for (const std::string& broken : { BrokenByCells(all), BrokenByConstraints(all, isKept),
         BrokenByCircles(all), BrokenByCellsBefore(all) })
  {
    if (!broken.empty())
    {
      return broken;
    }
  }
  return "";
}

/** A polygon with this number of corners, each 90 degrees or more, within the unit square. */
SegmentSoup Ring(int corners)
{
  std::vector<PlanarPoint> points;
  std::vector<Id> line;
  for (Id i = 0; i < corners; ++i)
  {
    const double angle = 2 * std::acos(-1) * i / corners;
    points.push_back({ 0.5 + 0.4 * std::cos(angle), 0.5 + 0.4 * std::sin(angle) });
    line.push_back(i);
  }
  line.push_back(0);
  return Lines(points, { line });
}

/** Needles around a center: corners of few degrees. */
SegmentSoup Star(int needles)
{
  std::vector<PlanarPoint> points;
  std::vector<Id> line;
  for (Id i = 0; i < 2 * needles; ++i)
  {
    const double angle = std::acos(-1) * i / needles;
    const double radius = i % 2 == 0 ? 1 : 0.05;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    line.push_back(i);
  }
  line.push_back(0);
  return Lines(points, { line });
}

TEST(RefineTriangles, KeepsTheLawsOnRandomCurves)
{
  for (unsigned seed = 0; seed < 16; ++seed)
  {
    const SegmentSoup soup =
      seed % 4 == 3 ? RandomSegments(seed, 12) : RandomWalk(seed, 9, 10, seed % 2 == 0);
    for (const double length : { 0.0, 0.2 })
    {
      RefinementParameters parameters = Split(length * std::ldexp(1.0, seed % 4 == 3 ? 0 : 4));
      EXPECT_EQ(Broken(RefineHull(MeshHullOf(soup), parameters), false), "") << "seed " << seed;
      parameters.Surface = SurfaceTreatment::Kept;
      EXPECT_EQ(Broken(RefineHull(MeshHullOf(soup), parameters), true), "") << "seed " << seed;
    }
  }
}

TEST(RefineTriangles, LeavesNoAngleBelowRuppertsWhereTheCurveHasNone)
{
  // A ring with a hole, not in its middle, and one corner near another one.
  SegmentSoup soup = Ring(40);
  const SegmentSoup hole =
    Lines({ { 0.3, 0.4 }, { 0.3, 0.6 }, { 0.5, 0.6 }, { 0.5, 0.4 } }, { { 0, 1, 2, 3, 0 } });
  for (const Segment& segment : hole.Segments)
  {
    soup.Segments.push_back({ { segment[0] + 40, segment[1] + 40 } });
  }
  soup.Points.insert(soup.Points.end(), hole.Points.begin(), hole.Points.end());
  for (const double length : { 0.0, 0.05 })
  {
    const Refinement all = RefineHull(MeshHullOf(soup), Split(length));
    EXPECT_EQ(Broken(all, false), "");
    for (const Triangle& cell : all.Refined.Mesh.Cells)
    {
      EXPECT_GT(LeastAngle(all.Refined.Curve.Points, cell), 20.7);
    }
    EXPECT_TRUE(all.Refined.Warnings.empty());
  }
}

TEST(RefineTriangles, MakesEdgesAndAreasAsLargeAsAskedFor)
{
  const SegmentSoup soup =
    Lines({ { 0, 0 }, { 10, 0 }, { 10, 6 }, { 0, 6 } }, { { 0, 1, 2, 3, 0 } });
  const auto refined = [&](const RefinementParameters& parameters)
  {
    const Refinement all = RefineHull(MeshHullOf(soup), parameters);
    EXPECT_EQ(Broken(all, parameters.Surface == SurfaceTreatment::Kept), "");
    return all.Refined;
  };
  const RefinedTriangles byLength = refined(Split(0.5));
  const double scale = 16; // coordinates are below 1
  for (const Triangle& cell : byLength.Mesh.Cells)
  {
    for (int k = 0; k < 3; ++k)
    {
      const PlanarPoint &p = byLength.Curve.Points[cell[k]],
                        &q = byLength.Curve.Points[cell[(k + 1) % 3]];
      EXPECT_LT(scale * std::hypot(p[0] - q[0], p[1] - q[1]), 1.4 * 0.5);
    }
  }
  RefinementParameters parameters = Split();
  parameters.Sizes.MaximumVolume = 0.1;
  const RefinedTriangles byArea = refined(parameters);
  EXPECT_GE(byArea.Mesh.Cells.size(), 600u);
  for (const Triangle& cell : byArea.Mesh.Cells)
  {
    EXPECT_LE(CGAL::to_double(TwiceArea(byArea.Curve.Points, cell[0], cell[1], cell[2])) / 2,
      0.1 / (scale * scale));
  }
  // Kept: the inside is filled although the boundary's edges are long.
  parameters = Split(0.5);
  parameters.Surface = SurfaceTreatment::Kept;
  EXPECT_GT(refined(parameters).Mesh.Cells.size(), 100u);
}

/** An outline with a gap, and a bar across one of its sides. */
SegmentSoup OutlineWithGap()
{
  return Lines(
    { { 0, 0 }, { 4, 0 }, { 4, 3 }, { 0, 3 }, { 0, 0.2 }, { 1, 1 }, { 6, 1 }, { 6, 2 }, { 1, 2 } },
    { { 0, 1, 2, 3, 4 }, { 5, 6, 7, 8, 5 } });
}

TEST(RefineTriangles, MakesNoAngleSmallWhereTheCurveIsKept)
{
  const auto leastAngle = [](const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
                            const std::vector<unsigned char>& inside)
  {
    double least = 180;
    for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
    {
      least =
        inside.empty() || inside[c] ? std::min(least, LeastAngle(points, mesh.Cells[c])) : least;
    }
    return least;
  };
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Kept;
  std::vector<SegmentSoup> soups = { Ring(40), Star(3), OutlineWithGap() };
  for (unsigned seed = 0; seed < 16; ++seed)
  {
    soups.push_back(RandomWalk(seed, 9, 10, true));
  }
  for (const SegmentSoup& soup : soups)
  {
    for (const double length : { 0.0, 0.1, 0.02 })
    {
      const PlanarHull hull = MeshHullOf(soup);
      parameters.Sizes.EdgeLength = std::ldexp(length, hull.Plane.Exponent);
      const Refinement all = RefineHull(hull, parameters);
      const double before = leastAngle(hull.Curve.Points, hull.Mesh, all.Inside);
      EXPECT_GE(leastAngle(all.Refined.Curve.Points, all.Refined.Mesh, {}),
        std::min(before, length > 0 ? 10 : 20.7) - 1e-9);
    }
  }
}

TEST(RefineTriangles, TellsOfTrianglesThatKeptEdgesLeaveLong)
{
  RefinementParameters parameters = Split(0.3);
  EXPECT_TRUE(RefineHull(MeshHullOf(OutlineWithGap()), parameters).Refined.Warnings.empty());
  parameters.Surface = SurfaceTreatment::Kept;
  const RefinedTriangles refined = RefineHull(MeshHullOf(OutlineWithGap()), parameters).Refined;
  ASSERT_EQ(refined.Warnings.size(), 1u);
  EXPECT_NE(refined.Warnings[0].find("longer than EdgeLength"), std::string::npos);
  // As far as that allows the inside is filled.
  EXPECT_GT(refined.Mesh.Cells.size(), 80u);
}

TEST(RefineTriangles, EndsAtSharpCornersAndKeepsTheRestGood)
{
  for (const int needles : { 3, 20, 60 })
  {
    const Refinement all = RefineHull(MeshHullOf(Star(needles)), Split());
    EXPECT_EQ(Broken(all, false), "");
    EXPECT_TRUE(all.Refined.Warnings.empty());
    const auto thin = std::count_if(all.Refined.Mesh.Cells.begin(), all.Refined.Mesh.Cells.end(),
      [&](const Triangle& cell) { return LeastAngle(all.Refined.Curve.Points, cell) < 20.7; });
    EXPECT_LT(thin, 16 * needles); // a few between the shells of each corner
    EXPECT_LT(all.Refined.Mesh.Cells.size(), 400u * needles);
  }
}

TEST(RefineTriangles, LeavesOnlyTheTriangleAtASharpCornerThinUnlessThatIsVerySharp)
{
  // Needles of 0.94 degrees, finer than the length; then of 0.09.
  for (const auto& [needles, thinPerNeedle] : { std::pair(20, 2), std::pair(200, 100) })
  {
    const Refinement all = RefineHull(MeshHullOf(Star(needles)), Split(0.04));
    EXPECT_TRUE(all.Refined.Warnings.empty());
    const auto thin = std::count_if(all.Refined.Mesh.Cells.begin(), all.Refined.Mesh.Cells.end(),
      [&](const Triangle& cell) { return LeastAngle(all.Refined.Curve.Points, cell) < 12; });
    EXPECT_LE(thin, thinPerNeedle * needles);
    EXPECT_GE(thin, needles);
  }
}

TEST(RefineTriangles, EndsBetweenLinesThatNearlyTouchAndSaysSo)
{
  const SegmentSoup soup =
    Lines({ { 0, 0 }, { 1, 0 }, { 1, 1e-9 }, { 0, 1e-9 } }, { { 0, 1, 2, 3, 0 } });
  const Refinement all = RefineHull(MeshHullOf(soup), Split());
  EXPECT_EQ(Broken(all, false), "");
  ASSERT_EQ(all.Refined.Warnings.size(), 1u);
  EXPECT_NE(all.Refined.Warnings[0].find("too close to each other"), std::string::npos);
  EXPECT_LT(all.Refined.Mesh.Cells.size(), 10000u);
}

TEST(RefineTriangles, GoesByLengthsOfThePlaneNotOfItsCoordinates)
{
  SegmentSoup soup = Ring(24);
  for (Point& p : soup.Points)
  {
    p = { { 2 * p[0] + p[1], p[0] + 2 * p[1], 2 * p[1] - 2 * p[0] } };
  }
  Monitor monitor;
  // The plane of few points is rounded: as for points of a file.
  const Plane plane = FindPlane(soup.Points);
  const PlanarHull hull = MeshPlanarHull(soup, plane, {}, monitor);
  ASSERT_FALSE(hull.Plane.Metric.IsPerpendicular());
  const Refinement all = RefineHull(hull, Split(0.3));
  EXPECT_EQ(Broken(all, false), "");
  for (const Triangle& cell : all.Refined.Mesh.Cells)
  {
    std::vector<PlanarPoint> corners;
    for (const Id p : cell)
    {
      corners.push_back(plane.Metric.Map(all.Refined.Curve.Points[p]));
    }
    EXPECT_GT(LeastAngle(corners, { { 0, 1, 2 } }), 20.7);
  }
}

TEST(RefineTriangles, IsTheSameTwiceAndCanBeStopped)
{
  const SegmentSoup soup = Star(8);
  EXPECT_EQ(RefineHull(MeshHullOf(soup), Split(0.02)).Refined.Mesh.Cells,
    RefineHull(MeshHullOf(soup), Split(0.02)).Refined.Mesh.Cells);
  struct Stopper : Monitor
  {
    int Left;
    explicit Stopper(int left)
      : Left(left)
    {
    }
    bool Continue(const char*, double) override { return this->Left-- > 0; }
  };
  const Refinement all = RefineHull(MeshHullOf(soup), Split(0.02));
  for (int left = 0; left < 3; ++left)
  {
    Stopper stopper(left);
    EXPECT_THROW(RefineTriangles(
                   all.Hull.Curve, all.Hull.Mesh, all.Inside, all.Hull.Plane, Split(0.02), stopper),
      Error);
  }
}

TEST(RefineTriangles, RefusesToRemesh)
{
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  EXPECT_THROW(RefineHull(MeshHullOf(Ring(8)), parameters), Error);
}
} // namespace
