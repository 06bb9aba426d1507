// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SizeSources.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace insideout
{
namespace
{
Box ReachOf(const SizeSource& source)
{
  return BoundingBox({ source.Corners.begin(), source.Corners.end() }).Widened(source.Reach);
}
} // namespace

SizeSources::SizeSources(const std::vector<SizeSource>& sources, double grading)
  : Grading(grading)
{
  std::map<int, std::vector<SizeSource>> byExponent;
  for (const SizeSource& source : sources)
  {
    byExponent[std::ilogb(source.Length)].push_back(source);
  }
  for (auto& [exponent, alike] : byExponent)
  {
    double shortest = alike.front().Length;
    std::vector<Box> boxes;
    for (const SizeSource& source : alike)
    {
      shortest = std::min(shortest, source.Length);
      boxes.push_back(ReachOf(source));
    }
    this->Octaves.push_back({ shortest, std::move(alike), BoxTree(boxes) });
  }
}

double SizeSources::LengthAt(const Point& place) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Octave& octave : this->Octaves)
  {
    octave.Tree.VisitNearestFirst([&](const Box& box)
      { return std::sqrt(SquaredDistance(box, place)); },
      [&] { return least > octave.Shortest ? (least - octave.Shortest) / this->Grading : -1; },
      [&](Id i)
      {
        const SizeSource& source = octave.Sources[i];
        const double distance = Distance(NearestPointOf(source.Corners, place), place);
        least =
          std::min(least, source.Length + this->Grading * std::max(0.0, distance - source.Reach));
      });
  }
  return least;
}
} // namespace insideout
