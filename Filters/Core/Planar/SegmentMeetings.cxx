// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/SegmentMeetings.h"

#include "Common/BoxTree.h"
#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"

#include <algorithm>

namespace insideout
{
namespace
{
constexpr Id BlockSize = 256; ///< number of the tree's nodes, or of segments, per task of a thread

Box BoxOf(const std::vector<PlanarPoint>& points, const Segment& segment)
{
  const PlanarPoint& a = points[segment[0]];
  const PlanarPoint& b = points[segment[1]];
  return { { { std::min(a[0], b[0]), std::min(a[1], b[1]), 0 } },
    { { std::max(a[0], b[0]), std::max(a[1], b[1]), 0 } } };
}

/** Tests pairs of segments, and records where they meet. */
class MeetingFinder
{
public:
  MeetingFinder(const std::vector<PlanarPoint>& points, const std::vector<Segment>& segments)
    : Points(points)
    , Segments(segments)
  {
  }

  void Test(Id i, Id j, SegmentMeetings& found) const
  {
    const Segment& s = this->Segments[i];
    const Segment& t = this->Segments[j];
    const std::size_t before = found.Touches.size() + found.Crossings.size();
    const int shared = (s[0] == t[0] || s[0] == t[1]) + (s[1] == t[0] || s[1] == t[1]);
    if (shared == 1)
    {
      this->TestNeighbors(i, j, found);
    }
    else if (shared == 0)
    {
      this->TestApart(i, j, found);
    }
    found.Pairs += found.Touches.size() + found.Crossings.size() > before;
  }

private:
  int Side(const Segment& segment, Id p) const
  {
    return Orient2D(this->Points[segment[0]], this->Points[segment[1]], this->Points[p]);
  }

  /** Whether a point on a segment's line, not an end, lies within the segment. */
  bool IsWithin(const Segment& segment, Id p) const
  {
    const Box box = BoxOf(this->Points, segment);
    return box.Holds({ { this->Points[p][0], this->Points[p][1], 0 } });
  }

  /** Segments with one common end meet elsewhere only if they overlap. */
  void TestNeighbors(Id i, Id j, SegmentMeetings& found) const
  {
    const Segment& s = this->Segments[i];
    const Segment& t = this->Segments[j];
    const Id endOfT = t[0] == s[0] || t[0] == s[1] ? t[1] : t[0];
    if (this->Side(s, endOfT) != 0)
    {
      return;
    }
    const Id endOfS = s[0] == t[0] || s[0] == t[1] ? s[1] : s[0];
    if (this->IsWithin(s, endOfT))
    {
      found.Touches.push_back({ i, endOfT });
    }
    else if (this->IsWithin(t, endOfS))
    {
      found.Touches.push_back({ j, endOfS });
    }
  }

  void TestApart(Id i, Id j, SegmentMeetings& found) const
  {
    const Segment& s = this->Segments[i];
    const Segment& t = this->Segments[j];
    const std::array<int, 2> ofT{ { this->Side(s, t[0]), this->Side(s, t[1]) } };
    if (ofT[0] == ofT[1] && ofT[0] != 0)
    {
      return;
    }
    const std::array<int, 2> ofS{ { this->Side(t, s[0]), this->Side(t, s[1]) } };
    if (ofT[0] * ofT[1] < 0 && ofS[0] * ofS[1] < 0)
    {
      found.Crossings.push_back({ { std::min(i, j), std::max(i, j) } });
      return;
    }
    for (int k = 0; k < 2; ++k)
    {
      if (ofT[k] == 0 && this->IsWithin(s, t[k]))
      {
        found.Touches.push_back({ i, t[k] });
      }
      if (ofS[k] == 0 && this->IsWithin(t, s[k]))
      {
        found.Touches.push_back({ j, s[k] });
      }
    }
  }

  const std::vector<PlanarPoint>& Points;
  const std::vector<Segment>& Segments;
};

/**
 * Call search(first, last, found) for blocks of [0, count), and concatenate the results in order.
 */
template <typename Search>
SegmentMeetings SearchInBlocks(
  Id count, Monitor& monitor, const ProgressRange& progress, const Search& search)
{
  const Id blocks = (count + BlockSize - 1) / BlockSize;
  std::vector<SegmentMeetings> found(blocks);
  const double nanosecondsPerSegment = 300;
  ParallelLoop(blocks, nanosecondsPerSegment * BlockSize, monitor, progress,
    [&](Id block)
    { search(block * BlockSize, std::min((block + 1) * BlockSize, count), found[block]); });
  SegmentMeetings all;
  for (const SegmentMeetings& part : found)
  {
    all.Touches.insert(all.Touches.end(), part.Touches.begin(), part.Touches.end());
    all.Crossings.insert(all.Crossings.end(), part.Crossings.begin(), part.Crossings.end());
    all.Pairs += part.Pairs;
  }
  return all;
}
} // namespace

SegmentMeetings FindSegmentMeetings(const std::vector<PlanarPoint>& points,
  const std::vector<Segment>& segments, const std::vector<char>& isNew, Monitor& monitor,
  const ProgressRange& progress)
{
  const MeetingFinder finder(points, segments);
  const auto isNewOne = [&](Id i) { return isNew.empty() || isNew[i] != 0; };
  std::vector<Id> ids; // of new segments
  std::vector<Box> boxes;
  for (Id i = 0; i < static_cast<Id>(segments.size()); ++i)
  {
    if (isNewOne(i))
    {
      ids.push_back(i);
      boxes.push_back(BoxOf(points, segments[i]));
    }
  }
  const BoxTree tree(std::move(boxes));
  if (ids.size() == segments.size())
  {
    return SearchInBlocks(tree.NumberOfParts(), monitor, progress,
      [&](Id first, Id last, SegmentMeetings& found)
      {
        for (Id part = first; part < last; ++part)
        {
          tree.VisitPairs(part, [&](Id i, Id j) { finder.Test(i, j, found); });
        }
      });
  }
  return SearchInBlocks(static_cast<Id>(segments.size()), monitor, progress,
    [&](Id first, Id last, SegmentMeetings& found)
    {
      for (Id i = first; i < last; ++i)
      {
        tree.Visit(BoxOf(points, segments[i]),
          [&](Id k)
          {
            // A pair of new segments is found twice.
            if (ids[k] != i && (!isNewOne(i) || i < ids[k]))
            {
              finder.Test(i, ids[k], found);
            }
          });
      }
    });
}
} // namespace insideout
