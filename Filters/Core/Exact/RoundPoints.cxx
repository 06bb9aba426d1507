// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RoundPoints.h"

#include "Exact/MovePoint.h"
#include "Exact/Phases.h"
#include "Exact/RoundingPlaces.h"
#include "Exact/SteinerPoints.h"

#include <algorithm>
#include <functional>

namespace insideout
{
// --- Rounding ------------------------------------------------------------------------------------

namespace
{
/** Places that are tried per point, of its hundreds, where many points are tried again and again.
 */
constexpr int PlacesAtRandom = 60;

/** Round what can be. @param[in] round called with a point and its places. @return the others */
std::vector<Id> RoundEach(
  ExactState& state, const std::function<bool(Id, const std::vector<Point>&)>& round)
{
  const FlippableMesh& mesh = state.Mesh;
  std::vector<Id> left;
  const Id end = mesh.Vertices().Size();
  for (Id point = mesh.Infinite() + 1; point < end; ++point)
  {
    if (!mesh.Vertices().IsDouble(point) && mesh.HasVertex(point))
    {
      state.Report(Phases::RoundingPoints);
      if (!round(point, PlacesFor(state, point)))
      {
        left.push_back(point);
      }
    }
  }
  return left;
}
} // namespace

std::vector<Id> RoundInOrder(ExactState& state)
{
  return RoundEach(state,
    [&](Id point, const std::vector<Point>& places)
    {
      return std::any_of(places.begin(), places.end(),
        [&](const Point& place) { return MovePoint(state, point, place); });
    });
}

std::vector<Id> RoundAtRandom(ExactState& state)
{
  return RoundEach(state,
    [&](Id point, const std::vector<Point>& places)
    {
      bool isRounded = false;
      for (int k = 0; k < PlacesAtRandom && !isRounded; ++k)
      {
        isRounded = MovePoint(state, point, places[state.Random() % places.size()]);
      }
      return isRounded;
    });
}

// --- Out of the way ------------------------------------------------------------------------------

namespace
{
/** Other places that are tried for a point which is in the way, or for one more. */
constexpr int PlacesPerStir = 8;

/** An average of the corners around a point. */
Point RandomPlaceInVolume(ExactState& state, Id point)
{
  std::vector<Id> star;
  state.Mesh.Star(point, star);
  Point sum = { { 0, 0, 0 } };
  double weights = 0;
  for (const Id cell : star)
  {
    for (const Id corner : state.Mesh.Cell(cell).Corners)
    {
      const double weight =
        corner == state.Mesh.Infinite() ? 0 : static_cast<double>(state.Random());
      const Point at = state.Mesh.Vertices().Nearest(corner);
      for (int k = 0; k < 3; ++k)
      {
        sum[k] += weight * at[k];
      }
      weights += weight;
    }
  }
  return { { sum[0] / weights, sum[1] / weights, sum[2] / weights } };
}
} // namespace

void Stir(ExactState& state, const std::vector<Id>& points)
{
  for (const Id neighbor : state.Mesh.NeighborsOf(points))
  {
    if (neighbor < state.Mesh.Infinite())
    {
      continue;
    }
    state.Report(Phases::RoundingPoints);
    const PointSupport support = state.SupportOf(neighbor);
    std::vector<Point> places;
    if (support.Segment != None)
    {
      const std::array<Id, 2> ends = state.Segments.NeighborsOnPath(support.Segment, neighbor);
      places = PlacesBetween(state.Mesh, ends[0], ends[1]);
    }
    else if (!support.Facets.empty())
    {
      continue;
    }
    bool isMoved = false;
    for (int k = 0; k < PlacesPerStir && !isMoved; ++k)
    {
      isMoved = MovePoint(state, neighbor,
        places.empty() ? RandomPlaceInVolume(state, neighbor)
                       : places[state.Random() % places.size()]);
    }
  }
}

namespace
{
/** Split a piece of a segment at a place near it, where no cell turns over. */
bool SplitAt(ExactState& state, Id segment, const EdgeRing& ring, const Point& place)
{
  FlippableMesh& mesh = state.Mesh;
  const Id point = mesh.AddVertex(place);
  const std::size_t n = ring.Points.size();
  std::vector<Id> facets;
  for (std::size_t k = 0; k < n; ++k)
  {
    const Id cell = ring.Cells[k];
    for (const Id end : { ring.U, ring.V })
    {
      Tetrahedron t = mesh.Cell(cell).Corners;
      t[mesh.CornerIndex(cell, end)] = point;
      if (mesh.IsInfinite(cell) || mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) <= 0)
      {
        mesh.RemoveLastVertex();
        return false;
      }
    }
    facets.push_back(mesh.Cell(cell).Facets[mesh.CornerIndex(cell, ring.Points[(k + 1) % n])]);
  }
  mesh.SplitEdge(ring, point);
  for (std::size_t k = 0; k < n; ++k)
  {
    for (const Id end : { ring.U, ring.V })
    {
      mesh.MarkFace(point, end, ring.Points[k], facets[k]);
    }
  }
  state.Segments.Split(segment, ring.U, ring.V, point);
  return true;
}
} // namespace

void SplitBeside(ExactState& state, const std::vector<Id>& points)
{
  for (const Id point : points)
  {
    const Id segment = state.Segments.Around(point);
    if (segment == None)
    {
      continue;
    }
    for (const Id neighbor : state.Segments.NeighborsOnPath(segment, point))
    {
      const std::vector<Point> places = PlacesBetween(state.Mesh, point, neighbor);
      EdgeRing ring;
      state.Mesh.Ring(point, neighbor, state.Mesh.FindEdge(point, neighbor), ring);
      bool isSplit = false;
      for (int k = 0; k < PlacesPerStir && !isSplit; ++k)
      {
        isSplit = SplitAt(state, segment, ring, places[state.Random() % places.size()]);
      }
    }
  }
}

// --- All together --------------------------------------------------------------------------------

std::vector<Id> RoundPoints(ExactState& state, bool maySplitBeside, std::int64_t since)
{
  const Id first = state.Mesh.Infinite() + 1;
  std::vector<Id> left = RoundInOrder(state);
  std::size_t before = left.size() + 1;
  while (!left.empty() && left.size() < before)
  {
    before = left.size();
    Tidy(state, first, since);
    left = RoundInOrder(state);
  }
  int patience = ShakesWithoutGain;
  bool isSplit = false;
  while (!left.empty() && patience > 0 && !state.Mesh.Work().IsUsedUp())
  {
    before = left.size();
    if (maySplitBeside && patience == ShakesWithoutGain / 2)
    {
      SplitBeside(state, left);
      isSplit = true;
    }
    Stir(state, left);
    Shake(state, left);
    left = RoundAtRandom(state);
    patience = left.size() < before ? ShakesWithoutGain : patience - 1;
  }
  if (isSplit && left.empty())
  {
    Tidy(state, first, since);
    left = RoundInOrder(state);
  }
  return left;
}
} // namespace insideout
