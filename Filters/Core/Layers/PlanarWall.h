// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Layers/LayerParameters.h"
#include "Layers/PlanarRims.h"
#include "Layers/WallDirections.h"

#include <vector>

namespace insideout
{
/** A constraint of the triangles behind layers. */
struct SegmentBehind
{
  Segment Ends; ///< of PlanarWall::Places
  Id Edge;      ///< of the input, 3 * cell + edge
  bool IsOuter;
};

/** The points of a plane by orthonormal coordinates, the third of which is 0. */
std::vector<Point> FlatPoints(const std::vector<PlanarPoint>& points, const PlanarMetric& metric);

/**
 * A wall of edges in a plane, and the places to which its points move behind layers. The moved
 * wall, the layers' sides and the other constraints cross nothing, no layer contains a point of
 * them, and all cells of layers are positive, exactly.
 */
struct PlanarWall
{
  std::vector<Segment> Facets; ///< the wall's edges, the solid on their left
  WallPoints AtWall;
  std::vector<Point> Flat; ///< FlatPoints of the mesh
  PlanarRims Rims;
  std::vector<WallDirection> Directions; ///< per point of the mesh, as the next three
  std::vector<double> Heights;           ///< of all layers
  std::vector<Id> FirstAt; ///< the first in the same place: a solid may touch itself in two points
  std::vector<Id> InnerOf; ///< the place behind the layers; None without layers

  std::vector<PlanarPoint> Places; ///< the points of the mesh, then those behind layers
  std::vector<Id> OwnerOf;         ///< per place behind layers its point of the wall
  double Height = 0;               ///< of all layers, where there is room
  Id Narrow = 0;                   ///< number of points for which a gap is too narrow

  Id NumberOfPoints() const { return static_cast<Id>(this->Flat.size()); }
  bool IsLifted(Id point) const { return this->InnerOf[point] != None; }

  /** The place that replaces a point behind the layers. */
  Id Behind(Id point) const { return this->IsLifted(point) ? this->InnerOf[point] : point; }

  /** The first place that is equal. */
  Id First(Id place) const { return place < this->NumberOfPoints() ? this->FirstAt[place] : place; }

  /** The constraints behind the layers. */
  std::vector<SegmentBehind> SegmentsBehind() const;

  /** The layers of each edge of the wall, cut along a diagonal. */
  PlanarMesh HalvesOfLayers() const;
};

/**
 * Move the points of a wall as far as MakePlanarLayers says.
 *
 * @throws Error as MakePlanarLayers
 */
PlanarWall PushPlanarWall(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
  const std::vector<Id>& wall, const PlanarMetric& metric, const LayerParameters& parameters,
  Monitor& monitor);
} // namespace insideout
