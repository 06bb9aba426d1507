// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <random>

/** Surfaces that tests are made of. Every closed one has its normals outward. */
namespace testmeshes
{
using namespace insideout;

/** The box from `low` to `high`, 12 triangles. */
inline TriangleSoup Box(Point low, Point high)
{
  TriangleSoup box;
  for (int i = 0; i < 8; ++i)
  {
    box.Points.push_back(
      { i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2] });
  }
  box.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return box;
}

/** Both surfaces in one; points are not merged. */
inline TriangleSoup Join(TriangleSoup a, const TriangleSoup& b)
{
  const Id offset = static_cast<Id>(a.Points.size());
  a.Points.insert(a.Points.end(), b.Points.begin(), b.Points.end());
  for (const Triangle& t : b.Triangles)
  {
    a.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
  return a;
}

/** The surface with every triangle turned over. */
inline TriangleSoup Reversed(TriangleSoup soup)
{
  for (Triangle& t : soup.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return soup;
}

/**
 * Random triangles on the integer grid {0..size-1}^3, where everything degenerate happens: shared
 * points and edges, overlaps, points on edges. No triangle is itself degenerate and no two have the
 * same three points; equal points are one.
 */
TriangleSoup GridSoup(unsigned seed, int triangles, int size);

/** Random triangles with coordinates in [0, 1), each with points of its own. */
TriangleSoup RandomSoup(unsigned seed, int triangles);

/** The soup as it is: each triangle a facet of multiplicity 1, its own source. Nothing is merged.
 */
FacetComplex ToComplex(const TriangleSoup& soup);

/** The soup with points at equal coordinates made one, the first of them. */
TriangleSoup Merged(const TriangleSoup& soup);

/** `blades` triangles through the z axis, each on both sides of it, slanted and of ever other size.
 */
TriangleSoup Fan(int blades);

/**
 * `fans` fans of `needles` needles of length 173 each, 0.001 apart from each other and 1 wide, in
 * parallel planes along a diagonal of space: the bounding boxes of all triangles meet, and they
 * meet in no more than common corners and edges.
 */
TriangleSoup SlantedFans(int fans, int needles);

/** `count` random triangles that all contain the origin, up to rounding, away from their edges. */
TriangleSoup ThroughOnePoint(unsigned seed, int count);

/** `teeth` thin triangles that stand on a long one, each touching it with one corner. */
TriangleSoup Comb(int teeth);
} // namespace testmeshes
