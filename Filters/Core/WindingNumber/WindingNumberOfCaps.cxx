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
// A bound of the sum of far caps in one product: 1/2, less room for rounding. A product costs an
// arctangent; a cap that would fill more than half of one is summed by triangles.
constexpr double MostOfFarCaps = 0.49;
constexpr double MostOfFarCap = 0.25;

// From sites nearer to a cap's box than this fraction of its diagonal an edge might be seen under
// nearly 180 degrees, where the boundary alone would lose digits.
constexpr double LeastRelativeDistance = 0x1p-5;

// Keeps bounds valid despite rounding.
constexpr double RoundedUp = 1 + 0x1p-40;

// The distances required by BoundaryProduct.h, with room to spare.
constexpr double LeastDistance = 0x1p-40;
constexpr double LeastAhead = 0x1p-6;
constexpr double MostAhead = 2;

// Neighboring caps form a bunch, up to this many boundary points. A bunch is evaluated as one cap
// where its winding number is certainly below the second value.
constexpr std::size_t PointsPerBunch = 64;
constexpr double MostOfBunch = 0x1p-6;

/**
 * Find a frame in which, from all sites in a ball, all places in a box lie ahead and not too near.
 *
 * @return whether there is one
 */
bool FindFrame(const Ball& from, const Box& to, Frame& frame)
{
  double most = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double above = to.Low[axis] - from.Centre[axis];
    const double below = from.Centre[axis] - to.High[axis];
    if (std::max(above, below) > most)
    {
      most = std::max(above, below);
      frame.Z = axis;
      frame.Sign = above > below ? 1 : -1;
    }
  }
  if (most < from.Radius + LeastAhead || most > MostAhead)
  {
    return false;
  }
  frame.X = (frame.Z + (frame.Sign > 0 ? 1 : 2)) % 3;
  frame.Y = (frame.Z + (frame.Sign > 0 ? 2 : 1)) % 3;
  return true;
}

double DistanceFrom(const Box& box, const Point& point)
{
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double gap = std::max({ 0.0, box.Low[axis] - point[axis], point[axis] - box.High[axis] });
    squared += gap * gap;
  }
  return std::sqrt(squared);
}

/** |w| is at most the area over that of the sphere around the site which touches the cap. */
double BoundOf(double area, const Box& around, const Ball& sites)
{
  const double distance = DistanceFrom(around, sites.Centre) / RoundedUp - sites.Radius;
  const double length = QuickDistance(around.Low, around.High);
  const bool clear = distance > LeastDistance && distance > LeastRelativeDistance * length;
  return clear ? area / (4 * Pi * distance * distance) : 1;
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

/** Add the principal value of the phase, in turns. */
void AddTurns(const PhaseProducts& products, double (&sums)[Lanes])
{
  for (int lane = 0; lane < Lanes; ++lane)
  {
    sums[lane] += std::atan2(products.Imaginary[lane], products.Real[lane]) / (2 * Pi);
  }
}

const PhaseProducts Ones = []
{
  PhaseProducts ones = {};
  std::fill(ones.Real, ones.Real + Lanes, 1.0);
  return ones;
}();
} // namespace

WindingNumberOfCaps::WindingNumberOfCaps(const std::vector<Point>& points,
  const std::vector<std::vector<CountedTriangle>>& caps, std::size_t sites, Monitor& monitor,
  const ProgressRange& progress)
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
  std::vector<Chain> bunches;
  if (!chains.empty())
  {
    this->AddBunches(chains.data(), chains.data() + chains.size(), bunches);
  }
  this->Tree = std::make_unique<const MultipoleTree>(points, bunches, sites, monitor, progress);
}

/** Halve the caps across their longest extent until they fit a bunch. */
void WindingNumberOfCaps::AddBunches(
  const Chain** first, const Chain** last, std::vector<Chain>& bunches)
{
  std::size_t boundaryPoints = 0;
  for (const Chain** chain = first; chain != last; ++chain)
  {
    boundaryPoints += (*chain)->size() + 2;
  }
  if (last - first == 1 || boundaryPoints <= PointsPerBunch)
  {
    this->AddBunch(first, last, bunches);
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
  this->AddBunches(first, middle, bunches);
  this->AddBunches(middle, last, bunches);
}

void WindingNumberOfCaps::AddBunch(
  const Chain* const* first, const Chain* const* last, std::vector<Chain>& bunches)
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
  bunches.push_back(std::move(all));
}

void WindingNumberOfCaps::Measure(const Chain& triangles, Part& part) const
{
  part.Around = Box::Empty();
  for (const CountedTriangle& triangle : triangles)
  {
    part.Around.Add(BoundingBox(this->Points, triangle.Corners));
  }
  part.Area = AreaOf(this->Points, triangles);
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
void WindingNumberOfCaps::Choose(
  const Ball& sites, const std::vector<Id>& bunches, std::vector<BoundedPart>& parts) const
{
  parts.clear();
  for (const Id i : bunches)
  {
    const Bunch& bunch = this->Bunches[i];
    const double bound = BoundOf(bunch.Whole.Area, bunch.Whole.Around, sites);
    if (bound <= MostOfBunch)
    {
      parts.push_back({ &bunch.Whole, bound });
      continue;
    }
    for (std::size_t k = bunch.FirstCap; k < bunch.LastCap; ++k)
    {
      const Part& cap = this->Caps[k];
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
  std::size_t first, SiteProducts& block, Chosen& chosen, std::vector<double>& w) const
{
  const std::size_t last = std::min(order.size(), first + Lanes);
  for (std::size_t i = first; i < last; ++i)
  {
    Prefetch(&w[order[i]]);
  }
  const Ball ball = BallAround(block.Rounded);
  this->Tree->Select(ball, chosen.Inner.Rest, chosen.Bunches);
  double sums[Lanes] = {};
  this->Tree->Add(chosen.Outer, block.Rounded, sums);
  this->Tree->Add(chosen.Inner, block.Rounded, sums);
  this->Tree->Add(chosen.Bunches, block.Rounded, sums);
  this->Choose(ball, chosen.Bunches.Near, chosen.Parts);

  PhaseProducts far = Ones;
  double bound = 0;
  bool anyNear = false;
  for (const BoundedPart& part : chosen.Parts)
  {
    if (part.Bound > MostOfFarCap)
    {
      anyNear = true;
      this->Triangles.Multiply(part.Taken->Triangles, sites, block);
      continue;
    }
    if (bound + part.Bound > MostOfFarCaps)
    {
      AddTurns(far, sums);
      far = Ones;
      bound = 0;
    }
    bound += part.Bound;
    this->MultiplyByFar(*part.Taken, ball, block.Rounded, far);
  }
  AddTurns(far, sums);
  for (std::size_t i = first; i < last; ++i)
  {
    const int lane = static_cast<int>(i - first);
    w[order[i]] += (anyNear ? WindingNumber(block.Product, lane) : 0) + sums[lane];
  }
}

void WindingNumberOfCaps::Add(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  if (this->IsEmpty())
  {
    return;
  }
  const std::size_t blocksPerRun = MultipoleTree::BlocksPerRun;
  const std::size_t sitesPerCall = this->Tree->RunsPerCall() * blocksPerRun * Lanes;
  const Id calls = static_cast<Id>((order.size() + sitesPerCall - 1) / sitesPerCall);
  const double nanosecondsPerTriangle = 2;
  ChunkedLoop(calls, nanosecondsPerTriangle * sitesPerCall * this->Triangles.NumberOfTriangles(),
    monitor, progress,
    [&](Id call)
    {
      Chosen chosen;
      const std::size_t first = static_cast<std::size_t>(call) * sitesPerCall;
      const std::size_t last = std::min(order.size(), first + sitesPerCall);
      std::vector<SiteProducts> blocks = MakeBlocks(sites, order, first, last);
      SiteProducts* const end = blocks.data() + blocks.size();
      chosen.Outer = this->Tree->Around(BallAround(blocks.data(), end), this->Tree->Roots());
      for (std::size_t i = 0; i < blocks.size(); ++i)
      {
        if (i % blocksPerRun == 0)
        {
          SiteProducts* const run = &blocks[i];
          const Ball ball = BallAround(run, std::min(end, run + blocksPerRun));
          chosen.Inner = this->Tree->Around(ball, chosen.Outer.Rest);
        }
        this->AddBlock(sites, order, first + i * Lanes, blocks[i], chosen, w);
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
    const Sites sites = { points, cells };
    Chosen chosen;
    chosen.Inner.Rest = this->Tree->Roots();
    SiteProducts block = MakeBlock(sites, { 0 }, 0);
    this->AddBlock(sites, { 0 }, 0, block, chosen, w);
  }
  return w.front();
}
} // namespace insideout
