// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/JoinSegments.h"

#include "Common/Buckets.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** One more than the highest id. */
std::size_t NumberOfPointsOf(const std::vector<std::array<Id, 2>>& segments)
{
  Id highest = None;
  for (const std::array<Id, 2>& segment : segments)
  {
    highest = std::max({ highest, segment[0], segment[1] });
  }
  return static_cast<std::size_t>(highest + 1);
}

/** The segments by their ends; each is traced once. */
class SegmentWalk
{
public:
  explicit SegmentWalk(const std::vector<std::array<Id, 2>>& segments)
    : Segments(segments)
    , Done(segments.size(), 0)
    , AtPoints(NumberOfPointsOf(segments),
        [&](auto visit)
        {
          for (std::size_t s = 0; s < segments.size(); ++s)
          {
            visit(segments[s][0], static_cast<Id>(s));
            visit(segments[s][1], static_cast<Id>(s));
          }
        })
  {
  }

  Id NumberOfPoints() const { return static_cast<Id>(this->AtPoints.Size()); }

  bool GoesOnThrough(Id p) const { return this->AtPoints[p].Size() == 2; }

  /** Trace one polyline for every untraced segment at the point. */
  void WalkFrom(Id start, std::vector<std::vector<Id>>& lines)
  {
    for (Id segment = this->Next(start); segment != None; segment = this->Next(start))
    {
      lines.push_back({ start });
      Id at = start;
      while (segment != None)
      {
        this->Done[segment] = 1;
        at = this->Segments[segment][this->Segments[segment][0] == at];
        lines.back().push_back(at);
        segment = at != start && this->GoesOnThrough(at) ? this->Next(at) : None;
      }
    }
  }

private:
  Id Next(Id p) const
  {
    const auto segments = this->AtPoints[p];
    const auto next = std::find_if(
      segments.begin(), segments.end(), [this](Id segment) { return !this->Done[segment]; });
    return next == segments.end() ? None : *next;
  }

  const std::vector<std::array<Id, 2>>& Segments;
  std::vector<char> Done;
  const Buckets<Id> AtPoints; ///< the segments that end there
};
} // namespace

std::vector<std::vector<Id>> JoinSegments(const std::vector<std::array<Id, 2>>& segments)
{
  SegmentWalk walk(segments);
  std::vector<std::vector<Id>> lines;
  for (const bool onLoops : { false, true }) // after the first round only loops remain
  {
    for (Id p = 0; p < walk.NumberOfPoints(); ++p)
    {
      if (onLoops || !walk.GoesOnThrough(p))
      {
        walk.WalkFrom(p, lines);
      }
    }
  }
  return lines;
}
} // namespace insideout
