// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/BoundaryTriangles.h"
#include "Resolve/FindIntersections.h"
#include "Validate/FacetEdges.h"

#include <gtest/gtest.h>

namespace testmeshes
{
/** Boundary triangles as a surface. */
inline insideout::TriangleSoup SoupOf(const std::vector<insideout::Point>& points,
  const std::vector<insideout::BoundaryTriangle>& triangles)
{
  insideout::TriangleSoup soup = { points, {} };
  for (const insideout::BoundaryTriangle& triangle : triangles)
  {
    soup.Triangles.push_back(triangle.Corners);
  }
  return soup;
}

/** Watertight, and without crossings. */
inline void ExpectSound(const insideout::TriangleSoup& surface)
{
  insideout::ForEachEdge(insideout::SortedFacetEdges(surface.Triangles),
    [](const insideout::FacetEdge* first, const insideout::FacetEdge* last)
    {
      int sum = 0;
      for (const insideout::FacetEdge* edge = first; edge != last; ++edge)
      {
        sum += edge->Direction;
      }
      EXPECT_EQ(sum, 0) << first->Low << " " << first->High;
    });
  insideout::Monitor monitor;
  EXPECT_TRUE(insideout::FindIntersections(surface.Points, surface.Triangles, monitor).empty());
}
} // namespace testmeshes
