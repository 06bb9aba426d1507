// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/SegmentTriangles.h"

#include "Planar/PlanarOutputs.h"
#include "Support/CutReference.h"
#include "Support/PlanarLaws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
using namespace testplanar;

MeshSegmentation SegmentHull(const PlanarHull& hull, const SegmentMeshParameters& parameters = {},
  const std::vector<Seed>& seeds = {})
{
  Monitor monitor;
  return SegmentTriangles(hull.Curve, hull.Mesh, hull.Plane, hull.W, PiecesOfSegments(hull.Mesh),
    seeds, parameters, monitor);
}

/** E from its definition: edges found by their points. */
double EnergyOf(const PlanarHull& hull, const std::vector<unsigned char>& inside)
{
  std::map<Segment, Id> left;
  for (Id c = 0; c < hull.Mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      left[{ { hull.Mesh.Cells[c][k], hull.Mesh.Cells[c][(k + 1) % 3] } }] = c;
    }
  }
  double energy = 0;
  double smooth = 0;
  double length = 0;
  int edges = 0;
  const GraphCutParameters parameters;
  for (const auto& [edge, cell] : left)
  {
    const auto beyond = left.find({ { edge[1], edge[0] } });
    if (beyond != left.end() && edge[0] < edge[1])
    {
      const PlanarPoint& p = hull.Curve.Points[edge[0]];
      const PlanarPoint& q = hull.Curve.Points[edge[1]];
      const double a = std::hypot(p[0] - q[0], p[1] - q[1]);
      const double jump = (hull.W[cell] - hull.W[beyond->second]) / parameters.Sigma;
      length += a;
      ++edges;
      smooth += inside[cell] == inside[beyond->second] ? 0 : a * std::exp(-jump * jump / 2);
    }
  }
  for (std::size_t c = 0; c < inside.size(); ++c)
  {
    energy += std::max(inside[c] ? 1 - hull.W[c] : hull.W[c], 0.0);
  }
  return energy + parameters.Gamma * smooth / (length / edges);
}

/** Open curves with few triangles, so that all labels can be tried. */
std::vector<PlanarHull> SmallHulls()
{
  std::vector<PlanarHull> hulls;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    PlanarHull hull = MeshHullOf(RandomWalk(seed, 12, 6, false));
    if (hull.Mesh.NumberOfCells() <= 14)
    {
      hulls.push_back(std::move(hull));
    }
  }
  return hulls;
}

int WorstPoint(const PlanarHull& hull, const std::vector<unsigned char>& inside)
{
  std::map<Id, int> ends;
  int worst = 0;
  for (const BoundaryEdge& edge : BoundaryEdges(hull.Mesh, inside))
  {
    worst = std::max({ worst, ++ends[edge.Ends[0]], ++ends[edge.Ends[1]] });
  }
  return worst;
}

TEST(SegmentTriangles, FindsTheLeastEnergyOfAllLabels)
{
  const std::vector<PlanarHull> hulls = SmallHulls();
  ASSERT_GT(hulls.size(), 10u);
  for (const PlanarHull& hull : hulls)
  {
    const std::size_t cells = hull.Mesh.Cells.size();
    double least = 1e300;
    for (unsigned labels = 0; labels < 1u << cells; ++labels)
    {
      std::vector<unsigned char> inside(cells);
      for (std::size_t c = 0; c < cells; ++c)
      {
        inside[c] = labels >> c & 1;
      }
      least = std::min(least, EnergyOf(hull, inside));
    }
    EXPECT_NEAR(EnergyOf(hull, SegmentHull(hull).Inside), least, 1e-12);
  }
}

TEST(SegmentTriangles, ChoosesRegionsAndFillsHolesOrMakesADisc)
{
  // A ring of area 8, and a square of area 1.
  const SegmentSoup soup = Lines({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 }, { 1, 1 }, { 2, 1 },
                                   { 2, 2 }, { 1, 2 }, { 4, 0 }, { 5, 0 }, { 5, 1 }, { 4, 1 } },
    { { 0, 1, 2, 3, 0 }, { 4, 7, 6, 5, 4 }, { 8, 9, 10, 11, 8 } });
  const PlanarHull hull = MeshHullOf(soup);
  Monitor monitor;
  const auto areas = [&](const SegmentMeshParameters& parameters)
  {
    std::vector<double> found;
    const MeshSegmentation made = SegmentHull(hull, parameters);
    EXPECT_TRUE(made.Warnings.empty());
    const SolidRegions regions = FindRegions(hull.Mesh, made.Inside, monitor, { "", 0, 1 });
    for (const AreaProperties& region : MeasureRegions(hull.Curve, hull.Mesh, hull.Plane, regions))
    {
      found.push_back(region.Area);
    }
    std::sort(found.begin(), found.end());
    return found;
  };
  SegmentMeshParameters largest;
  largest.Topology.Regions.LargestRegions = 1;
  EXPECT_EQ(areas(largest), std::vector<double>({ 8 }));
  SegmentMeshParameters large;
  large.Topology.Regions.MinimumRegionVolume = 7.5;
  EXPECT_EQ(areas(large), std::vector<double>({ 8 }));
  SegmentMeshParameters filled;
  filled.Topology.Regions.FillCavities = true;
  EXPECT_EQ(areas(filled), std::vector<double>({ 1, 9 }));
  SegmentMeshParameters disc;
  disc.Topology.Goal = TopologyGoal::SimplyConnected;
  EXPECT_EQ(areas(disc).size(), 1u);
  // As many points as edges, less one, and triangles: neither a hole nor two parts that touch.
  std::map<Id, int> points;
  std::map<Segment, int> edges;
  int triangles = 0;
  const MeshSegmentation made = SegmentHull(hull, disc);
  for (std::size_t c = 0; c < made.Inside.size(); ++c)
  {
    triangles += made.Inside[c];
    for (int k = 0; made.Inside[c] && k < 3; ++k)
    {
      const Id a = hull.Mesh.Cells[c][k];
      const Id b = hull.Mesh.Cells[c][(k + 1) % 3];
      points[a] = 1;
      edges[{ { std::min(a, b), std::max(a, b) } }] = 1;
    }
  }
  EXPECT_EQ(static_cast<int>(points.size()) - static_cast<int>(edges.size()) + triangles, 1);
}

TEST(SegmentTriangles, GivesWhereWIsOneOfClosedCurves)
{
  const SegmentSoup soup =
    Lines({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } },
      { { 0, 1, 2, 3, 0 }, { 4, 7, 6, 5, 4 } });
  const PlanarHull hull = MeshHullOf(soup);
  const MeshSegmentation segmentation = SegmentHull(hull);
  for (std::size_t c = 0; c < hull.W.size(); ++c)
  {
    EXPECT_EQ(segmentation.Inside[c], hull.W[c] == 1);
  }
  EXPECT_EQ(BoundaryEdges(hull.Mesh, segmentation.Inside).size(), 8u);
  EXPECT_TRUE(OutlierSegments(hull.Curve, hull.Mesh, segmentation.Inside).empty());
  Monitor monitor;
  const SolidRegions regions = FindRegions(hull.Mesh, segmentation.Inside, monitor, { "", 0, 1 });
  const auto measured = MeasureRegions(hull.Curve, hull.Mesh, hull.Plane, regions);
  ASSERT_EQ(measured.size(), 1u);
  EXPECT_DOUBLE_EQ(measured[0].Area, 8);
  EXPECT_DOUBLE_EQ(measured[0].Center[0], 1.5);
  EXPECT_DOUBLE_EQ(measured[0].Center[1], 1.5);
}

TEST(SegmentTriangles, KeepsEverySegmentAndMakesTheBoundaryAManifold)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const PlanarHull hull = MeshHullOf(RandomWalk(seed, 20, 20, seed % 2 == 0));
    SegmentMeshParameters parameters;
    parameters.ConstrainFacets = true;
    EXPECT_TRUE(
      OutlierSegments(hull.Curve, hull.Mesh, SegmentHull(hull, parameters).Inside).empty());
    parameters.FillNonManifold = true;
    const MeshSegmentation both = SegmentHull(hull, parameters);
    EXPECT_TRUE(OutlierSegments(hull.Curve, hull.Mesh, both.Inside).empty());
    EXPECT_LE(WorstPoint(hull, both.Inside), 2) << "seed " << seed;
  }
}

TEST(SegmentTriangles, GivesNoManifoldUnlessAskedTo)
{
  // Two squares at a corner.
  const PlanarHull hull =
    MeshHullOf(Lines({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } },
      { { 0, 1, 2, 3, 0 }, { 2, 4, 5, 6, 2 } }));
  EXPECT_EQ(WorstPoint(hull, SegmentHull(hull).Inside), 4);
  SegmentMeshParameters parameters;
  parameters.FillNonManifold = true;
  EXPECT_EQ(WorstPoint(hull, SegmentHull(hull, parameters).Inside), 2);
}

TEST(SegmentTriangles, ObeysSeedsAboveThePlane)
{
  const PlanarHull hull = MeshHullOf(
    Lines({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 2 } }, { { 0, 1, 2, 3, 0 }, { 4, 2 } }));
  const std::vector<Seed> seeds = { { { { 0.5, 0.4, 9 } }, false }, { { { 1.2, 1.1, 0 } }, true },
    { { { 5, 5, 0 } }, true } };
  const MeshSegmentation segmentation = SegmentHull(hull, {}, seeds);
  EXPECT_EQ(segmentation.Warnings.size(), 1u);
  int outside = 0;
  int added = 0;
  for (std::size_t c = 0; c < hull.W.size(); ++c)
  {
    outside += hull.W[c] > 0.5 && !segmentation.Inside[c];
    added += hull.W[c] < 0.5 && segmentation.Inside[c];
  }
  EXPECT_GE(outside, 1);
  EXPECT_GE(added, 1);
}

TEST(JoinAlong, FollowsSegmentsOfOneKeyAroundAndBetweenBranches)
{
  const std::vector<Segment> segments = { { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } }, { { 3, 4 } },
    { { 4, 5 } }, { { 4, 6 } }, { { 7, 8 } }, { { 8, 9 } } };
  const auto lines = JoinAlong(segments, { 0, 0, 0, 0, 0, 0, 1, 2 });
  EXPECT_EQ(
    lines, (std::vector<std::vector<Id>>{ { 0, 1, 2 }, { 3 }, { 4 }, { 5 }, { 6 }, { 7 } }));
}
} // namespace
