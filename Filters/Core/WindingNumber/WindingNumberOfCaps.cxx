// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumberOfCaps.h"

#include "Common/Box.h"
#include "Common/ChunkedLoop.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/Prefetch.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
// A bound of the sum of far caps: 1/2, less room for rounding.
constexpr double MostOfFarCaps = 0.49;

// From sites nearer to a cap's ball than this fraction of its radius an edge might be seen under
// nearly 180 degrees, where the boundary alone would lose digits.
constexpr double LeastRelativeDistance = 0x1p-4;

// The distances required by BoundaryProduct.h, with room to spare.
constexpr double LeastDistance = 0x1p-40;
constexpr double LeastAhead = 0x1p-6;
constexpr double MostAhead = 4;

// Neighboring caps form a bunch, up to this many boundary points. A bunch is evaluated as one cap
// where its winding number is certainly below the second value.
constexpr std::size_t PointsPerBunch = 64;
constexpr double MostOfBunch = 0x1p-6;

/** Centered at the middle of the sites' box. */
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

/** Coordinates are below 2^50, so that their squares do not overflow. */
double QuickDistance(const Point& a, const Point& b)
{
  const Point d = Difference(a, b);
  return std::sqrt(Dot(d, d));
}

/**
 * Find a frame in which, from all sites in a ball, all places in another ball lie ahead and not too
 * near.
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
  return std::abs(ahead) > from.Radius + to.Radius + LeastAhead && std::abs(ahead) < MostAhead;
}

/** |w| is at most the area over that of the sphere around the site which touches the cap. */
double BoundOf(
  double area, const WindingNumberOfCaps::Ball& around, const WindingNumberOfCaps::Ball& sites)
{
  const double distance = QuickDistance(around.Centre, sites.Centre) - sites.Radius - around.Radius;
  const bool clear = distance > LeastDistance && distance > LeastRelativeDistance * around.Radius;
  return clear ? area / (4 * Pi * distance * distance) : 1;
}

/** The largest bound of caps that count as far; together these are below 1/2. */
template <typename BoundedParts>
double LargestFar(const BoundedParts& parts)
{
  double largestFar = 2 * MostOfFarCaps;
  double sum = 1;
  while (sum > MostOfFarCaps)
  {
    largestFar /= 2;
    sum = 0;
    for (const auto& part : parts)
    {
      sum += part.Bound <= largestFar ? part.Bound : 0;
    }
  }
  return largestFar;
}

/** A chain's boundary, in loops. */
std::vector<Loop> LoopsAround(std::vector<CountedTriangle> triangles)
{
  // Renumber the points: time grows with the highest number.
  std::vector<Id> ids;
  for (const CountedTriangle& triangle : triangles)
  {
    ids.insert(ids.end(), triangle.Corners.begin(), triangle.Corners.end());
  }
  SortUniquely(ids);
  for (CountedTriangle& triangle : triangles)
  {
    for (Id& corner : triangle.Corners)
    {
      corner = IndexIn(ids, corner);
    }
  }
  std::vector<Loop> loops = LoopsOf(CountedBoundary(triangles, static_cast<Id>(ids.size())));
  for (Loop& loop : loops)
  {
    for (Id& point : loop)
    {
      point = ids[point];
    }
  }
  return loops;
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
  std::vector<const Chain*> chains;
  for (const Chain& chain : caps)
  {
    if (!chain.empty())
    {
      chains.push_back(&chain);
    }
  }
  if (!chains.empty())
  {
    this->AddBunches(chains.data(), chains.data() + chains.size());
  }
}

/** Halve the caps across their longest extent until they fit a bunch. */
void WindingNumberOfCaps::AddBunches(const Chain** first, const Chain** last)
{
  std::size_t boundaryPoints = 0;
  for (const Chain** chain = first; chain != last; ++chain)
  {
    boundaryPoints += (*chain)->size() + 2;
  }
  if (last - first == 1 || boundaryPoints <= PointsPerBunch)
  {
    this->AddBunch(first, last);
    return;
  }
  const auto less = [this](int axis)
  {
    return [this, axis](const Chain* a, const Chain* b) {
      return this->Points[a->front().Corners[0]][axis] < this->Points[b->front().Corners[0]][axis];
    };
  };
  int longest = 0;
  double longestExtent = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(first, last, less(axis));
    const double extent = this->Points[(*high)->front().Corners[0]][axis] -
      this->Points[(*low)->front().Corners[0]][axis];
    if (extent > longestExtent)
    {
      longest = axis;
      longestExtent = extent;
    }
  }
  const Chain** const middle = first + (last - first) / 2;
  std::nth_element(first, middle, last, less(longest));
  this->AddBunches(first, middle);
  this->AddBunches(middle, last);
}

void WindingNumberOfCaps::AddBunch(const Chain* const* first, const Chain* const* last)
{
  Bunch bunch;
  bunch.FirstCap = this->Caps.size();
  Chain all;
  for (const Chain* const* chain = first; chain != last; ++chain)
  {
    Part cap;
    this->Measure(**chain, cap);
    cap.Triangles = this->Triangles.Add(**chain);
    this->AddLoops(LoopsAround(**chain), cap);
    this->Caps.push_back(cap);
    all.insert(all.end(), (*chain)->begin(), (*chain)->end());
  }
  bunch.LastCap = this->Caps.size();
  bunch.Whole = this->Caps[bunch.FirstCap];
  bunch.Whole.Triangles.Last = this->Caps.back().Triangles.Last;
  bunch.Whole.LastSize = this->Caps.back().LastSize;
  this->Measure(all, bunch.Whole);
  this->Bunches.push_back(bunch);
}

void WindingNumberOfCaps::Measure(const Chain& triangles, Part& part) const
{
  Box box = Box::Empty();
  part.Area = 0;
  for (const CountedTriangle& triangle : triangles)
  {
    const auto [a, b, c] = CornersOf(this->Points, triangle.Corners);
    box.Add(BoundingBox(this->Points, triangle.Corners));
    part.Area += std::abs(triangle.Count) * Length(NormalOf(a, b, c)) / 2;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    part.Around.Centre[axis] = box.Low[axis] / 2 + box.High[axis] / 2;
  }
  part.Around.Radius = 0;
  for (const CountedTriangle& triangle : triangles)
  {
    for (const Id p : triangle.Corners)
    {
      part.Around.Radius =
        std::max(part.Around.Radius, QuickDistance(part.Around.Centre, this->Points[p]));
    }
  }
  const double roundedUp = 1 + 0x1p-40;
  part.Around.Radius *= roundedUp;
  part.Area *= roundedUp;
}

void WindingNumberOfCaps::AddLoops(const std::vector<Loop>& loops, Part& cap)
{
  cap.FirstPoint = this->LoopPoints.size();
  cap.FirstSize = this->LoopSizes.size();
  for (const Loop& loop : loops)
  {
    for (const Id p : loop)
    {
      this->LoopPoints.push_back(this->Points[p]);
    }
    this->LoopSizes.push_back(static_cast<std::int32_t>(loop.size()));
  }
  cap.LastSize = this->LoopSizes.size();
}

/** Bunches, and the single caps of those too near to be taken as one, each with its bound. */
void WindingNumberOfCaps::Choose(const Ball& sites, std::vector<BoundedPart>& parts) const
{
  parts.clear();
  for (const Bunch& bunch : this->Bunches)
  {
    const double bound = BoundOf(bunch.Whole.Area, bunch.Whole.Around, sites);
    if (bound <= MostOfBunch)
    {
      parts.push_back({ &bunch.Whole, bound });
      continue;
    }
    for (std::size_t i = bunch.FirstCap; i < bunch.LastCap; ++i)
    {
      const Part& cap = this->Caps[i];
      parts.push_back({ &cap, BoundOf(cap.Area, cap.Around, sites) });
    }
  }
}

void WindingNumberOfCaps::MultiplyByFar(
  const Part& part, const Ball& ball, const SiteBlock& sites, PhaseProducts& products) const
{
  const std::int32_t* const sizes = this->LoopSizes.data();
  const BoundaryLoops loops = { &this->LoopPoints[part.FirstPoint], sizes + part.FirstSize,
    sizes + part.LastSize };
  Frame frame;
  if (FindFrame(ball, part.Around, frame))
  {
    MultiplyByBoundaryAhead(loops, frame, sites, products);
  }
  else
  {
    MultiplyByBoundary(loops, sites, products);
  }
}

void WindingNumberOfCaps::AddBlock(const Sites& sites, const std::vector<Id>& order,
  std::size_t first, std::vector<BoundedPart>& parts, std::vector<double>& w) const
{
  const std::size_t last = std::min(order.size(), first + Lanes);
  for (std::size_t i = first; i < last; ++i)
  {
    Prefetch(&w[order[i]]);
  }
  SiteProducts block = MakeBlock(sites, order, first);
  const Ball ball = BallAround(block.Rounded);
  this->Choose(ball, parts);
  const double largestFar = LargestFar(parts);

  PhaseProducts far;
  std::fill(far.Real, far.Real + Lanes, 1.0);
  std::fill(far.Imaginary, far.Imaginary + Lanes, 0.0);
  bool anyNear = false;
  for (const BoundedPart& part : parts)
  {
    if (part.Bound <= largestFar)
    {
      this->MultiplyByFar(*part.Taken, ball, block.Rounded, far);
    }
    else
    {
      anyNear = true;
      this->Triangles.Multiply(part.Taken->Triangles, sites, block);
    }
  }
  for (std::size_t i = first; i < last; ++i)
  {
    const int lane = static_cast<int>(i - first);
    w[order[i]] += (anyNear ? WindingNumber(block.Product, lane) : 0) + Turns(far, lane);
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
      std::vector<BoundedPart> parts;
      const std::size_t first = static_cast<std::size_t>(call) * sitesPerCall;
      for (std::size_t i = first; i < std::min(order.size(), first + sitesPerCall); i += Lanes)
      {
        this->AddBlock(sites, order, i, parts, w);
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
    std::vector<BoundedPart> parts;
    this->AddBlock({ points, cells }, { 0 }, 0, parts, w);
  }
  return w.front();
}
} // namespace insideout
