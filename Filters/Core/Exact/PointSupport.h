// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"

namespace insideout
{
/** What of the surface a Steiner point lies on. */
struct PointSupport
{
  Id Segment = None;      ///< that the point is within, None for none
  std::vector<Id> Facets; ///< whose faces have the point, ascending
};

PointSupport FindPointSupport(const FlippableMesh& mesh, const SegmentTable& segments, Id point);
} // namespace insideout
