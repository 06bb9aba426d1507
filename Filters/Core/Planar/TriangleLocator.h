// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "Common/PointPredicates.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
/** Locates points in triangles. */
class TriangleLocator
{
public:
  /** @param[in] points, mesh have to outlive this object */
  TriangleLocator(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh);

  /** The lowest cell with isGood(cell) that contains a place, boundary included; None if there is
   * none. */
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
