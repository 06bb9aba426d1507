// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PointSupport.h"

#include "Common/SortUniquely.h"

namespace insideout
{
PointSupport FindPointSupport(const FlippableMesh& mesh, const SegmentTable& segments, Id point)
{
  PointSupport support;
  support.Segment = segments.Around(point);
  std::vector<Id> star;
  mesh.Star(point, star);
  for (const Id id : star)
  {
    const FlippableCell& cell = mesh.Cell(id);
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] != point && cell.Facets[k] != None)
      {
        support.Facets.push_back(cell.Facets[k]);
      }
    }
  }
  SortUniquely(support.Facets);
  return support;
}
} // namespace insideout
