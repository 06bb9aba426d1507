// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/Body.h"

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
} // namespace testmeshes
