// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/QuadraticCells.h"

#include "Common/Error.h"

#include <limits>
#include <string>

namespace insideout
{
namespace
{
constexpr std::array<std::array<int, 2>, 6> EdgesOfCell = { { { { 0, 1 } }, { { 1, 2 } },
  { { 2, 0 } }, { { 0, 3 } }, { { 1, 3 } }, { { 2, 3 } } } };

Edge EdgeOf(const Tetrahedron& cell, int k)
{
  return EdgeBetween(cell[EdgesOfCell[k][0]], cell[EdgesOfCell[k][1]]);
}
} // namespace

QuadraticCells MakeQuadraticCells(Id numberOfPoints, const std::vector<Tetrahedron>& cells)
{
  QuadraticCells result;
  result.Edges.reserve(6 * cells.size());
  for (const Tetrahedron& cell : cells)
  {
    for (int k = 0; k < 6; ++k)
    {
      result.Edges.push_back(EdgeOf(cell, k));
    }
  }
  std::sort(result.Edges.begin(), result.Edges.end());
  result.Edges.erase(std::unique(result.Edges.begin(), result.Edges.end()), result.Edges.end());
  result.Edges.shrink_to_fit();
  if (result.Edges.size() >
    static_cast<std::size_t>(std::numeric_limits<Id>::max() - numberOfPoints))
  {
    throw Error(ErrorCode::TooLarge,
      "quadratic cells would have " + std::to_string(result.Edges.size()) +
        " points more, and there would be more than can be counted");
  }

  result.Cells.reserve(cells.size());
  for (const Tetrahedron& cell : cells)
  {
    QuadraticTetrahedron quadratic = { { cell[0], cell[1], cell[2], cell[3] } };
    for (int k = 0; k < 6; ++k)
    {
      const auto found =
        std::lower_bound(result.Edges.begin(), result.Edges.end(), EdgeOf(cell, k));
      quadratic[4 + k] = numberOfPoints + static_cast<Id>(found - result.Edges.begin());
    }
    result.Cells.push_back(quadratic);
  }
  return result;
}
} // namespace insideout
