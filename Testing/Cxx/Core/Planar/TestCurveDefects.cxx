// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/CurveDefects.h"

#include "Support/PlanarLaws.h"

#include <gtest/gtest.h>

namespace
{
using namespace testplanar;

CurveDefects DefectsOf(const SegmentSoup& soup)
{
  Monitor monitor;
  return FindCurveDefects(soup, FindPlane(soup.Points), {}, monitor);
}

std::size_t Count(const CurveDefects& defects, CurveDefect type)
{
  std::size_t count = 0;
  for (const CurveDefectPoint& point : defects.Points)
  {
    count += point.Type == type;
  }
  return count;
}

TEST(CurveDefects, FindsNothingWrongWithASquare)
{
  const CurveDefects defects =
    DefectsOf(Lines({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2, 3, 0 } }));
  EXPECT_TRUE(defects.Points.empty());
  EXPECT_EQ(defects.IntersectingPairs, 0u);
  EXPECT_EQ(defects.Areas.Winding, 1);
  EXPECT_TRUE(defects.TurnedSegments.empty());
  for (const SegmentDefects& segment : defects.Segments)
  {
    EXPECT_EQ(segment.Component, 0);
    EXPECT_FALSE(segment.Degenerate || segment.Duplicate);
  }
}

TEST(CurveDefects, FindsEveryCrossingOfRandomSegments)
{
  const SegmentSoup soup = RandomSegments(9, 60);
  const CurveDefects defects = DefectsOf(soup);
  EXPECT_EQ(Count(defects, CurveDefect::OpenEnd), 120u);
  EXPECT_EQ(Count(defects, CurveDefect::Crossing), defects.IntersectingPairs);
  EXPECT_EQ(Count(defects, CurveDefect::TJunction), 0u);
  std::size_t met = 0;
  for (const SegmentDefects& segment : defects.Segments)
  {
    met += static_cast<std::size_t>(segment.SelfIntersections);
  }
  EXPECT_EQ(met, 2 * defects.IntersectingPairs);
}

TEST(CurveDefects, NamesThePointsWhereSegmentsOverlap)
{
  const CurveDefects defects = DefectsOf(Lines({ { 0, 0 }, { 3, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 } },
    { { 0, 1 }, { 2, 3, 4 }, { 3, 2 }, { 4, 4 } }));
  ASSERT_EQ(Count(defects, CurveDefect::TJunction), 2u);
  EXPECT_EQ(defects.Counts.CancelledSegments, 1);
  EXPECT_TRUE(defects.Segments.back().Degenerate);
  EXPECT_TRUE(defects.Segments[3].Duplicate);
}

TEST(CurveDefects, MeasuresWhatIsEnclosedOnceLinesAreTurned)
{
  // A square of 16, a clockwise one of 1 beside it, a line that encloses nothing.
  const CurveDefects defects = DefectsOf(Lines({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 5, 0 },
                                                 { 5, 1 }, { 6, 1 }, { 6, 0 }, { 8, 0 }, { 9, 3 } },
    { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 }, { 8, 9 } }));
  EXPECT_EQ(defects.Areas.Winding, 17);
  EXPECT_EQ(defects.TurnedSegments, (std::vector<Id>{ 4, 5, 6, 7 }));
}

TEST(CurveDefects, TellWhatAHoleAcrossItsOutlineMeansByThreeRules)
{
  // 100 by 80, and a hole of 40 by 30 of which 40 by 8.8 are outside.
  SegmentSoup soup = Lines({ { 0, 0 }, { 100, 0 }, { 100, 80 }, { 0, 80 }, { 30, 58.8 },
                             { 30, 88.8 }, { 70, 88.8 }, { 70, 58.8 } },
    { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 } });
  const auto expect = [&](Orientation orientation, double winding, double asGiven)
  {
    Monitor monitor;
    PlanarHullParameters parameters;
    parameters.Orientation = orientation;
    const CurveDefects defects =
      FindCurveDefects(soup, FindPlane(soup.Points), parameters, monitor);
    EXPECT_NEAR(defects.Areas.Winding, winding, 1e-9);
    EXPECT_NEAR(defects.Areas.EvenOdd, 7504, 1e-9);
    EXPECT_NEAR(defects.Areas.AsGiven, asGiven, 1e-9);
    return defects;
  };
  const CurveDefects automatic = expect(Orientation::Automatic, 8352, 7152);
  EXPECT_TRUE(automatic.Areas.Differ());
  ASSERT_EQ(automatic.Warnings.size(), 2u);
  EXPECT_EQ(automatic.Warnings[1],
    "the contours enclose an area of 8352 by the winding number, 7504 by even-odd and 7152 as "
    "given: "
    "Orientation chooses");
  EXPECT_TRUE(expect(Orientation::AsGiven, 7152, 7152).Areas.Differ());
  // Two outlines that overlap are one area; that all run clockwise is no hole.
  std::swap(soup.Points[5], soup.Points[7]);
  EXPECT_FALSE(expect(Orientation::Automatic, 8352, 8352).Areas.Differ());
  for (Segment& segment : soup.Segments)
  {
    std::swap(segment[0], segment[1]);
  }
  EXPECT_FALSE(expect(Orientation::Automatic, 8352, 0).Areas.Differ());
}

TEST(CurveDefects, TellWhatAHoleThatRunsLikeItsOutlineMeansByThreeRules)
{
  // As contours of DICOM: an outline, a hole and an island in it, all of which run the same way.
  const CurveDefects defects =
    DefectsOf(Lines({ { 0, 0 }, { 6, 0 }, { 6, 6 }, { 0, 6 }, { 1, 1 }, { 5, 1 }, { 5, 5 },
                      { 1, 5 }, { 2, 2 }, { 4, 2 }, { 4, 4 }, { 2, 4 } },
      { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 }, { 8, 9, 10, 11, 8 } }));
  EXPECT_EQ(defects.Areas.Winding, 36);
  EXPECT_EQ(defects.Areas.EvenOdd, 24);
  EXPECT_EQ(defects.Areas.AsGiven, 36);
  EXPECT_TRUE(defects.Areas.Differ());
  ASSERT_EQ(defects.Warnings.size(), 1u);
  EXPECT_EQ(defects.Warnings[0],
    "the contours enclose an area of 36 by the winding number, 24 by even-odd and 36 as given: a "
    "contour within another is a hole only if it runs the other way");
}

TEST(CurveDefects, TellOfAHoleThatRunsLikeItsOutlineBesideOutlinesThatCross)
{
  // A square with a smaller one in it; and apart from them two squares that overlap.
  const auto square = [](double x, double y, double side)
  {
    return std::vector<std::array<double, 2>>{ { x, y }, { x + side, y }, { x + side, y + side },
      { x, y + side } };
  };
  std::vector<std::array<double, 2>> points;
  for (const auto& corners :
    { square(0, 0, 6), square(1, 1, 4), square(10, 0, 4), square(12, 2, 4) })
  {
    points.insert(points.end(), corners.begin(), corners.end());
  }
  const auto defects = [&](std::size_t squares)
  {
    std::vector<std::vector<Id>> lines;
    for (Id i = 0; i < 4; ++i)
    {
      if (squares == 4 || i != 1)
      {
        lines.push_back({ 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3, 4 * i });
      }
    }
    return DefectsOf(Lines(points, lines));
  };
  const CurveDefects nested = defects(4);
  EXPECT_EQ(nested.Areas.Winding, 36 + 28);
  EXPECT_EQ(nested.Areas.EvenOdd, 20 + 24);
  EXPECT_TRUE(nested.Areas.Within);
  EXPECT_FALSE(nested.Areas.Across);
  EXPECT_FALSE(defects(3).Areas.Differ());
}

TEST(CurveDefects, TellNothingOfAHoleWithinItsOutline)
{
  const CurveDefects defects = DefectsOf(
    Lines({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 1 }, { 1, 2 }, { 2, 2 }, { 2, 1 } },
      { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 } }));
  EXPECT_EQ(defects.Areas.Winding, 15);
  EXPECT_EQ(defects.Areas.EvenOdd, 15);
  EXPECT_EQ(defects.Areas.AsGiven, 15);
  EXPECT_FALSE(defects.Areas.Differ());
  EXPECT_TRUE(defects.Warnings.empty());
}
} // namespace
