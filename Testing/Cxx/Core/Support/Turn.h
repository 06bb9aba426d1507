// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Vectors.h"

#include <random>

namespace testmeshes
{
using namespace insideout;

/** Turns about the origin by a random rotation: two reflections. */
class Turn
{
public:
  explicit Turn(std::mt19937& random)
  {
    std::normal_distribution<double> normal;
    for (Point& mirror : this->Mirrors)
    {
      mirror = { normal(random), normal(random), normal(random) };
    }
  }

  TriangleSoup operator()(TriangleSoup soup) const
  {
    for (Point& p : soup.Points)
    {
      for (const Point& mirror : this->Mirrors)
      {
        const double by = 2 * Dot(mirror, p) / Dot(mirror, mirror);
        p = { p[0] - by * mirror[0], p[1] - by * mirror[1], p[2] - by * mirror[2] };
      }
    }
    return soup;
  }

private:
  std::array<Point, 2> Mirrors;
};
} // namespace testmeshes
