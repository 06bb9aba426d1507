// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terrain/TerrainProof.h"

#include "Resolve/MeetBeyondSharedCorners.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace insideout;
using namespace testmeshes;

namespace
{
/** All edges less those that run opposite ways, by definition. */
std::vector<BorderEdge> BorderOf(const TriangleSoup& soup)
{
  std::map<std::array<Id, 2>, int> sums;
  for (const Triangle& t : soup.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id from = t[k];
      const Id to = t[(k + 1) % 3];
      sums[{ std::min(from, to), std::max(from, to) }] += from < to ? 1 : -1;
    }
  }
  std::vector<BorderEdge> border;
  for (const auto& [edge, sum] : sums)
  {
    for (int n = 0; n < std::abs(sum); ++n)
    {
      border.push_back(sum > 0 ? BorderEdge{ edge[0], edge[1] } : BorderEdge{ edge[1], edge[0] });
    }
  }
  return border;
}

bool ShowsAll(const TriangleSoup& soup, const AxisView& view)
{
  return std::all_of(soup.Triangles.begin(), soup.Triangles.end(),
    [&](const Triangle& t) { return view.ShowsFront(soup.Points, t); });
}

const AxisView FromAbove{ 2 };

bool IsProved(const TriangleSoup& soup, const AxisView& view = FromAbove)
{
  EXPECT_TRUE(ShowsAll(soup, view));
  return IsTerrain(soup.Points, view, BorderOf(soup));
}

/** Whether any two triangles meet beyond shared corners: all pairs are asked. */
bool AnyMeet(const TriangleSoup& soup)
{
  for (std::size_t i = 0; i < soup.Triangles.size(); ++i)
  {
    for (std::size_t j = i + 1; j < soup.Triangles.size(); ++j)
    {
      if (MeetBeyondSharedCorners(soup.Points, soup.Triangles[i], soup.Triangles[j]))
      {
        return true;
      }
    }
  }
  return false;
}

/** Squares of two triangles each, `across` and `along`, with a point for each of their corners. */
template <typename Place>
TriangleSoup Sheet(int across, int along, const Place& place)
{
  TriangleSoup sheet;
  for (int i = 0; i <= across; ++i)
  {
    for (int j = 0; j <= along; ++j)
    {
      sheet.Points.push_back(place(i, j));
    }
  }
  for (int i = 0; i < across; ++i)
  {
    for (int j = 0; j < along; ++j)
    {
      const Id a = i * (along + 1) + j;
      const Id b = a + along + 1;
      sheet.Triangles.push_back({ a, b, b + 1 });
      sheet.Triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return sheet;
}

/** A ramp that goes around an axis and up. */
TriangleSoup Ramp(double turns, double rise)
{
  const int steps = 24;
  return Sheet(1, steps,
    [&](int i, int j)
    {
      const double angle = 2 * std::acos(-1.0) * turns * j / steps;
      return Point{ (1 + i) * std::cos(angle), (1 + i) * std::sin(angle), rise * j };
    });
}

TriangleSoup Hills(unsigned seed, double height)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  return Sheet(9, 11,
    [&](int i, int j) {
      return Point{ i + 0.4 * number(random), j + 0.4 * number(random), height * number(random) };
    });
}

TEST(TerrainProof, HoldsForHillsInAllSixViews)
{
  for (std::size_t view = 0; view < AxisView::Count; ++view)
  {
    TriangleSoup hills = Hills(static_cast<unsigned>(view), 3);
    for (Point& p : hills.Points)
    {
      const std::size_t axis = view % 3;
      Point moved;
      moved[(axis + 1) % 3] = p[0];
      moved[(axis + 2) % 3] = p[1];
      moved[axis] = p[2];
      p = moved;
    }
    hills = view < 3 ? hills : Reversed(hills);
    for (std::size_t other = 0; other < AxisView::Count; ++other)
    {
      EXPECT_EQ(ShowsAll(hills, AxisView(other)), other == view);
    }
    EXPECT_TRUE(IsProved(hills, AxisView(view)));
    EXPECT_FALSE(AnyMeet(hills));
  }
}

TEST(TerrainProof, TellsHowFarADirectionPointsTowardsTheView)
{
  const Point direction = { 1, -2, 3 };
  const std::array<double, AxisView::Count> expected = { 1, -2, 3, -1, 2, -3 };
  for (std::size_t view = 0; view < AxisView::Count; ++view)
  {
    EXPECT_EQ(AxisView(view).Towards(direction), expected[view]);
  }
}

TEST(TerrainProof, ProvesNothingThatMeets)
{
  // Waves that break more and more; of each what shows its front from above.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  int proved = 0;
  int meeting = 0;
  for (int i = 0; i < 400; ++i)
  {
    const double size = 1.5 * i / 400;
    TriangleSoup sheet = Sheet(6, 6,
      [&](int x, int y) {
        return Point{ x + size * number(random), y + size * number(random), size * number(random) };
      });
    const auto isHidden = [&](const Triangle& t) { return !FromAbove.ShowsFront(sheet.Points, t); };
    sheet.Triangles.erase(std::remove_if(sheet.Triangles.begin(), sheet.Triangles.end(), isHidden),
      sheet.Triangles.end());
    const bool isProved = IsProved(sheet);
    const bool meet = AnyMeet(sheet);
    EXPECT_FALSE(isProved && meet) << i;
    proved += isProved;
    meeting += meet;
  }
  EXPECT_GT(proved, 100);
  EXPECT_GT(meeting, 100);
}

TEST(TerrainProof, ProvesNothingThatMeetsOnAGrid)
{
  // Few places, so that corners, edges and triangles coincide in all ways.
  std::mt19937 random(2);
  std::uniform_int_distribution<int> number(0, 3);
  int proved = 0;
  int meeting = 0;
  for (int i = 0; i < 20000; ++i)
  {
    TriangleSoup soup;
    std::map<Point, Id> ids; // but now and then two for one place
    for (int t = 0; t < 2 + i % 4; ++t)
    {
      Triangle corners;
      for (Id& p : corners)
      {
        const Point place = { double(number(random)), double(number(random)),
          double(i % 2) * number(random) };
        const auto [known, isNew] = ids.insert({ place, static_cast<Id>(soup.Points.size()) });
        if (isNew || i % 16 == 0)
        {
          known->second = static_cast<Id>(soup.Points.size());
          soup.Points.push_back(place);
        }
        p = known->second;
      }
      if (!FromAbove.ShowsFront(soup.Points, corners))
      {
        std::swap(corners[0], corners[1]);
      }
      const auto hasCorners = [&](Triangle other)
      {
        Triangle one = corners;
        std::sort(one.begin(), one.end());
        std::sort(other.begin(), other.end());
        return one == other;
      };
      if (FromAbove.ShowsFront(soup.Points, corners) &&
        std::none_of(soup.Triangles.begin(), soup.Triangles.end(), hasCorners))
      {
        soup.Triangles.push_back(corners);
      }
    }
    if (soup.Triangles.size() > 1)
    {
      const bool isProved = IsProved(soup);
      const bool meet = AnyMeet(soup);
      EXPECT_FALSE(isProved && meet) << i;
      proved += isProved;
      meeting += meet;
    }
  }
  EXPECT_GT(proved, 200);
  EXPECT_GT(meeting, 5000);
}

TEST(TerrainProof, ARampThatCoversItselfIsNotProved)
{
  EXPECT_TRUE(IsProved(Ramp(0.9, 0.1)));
  EXPECT_FALSE(IsProved(Ramp(1.5, 0.1))); // though nothing meets there,
  EXPECT_FALSE(AnyMeet(Ramp(1.5, 0.1)));
  EXPECT_FALSE(IsProved(Ramp(1.5, 0))); // for here it does
  EXPECT_TRUE(AnyMeet(Ramp(1.5, 0)));
}

TEST(TerrainProof, EdgesOfTheBorderMustNotMeet)
{
  // Around three quarters, and on until a corner touches the first edge from outside.
  TriangleSoup touching;
  touching.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 1, 1, 5 }, { -1, 1, 5 },
    { -1, -1, 5 }, { 0, -1, 5 }, { 1, 0, 0 } };
  touching.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 5 }, { 0, 5, 6 }, { 6, 7, 0 } };
  EXPECT_TRUE(IsProved(touching));
  touching.Triangles.push_back({ 7, 8, 0 }); // along the first edge, under another id
  EXPECT_FALSE(IsProved(touching));
  EXPECT_TRUE(AnyMeet(touching));
}

TEST(TerrainProof, NoEdgeIsLeftTwice)
{
  TriangleSoup two;
  two.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.2, 0.5, 0 } };
  two.Triangles = { { 0, 1, 2 }, { 0, 1, 3 } };
  EXPECT_FALSE(IsProved(two));
  EXPECT_TRUE(AnyMeet(two));
}

TEST(TerrainProof, TheBorderMustBeInOnePiece)
{
  TriangleSoup nested;
  nested.Points = { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 } };
  nested.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  EXPECT_FALSE(IsProved(nested));
  EXPECT_TRUE(AnyMeet(nested));

  // A ring has two pieces, too: it is a terrain, but not proved to be one.
  TriangleSoup ring = Ramp(1, 0);
  for (Triangle& t : ring.Triangles)
  {
    for (Id& p : t)
    {
      p = p % 25 == 24 ? p - 24 : p;
    }
  }
  EXPECT_FALSE(AnyMeet(ring));
  EXPECT_FALSE(IsProved(ring));
}

TEST(TerrainProof, EdgesTakeTurnsAroundAnEnd)
{
  // Two triangles with one corner in common: beside each other, and one upon the other.
  TriangleSoup two;
  two.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { -4, 1, 0 }, { -4, -1, 0 } };
  two.Triangles = { { 0, 1, 2 }, { 0, 3, 4 } };
  EXPECT_TRUE(IsProved(two));
  EXPECT_FALSE(AnyMeet(two));
  two.Points[3] = { 2, 0.5, 0 };
  two.Points[4] = { 2, 1.5, 0 };
  EXPECT_FALSE(IsProved(two));
  EXPECT_TRUE(AnyMeet(two));
}

TEST(TerrainProof, CornersOfOnePlaceAndTwoIdsAreNotShared)
{
  // A ring of triangles around a square, open at a corner, where both ends touch.
  TriangleSoup ring;
  ring.Points = { { 1, 0, 0 }, { 3, 0, 0 }, { 4, 2, 0 }, { 2, 4, 0 }, { 0, 2, 0 }, { 1, 0, 0 },
    { 1, 2, 0 }, { 2, 1, 0 }, { 3, 2, 0 }, { 2, 3, 0 } };
  ring.Triangles = { { 0, 1, 7 }, { 1, 2, 8 }, { 1, 8, 7 }, { 2, 3, 9 }, { 2, 9, 8 }, { 3, 4, 9 },
    { 4, 6, 9 }, { 4, 5, 6 } };
  EXPECT_FALSE(IsProved(ring));
  EXPECT_TRUE(AnyMeet(ring));
  ring.Points[5] = { 0.5, 0, 0 };
  EXPECT_TRUE(IsProved(ring));
  EXPECT_FALSE(AnyMeet(ring));
}

TEST(TerrainProof, ThinnestGapsAreSeen)
{
  // Two triangles joined at one corner; between the others there is one bit of a coordinate.
  TriangleSoup two;
  two.Points = { { 0, 0, 0 }, { 1, 0.25, 0 }, { 1, 0.75, 0 }, { 2, 0.5, 0 }, { 2, 1.5, 0 } };
  two.Triangles = { { 0, 1, 2 }, { 0, 3, 4 } };
  for (int k = 0; k < 3; ++k)
  {
    two.Points[3] = { 3, 2.25, 0 }; // on the line from corner 0 through corner 2
    two.Points[4] = { 3, 3, 0 };
    two.Points[3][1] = std::nextafter(2.25, k == 0 ? 0 : k == 1 ? 9 : 2.25);
    EXPECT_EQ(IsProved(two), k == 1);
    EXPECT_EQ(AnyMeet(two), k != 1);
  }
}
} // namespace
