// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"

namespace insideout
{
/** Whether a change of the mesh may bring new points in the volume. */
enum class VolumePoints
{
  None,
  AsNeeded
};

/** A part of space that is to be filled with cells. */
struct Sector
{
  std::vector<Triangle> Walls; ///< its boundary, counter-clockwise seen from inside
  std::vector<Id> Corners;     ///< of the walls; the infinite vertex is none
  bool IsInfinite = false;     ///< it is beyond the hull
};

/** Fills sectors with cells that meet in one point: a corner that sees all walls, or a new point.
 */
class SectorFiller
{
public:
  explicit SectorFiller(FlippableMesh& mesh)
    : Mesh(mesh)
  {
  }

  /**
   * Append the cells of all sectors to `fresh`.
   * @param[in] inside a point that all walls are seen from, or nearly: new points are near it
   * @return false, and no new point, if that cannot be done
   */
  bool Fill(const std::vector<Sector>& sectors, const Point& inside, VolumePoints volumePoints,
    std::vector<Tetrahedron>& fresh);

private:
  bool SeesAll(const Sector& sector, Id apex) const;
  Id FindApex(const Sector& sector) const;
  Id NewApex(const Sector& sector, const Point& inside) const;

  FlippableMesh& Mesh;
};
} // namespace insideout
