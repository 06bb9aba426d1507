// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Common/Vectors.h"

#include <string>
#include <vector>

namespace testmeshes
{
/** Bodies called A, B and so on, whose points and triangles are numbered one after the other. */
inline std::vector<insideout::Body> BodiesOf(const std::vector<insideout::TriangleSoup>& soups)
{
  std::vector<insideout::Body> bodies;
  insideout::Id points = 0;
  insideout::Id triangles = 0;
  for (const insideout::TriangleSoup& soup : soups)
  {
    bodies.push_back(insideout::MakeBody(
      std::string(1, static_cast<char>('A' + bodies.size())), soup, points, triangles));
    points += static_cast<insideout::Id>(soup.Points.size());
    triangles += static_cast<insideout::Id>(soup.Triangles.size());
  }
  return bodies;
}

/** Such bodies resolved together. */
inline insideout::ResolvedBodies ResolveTouching(
  const std::vector<insideout::TriangleSoup>& soups, double touchTolerance)
{
  insideout::Monitor monitor;
  insideout::BodyParameters parameters;
  parameters.TouchTolerance = touchTolerance;
  return ResolveBodies(BodiesOf(soups), parameters, monitor);
}

/** The area of facets that count for two bodies. */
inline double InterfaceOf(const insideout::ResolvedBodies& bodies)
{
  double area = 0;
  for (insideout::Id f = 0; f < bodies.Surface.NumberOfFacets(); ++f)
  {
    if (bodies.CountOffsets[f + 1] - bodies.CountOffsets[f] == 2)
    {
      const auto [a, b, c] = insideout::CornersOf(bodies.Surface.Points, bodies.Surface.Facets[f]);
      area += insideout::Length(insideout::NormalOf(a, b, c)) / 2;
    }
  }
  return area;
}
} // namespace testmeshes
