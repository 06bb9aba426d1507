// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <vector>

namespace insideout
{
/** A piece of the surface, by its points' ids and coordinates. */
struct SurfacePiece
{
  Triangle Corners;
  std::array<Point, 3> Places;
  Id Facet; ///< facet of the input
};

/** The normal, with twice the area as length. */
Point NormalOf(const SurfacePiece& piece);

Point CentreOf(const std::array<Point, 3>& triangle);

/** The center of mass of pieces. @return false if they have no area */
bool FindCenter(const std::vector<SurfacePiece>& pieces, Point& center);

/** The least height of pieces over their longest edge: 0.87 if they are equilateral. */
double LowestOf(const std::vector<SurfacePiece>& pieces);

double LongestEdgeOf(const std::array<Point, 3>& triangle);

/** Whether a triangle is so thin that it may fold over by rounding. */
bool IsThin(const std::array<Point, 3>& triangle);

/** Whether the area of a triangle is a rounding error. */
bool HasNoArea(const std::array<Point, 3>& triangle);

/**
 * Whether coplanar pieces, all seen from one side, face a normal's direction. Signs of thin pieces
 * are rounding errors and do not count.
 */
bool AreUnfolded(const std::vector<SurfacePiece>& pieces, const Point& normal);

/**
 * Whether all fresh pieces face the same way as the gone ones together. If the gone ones are all
 * thin, their normals are rounding errors: it suffices that the least height grows.
 */
bool LookAlike(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);

/**
 * Whether each fresh piece faces the same way as the one it replaces. One that replaces a thin one
 * may be thin itself: its normal is a rounding error.
 * @param[in] low height at or below which both pieces may face anywhere
 */
bool EachLooksAlike(
  const std::vector<SurfacePiece>& before, const std::vector<SurfacePiece>& fresh, double low);

/** The piece of the cell's face opposite to corner k, counter-clockwise seen from within. */
SurfacePiece PieceAt(const RefinableMesh& mesh, Id cell, int k);

/** Record pieces and their replacements in an exchange. */
void ExchangePieces(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh,
  CellExchange& exchange);

/** All pieces of facets, each once, seen from the side of the larger region. */
std::vector<SurfacePiece> PiecesOf(const RefinableMesh& mesh);
} // namespace insideout
