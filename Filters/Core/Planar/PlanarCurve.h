// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/PlanarPoint.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** From one point to another: the counterpart of a triangle of a surface. */
using Segment = std::array<Id, 2>;

/** A curve as given, in one plane: points and segments, unchecked. */
struct SegmentSoup
{
  std::vector<Point> Points;
  std::vector<Segment> Segments;

  /** The count of each segment, if known (edges of polygons); else empty. */
  std::vector<std::int16_t> Multiplicity = {};

  /** Not 0 for segments that shape the mesh but do not count; empty if all count. */
  std::vector<unsigned char> NonParticipating = {};
};

/** A given segment that a segment of the complex is a piece of, and whether the latter runs the
 * other way. */
struct SegmentSource
{
  Id Segment;
  bool Reversed;
};

/**
 * Segments with their counts: the curve between the stages, as FacetComplex is the surface. After
 * counting, no two have the same two points, and all have a length. After resolving, no two
 * constraints meet except in shared points, and no point lies within one.
 *
 * Segment s is made of the input segments Sources[SourceOffsets[s]] to
 * Sources[SourceOffsets[s + 1]], and Multiplicity[s] is their signed count along its own direction.
 */
struct SegmentComplex
{
  std::vector<PlanarPoint> Points;  ///< coordinates from Plane::Project
  std::vector<PointOrigin> Origins; ///< one per point
  std::vector<Segment> Segments;
  std::vector<std::int16_t> Multiplicity; ///< one per segment
  std::vector<Id> SourceOffsets = { 0 };  ///< one per segment, and the end
  std::vector<SegmentSource> Sources;     ///< sorted by segment within a segment

  /** Segments from here on could not be resolved: they count, but are not constraints. */
  Id NumberOfConstraints = 0;

  Id NumberOfSegments() const { return static_cast<Id>(this->Segments.size()); }
};

/**
 * The lowest given segment that a segment is a piece of, preferring those that run along `side` (+1
 * the segment's own direction, -1 the other).
 */
inline Id SourceOfSegment(const SegmentComplex& curve, Id segment, int side)
{
  const Id first = curve.SourceOffsets[segment];
  for (Id s = first; s < curve.SourceOffsets[segment + 1]; ++s)
  {
    if (curve.Sources[s].Reversed == (side < 0))
    {
      return curve.Sources[s].Segment;
    }
  }
  return curve.Sources[first].Segment;
}

/** Edge k of a triangle, as VTK numbers it: from corner k to the next. */
constexpr Segment EdgeOf(const Triangle& cell, int k)
{
  return { { cell[k], cell[(k + 1) % 3] } };
}

/**
 * Triangles of the convex hull of a SegmentComplex, which has their points. They run
 * counter-clockwise, exactly.
 */
struct PlanarMesh
{
  std::vector<Triangle> Cells;
  /// neighbors across edge k (EdgeOf), None outside the hull
  std::vector<std::array<Id, 3>> Neighbors;
  std::vector<std::array<Id, 3>> Segments; ///< the segment on edge k, None for none

  /** +1 if that segment runs as the cell does, -1 against it, 0 for no segment. */
  std::vector<std::array<std::int8_t, 3>> SegmentSides;

  Id NumberOfCells() const { return static_cast<Id>(this->Cells.size()); }
};

/** The jump of the winding number on entering cell `cell` through its edge `k`. */
inline int MultiplicityOnEntering(
  const SegmentComplex& curve, const PlanarMesh& mesh, Id cell, int k)
{
  const Id segment = mesh.Segments[cell][k];
  return segment == None ? 0 : mesh.SegmentSides[cell][k] * curve.Multiplicity[segment];
}
} // namespace insideout
