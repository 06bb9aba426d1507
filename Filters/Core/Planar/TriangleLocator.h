// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "Common/PointPredicates.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
/** Finds the triangles that places are in. */
class TriangleLocator
{
public:
  /** @param[in] points, mesh have to live as long */
  TriangleLocator(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh);

  /** The lowest cell that a place is in, boundary included, and that is good, by isGood(cell); None
   * where there is none. */
  template <typename IsGood>
  Id Find(const PlanarPoint& place, const IsGood& isGood) const
  {
    Id found = None;
    const Point flat = { { place[0], place[1], 0 } };
    this->Tree.Visit({ flat, flat },
      [&](Id cell)
      {
        if ((found == None || cell < found) && isGood(cell) && this->Contains(cell, place))
        {
          found = cell;
        }
      });
    return found;
  }

private:
  bool Contains(Id cell, const PlanarPoint& place) const;

  const std::vector<PlanarPoint>& Points;
  const PlanarMesh& Mesh;
  const BoxTree Tree;
};
} // namespace insideout
