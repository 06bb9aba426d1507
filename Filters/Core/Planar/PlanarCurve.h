// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/PlanarPoint.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** From one point to another: what a triangle is to a surface. */
using Segment = std::array<Id, 2>;

/** A curve as it was given, all of it in one plane: points and segments, nothing checked. */
struct SegmentSoup
{
  std::vector<Point> Points;
  std::vector<Segment> Segments;

  /** How often each segment counts, where that is known (edges of polygons); else empty. */
  std::vector<std::int16_t> Multiplicity = {};

  /** Not 0 for segments that shape the mesh but do not count; empty where every one does. */
  std::vector<unsigned char> NonParticipating = {};
};

/** An input segment that one of the complex is a piece of, and whether that one runs the other way.
 */
struct SegmentSource
{
  Id Segment;
  bool Reversed;
};

/**
 * Segments with what they count: the curve between the stages, as FacetComplex is the surface.
 * After counting no two have the same two points and none is without length; after resolving no two
 * of the constraints meet except in shared points, and no point lies within one.
 *
 * Segment s is made of the input segments Sources[SourceOffsets[s]] to
 * Sources[SourceOffsets[s + 1]], and Multiplicity[s] is their signed count along its own direction.
 */
struct SegmentComplex
{
  std::vector<PlanarPoint> Points;  ///< as Plane::Project has them
  std::vector<PointOrigin> Origins; ///< one per point
  std::vector<Segment> Segments;
  std::vector<std::int16_t> Multiplicity; ///< one per segment
  std::vector<Id> SourceOffsets = { 0 };  ///< one per segment, and the end
  std::vector<SegmentSource> Sources;     ///< sorted by segment within a segment

  /** Segments from here on could not be resolved: they count, but are no constraints. */
  Id NumberOfConstraints = 0;

  Id NumberOfSegments() const { return static_cast<Id>(this->Segments.size()); }
};

/**
 * The lowest input segment that a segment is a piece of: of those that run along `side` (+1 the
 * segment's own direction, -1 the other) if there is one.
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
  std::vector<std::array<Id, 3>> Neighbors; ///< across edge k (EdgeOf), None beyond the hull
  std::vector<std::array<Id, 3>> Segments;  ///< that edge k is, None for none

  /** +1 where that segment runs as the cell does, -1 against it, 0 for no segment. */
  std::vector<std::array<std::int8_t, 3>> SegmentSides;

  Id NumberOfCells() const { return static_cast<Id>(this->Cells.size()); }
};

/** By how much the winding number rises when one enters cell `cell` through its edge `k`. */
inline int MultiplicityOnEntering(
  const SegmentComplex& curve, const PlanarMesh& mesh, Id cell, int k)
{
  const Id segment = mesh.Segments[cell][k];
  return segment == None ? 0 : mesh.SegmentSides[cell][k] * curve.Multiplicity[segment];
}
} // namespace insideout
