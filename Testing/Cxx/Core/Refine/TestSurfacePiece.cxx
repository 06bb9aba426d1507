// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SurfacePiece.h"

#include <gtest/gtest.h>

#include <utility>

using namespace insideout;

namespace
{
SurfacePiece Piece(const std::array<Point, 3>& places)
{
  return { { { 0, 1, 2 } }, places, 0 };
}

/** The pieces of a quadrilateral by each of its diagonals. */
struct Strip
{
  explicit Strip(double height)
  {
    const Point a = { 0, 0, 0 };
    const Point b = { 0.9, -0.2 * height, 0 };
    const Point c = { 1, 0, 0 };
    const Point d = { 0.5, height, 0 };
    this->Across = { Piece({ a, b, c }), Piece({ a, c, d }) };
    this->Upright = { Piece({ a, b, d }), Piece({ d, b, c }) };
  }

  std::vector<SurfacePiece> Across; ///< with the lowest piece
  std::vector<SurfacePiece> Upright;
};

std::vector<SurfacePiece> TurnedOver(std::vector<SurfacePiece> pieces)
{
  for (SurfacePiece& piece : pieces)
  {
    std::swap(piece.Places[1], piece.Places[2]);
  }
  return pieces;
}

TEST(LookAlike, NeedlesMayReplaceNeedlesOfALowerLeastHeightWhicheverWayTheyFace)
{
  const Strip needles(1e-8);
  EXPECT_TRUE(LookAlike(needles.Across, needles.Upright));
  EXPECT_TRUE(LookAlike(needles.Across, TurnedOver(needles.Upright)));
  EXPECT_FALSE(LookAlike(needles.Upright, needles.Across));
}

TEST(LookAlike, APieceOfOnePlaceMayNotReplaceANeedle)
{
  const Strip needles(1e-8);
  const Point a = { 0, 0, 0 };
  EXPECT_FALSE(LookAlike(needles.Across, { Piece({ a, a, a }), Piece({ a, a, a }) }));
}

TEST(LookAlike, NeedlesAndPiecesTurnedOverMayNotReplaceOthers)
{
  const Strip wide(1e-2);
  const Strip needles(1e-8);
  EXPECT_TRUE(LookAlike(wide.Across, wide.Upright));
  EXPECT_TRUE(LookAlike(wide.Upright, wide.Across));
  EXPECT_FALSE(LookAlike(wide.Across, TurnedOver(wide.Upright)));
  EXPECT_FALSE(LookAlike(wide.Across, needles.Upright));
  EXPECT_FALSE(LookAlike({ needles.Across[0], wide.Across[1] }, needles.Upright));
}
} // namespace
