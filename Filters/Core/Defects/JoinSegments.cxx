// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/JoinSegments.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** The segments by their ends; each is walked along once. */
class SegmentWalk
{
public:
  explicit SegmentWalk(const std::vector<std::array<Id, 2>>& segments)
    : Segments(segments)
    , Done(segments.size(), 0)
  {
    for (const std::array<Id, 2>& segment : segments)
    {
      const std::size_t highest = std::max(segment[0], segment[1]);
      this->Begin.resize(std::max(this->Begin.size(), highest + 3), 0);
      ++this->Begin[segment[0] + 2];
      ++this->Begin[segment[1] + 2];
    }
    for (std::size_t p = 2; p < this->Begin.size(); ++p)
    {
      this->Begin[p] += this->Begin[p - 1];
    }
    // Counted one point ahead, so that filling moves each Begin to where it belongs.
    this->Ends.resize(2 * segments.size());
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      this->Ends[this->Begin[segments[s][0] + 1]++] = static_cast<Id>(s);
      this->Ends[this->Begin[segments[s][1] + 1]++] = static_cast<Id>(s);
    }
  }

  Id NumberOfPoints() const
  {
    return this->Begin.empty() ? 0 : static_cast<Id>(this->Begin.size() - 2);
  }

  bool GoesOnThrough(Id p) const { return this->Begin[p + 1] - this->Begin[p] == 2; }

  /** One polyline for every segment at the point that is not done yet. */
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
    for (Id k = this->Begin[p]; k < this->Begin[p + 1]; ++k)
    {
      if (!this->Done[this->Ends[k]])
      {
        return this->Ends[k];
      }
    }
    return None;
  }

  const std::vector<std::array<Id, 2>>& Segments;
  std::vector<char> Done;
  std::vector<Id> Begin; ///< the segments at point p are Ends[Begin[p]] to Ends[Begin[p + 1]]
  std::vector<Id> Ends;
};
} // namespace

std::vector<std::vector<Id>> JoinSegments(const std::vector<std::array<Id, 2>>& segments)
{
  SegmentWalk walk(segments);
  std::vector<std::vector<Id>> lines;
  for (const bool onLoops : { false, true }) // what is left after the first round are loops
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
