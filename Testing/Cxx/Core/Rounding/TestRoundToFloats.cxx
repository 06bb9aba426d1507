// SPDX-License-Identifier: GPL-3.0-or-later
#include "Rounding/RoundToFloats.h"

#include "Common/PointPredicates.h"
#include "Resolve/FindIntersections.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/TestMeshes.h"
#include "Support/Turn.h"
#include "Validate/CountedChain.h"
#include "Validate/MergePoints.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace insideout;

namespace
{
/** Boxes turned alike, a little beside one another and cut where they cross: no two facets meet in
 * doubles, but hardly anything lies between them. */
PolygonSurface ResolvedBoxes(unsigned seed, double gap)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  for (int box = 0; box < 4; ++box)
  {
    const double low = gap * box;
    soup = testmeshes::Join(
      soup, testmeshes::Box({ low, low, low }, { 1 + low, 1.5 - low, 2 + 3 * low }));
  }
  soup = testmeshes::Turn(random)(soup);
  Monitor monitor;
  const FacetComplex resolved =
    ResolveSelfIntersections(CountFacets(soup, {}, monitor).Surface, monitor).Surface;
  PolygonSurface surface;
  surface.Points = resolved.Points;
  for (Id f = 0; f < resolved.NumberOfFacets(); ++f)
  {
    Triangle corners = resolved.Facets[f];
    if (resolved.Multiplicity[f] < 0)
    {
      std::swap(corners[1], corners[2]);
    }
    for (int copy = 0; copy < std::abs(resolved.Multiplicity[f]); ++copy)
    {
      surface.Corners.insert(surface.Corners.end(), corners.begin(), corners.end());
      surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
    }
  }
  return surface;
}

/** Each place once: the triangles that FindIntersections takes. */
struct Facets
{
  explicit Facets(const PolygonSurface& surface)
    : Points(surface.Points)
  {
    std::set<Triangle> places;
    const std::vector<Id> merged = MergePoints(this->Points, 0);
    for (std::size_t c = 0; c < surface.Corners.size(); c += 3)
    {
      const Triangle t = { merged[surface.Corners[c]], merged[surface.Corners[c + 1]],
        merged[surface.Corners[c + 2]] };
      for (int k = 0; k < 3; ++k)
      {
        const Id p = t[k];
        const Id q = t[(k + 1) % 3];
        this->EdgeSums[{ std::min(p, q), std::max(p, q) }] += p < q ? 1 : -1;
      }
      Triangle sorted = t;
      std::sort(sorted.begin(), sorted.end());
      const bool isFlat =
        sorted[0] == sorted[1] || sorted[1] == sorted[2] || IsDegenerate(this->Points, sorted);
      this->Degenerate += isFlat;
      if (!isFlat && places.insert(sorted).second)
      {
        this->Triangles.push_back(sorted);
      }
    }
  }

  bool IsClosed() const
  {
    return std::all_of(this->EdgeSums.begin(), this->EdgeSums.end(),
      [](const auto& edge) { return edge.second == 0; });
  }

  std::size_t Crossings() const
  {
    Monitor monitor;
    return FindIntersections(this->Points, this->Triangles, monitor).size();
  }

  std::vector<Point> Points;
  std::vector<Triangle> Triangles;
  std::map<std::array<Id, 2>, int> EdgeSums;
  int Degenerate = 0;
};

void ExpectFloats(const PolygonSurface& surface)
{
  for (const Point& point : surface.Points)
  {
    for (const double x : point)
    {
      const volatile auto single = static_cast<float>(x);
      EXPECT_EQ(double(single), x);
    }
  }
}
} // namespace

TEST(RoundToFloats, KeepsAClosedSurfaceClosedAndTakesNearlyAllCrossingsAway)
{
  Monitor monitor;
  std::size_t crossingsByRoundingAlone = 0;
  std::size_t crossingsLeft = 0;
  int flatByRoundingAlone = 0;
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const bool isWide = seed % 2 == 0; // as wide as floats are apart there
    PolygonSurface surface = ResolvedBoxes(seed, isWide ? 1e-7 : 3e-8);
    const Facets before(surface);
    ASSERT_TRUE(before.IsClosed());
    ASSERT_EQ(before.Crossings(), 0u);
    PolygonSurface alone = surface;
    for (Point& point : alone.Points)
    {
      for (double& x : point)
      {
        const volatile auto single = static_cast<float>(x);
        x = double(single);
      }
    }
    crossingsByRoundingAlone += Facets(alone).Crossings();
    flatByRoundingAlone += Facets(alone).Degenerate;

    const FloatRounding rounding = RoundToFloats(surface, monitor);
    const Facets after(surface);
    ExpectFloats(surface);
    EXPECT_TRUE(after.IsClosed()) << seed;
    EXPECT_EQ(after.Degenerate, 0) << seed;
    EXPECT_EQ(after.Crossings(), static_cast<std::size_t>(rounding.IntersectingPairs)) << seed;
    EXPECT_TRUE(!isWide || rounding.IntersectingPairs == 0) << seed;
    EXPECT_GE(after.Triangles.size(), 12u) << "the box itself stays";
    crossingsLeft += after.Crossings();
  }
  EXPECT_GT(crossingsByRoundingAlone, 30 * crossingsLeft);
  EXPECT_GT(flatByRoundingAlone, 0);
}

TEST(RoundToFloats, LeavesWhatCrossesAlready)
{
  Monitor monitor;
  const TriangleSoup soup = testmeshes::RandomSoup(5, 300);
  PolygonSurface surface;
  surface.Points = soup.Points;
  for (const Triangle& triangle : soup.Triangles)
  {
    surface.Corners.insert(surface.Corners.end(), triangle.begin(), triangle.end());
    surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
  }
  const std::vector<Id> corners = surface.Corners;
  const FloatRounding rounding = RoundToFloats(surface, monitor);
  EXPECT_EQ(surface.Corners, corners);
  EXPECT_GT(Facets(surface).Crossings(), 100u);
  EXPECT_EQ(rounding.IntersectingPairs, 0);
  EXPECT_TRUE(WordsOf(rounding).empty());
}

TEST(RoundToFloats, KeepsBothSidesOfASheet)
{
  Monitor monitor;
  PolygonSurface surface;
  surface.Points = { { 0, 0, 0 }, { 1, 0, 0.1 }, { 0, 1, 0 } };
  surface.Corners = { 0, 1, 2, 0, 2, 1 };
  surface.Offsets = { 0, 3, 6 };
  RoundToFloats(surface, monitor);
  EXPECT_EQ(surface.Offsets.size(), 3u);
}

TEST(RoundToFloats, KeepsTheAttributesOfTriangles)
{
  Monitor monitor;
  PolygonSurface surface;
  surface.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1 + 1e-12, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  surface.Corners = { 0, 3, 1, 1, 3, 2, 0, 1, 4 }; // the second loses its area
  surface.Offsets = { 0, 3, 6, 9 };
  surface.PolygonAttributes = { { "GroupIds", 1, std::vector<std::int32_t>{ 7, 8, 9 } },
    { "Pairs", 2, std::vector<double>{ 1, 2, 3, 4, 5, 6 } } };
  surface.PointAttributes = { { "pressure", 1, std::vector<double>(5, 1.0) } };
  surface.Names = { { "GroupNames", { "wall" } } };
  RoundToFloats(surface, monitor);
  const std::vector<Attribute>& kept = surface.PolygonAttributes;
  EXPECT_EQ(
    std::get<std::vector<std::int32_t>>(kept[0].Values), (std::vector<std::int32_t>{ 7, 9 }));
  EXPECT_EQ(std::get<std::vector<double>>(kept[1].Values), (std::vector<double>{ 1, 2, 5, 6 }));
  EXPECT_TRUE(surface.PointAttributes.empty());
  EXPECT_EQ(surface.Names[0].Values[0], "wall");
}

TEST(RoundToFloats, CountsNearPointsThatItCannotContract)
{
  Monitor monitor;
  PolygonSurface surface;
  surface.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1e-7, 0, 0.0 }, { -1, 0, 0 },
    { 0, -1, 0 } };
  surface.Corners = { 0, 1, 2, 3, 4, 5 };
  surface.Offsets = { 0, 3, 6 };
  const FloatRounding rounding = RoundToFloats(surface, monitor);
  EXPECT_EQ(rounding.NearPoints, 2);
  EXPECT_EQ(WordsOf(rounding),
    "rounded to the floats that the format has: 2 points are nearer to another one than a "
    "millionth of the size");
}

TEST(RoundToFloats, LeavesWhatTheWriterRefuses)
{
  Monitor monitor;
  PolygonSurface quad;
  quad.Points = { { 0, 0, 0 }, { 1, 0, 1.0 / 3 }, { 1, 1, 0 }, { 0, 1, 0 } };
  quad.Corners = { 0, 1, 2, 3 };
  quad.Offsets = { 0, 4 };
  RoundToFloats(quad, monitor);
  EXPECT_EQ(quad.Points[1][2], 1.0 / 3);
  PolygonSurface large = quad;
  large.Corners.pop_back();
  large.Offsets = { 0, 3 };
  large.Points[0][0] = 1e39;
  RoundToFloats(large, monitor);
  EXPECT_EQ(large.Points[0][0], 1e39);
}
