// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/PlanarWall.h"

#include "Common/BoxTree.h"
#include "Common/Error.h"
#include "Common/PartMonitor.h"
#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Layers/LayerColumns.h"
#include "Layers/LayerHeights.h"
#include "Planar/SegmentMeetings.h"
#include "Planar/TriangleLocator.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

namespace insideout
{
namespace
{
/** Number of halvings of a height from which on it is 0. */
constexpr int MostHalvings = 8;

/** Points of a run stay if they leave this share of the edge behind them to layers. */
constexpr double LeastShareOfLength = 0.5;

std::vector<Segment> EdgesOf(const PlanarMesh& mesh, const std::vector<Id>& wall)
{
  std::vector<Segment> facets;
  for (const Id edge : wall)
  {
    facets.push_back(EdgeOf(mesh.Cells[edge / 3], edge % 3));
  }
  return facets;
}

/** Per point the first in the same place: where a solid touches itself points may be twice. */
std::vector<Id> FirstOfEqual(const std::vector<PlanarPoint>& points)
{
  std::vector<Id> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](Id a, Id b) { return std::tie(points[a], a) < std::tie(points[b], b); });
  std::vector<Id> first = order;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isSame = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = isSame ? first[order[i - 1]] : order[i];
  }
  return first;
}

/** The first point of a run from one end on that leaves half of the edge behind it to the layers
 * at this end; the other end at last. */
std::size_t FirstWithRoom(const PlanarWall& wall, const std::vector<Id>& run)
{
  const Id end = run.front();
  const double gone = wall.Heights[end] * wall.Directions[end].LengthPerHeight();
  const auto from = [&](Id a, Id b) { return Distance(wall.Flat[a], wall.Flat[b]); };
  std::size_t i = 1;
  while (i + 1 < run.size() && gone > 0 &&
    from(end, run[i]) <= gone + LeastShareOfLength * from(run[i], run[i + 1]))
  {
    ++i;
  }
  return i;
}

/** Finds the places of PlanarWall: heights as in space, halved until the proof holds. */
class Pusher
{
public:
  Pusher(PlanarWall& wall, const PlanarMetric& metric, const LayerParameters& parameters,
    Monitor& monitor)
    : Wall(wall)
    , Metric(metric)
    , Fractions(FractionsOfLayers(parameters.Layers, parameters.Growth))
    , Caller(monitor)
    , Watch(monitor, { Stages::Layering, 0.1, 0.1 })
    , Halvings(wall.Flat.size(), 0)
  {
    wall.Height = HeightOfAll(parameters);
  }

  void Push()
  {
    this->FindHeights();
    for (;;)
    {
      this->Caller.Check(Stages::Layering, 0.1);
      this->PlaceInner();
      const std::vector<Id> lower = this->PointsToLower();
      if (lower.empty())
      {
        break;
      }
      for (const Id p : lower)
      {
        this->Halvings[p] += 1;
        this->Wall.Heights[p] = this->Halvings[p] < MostHalvings ? this->Wall.Heights[p] / 2 : 0;
      }
      GradeHeights(this->Wall.Flat, this->Wall.AtWall, this->Wall.Heights);
    }
  }

private:
  void FindHeights()
  {
    std::vector<Point> normals;
    for (const auto& [a, b] : this->Wall.Facets)
    {
      const Point way = Difference(this->Wall.Flat[b], this->Wall.Flat[a]);
      const double length = Length(way);
      normals.push_back({ { -way[1] / length, way[0] / length, 0 } });
    }
    this->Wall.Directions = FindWallDirections(
      this->Wall.Flat, this->Wall.AtWall, normals, this->Wall.Rims.AtPoints, this->Wall.Height);
    this->Wall.Heights = LimitHeights(this->Wall.Flat, this->Wall.AtWall, this->Wall.Directions,
      this->WaysAhead(), this->Wall.Height, this->Wall.Narrow);
  }

  /** Per point, the way along its direction to a constraint or the end of its run. */
  std::vector<double> WaysAhead() const
  {
    std::vector<Segment> all;
    for (const PlanarConstraint& constraint : this->Wall.Rims.Constraints)
    {
      all.push_back(constraint.Ends);
    }
    for (const PlanarRun& run : this->Wall.Rims.Runs)
    {
      all.push_back({ { run.Points.front(), run.Points.back() } });
    }
    std::vector<Box> boxes;
    for (const Segment& segment : all)
    {
      boxes.push_back(BoundingBox(this->Wall.Flat, segment));
    }
    const BoxTree tree(boxes);
    std::vector<double> ways(this->Wall.Flat.size(), 0);
    for (const Id p : this->Wall.AtWall.Points)
    {
      const WallDirection& direction = this->Wall.Directions[p];
      ways[p] = direction.EnoughWay(this->Wall.Height);
      tree.VisitNearestFirst([&](const Box& box)
        { return WayInto(box, this->Wall.Flat[p], direction.Inward); },
        [&] { return ways[p]; },
        [&](Id s)
        {
          if (this->Wall.First(all[s][0]) != this->Wall.First(p) &&
            this->Wall.First(all[s][1]) != this->Wall.First(p))
          {
            ways[p] = std::min(ways[p], this->WayTo(all[s], this->Wall.Flat[p], direction.Inward));
          }
        });
    }
    for (const PlanarRun& run : this->Wall.Rims.Runs)
    {
      const double length =
        Distance(this->Wall.Flat[run.Points.front()], this->Wall.Flat[run.Points.back()]);
      for (const auto& [isWall, p] : { std::pair(run.BeginsAtWall, run.Points.front()),
             std::pair(run.EndsAtWall, run.Points.back()) })
      {
        ways[p] = isWall ? length : ways[p];
      }
    }
    return ways;
  }

  /** The way from a place along a direction into a box; infinite if it is not ahead. */
  static double WayInto(const Box& box, const Point& from, const Point& direction)
  {
    double first = 0;
    double last = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k)
    {
      if (direction[k] != 0)
      {
        const double low = (box.Low[k] - from[k]) / direction[k];
        const double high = (box.High[k] - from[k]) / direction[k];
        first = std::max(first, std::min(low, high));
        last = std::min(last, std::max(low, high));
      }
      else if (from[k] < box.Low[k] || from[k] > box.High[k])
      {
        return std::numeric_limits<double>::infinity();
      }
    }
    return first <= last ? first : std::numeric_limits<double>::infinity();
  }

  /** The way from a place along a direction to a segment; infinite if it is not ahead. */
  double WayTo(const Segment& segment, const Point& from, const Point& direction) const
  {
    const Point begin = Difference(this->Wall.Flat[segment[0]], from);
    const Point along = Difference(this->Wall.Flat[segment[1]], this->Wall.Flat[segment[0]]);
    const double turn = direction[0] * along[1] - direction[1] * along[0];
    const double way = (begin[0] * along[1] - begin[1] * along[0]) / turn;
    const double share = (begin[0] * direction[1] - begin[1] * direction[0]) / turn;
    const bool isAhead = turn != 0 && way > 0 && share >= 0 && share <= 1;
    return isAhead ? way : std::numeric_limits<double>::infinity();
  }

  /** Place the inner ends of the layers. */
  void PlaceInner()
  {
    const PlanarMetric& metric = this->Metric;
    this->Wall.Places.resize(this->Wall.NumberOfPoints());
    this->Wall.OwnerOf.clear();
    for (const Id p : this->Wall.AtWall.Points)
    {
      const WallDirection& direction = this->Wall.Directions[p];
      const double way = this->Wall.Heights[p] * direction.LengthPerHeight();
      const double y = way * direction.Inward[1] / metric.YY;
      const PlanarPoint place = { this->Wall.Places[p][0] +
          (way * direction.Inward[0] - metric.XY * y) / metric.XX,
        this->Wall.Places[p][1] + y };
      this->Wall.InnerOf[p] =
        place == this->Wall.Places[p] ? None : static_cast<Id>(this->Wall.Places.size());
      if (this->Wall.IsLifted(p))
      {
        this->Wall.Places.push_back(place);
        this->Wall.OwnerOf.push_back(p);
      }
      else
      {
        this->Wall.Heights[p] = 0;
      }
    }
  }

  // The proof that layers and constraints do not meet.

  /** The point of the wall whose layers end at a place, to `owners`; others have none. */
  void AppendOwner(Id place, std::vector<Id>& owners) const
  {
    if (place >= this->Wall.NumberOfPoints())
    {
      owners.push_back(this->Wall.OwnerOf[place - this->Wall.NumberOfPoints()]);
    }
  }

  /** The points of the wall whose layers meet something or are not positive. */
  std::vector<Id> PointsToLower()
  {
    std::vector<Id> lower = this->OwnersOfEqualPlaces();
    if (!lower.empty())
    {
      return lower;
    }
    std::vector<Segment> segments;
    const auto add = [&](Id a, Id b) {
      segments.push_back({ { this->Wall.First(a), this->Wall.First(b) } });
    };
    for (const SegmentBehind& segment : this->Wall.SegmentsBehind())
    {
      add(segment.Ends[0], segment.Ends[1]);
    }
    for (const auto& [a, b] : this->Wall.Facets)
    {
      if (this->Wall.IsLifted(a) || this->Wall.IsLifted(b))
      {
        add(a, b);
      }
      if (!this->ArePositive(a, b))
      {
        this->AppendOwner(this->Wall.Behind(a), lower);
        this->AppendOwner(this->Wall.Behind(b), lower);
      }
    }
    for (std::size_t i = 0; i < this->Wall.OwnerOf.size(); ++i)
    {
      add(this->Wall.OwnerOf[i], this->Wall.NumberOfPoints() + static_cast<Id>(i));
    }
    const SegmentMeetings meetings = FindSegmentMeetings(
      this->Wall.Places, segments, {}, this->Watch, { Stages::Layering, 0.1, 0.1 });
    for (const auto& [a, b] : meetings.Crossings)
    {
      this->AppendOwners({ segments[a][0], segments[a][1], segments[b][0], segments[b][1] }, lower);
    }
    for (const auto& [segment, point] : meetings.Touches)
    {
      this->AppendOwners({ segments[segment][0], segments[segment][1], point }, lower);
    }
    if (lower.empty())
    {
      this->AppendOwnersOfFullLayers(segments, lower);
    }
    SortUniquely(lower);
    return lower;
  }

  void AppendOwners(const std::vector<Id>& places, std::vector<Id>& owners) const
  {
    const std::size_t before = owners.size();
    for (const Id place : places)
    {
      this->AppendOwner(place, owners);
    }
    if (owners.size() == before)
    {
      throw Error(ErrorCode::SelfIntersecting,
        "edges of the triangles cross at point " + std::to_string(places.front()));
    }
  }

  /** The owners of layers that contain a point of constraints. */
  void AppendOwnersOfFullLayers(const std::vector<Segment>& segments, std::vector<Id>& owners) const
  {
    const PlanarMesh halves = this->Wall.HalvesOfLayers();
    std::vector<Id> used;
    for (const Segment& segment : segments)
    {
      used.insert(used.end(), segment.begin(), segment.end());
    }
    SortUniquely(used);
    const TriangleLocator layers(this->Wall.Places, halves);
    for (const Id place : used)
    {
      const Id found = layers.Find(this->Wall.Places[place],
        [&](Id half)
        {
          // The corner of the other half is outside this one: the quad is convex.
          const Triangle& corners = halves.Cells[half];
          return std::find(corners.begin(), corners.end(), place) == corners.end();
        });
      if (found != None)
      {
        const Triangle& corners = halves.Cells[found];
        this->AppendOwners({ place, corners[0], corners[1], corners[2] }, owners);
      }
    }
  }

  std::vector<Id> OwnersOfEqualPlaces() const
  {
    std::vector<Id> order(this->Wall.Places.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
      [this](Id a, Id b) { return this->Wall.Places[a] < this->Wall.Places[b]; });
    std::vector<Id> owners;
    for (std::size_t i = 1; i < order.size(); ++i)
    {
      if (this->Wall.Places[order[i - 1]] == this->Wall.Places[order[i]])
      {
        this->AppendOwner(order[i - 1], owners);
        this->AppendOwner(order[i], owners);
      }
    }
    SortUniquely(owners);
    return owners;
  }

  /** Whether all layers of an edge of the wall are positive at their corners. */
  bool ArePositive(Id a, Id b) const
  {
    const auto placeOf = [this](Id p, std::size_t border)
    {
      return PlaceOnBorder(
        this->Wall.Places[p], this->Wall.Places[this->Wall.Behind(p)], this->Fractions[border]);
    };
    for (std::size_t border = 1; border < this->Fractions.size(); ++border)
    {
      std::vector<PlanarPoint> corners = { placeOf(a, border - 1), placeOf(b, border - 1) };
      for (const Id p : { b, a })
      {
        if (this->Wall.IsLifted(p))
        {
          corners.push_back(placeOf(p, border));
        }
      }
      const std::size_t count = corners.size();
      for (std::size_t k = 0; k < count && count > 2; ++k)
      {
        if (Orient2D(corners[k], corners[(k + 1) % count], corners[(k + 2) % count]) <= 0)
        {
          return false;
        }
      }
    }
    return true;
  }

  PlanarWall& Wall;
  const PlanarMetric& Metric;
  const std::vector<double> Fractions;
  Monitor& Caller;
  QuietMonitor Watch;
  std::vector<int> Halvings; ///< per point
};
} // namespace

std::vector<Point> FlatPoints(const std::vector<PlanarPoint>& points, const PlanarMetric& metric)
{
  std::vector<Point> flat;
  flat.reserve(points.size());
  for (const PlanarPoint& p : points)
  {
    const PlanarPoint mapped = metric.Map(p);
    flat.push_back({ { mapped[0], mapped[1], 0 } });
  }
  return flat;
}

std::vector<SegmentBehind> PlanarWall::SegmentsBehind() const
{
  std::vector<SegmentBehind> segments;
  for (const PlanarConstraint& constraint : this->Rims.Constraints)
  {
    segments.push_back({ { { this->Behind(constraint.Ends[0]), this->Behind(constraint.Ends[1]) } },
      constraint.Edge, constraint.IsOuter });
  }
  for (const PlanarRun& run : this->Rims.Runs)
  {
    const std::size_t last = run.Edges.size();
    std::vector<std::size_t> kept = { 0 };
    const std::vector<Id> back(run.Points.rbegin(), run.Points.rend());
    const std::size_t end = last - FirstWithRoom(*this, back);
    for (std::size_t i = FirstWithRoom(*this, run.Points); i <= end; ++i)
    {
      kept.push_back(i);
    }
    kept.push_back(last);
    for (std::size_t k = 1; k < kept.size(); ++k)
    {
      const auto placeOf = [&](std::size_t i)
      { return i == 0 || i == last ? this->Behind(run.Points[i]) : run.Points[i]; };
      segments.push_back(
        { { { placeOf(kept[k - 1]), placeOf(kept[k]) } }, run.Edges[kept[k] - 1], true });
    }
  }
  return segments;
}

PlanarMesh PlanarWall::HalvesOfLayers() const
{
  PlanarMesh halves;
  for (const auto& [a, b] : this->Facets)
  {
    if (this->IsLifted(b))
    {
      halves.Cells.push_back({ { this->First(a), this->First(b), this->Behind(b) } });
    }
    if (this->IsLifted(a))
    {
      halves.Cells.push_back({ { this->First(a), this->First(this->Behind(b)), this->Behind(a) } });
    }
  }
  return halves;
}

PlanarWall PushPlanarWall(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
  const std::vector<Id>& wall, const PlanarMetric& metric, const LayerParameters& parameters,
  Monitor& monitor)
{
  const std::vector<Segment> facets = EdgesOf(mesh, wall);
  const std::vector<Point> flat = FlatPoints(points, metric);
  PlanarWall pushed = { facets, WallPoints(points.size(), facets), flat,
    FindPlanarRims(flat, mesh, wall), {}, {}, FirstOfEqual(points),
    std::vector<Id>(points.size(), None), points, {} };
  Pusher(pushed, metric, parameters, monitor).Push();
  return pushed;
}
} // namespace insideout
