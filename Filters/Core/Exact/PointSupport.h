// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"

namespace insideout
{
/** What of the surface a vertex lies on. */
struct PointSupport
{
  Id Segment = None;      ///< one that the vertex is within or an end of, None for none
  std::vector<Id> Facets; ///< whose faces have the vertex, ascending
};

PointSupport FindPointSupport(const FlippableMesh& mesh, const SegmentTable& segments, Id vertex);
} // namespace insideout
