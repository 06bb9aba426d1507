// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/ResolveSegments.h"

#include "Common/Buckets.h"
#include "Common/DoubleDouble.h"
#include "Common/Edge.h"
#include "Common/Error.h"
#include "Common/ParallelLoop.h"
#include "Common/Stages.h"
#include "Planar/SegmentMeetings.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <unordered_map>

namespace insideout
{
namespace
{
/** Limit of rounds of cutting; segments that still cross are then left out. */
constexpr int MostRounds = 24;

/**
 * A crossing this near to an end of one of its segments is moved to that end. Coordinates are below
 * 1: in the first rounds this is their rounding, in the last 2^-41, less than 1e-12.
 */
double Nearness(int round)
{
  return std::ldexp(1.0, -53 + round / 2);
}

DoubleDouble Difference(double a, double b)
{
  return TwoSum(a, -b);
}

DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b)
{
  const double first = a.High / b.High;
  const DoubleDouble rest = a - b * DoubleDouble(first);
  return QuickTwoSum(first, rest.High / b.High);
}

/** (b - a) x (d - c), up to rounding in 106 digits. */
DoubleDouble CrossProduct(
  const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d)
{
  return Difference(b[0], a[0]) * Difference(d[1], c[1]) -
    Difference(b[1], a[1]) * Difference(d[0], c[0]);
}

/** The rounded crossing of two segments, within both their boxes as the exact one is. */
PlanarPoint CrossingOf(
  const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d)
{
  const DoubleDouble t = CrossProduct(a, c, c, d) / CrossProduct(a, b, c, d);
  PlanarPoint p;
  for (int k = 0; k < 2; ++k)
  {
    const double low = std::max(std::min(a[k], b[k]), std::min(c[k], d[k]));
    const double high = std::min(std::max(a[k], b[k]), std::max(c[k], d[k]));
    const double x = static_cast<double>(DoubleDouble(a[k]) + t * Difference(b[k], a[k]));
    p[k] = std::isfinite(x) ? std::min(std::max(x, low), high) : low; // nearly parallel
  }
  return p;
}

struct HashOfPlace
{
  std::size_t operator()(const PlanarPoint& p) const
  {
    std::uint64_t bits[2];
    std::memcpy(bits, p.data(), sizeof(bits));
    return (bits[0] * 0x9E3779B97F4A7C15u ^ (bits[1] + (bits[0] >> 29))) * 0xBF58476D1CE4E5B9u;
  }
};

/** The segments during cutting. */
class Cutter
{
public:
  Cutter(const SegmentComplex& curve, Monitor& monitor)
    : Given(curve)
    , Watch(monitor)
    , Points(curve.Points)
    , Origins(curve.Origins)
    , Pieces(curve.Segments)
    , IsLeftOut(curve.Segments.size(), 0)
  {
    for (Id s = 0; s < curve.NumberOfSegments(); ++s)
    {
      this->SegmentOfPiece.push_back(s);
    }
  }

  ResolvedCurve Resolve();

private:
  struct Cut
  {
    Id Piece;
    Id Point;
  };

  SegmentMeetings FindMeetings(int round);
  void Round(const SegmentMeetings& meetings, int round);
  void LeaveOut(const SegmentMeetings& meetings);
  void CutAtCrossing(const Segment& pair, const PlanarPoint& place, double nearness);
  bool IsAlong(Id piece, Id point) const;
  bool AddCut(Id piece, Id point);
  Id PointAt(const PlanarPoint& place, Id piece);
  PointOrigin OriginOf(const PlanarPoint& place, Id piece) const;
  void ApplyCuts();
  DoubleDouble PlaceAlong(Id piece, Id point) const;
  SegmentComplex Joined() const;

  const SegmentComplex& Given;
  Monitor& Watch;
  std::vector<PlanarPoint> Points;
  std::vector<PointOrigin> Origins;
  std::vector<Segment> Pieces;
  std::vector<Id> SegmentOfPiece; ///< of the given curve
  std::vector<char> IsNew;        ///< per piece; empty before the first round
  std::vector<char> IsLeftOut;    ///< per given segment
  std::vector<Cut> Cuts;
  std::vector<Id> Stuck; ///< pieces that cross and could not be cut yet: retried
  /// pieces of all segments, once any exist
  std::unordered_map<PlanarPoint, Id, HashOfPlace> PointsByPlace;
};

SegmentMeetings Cutter::FindMeetings(int round)
{
  // Each round takes half of the remaining progress.
  const double begin = 1 - std::ldexp(1.0, -round);
  return FindSegmentMeetings(this->Points, this->Pieces, this->IsNew, this->Watch,
    { Stages::Resolving, begin, begin + (1 - begin) / 2 });
}

/** The projection of a point onto a piece: between 0 and PlaceAlong of its end if within. */
DoubleDouble Cutter::PlaceAlong(Id piece, Id point) const
{
  const PlanarPoint& a = this->Points[this->Pieces[piece][0]];
  const PlanarPoint& b = this->Points[this->Pieces[piece][1]];
  const PlanarPoint& p = this->Points[point];
  return Difference(p[0], a[0]) * Difference(b[0], a[0]) +
    Difference(p[1], a[1]) * Difference(b[1], a[1]);
}

bool Cutter::IsAlong(Id piece, Id point) const
{
  const DoubleDouble place = this->PlaceAlong(piece, point);
  return place.High > 0 && (this->PlaceAlong(piece, this->Pieces[piece][1]) - place).High > 0;
}

bool Cutter::AddCut(Id piece, Id point)
{
  const bool isWithin = point != this->Pieces[piece][0] && point != this->Pieces[piece][1] &&
    this->IsAlong(piece, point);
  if (isWithin)
  {
    this->Cuts.push_back({ piece, point });
  }
  return isWithin;
}

/** A point on a given segment, interpolated between its ends. */
PointOrigin Cutter::OriginOf(const PlanarPoint& place, Id piece) const
{
  const Segment& given = this->Given.Segments[this->SegmentOfPiece[piece]];
  const PlanarPoint& a = this->Given.Points[given[0]];
  const PlanarPoint& b = this->Given.Points[given[1]];
  const int axis = std::abs(b[0] - a[0]) > std::abs(b[1] - a[1]) ? 0 : 1;
  const double t = std::min(std::max((place[axis] - a[axis]) / (b[axis] - a[axis]), 0.0), 1.0);
  const Id from = this->Given.Origins[given[0]].Points[0];
  const Id to = this->Given.Origins[given[1]].Points[0];
  PointOrigin origin;
  origin.Points = { { from, to, to } };
  // At most nearly 1: weight 1 marks an input point.
  origin.Weights = { { std::min(1 - t, 1 - 0x1p-53), std::max(t, 0x1p-53), 0 } };
  return origin;
}

/** The point at a place, a new one if there is none. */
Id Cutter::PointAt(const PlanarPoint& place, Id piece)
{
  if (this->PointsByPlace.empty())
  {
    this->PointsByPlace.reserve(2 * this->Points.size());
    for (std::size_t p = 0; p < this->Points.size(); ++p)
    {
      this->PointsByPlace.emplace(
        PlanarPoint{ this->Points[p][0] + 0.0, this->Points[p][1] + 0.0 }, static_cast<Id>(p));
    }
  }
  const PlanarPoint key = { place[0] + 0.0, place[1] + 0.0 }; // -0 is 0
  const auto [found, isNew] =
    this->PointsByPlace.emplace(key, static_cast<Id>(this->Points.size()));
  if (isNew)
  {
    if (this->Points.size() == static_cast<std::size_t>(std::numeric_limits<Id>::max()))
    {
      throw Error(ErrorCode::TooLarge, "the segments cross in more points than can be counted");
    }
    this->Points.push_back(key);
    this->Origins.push_back(this->OriginOf(key, piece));
  }
  return found->second;
}

void Cutter::CutAtCrossing(const Segment& pair, const PlanarPoint& place, double nearness)
{
  Id nearest = None;
  double least = nearness;
  for (const Id piece : pair)
  {
    const Id other = piece == pair[0] ? pair[1] : pair[0];
    for (const Id end : this->Pieces[piece])
    {
      const PlanarPoint& p = this->Points[end];
      const double distance = std::max(std::abs(p[0] - place[0]), std::abs(p[1] - place[1]));
      if (distance <= least && this->IsAlong(other, end))
      {
        least = distance;
        nearest = end;
      }
    }
  }
  const Id point = nearest == None ? this->PointAt(place, pair[0]) : nearest;
  const bool isFirstCut = this->AddCut(pair[0], point);
  const bool isSecondCut = this->AddCut(pair[1], point);
  if (!isFirstCut && !isSecondCut)
  {
    this->Stuck.push_back(pair[0]);
  }
}

/** Replace each cut piece by its parts. */
void Cutter::ApplyCuts()
{
  std::vector<std::pair<DoubleDouble, Cut>> cuts;
  cuts.reserve(this->Cuts.size());
  for (const Cut& cut : this->Cuts)
  {
    cuts.emplace_back(this->PlaceAlong(cut.Piece, cut.Point), cut);
  }
  std::sort(cuts.begin(), cuts.end(),
    [](const auto& a, const auto& b)
    {
      return std::tie(a.second.Piece, a.first.High, a.first.Low, a.second.Point) <
        std::tie(b.second.Piece, b.first.High, b.first.Low, b.second.Point);
    });
  std::vector<Segment> pieces;
  std::vector<Id> segmentOfPiece;
  pieces.reserve(this->Pieces.size() + cuts.size());
  segmentOfPiece.reserve(this->Pieces.size() + cuts.size());
  this->IsNew.clear();
  std::vector<char> isStuck(this->Pieces.size(), 0);
  for (const Id piece : this->Stuck)
  {
    isStuck[piece] = 1;
  }
  auto cut = cuts.begin();
  for (Id piece = 0; piece < static_cast<Id>(this->Pieces.size()); ++piece)
  {
    const auto add = [&](Id from, Id to, bool isNew)
    {
      if (from != to)
      {
        pieces.push_back({ { from, to } });
        segmentOfPiece.push_back(this->SegmentOfPiece[piece]);
        this->IsNew.push_back(isNew);
      }
    };
    Id from = this->Pieces[piece][0];
    const bool isCut = cut != cuts.end() && cut->second.Piece == piece;
    for (; cut != cuts.end() && cut->second.Piece == piece; ++cut)
    {
      add(from, cut->second.Point, true);
      from = cut->second.Point;
    }
    add(from, this->Pieces[piece][1], isCut || isStuck[piece]);
  }
  if (pieces.size() > static_cast<std::size_t>(std::numeric_limits<Id>::max()))
  {
    throw Error(ErrorCode::TooLarge, "the segments are cut into more pieces than can be counted");
  }
  this->Pieces = std::move(pieces);
  this->SegmentOfPiece = std::move(segmentOfPiece);
  this->Cuts.clear();
  this->Stuck.clear();
}

void Cutter::Round(const SegmentMeetings& meetings, int round)
{
  for (const SegmentTouch& touch : meetings.Touches)
  {
    this->AddCut(touch.Segment, touch.Point);
  }
  std::vector<PlanarPoint> places(meetings.Crossings.size());
  const double nanosecondsPerCrossing = 100;
  ParallelLoop(places.size(), nanosecondsPerCrossing,
    [&](std::size_t c)
    {
      const Segment& s = this->Pieces[meetings.Crossings[c][0]];
      const Segment& t = this->Pieces[meetings.Crossings[c][1]];
      places[c] =
        CrossingOf(this->Points[s[0]], this->Points[s[1]], this->Points[t[0]], this->Points[t[1]]);
    });
  for (std::size_t c = 0; c < places.size(); ++c)
  {
    this->CutAtCrossing(meetings.Crossings[c], places[c], Nearness(round));
  }
  this->ApplyCuts();
}

/** Leave out one of each two given segments whose pieces still meet: the later one. */
void Cutter::LeaveOut(const SegmentMeetings& meetings)
{
  for (const Segment& pair : meetings.Crossings)
  {
    const Id later = std::max(this->SegmentOfPiece[pair[0]], this->SegmentOfPiece[pair[1]]);
    this->IsLeftOut[later] = 1;
  }
  for (const SegmentTouch& touch : meetings.Touches)
  {
    this->IsLeftOut[this->SegmentOfPiece[touch.Segment]] = 1;
  }
}

/** Pieces by their ends, coincident ones merged; then the given segments that are left out. */
SegmentComplex Cutter::Joined() const
{
  struct Part
  {
    Edge Ends;
    Id Segment;
    bool IsTurned;
  };
  std::vector<Part> parts;
  parts.reserve(this->Pieces.size());
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    const auto& [from, to] = this->Pieces[i];
    if (!this->IsLeftOut[this->SegmentOfPiece[i]])
    {
      parts.push_back({ EdgeBetween(from, to), this->SegmentOfPiece[i], to < from });
    }
  }
  const Buckets<Id> byEnd(this->Points.size(),
    [&](auto visit)
    {
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        visit(static_cast<std::size_t>(parts[i].Ends[0]), static_cast<Id>(i));
      }
    });
  SegmentComplex curve;
  curve.Points = this->Points;
  curve.Origins = this->Origins;
  const auto addSources = [&](Id segment, bool isTurned)
  {
    for (Id s = this->Given.SourceOffsets[segment]; s < this->Given.SourceOffsets[segment + 1]; ++s)
    {
      const SegmentSource& source = this->Given.Sources[s];
      curve.Sources.push_back({ source.Segment, source.Reversed != isTurned });
    }
  };
  const auto finish = [&](const Segment& segment, long count)
  {
    if (std::abs(count) > std::numeric_limits<std::int16_t>::max())
    {
      throw Error(ErrorCode::TooLarge, "more segments coincide than can be counted");
    }
    const auto bySegment = [](const SegmentSource& a, const SegmentSource& b)
    { return a.Segment < b.Segment; };
    std::sort(curve.Sources.begin() + curve.SourceOffsets.back(), curve.Sources.end(), bySegment);
    curve.SourceOffsets.push_back(static_cast<Id>(curve.Sources.size()));
    curve.Segments.push_back(segment);
    curve.Multiplicity.push_back(static_cast<std::int16_t>(count));
  };
  std::vector<Id> group;
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    group.assign(byEnd[p].begin(), byEnd[p].end());
    std::sort(group.begin(), group.end(),
      [&](Id a, Id b)
      {
        return std::tie(parts[a].Ends[1], parts[a].Segment) <
          std::tie(parts[b].Ends[1], parts[b].Segment);
      });
    for (std::size_t first = 0, last = 0; first < group.size(); first = last)
    {
      const Part& leader = parts[group[first]];
      long count = 0;
      for (; last < group.size() && parts[group[last]].Ends == leader.Ends; ++last)
      {
        const Part& part = parts[group[last]];
        const bool isTurned = part.IsTurned != leader.IsTurned;
        count += (isTurned ? -1 : 1) * this->Given.Multiplicity[part.Segment];
        addSources(part.Segment, isTurned);
      }
      const Edge& ends = leader.Ends;
      finish(
        leader.IsTurned ? Segment{ { ends[1], ends[0] } } : Segment{ { ends[0], ends[1] } }, count);
    }
  }
  curve.NumberOfConstraints = curve.NumberOfSegments();
  for (Id s = 0; s < this->Given.NumberOfSegments(); ++s)
  {
    if (this->IsLeftOut[s])
    {
      addSources(s, false);
      finish(this->Given.Segments[s], this->Given.Multiplicity[s]);
    }
  }
  return curve;
}

ResolvedCurve Cutter::Resolve()
{
  ResolvedCurve resolved;
  SegmentMeetings meetings = this->FindMeetings(0);
  resolved.IntersectingPairs = meetings.Pairs;
  for (; !meetings.Empty() && resolved.Rounds < MostRounds; ++resolved.Rounds)
  {
    this->Round(meetings, resolved.Rounds);
    meetings = this->FindMeetings(resolved.Rounds + 1);
  }
  this->LeaveOut(meetings);
  resolved.Curve = this->Joined();
  this->Watch.Check(Stages::Resolving, 1);
  return resolved;
}
} // namespace

ResolvedCurve ResolveSegments(const SegmentComplex& curve, Monitor& monitor)
{
  return Cutter(curve, monitor).Resolve();
}
} // namespace insideout
