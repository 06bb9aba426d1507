// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FillSector.h"
#include "Exact/SegmentTable.h"

namespace insideout
{
/**
 * Flips in a plane: where two faces in one plane are a strictly convex quadrilateral, its other
 * diagonal takes the place of their common edge, whatever is above and below. The cells around the
 * edge are two sectors, one on each side of the plane (SectorFiller); a sector that no corner sees
 * all of gets a new point in the volume.
 */
class FlatFlipper
{
public:
  FlatFlipper(FlippableMesh& mesh, const SegmentTable& segments)
    : Mesh(mesh)
    , Segments(segments)
    , Filler(mesh)
  {
  }

  /**
   * Make a and b see each other along the plane that they span with the edges that the segment
   * between them crosses: flip these, the ones that then cross it no more first (Sloan 1993).
   * @return whether the edge is there; else some flips may have been made
   */
  bool MakeEdge(Id a, Id b);

  /** Flip one edge. @return whether that was possible; p and q are then the ends of the new one */
  bool Flip(Id u, Id v, VolumePoints volumePoints, Id& p, Id& q);

  /**
   * Put a new point in the place of an edge: near its middle, connected with all that is around.
   * @return whether that was possible
   */
  bool StarEdge(Id u, Id v);

private:
  bool FindRing(Id u, Id v);
  bool AddWalls(std::size_t k, Sector& sector) const;
  Point MiddleOfEdge() const;
  bool FindQuadrilateral(Id u, Id v);

  FlippableMesh& Mesh;
  const SegmentTable& Segments;
  SectorFiller Filler;
  EdgeRing Ring;
  std::size_t Second = 0; ///< index in the ring of the point across the plane from its first
};
} // namespace insideout
