// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ShortestInHull.h"

#include "Common/Vectors.h"

#include <algorithm>

namespace insideout
{
Point ShortestInHull(const std::vector<Point>& vectors, int steps)
{
  Point shortest = vectors.front();
  for (int step = 0; step < steps; ++step)
  {
    const Point* least = &vectors.front();
    for (const Point& vector : vectors)
    {
      if (Dot(vector, shortest) < Dot(*least, shortest))
      {
        least = &vector;
      }
    }
    const Point towards = Difference(*least, shortest);
    const double squared = Dot(towards, towards);
    const double gain = -Dot(towards, shortest);
    if (!(gain > 1e-3 * Dot(shortest, shortest)))
    {
      break;
    }
    const double t = std::min(1.0, gain / squared);
    shortest = { { shortest[0] + t * towards[0], shortest[1] + t * towards[1],
      shortest[2] + t * towards[2] } };
  }
  return shortest;
}
} // namespace insideout
