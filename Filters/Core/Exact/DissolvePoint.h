// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FillSector.h"
#include "Exact/SegmentTable.h"

namespace insideout
{
/**
 * Takes Steiner points out of a mesh. The facets (and faces of the hull) that have the point cut
 * the cells around it into sectors. The facets are triangulated without the point, and each sector
 * is filled with cells that meet in one of its own corners, if one sees all of its boundary; or
 * else, where that is allowed, in a new point within (the idea of George, Borouchaki and Saltel
 * 2003: a point that splits a segment goes into the volume on each side).
 */
class PointDissolver
{
public:
  PointDissolver(FlippableMesh& mesh, SegmentTable& segments)
    : Mesh(mesh)
    , Segments(segments)
    , Filler(mesh)
  {
  }

  /** @return whether the point is gone */
  bool Dissolve(Id point, VolumePoints volumePoints);

private:
  /** Faces around the point in one plane, from the edge before it to the one behind it, or a disk.
   */
  struct Fan
  {
    Id Facet; ///< None for faces of the hull and for free faces that only separate sectors
    std::vector<Id> Points; ///< the other ends of the edges from the point, in order
    bool IsClosed;          ///< the last point is beside the first
    std::vector<Triangle> Pieces;
  };

  void FindSupport(Id point);
  bool FindFans(Id point);
  bool FollowFan(Id point, bool onHull, Fan& fan) const;
  bool AddSeparators(Id point);
  bool IsHullFace(Id cell, int face) const;
  bool IsWall(Id point, Id cell, int face) const;
  bool TriangulateFans(Id point, int way);
  bool CutEars(Id off, int side, Fan& fan, int start) const;
  bool FindSectors(Id point);
  void AddOuterWall(Id point, Id cell, Sector& sector) const;
  bool AddFanWalls(Id point);
  bool Fill(Id point, VolumePoints volumePoints);
  void MarkPieces() const;

  FlippableMesh& Mesh;
  SegmentTable& Segments;
  SectorFiller Filler;

  std::vector<Id> Star;
  Id Segment = None;
  Id Before = None;
  Id Behind = None;
  std::vector<Fan> Fans;
  std::vector<Sector> Sectors;
  std::vector<Id> SectorOf; ///< per cell, which is told for those of Star only
};
} // namespace insideout
