// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberOfCaps.h"

#include "ChunkedLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

// Far caps together are below this; 1/2 less room for rounding.
constexpr double MostOfFarCaps = 0.49;

// Sites nearer to a cap's ball than this part of its radius might see an edge under nearly 180
// degrees, where the boundary alone would lose digits.
constexpr double LeastRelativeDistance = 0x1p-4;

// What BoundaryProduct.h asks for, with room to spare.
constexpr double LeastDistance = 0x1p-40;
constexpr double LeastAhead = 0x1p-6;

/** About the middle of the sites' box. */
WindingNumberOfCaps::Ball BallAround(const SiteBlock& sites)
{
  WindingNumberOfCaps::Ball ball;
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(sites.High[axis], sites.High[axis] + Lanes);
    ball.Centre[axis] = *low / 2 + *high / 2;
    const double extent = *high / 2 - *low / 2;
    squared += extent * extent;
  }
  const double roundedUp = 1 + 0x1p-40;
  ball.Radius = std::sqrt(squared) * roundedUp;
  return ball;
}

double Distance(const Point& a, const Point& b)
{
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return std::sqrt(x * x + y * y + z * z);
}

/**
 * Find a frame in which all sites in a ball see all places in another ahead, not too near.
 *
 * @return whether there is one
 */
bool FindFrame(
  const WindingNumberOfCaps::Ball& from, const WindingNumberOfCaps::Ball& to, Frame& frame)
{
  frame.Z = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    if (std::abs(to.Centre[axis] - from.Centre[axis]) >
      std::abs(to.Centre[frame.Z] - from.Centre[frame.Z]))
    {
      frame.Z = axis;
    }
  }
  const double ahead = to.Centre[frame.Z] - from.Centre[frame.Z];
  frame.Sign = ahead > 0 ? 1 : -1;
  frame.X = (frame.Z + (ahead > 0 ? 1 : 2)) % 3;
  frame.Y = (frame.Z + (ahead > 0 ? 2 : 1)) % 3;
  return std::abs(ahead) > from.Radius + to.Radius + LeastAhead;
}

/** The principal value of the phase, in turns. */
double Turns(const PhaseProducts& products, int lane)
{
  return std::atan2(products.Imaginary[lane], products.Real[lane]) / (2 * Pi);
}
} // namespace

WindingNumberOfCaps::WindingNumberOfCaps(
  const std::vector<Point>& points, const std::vector<std::vector<CountedTriangle>>& caps)
  : Points(points)
  , Triangles(points)
{
  for (const std::vector<CountedTriangle>& triangles : caps)
  {
    if (triangles.empty())
    {
      continue;
    }
    Cap cap;
    this->SetBall(triangles, cap);
    cap.Triangles = this->Triangles.Add(triangles);
    cap.Edges = this->AddEdges(triangles);
    this->Caps.push_back(cap);
  }
}

void WindingNumberOfCaps::SetBall(const std::vector<CountedTriangle>& triangles, Cap& cap) const
{
  const double infinity = std::numeric_limits<double>::infinity();
  Point low = { infinity, infinity, infinity };
  Point high = { -infinity, -infinity, -infinity };
  cap.Area = 0;
  for (const CountedTriangle& triangle : triangles)
  {
    std::array<Point, 3> p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = this->Points[triangle.Corners[k]];
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], p[k][axis]);
        high[axis] = std::max(high[axis], p[k][axis]);
      }
    }
    SummedFacet facet;
    SetGeometry(facet, p[0], p[1], p[2]);
    cap.Area +=
      std::abs(triangle.Count) * std::hypot(facet.Normal[0], facet.Normal[1], facet.Normal[2]) / 2;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    cap.Around.Centre[axis] = low[axis] / 2 + high[axis] / 2;
  }
  cap.Around.Radius = 0;
  for (const CountedTriangle& triangle : triangles)
  {
    for (const Id p : triangle.Corners)
    {
      cap.Around.Radius = std::max(cap.Around.Radius, Distance(cap.Around.Centre, this->Points[p]));
    }
  }
  const double roundedUp = 1 + 0x1p-40;
  cap.Around.Radius *= roundedUp;
  cap.Area *= roundedUp;
}

TileRange WindingNumberOfCaps::AddEdges(const std::vector<CountedTriangle>& triangles)
{
  TileRange range;
  range.First = this->EdgeTiles.size();
  EdgeTile tile = { this->EdgePoints.size(), 0, this->Edges.size(), 0 };
  for (const Loop& loop : LoopsOf(CountedBoundary(triangles, static_cast<Id>(this->Points.size()))))
  {
    this->AddLoop(loop, tile);
  }
  if (tile.FirstEdge < this->Edges.size())
  {
    this->CloseTile(tile);
  }
  range.Last = this->EdgeTiles.size();
  return range;
}

void WindingNumberOfCaps::AddLoop(const Loop& loop, EdgeTile& tile)
{
  const std::size_t size = loop.size();
  const auto local = [&]()
  { return static_cast<std::int32_t>(this->EdgePoints.size() - tile.FirstPoint); };
  const auto add = [&](std::size_t i) { this->EdgePoints.push_back(this->Points[loop[i % size]]); };
  if (size <= MostTilePoints && static_cast<std::size_t>(local()) + size > MostTilePoints)
  {
    this->CloseTile(tile);
  }
  if (static_cast<std::size_t>(local()) + size <= MostTilePoints)
  {
    const std::int32_t first = local();
    for (std::size_t i = 0; i < size; ++i)
    {
      add(i);
      this->Edges.push_back({ first + static_cast<std::int32_t>(i),
        first + static_cast<std::int32_t>((i + 1) % size) });
    }
    return;
  }
  // Too long for a tile: as open walks, which repeat the point between two tiles.
  add(0);
  for (std::size_t i = 0; i < size; ++i)
  {
    if (static_cast<std::size_t>(local()) == MostTilePoints)
    {
      this->CloseTile(tile);
      add(i);
    }
    this->Edges.push_back({ local() - 1, local() });
    add(i + 1);
  }
}

void WindingNumberOfCaps::CloseTile(EdgeTile& tile)
{
  tile.LastPoint = this->EdgePoints.size();
  tile.LastEdge = this->Edges.size();
  this->EdgeTiles.push_back(tile);
  tile = { tile.LastPoint, 0, tile.LastEdge, 0 };
}

/** A bound of |w| for each cap; those up to the value returned are together below 1/2. */
double WindingNumberOfCaps::FindLargestFar(const Ball& ball, std::vector<double>& bounds) const
{
  bounds.resize(this->Caps.size());
  double sum = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    // |w| is at most the area over that of the sphere around the site which touches the cap.
    const Cap& cap = this->Caps[i];
    const double distance =
      Distance(cap.Around.Centre, ball.Centre) - ball.Radius - cap.Around.Radius;
    const bool clear =
      distance > LeastDistance && distance > LeastRelativeDistance * cap.Around.Radius;
    bounds[i] = clear ? cap.Area / (4 * Pi * distance * distance) : 1;
    sum += bounds[i];
  }
  double largestFar = MostOfFarCaps;
  while (sum > MostOfFarCaps)
  {
    sum = 0;
    for (const double bound : bounds)
    {
      sum += bound <= largestFar ? bound : 0;
    }
    largestFar = sum > MostOfFarCaps ? largestFar / 2 : largestFar;
  }
  return largestFar;
}

void WindingNumberOfCaps::AddBlock(const Sites& sites, const std::vector<Id>& order,
  std::size_t first, std::vector<double>& bounds, std::vector<double>& w) const
{
  SiteProducts block = MakeBlock(sites, order, first);
  const Ball ball = BallAround(block.Rounded);
  const double largestFar = this->FindLargestFar(ball, bounds);

  PhaseProducts far;
  std::fill(far.Real, far.Real + Lanes, 1.0);
  std::fill(far.Imaginary, far.Imaginary + Lanes, 0.0);
  for (std::size_t i = 0; i < this->Caps.size(); ++i)
  {
    const Cap& cap = this->Caps[i];
    if (!(bounds[i] <= largestFar))
    {
      this->Triangles.Multiply(cap.Triangles, sites, block);
      continue;
    }
    Frame frame;
    const bool isAhead = FindFrame(ball, cap.Around, frame);
    for (std::size_t t = cap.Edges.First; t < cap.Edges.Last; ++t)
    {
      const EdgeTile& tile = this->EdgeTiles[t];
      const Point* const points = &this->EdgePoints[tile.FirstPoint];
      const std::size_t numberOfPoints = tile.LastPoint - tile.FirstPoint;
      const TileEdge* const edges = &this->Edges[tile.FirstEdge];
      const std::size_t numberOfEdges = tile.LastEdge - tile.FirstEdge;
      if (isAhead)
      {
        MultiplyByBoundaryAhead(
          points, numberOfPoints, edges, numberOfEdges, frame, block.Rounded, far);
      }
      else
      {
        MultiplyByBoundary(points, numberOfPoints, edges, numberOfEdges, block.Rounded, far);
      }
    }
  }
  const std::size_t last = std::min(order.size(), first + Lanes);
  for (std::size_t i = first; i < last; ++i)
  {
    const int lane = static_cast<int>(i - first);
    w[order[i]] += WindingNumber(block.Product, lane) + Turns(far, lane);
  }
}

void WindingNumberOfCaps::Add(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  if (this->IsEmpty())
  {
    return;
  }
  const std::size_t sitesPerCall = 16 * Lanes;
  const Id calls = static_cast<Id>((order.size() + sitesPerCall - 1) / sitesPerCall);
  const double nanosecondsPerTriangle = 2;
  ChunkedLoop(calls, nanosecondsPerTriangle * sitesPerCall * this->Triangles.NumberOfTriangles(),
    monitor, progress,
    [&](Id call)
    {
      std::vector<double> bounds;
      const std::size_t first = static_cast<std::size_t>(call) * sitesPerCall;
      for (std::size_t i = first; i < std::min(order.size(), first + sitesPerCall); i += Lanes)
      {
        this->AddBlock(sites, order, i, bounds, w);
      }
    });
}

double WindingNumberOfCaps::At(const Point& point) const
{
  std::vector<double> w = { 0 };
  if (!this->IsEmpty())
  {
    const std::vector<Point> points = { point };
    const std::vector<Tetrahedron> cells = { { { 0, 0, 0, 0 } } };
    std::vector<double> bounds;
    this->AddBlock({ points, cells }, { 0 }, 0, bounds, w);
  }
  return w.front();
}
} // namespace insideout
