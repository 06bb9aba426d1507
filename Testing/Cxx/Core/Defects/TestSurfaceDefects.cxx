// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/SurfaceDefects.h"

#include "Support/TestMeshes.h"
#include "Validate/FacetEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace insideout;
using namespace testmeshes;

namespace
{
SurfaceDefects Find(const TriangleSoup& soup, double mergeTolerance = 0)
{
  Monitor monitor;
  return FindSurfaceDefects(soup, mergeTolerance, Orientation::Automatic, monitor);
}

template <typename Member>
Id Sum(const SurfaceDefects& defects, Member member)
{
  Id sum = 0;
  for (const TriangleDefects& triangle : defects.Triangles)
  {
    sum += triangle.*member;
  }
  return sum;
}

std::vector<const DefectLine*> LinesOf(const SurfaceDefects& defects, DefectType type)
{
  std::vector<const DefectLine*> lines;
  for (const DefectLine& line : defects.Lines)
  {
    if (line.Type == type)
    {
      lines.push_back(&line);
    }
  }
  return lines;
}

double Length(const SurfaceDefects& defects, DefectType type)
{
  double length = 0;
  for (const DefectLine* line : LinesOf(defects, type))
  {
    for (std::size_t i = 1; i < line->Points.size(); ++i)
    {
      const Point& p = defects.Points[line->Points[i - 1]];
      const Point& q = defects.Points[line->Points[i]];
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
  }
  return length;
}

/** A box of unit edges without its last two triangles, which make the side x = 1. */
TriangleSoup OpenBox()
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.Triangles.resize(10);
  return box;
}
} // namespace

TEST(SurfaceDefects, AreNoneOnABox)
{
  const SurfaceDefects defects = Find(Box({ 0, 0, 0 }, { 1, 1, 1 }));
  ASSERT_EQ(defects.Triangles.size(), 12u);
  for (const TriangleDefects& triangle : defects.Triangles)
  {
    EXPECT_EQ(triangle.Component, 0);
    EXPECT_EQ(triangle.SelfIntersections, 0);
    EXPECT_FALSE(
      triangle.Degenerate || triangle.Duplicate || triangle.Inconsistent || triangle.TwoSided);
  }
  EXPECT_TRUE(defects.Lines.empty());
  EXPECT_TRUE(defects.Points.empty());
  EXPECT_EQ(defects.UnbalancedEdges, 0);
  EXPECT_FALSE(defects.Planar);
  EXPECT_TRUE(defects.Warnings.empty());
}

TEST(SurfaceDefects, OpenBoundaryIsOneLoop)
{
  const SurfaceDefects defects = Find(OpenBox());
  EXPECT_EQ(defects.Counts.OpenEdges, 4);
  EXPECT_EQ(defects.UnbalancedEdges, 4);
  ASSERT_EQ(defects.Lines.size(), 1u);
  EXPECT_EQ(defects.Lines[0].Type, DefectType::OpenBoundary);
  EXPECT_EQ(defects.Lines[0].Points.size(), 5u);
  EXPECT_EQ(defects.Lines[0].Points.front(), defects.Lines[0].Points.back());
  EXPECT_DOUBLE_EQ(Length(defects, DefectType::OpenBoundary), 4);
  for (std::size_t p = 0; p < defects.Points.size(); ++p)
  {
    EXPECT_EQ(defects.Points[p], OpenBox().Points[defects.InputPoints[p]]);
  }
}

TEST(SurfaceDefects, AFacetThatIsTurnedOverIsInconsistentWithItsThreeNeighbors)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  std::swap(box.Triangles[3][0], box.Triangles[3][1]);
  const SurfaceDefects defects = Find(box);
  EXPECT_EQ(defects.InconsistentEdges, 3);
  EXPECT_EQ(defects.UnbalancedEdges, 3);
  EXPECT_EQ(Sum(defects, &TriangleDefects::Inconsistent), 4);
  EXPECT_TRUE(defects.Triangles[3].Inconsistent);
  ASSERT_EQ(defects.Lines.size(), 1u) << "around the facet";
  EXPECT_EQ(defects.Lines[0].Type, DefectType::InconsistentEdge);
  EXPECT_NEAR(Length(defects, DefectType::InconsistentEdge), 2 + std::sqrt(2.0), 1e-15);
}

TEST(SurfaceDefects, BoxesThatTouchAlongAnEdgeShareANonManifoldOne)
{
  const SurfaceDefects defects =
    Find(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 1, 0 }, { 2, 2, 1 })));
  EXPECT_EQ(defects.Counts.NonManifoldEdges, 1);
  EXPECT_EQ(defects.Counts.Components, 1);
  EXPECT_EQ(defects.IntersectingPairs, 0);
  EXPECT_EQ(defects.UnbalancedEdges, 0) << "two facets run along it either way";
  ASSERT_EQ(defects.Lines.size(), 1u);
  EXPECT_EQ(defects.Lines[0].Type, DefectType::NonManifoldEdge);
  EXPECT_EQ(Length(defects, DefectType::NonManifoldEdge), 1);
}

TEST(SurfaceDefects, ComponentsAreNumberedByTheirFirstTriangles)
{
  const SurfaceDefects defects =
    Find(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0.5, 0.5 }, { 1.5, 1.5, 1.5 })));
  for (Id t = 0; t < 24; ++t)
  {
    EXPECT_EQ(defects.Triangles[t].Component, t / 12);
  }
  const auto curves = LinesOf(defects, DefectType::IntersectionCurve);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0]->Points.front(), curves[0]->Points.back());
  EXPECT_EQ(defects.Lines.size(), 1u);
  EXPECT_DOUBLE_EQ(Length(defects, DefectType::IntersectionCurve), 3);
}

TEST(SurfaceDefects, DuplicatesAreMarkedFromTheSecondOn)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.Triangles.push_back({ box.Triangles[4][1], box.Triangles[4][2], box.Triangles[4][0] });
  box.Triangles.push_back({ box.Triangles[5][1], box.Triangles[5][0], box.Triangles[5][2] });
  box.Triangles.push_back({ 0, 1, 0 });
  const SurfaceDefects defects = Find(box);
  for (Id t = 0; t < 15; ++t)
  {
    EXPECT_EQ(defects.Triangles[t].Duplicate, t == 12 || t == 13) << t;
    EXPECT_EQ(defects.Triangles[t].Degenerate, t == 14) << t;
    EXPECT_EQ(defects.Triangles[t].Component, t == 14 ? None : 0) << t;
    EXPECT_FALSE(defects.Triangles[t].Inconsistent) << "what is given both ways agrees with all";
  }
  EXPECT_EQ(defects.UnbalancedEdges, 0) << "of opposite copies the one that closes the box counts";
  EXPECT_EQ(defects.Counts.DuplicateFacets, 2);
  EXPECT_EQ(defects.Counts.DegenerateFacets, 1);
}

TEST(SurfaceDefects, TwoSidedComponentsAreMarkedWhetherSolidOrSheet)
{
  const TriangleSoup solid = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleSoup sheet{ { { 5, 0, 0 }, { 6, 0, 0 }, { 5, 1, 0 } }, { { 0, 1, 2 } } };
  const TriangleSoup twoSided = Join(Join(solid, Reversed(solid)), Join(sheet, Reversed(sheet)));
  const SurfaceDefects defects = Find(Join(twoSided, Box({ 8, 0, 0 }, { 9, 1, 1 })));
  EXPECT_EQ(defects.Counts.TwoSidedSolids, 1);
  EXPECT_EQ(defects.Counts.TwoSidedSheets, 1);
  for (Id t = 0; t < 38; ++t)
  {
    EXPECT_EQ(defects.Triangles[t].TwoSided, t < 26) << t;
  }
  EXPECT_EQ(defects.InconsistentEdges, 0);
  EXPECT_EQ(defects.UnbalancedEdges, 0);
}

TEST(SurfaceDefects, TakesTheMultiplicitiesOfAResolvedSurface)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  std::swap(box.Triangles[3][0], box.Triangles[3][1]);
  box.Multiplicity.assign(12, 2);
  box.Multiplicity[3] = -2;
  SurfaceDefects defects = Find(box);
  EXPECT_EQ(defects.InconsistentEdges, 0);
  EXPECT_EQ(defects.UnbalancedEdges, 0);
  box.Multiplicity.assign(12, 0);
  defects = Find(box);
  EXPECT_EQ(Sum(defects, &TriangleDefects::TwoSided), 12);
}

TEST(SurfaceDefects, AdviseAMergeToleranceThatJoinsNearPoints)
{
  const TriangleSoup boxes =
    Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1 + 1e-9, 0, 0 }, { 2, 1, 1 }));
  const SurfaceDefects defects = Find(boxes);
  EXPECT_EQ(defects.NearPoints, 8);
  EXPECT_NEAR(defects.NearDistance, 1e-6 * std::sqrt(6.0), 1e-12);
  ASSERT_EQ(defects.Warnings.size(), 1u);
  EXPECT_NE(defects.Warnings[0].find("set MergeTolerance to 2.4e-06"), std::string::npos);
  const SurfaceDefects merged = Find(boxes, defects.NearDistance);
  EXPECT_EQ(merged.NearPoints, 0);
  EXPECT_EQ(merged.Counts.Points, 12);
}

TEST(SurfaceDefects, SayThatASurfaceLiesInOnePlane)
{
  TriangleSoup sheet{ { { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 } },
    { { 0, 1, 2 }, { 1, 3, 2 } } };
  EXPECT_TRUE(Find(sheet).Planar);
  sheet.Points[3][2] = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(Find(sheet).Planar);
}

TEST(SurfaceDefects, CountWhatTheyMark)
{
  for (unsigned seed = 0; seed < 15; ++seed)
  {
    // Few points, so that edges have many facets; some triangles twice, some turned over.
    TriangleSoup soup = GridSoup(seed, 40, 3);
    const SurfaceDefects plain = Find(soup);
    ASSERT_EQ(Sum(plain, &TriangleDefects::SelfIntersections), 2 * plain.IntersectingPairs);

    for (Id t = 0; t < 10; ++t)
    {
      soup.Triangles.push_back(soup.Triangles[3 * t]);
      std::swap(soup.Triangles.back()[0], soup.Triangles.back()[t % 3]);
    }
    soup.Triangles.push_back({ 1, 1, 2 });
    const SurfaceDefects defects = Find(soup);
    ASSERT_EQ(Sum(defects, &TriangleDefects::Duplicate), defects.Counts.DuplicateFacets);
    ASSERT_EQ(Sum(defects, &TriangleDefects::Degenerate), defects.Counts.DegenerateFacets);
    Id highest = None;
    Id facets = 0;
    Id intersecting = 0;
    for (const TriangleDefects& triangle : defects.Triangles)
    {
      highest = std::max(highest, triangle.Component);
      if (!triangle.Duplicate && !triangle.Degenerate)
      {
        ++facets;
        intersecting += triangle.SelfIntersections > 0;
      }
    }
    ASSERT_EQ(highest + 1, defects.Counts.Components);
    ASSERT_EQ(facets, defects.Counts.Facets);
    ASSERT_EQ(intersecting, defects.IntersectingFacets);
  }
}

TEST(SurfaceDefects, DrawEveryEdgeThatTheyCountOnce)
{
  for (unsigned seed = 0; seed < 15; ++seed)
  {
    const TriangleSoup soup = GridSoup(seed, 30, 3);
    const SurfaceDefects defects = Find(soup);
    std::array<double, 3> length{ { 0, 0, 0 } };
    ForEachEdge(SortedFacetEdges(soup.Triangles),
      [&](const FacetEdge* first, const FacetEdge* last)
      {
        const Point& p = soup.Points[first->Low];
        const Point& q = soup.Points[first->High];
        const double own = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        const bool inconsistent = last - first == 2 && first[0].Direction == first[1].Direction;
        length[0] += last - first == 1 ? own : 0;
        length[1] += last - first > 2 ? own : 0;
        length[2] += inconsistent ? own : 0;
      });
    const std::array<DefectType, 3> types{ { DefectType::OpenBoundary, DefectType::NonManifoldEdge,
      DefectType::InconsistentEdge } };
    std::array<Id, 3> segments{ { 0, 0, 0 } };
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_NEAR(Length(defects, types[i]), length[i], 1e-12);
      for (const DefectLine* line : LinesOf(defects, types[i]))
      {
        segments[i] += static_cast<Id>(line->Points.size()) - 1;
      }
    }
    ASSERT_EQ(segments[0], defects.Counts.OpenEdges);
    ASSERT_EQ(segments[1], defects.Counts.NonManifoldEdges);
    ASSERT_EQ(segments[2], defects.InconsistentEdges);
  }
}

TEST(SurfaceDefects, GoWithTheTrianglesInWhateverOrderTheyCome)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const TriangleSoup soup = GridSoup(seed, 40, 3);
    std::vector<Id> order(soup.Triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(seed);
    std::shuffle(order.begin(), order.end(), random);
    TriangleSoup shuffled = soup;
    for (std::size_t t = 0; t < order.size(); ++t)
    {
      shuffled.Triangles[t] = soup.Triangles[order[t]];
    }
    const SurfaceDefects a = Find(soup);
    const SurfaceDefects b = Find(shuffled);
    std::vector<Id> renamed(a.Counts.Components, None);
    for (std::size_t t = 0; t < order.size(); ++t)
    {
      const TriangleDefects& here = b.Triangles[t];
      const TriangleDefects& there = a.Triangles[order[t]];
      ASSERT_EQ(here.SelfIntersections, there.SelfIntersections);
      ASSERT_EQ(here.Inconsistent, there.Inconsistent);
      ASSERT_EQ(here.TwoSided, there.TwoSided);
      Id& name = renamed[there.Component];
      name = name == None ? here.Component : name;
      ASSERT_EQ(name, here.Component);
    }
    ASSERT_EQ(a.Counts.Components, b.Counts.Components);
    ASSERT_EQ(a.Points.size(), b.Points.size());
    ASSERT_EQ(a.Lines.size(), b.Lines.size());
    for (const DefectType type : { DefectType::OpenBoundary, DefectType::NonManifoldEdge,
           DefectType::InconsistentEdge, DefectType::IntersectionCurve })
    {
      ASSERT_NEAR(Length(a, type), Length(b, type), 1e-12);
    }
  }
}

TEST(SurfaceDefects, TakeNothingFromAnEmptyOrDegenerateSurface)
{
  EXPECT_THROW(Find({}), Error);
  EXPECT_THROW(Find({ { { 0, 0, 0 }, { 1, 1, 1 } }, { { 0, 1, 0 } } }), Error);
  EXPECT_THROW(Find(OpenBox(), -1), Error);
}

TEST(SurfaceDefects, CanBeStoppedInEveryStage)
{
  struct Stopper : Monitor
  {
    std::string Stage;
    bool Continue(const char* stage, double) override { return stage != this->Stage; }
  };
  for (const char* stage : { "validating", "finding self-intersections", "tracing intersections" })
  {
    Stopper monitor;
    monitor.Stage = stage;
    try
    {
      FindSurfaceDefects(RandomSoup(1, 50), 0, Orientation::Automatic, monitor);
      ADD_FAILURE() << "went on while " << stage;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
  }
}
