// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <vector>

namespace insideout
{
/** A piece of the surface, by its points' ids and places. */
struct SurfacePiece
{
  Triangle Corners;
  std::array<Point, 3> Places;
  Id Facet; ///< of the input
};

/** As long as twice its area. */
Point NormalOf(const SurfacePiece& piece);

/** Whether a triangle is so thin that it may fold over by rounding. */
bool IsThin(const std::array<Point, 3>& triangle);

/** Whether pieces of one plane, all seen from one side, look where a normal does. Where cells are
 * flat their signs do not tell. */
bool AreUnfolded(const std::vector<SurfacePiece>& pieces, const Point& normal);

/** Whether all fresh pieces look where the gone ones do, all together. */
bool LookAlike(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);

/** Whether each fresh piece looks where the one that it was does. */
bool EachLooksAlike(
  const std::vector<SurfacePiece>& before, const std::vector<SurfacePiece>& fresh);

/** The piece that the face of a cell across from corner k is, counter-clockwise seen from within.
 */
SurfacePiece PieceAt(const RefinableMesh& mesh, Id cell, int k);

/** Let pieces take the place of others in an exchange. */
void ExchangePieces(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh,
  CellExchange& exchange);

/** All pieces of facets, each once, by the points of the mesh. */
std::vector<SurfacePiece> PiecesOf(const RefinableMesh& mesh);
} // namespace insideout
