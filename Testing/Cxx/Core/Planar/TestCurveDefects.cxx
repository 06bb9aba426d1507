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
  EXPECT_EQ(defects.Area, 1);
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
  EXPECT_EQ(defects.Area, 17);
  EXPECT_EQ(defects.TurnedSegments, (std::vector<Id>{ 4, 5, 6, 7 }));
}
} // namespace
