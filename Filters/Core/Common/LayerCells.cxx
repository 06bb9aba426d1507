// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/LayerCells.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Whether a face of a part is half of a quad: the other faces are triangles of the cell, or within
 * it. */
bool IsHalfOf(const Triangle& face, const std::array<Id, 4>& quad)
{
  return std::all_of(face.begin(), face.end(),
    [&](Id corner) { return std::find(quad.begin(), quad.end(), corner) != quad.end(); });
}

template <std::size_t Quads>
CellPart PartOf(const Tetrahedron& corners, const std::array<std::array<Id, 4>, Quads>& quads)
{
  CellPart part = { corners, {} };
  for (int k = 0; k < 4; ++k)
  {
    part.IsHalf[k] = std::any_of(quads.begin(), quads.end(),
      [&](const auto& quad) { return IsHalfOf(FaceOf(corners, k), quad); });
  }
  return part;
}

/** The same prism with its lowest corner first. */
Prism LowestFirst(const Prism& p)
{
  const auto lowest = std::min_element(p.begin(), p.end()) - p.begin();
  const Prism other = { { p[3], p[5], p[4], p[0], p[2], p[1] } };
  const Prism& from = lowest < 3 ? p : other;
  const auto first = std::min_element(from.begin(), from.begin() + 3) - from.begin();
  Prism turned;
  for (int k = 0; k < 3; ++k)
  {
    turned[k] = from[(first + k) % 3];
    turned[k + 3] = from[(first + k) % 3 + 3];
  }
  return turned;
}
} // namespace

int OrientPrism(const std::array<Point, 3>& first, const std::array<Point, 3>& second, int k)
{
  return std::min(Orient3D(first[0], first[2], first[1], second[k]),
    Orient3D(second[0], second[1], second[2], first[k]));
}

int Orient(const std::vector<Point>& points, const Prism& prism)
{
  const auto first = CornersOf(points, Triangle{ { prism[0], prism[1], prism[2] } });
  const auto second = CornersOf(points, Triangle{ { prism[3], prism[4], prism[5] } });
  return std::min({ OrientPrism(first, second, 0), OrientPrism(first, second, 1),
    OrientPrism(first, second, 2) });
}

int Orient(const std::vector<Point>& points, const Pyramid& pyramid)
{
  int least = 1;
  for (int k = 0; k < 4; ++k)
  {
    least = std::min(least,
      Orient3D(points, { { pyramid[k], pyramid[(k + 1) % 4], pyramid[(k + 2) % 4], pyramid[4] } }));
  }
  return least;
}

Prism NodesOfC3D6(const Prism& prism)
{
  return { { prism[3], prism[4], prism[5], prism[0], prism[1], prism[2] } };
}

Prism NodesOfC3D6(const Pyramid& pyramid)
{
  return { { pyramid[4], pyramid[3], pyramid[2], pyramid[4], pyramid[0], pyramid[1] } };
}

void AppendParts(const Prism& prism, std::vector<CellPart>& parts)
{
  const Prism p = LowestFirst(prism);
  const std::array<std::array<Id, 4>, 3> quads = { { { { p[0], p[1], p[4], p[3] } },
    { { p[1], p[2], p[5], p[4] } }, { { p[2], p[0], p[3], p[5] } } } };
  parts.push_back(PartOf({ { p[0], p[5], p[4], p[3] } }, quads));
  if (std::min(p[1], p[5]) < std::min(p[2], p[4]))
  {
    parts.push_back(PartOf({ { p[0], p[2], p[1], p[5] } }, quads));
    parts.push_back(PartOf({ { p[0], p[5], p[1], p[4] } }, quads));
  }
  else
  {
    parts.push_back(PartOf({ { p[0], p[2], p[1], p[4] } }, quads));
    parts.push_back(PartOf({ { p[0], p[5], p[2], p[4] } }, quads));
  }
}

void AppendParts(const Pyramid& p, std::vector<CellPart>& parts)
{
  const std::array<std::array<Id, 4>, 1> base = { { { { p[0], p[1], p[2], p[3] } } } };
  const int first = std::min(p[0], p[2]) < std::min(p[1], p[3]) ? 0 : 1;
  for (const int k : { first, first + 2 })
  {
    parts.push_back(PartOf({ { p[k % 4], p[(k + 1) % 4], p[(k + 2) % 4], p[4] } }, base));
  }
}
} // namespace insideout
