// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/CutLayers.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace insideout;

namespace
{
constexpr double Radius = 1e-13;

/** Two large facets whose corners differ by `height` from a plane: they cross along its middle. */
struct CrossedSheets
{
  explicit CrossedSheets(double height, double tilt = 0)
    : Points{ { 0, 0, -height }, { 4, 0, height }, { 0, 4, height + 4 * tilt }, { 1, 1, height },
      { 5, 1, -height }, { 1, 5, -height } }
  {
  }

  std::vector<PlanarSubdivision> Cut() const
  {
    Monitor monitor;
    return CutLayers(
      { this->Points, this->Facets }, { { { 0, 1 } } }, Radius, monitor, { "", 0, 1 });
  }

  std::vector<Point> Points;
  std::vector<Triangle> Facets{ { 0, 1, 2 }, { 3, 4, 5 } };
};

/**
 * Two bands of facets around an axis, `turn` radians long: the second is ahead by half a facet, so
 * that each facet is a layer of two of the other band and the groups go on to the end.
 */
struct Bands
{
  explicit Bands(double turn)
  {
    const double width = 300 * Radius;
    const double fromAxis = width * width / (2 * Radius);
    const Id count = static_cast<Id>(turn * fromAxis / width);
    for (const double ahead : { 0.0, 0.5 })
    {
      const Id first = static_cast<Id>(this->Points.size());
      for (Id k = 0; k <= count; ++k)
      {
        const double angle = (k + ahead) * width / fromAxis;
        const double x = fromAxis * std::cos(angle);
        const double y = fromAxis * std::sin(angle);
        this->Points.insert(this->Points.end(), { { x, y, 0 }, { x, y, 2 * width } });
      }
      for (Id k = first; k < first + 2 * count; k += 2)
      {
        this->Facets.insert(this->Facets.end(), { { k, k + 2, k + 1 }, { k + 2, k + 3, k + 1 } });
      }
    }
  }

  /** The number of groups. */
  std::size_t Cut() const
  {
    std::vector<std::array<Id, 2>> pairs;
    for (Id f = 1; f < static_cast<Id>(this->Facets.size()); ++f)
    {
      pairs.push_back({ 0, f });
    }
    Monitor monitor;
    return CutLayers({ this->Points, this->Facets }, pairs, Radius, monitor, { "", 0, 1 }).size();
  }

  std::vector<Point> Points;
  std::vector<Triangle> Facets;
};

/** How many pieces have both facets as sources. */
std::size_t Shared(const PlanarSubdivision& subdivision)
{
  std::size_t count = 0;
  for (const Piece& piece : subdivision.Pieces)
  {
    count += piece.Sources.size() == 2;
  }
  return count;
}
} // namespace

TEST(CutLayers, GivesOverlappingLayersTheSamePieces)
{
  const auto subdivisions = CrossedSheets(1e-15).Cut();
  ASSERT_EQ(subdivisions.size(), 1u);
  EXPECT_EQ(subdivisions[0].Facets.size(), 2u);
  // The overlap is the triangle between corner 3 and the hypotenuse of the first facet.
  EXPECT_EQ(Shared(subdivisions[0]), 1u);
}

TEST(CutLayers, LeavesFacetsThatAreExactlyInOnePlaneToTheExactCut)
{
  EXPECT_TRUE(CrossedSheets(0).Cut().empty());
}

TEST(CutLayers, LeavesFacetsFartherApartThanTheRadius)
{
  EXPECT_TRUE(CrossedSheets(1e-12).Cut().empty());
  EXPECT_TRUE(CrossedSheets(1e-15, 1e-9).Cut().empty());
}

TEST(CutLayers, LeavesFacetsTooNarrowToTellTheirPlane)
{
  CrossedSheets sheets(1e-15);
  sheets.Points[5] = { 3, 1 + 1e-12, -1e-15 };
  EXPECT_TRUE(sheets.Cut().empty());
}

TEST(CutLayers, SpreadsOverTheFacetsThatOverlapTheLayersWithoutCrossing)
{
  CrossedSheets sheets(1e-15);
  sheets.Points.insert(
    sheets.Points.end(), { { 0.5, 0.5, 3e-14 }, { 0.75, 0.5, 3e-14 }, { 0.5, 0.75, 3e-14 } });
  sheets.Facets.push_back({ 6, 7, 8 });
  const auto subdivisions = sheets.Cut();
  ASSERT_EQ(subdivisions.size(), 1u);
  EXPECT_EQ(subdivisions[0].Facets.size(), 3u);
}

TEST(CutLayers, LeavesLayersThatTurnUntilTheyAreSeenEdgeOn)
{
  EXPECT_EQ(Bands(0.1).Cut(), 1u);
  EXPECT_EQ(Bands(1.6).Cut(), 0u);
}
