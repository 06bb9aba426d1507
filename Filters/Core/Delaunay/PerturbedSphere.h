// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/SignOfDeterminant.h"
#include "Common/Types.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
/** Squared lengths of which a product of five neither over- nor underflows. */
constexpr double SmallestSquare = 1e-50;
constexpr double LargestSquare = 1e50;

/** Two doubles that are computed with at once. */
using TwoDoubles = double __attribute__((vector_size(16)));

inline TwoDoubles Swapped(TwoDoubles a)
{
  return TwoDoubles{ a[1], a[0] };
}

/**
 * 1 within the sphere, -1 beyond it, if certain in doubles: the determinant of Shewchuk 1997, whose
 * terms come in pairs.
 */
inline int SideOfSphereInDoubles(
  const Point& a, const Point& b, const Point& c, const Point& d, const Point& e)
{
  std::array<TwoDoubles, 3> ac;
  std::array<TwoDoubles, 3> bd;
  for (int k = 0; k < 3; ++k)
  {
    ac[k] = TwoDoubles{ a[k], c[k] } - TwoDoubles{ e[k], e[k] };
    bd[k] = TwoDoubles{ b[k], d[k] } - TwoDoubles{ e[k], e[k] };
  }
  const TwoDoubles ca0 = Swapped(ac[0]);
  const TwoDoubles ca1 = Swapped(ac[1]);
  // Minors of x and y: of a and b, c and d; of b and c, d and a; of a and c, b and d.
  const TwoDoubles abCd = ac[0] * bd[1] - bd[0] * ac[1];
  const TwoDoubles bcDa = bd[0] * ca1 - ca0 * bd[1];
  const double minorAc = ac[0][0] * ac[1][1] - ac[0][1] * ac[1][0];
  const double minorBd = bd[0][0] * bd[1][1] - bd[0][1] * bd[1][0];
  // Those of x, y and z: of a, b, c and c, d, a; of b, c, d and d, a, b.
  const TwoDoubles abcCda = ac[2] * bcDa + Swapped(ac[2]) * abCd +
    TwoDoubles{ -bd[2][0], bd[2][1] } * TwoDoubles{ minorAc, minorAc };
  const TwoDoubles bcdDab = bd[2] * Swapped(abCd) + Swapped(bd[2]) * bcDa +
    TwoDoubles{ -ac[2][1], ac[2][0] } * TwoDoubles{ minorBd, minorBd };
  const TwoDoubles squaresAc = ac[0] * ac[0] + ac[1] * ac[1] + ac[2] * ac[2];
  const TwoDoubles squaresBd = bd[0] * bd[0] + bd[1] * bd[1] + bd[2] * bd[2];
  const TwoDoubles halves = squaresAc * bcdDab - squaresBd * Swapped(abcCda);
  const double determinant = halves[0] + halves[1];
  // 24 products of a squared length and three differences, each off by at most 20 roundings.
  const double square =
    std::max(std::max(squaresAc[0], squaresAc[1]), std::max(squaresBd[0], squaresBd[1]));
  constexpr double error = 500 * DoubleEpsilon;
  const bool isCertain = square > SmallestSquare && square < LargestSquare &&
    determinant * determinant > error * error * square * square * square * square * square;
  return !isCertain ? Undecided : determinant > 0 ? 1 : -1;
}

/** IsInSphere where doubles do not suffice. */
bool IsInSphereExactly(
  const Point& a, const Point& b, const Point& c, const Point& d, const Point& e);

/**
 * Whether e is within the sphere through a positive tetrahedron a, b, c, d (Orient3D). Points on
 * the sphere count as moved by infinitely small amounts, which depend on the lexicographic order of
 * their coordinates alone (Devillers, Teillaud 2011). So any points have one Delaunay
 * tetrahedralization, without flat cells.
 *
 * @param[in] e at none of the other places
 */
inline bool IsInSphere(
  const Point& a, const Point& b, const Point& c, const Point& d, const Point& e)
{
  const int side = SideOfSphereInDoubles(a, b, c, d, e);
  return side == Undecided ? IsInSphereExactly(a, b, c, d, e) : side > 0;
}
} // namespace insideout
