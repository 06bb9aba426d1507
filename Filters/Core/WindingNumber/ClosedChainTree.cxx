// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ClosedChainTree.h"

#include "Common/ChunkedLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insideout
{
namespace
{
// A cube with more facets than the first is subdivided; with more than the second, it is subdivided
// alone, on all threads.
constexpr std::ptrdiff_t MostInCube = 256;
constexpr std::size_t ManyInCube = 4096;

/** Call evaluate(i) for each i below count, on all threads. */
template <typename Evaluation>
void EvaluateEach(
  std::size_t count, Monitor& monitor, const ProgressRange& progress, const Evaluation& evaluate)
{
  const std::size_t sitesPerCall = 1024;
  const Id calls = static_cast<Id>((count + sitesPerCall - 1) / sitesPerCall);
  const double nanosecondsPerSite = 100;
  ChunkedLoop(calls, nanosecondsPerSite * sitesPerCall, monitor, progress,
    [&](Id call)
    {
      const std::size_t first = static_cast<std::size_t>(call) * sitesPerCall;
      for (std::size_t i = first; i < std::min(count, first + sitesPerCall); ++i)
      {
        evaluate(i);
      }
    });
}
} // namespace

ClosedChainTree::ClosedChainTree(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, Monitor& monitor, const ProgressRange& progress)
  : Facets(points, triangles)
{
  this->Build(nullptr, monitor, progress);
}

ClosedChainTree::ClosedChainTree(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, const std::vector<Point>& wanted, Monitor& monitor,
  const ProgressRange& progress)
  : Facets(points, triangles)
{
  this->Build(&wanted, monitor, progress);
}

void ClosedChainTree::Build(
  const std::vector<Point>* wanted, Monitor& monitor, const ProgressRange& progress)
{
  monitor.Check(progress.Stage, progress.Begin);
  if (this->Facets.Size() == 0)
  {
    return;
  }
  this->Grid = std::make_unique<ReferenceGrid>(this->Facets);
  if (wanted)
  {
    this->IsWanted.assign(this->Grid->NumberOfCubes(), 0);
    for (const Point& site : *wanted)
    {
      const std::ptrdiff_t cube = this->Grid->CubeAt(site);
      if (cube != None)
      {
        this->IsWanted[static_cast<std::size_t>(cube)] = 1;
      }
    }
  }
  if (this->Grid->Fill(this->IsWanted))
  {
    this->BuildTrees(wanted, monitor, progress);
  }
  else
  {
    this->Grid.reset();
    this->BuildOneTree(wanted, monitor, progress);
  }
}

/** Build trees for the cubes with many facets. */
void ClosedChainTree::BuildTrees(
  const std::vector<Point>* wanted, Monitor& monitor, const ProgressRange& progress)
{
  const ReferenceGrid& grid = *this->Grid;
  for (std::size_t cube = 0; cube < grid.NumberOfCubes(); ++cube)
  {
    if (grid.LastFacet(cube) - grid.FirstFacet(cube) > MostInCube)
    {
      this->Crowded.push_back(cube);
    }
  }
  const std::size_t trees = this->Crowded.size();
  this->Trees.resize(trees);
  std::vector<std::vector<Id>> wantedIn(trees);
  for (std::size_t i = 0; wanted && trees > 0 && i < wanted->size(); ++i)
  {
    const std::ptrdiff_t cube = grid.CubeAt((*wanted)[i]);
    const std::size_t tree = cube == None ? trees : this->TreeOf(static_cast<std::size_t>(cube));
    if (tree < trees && this->Crowded[tree] == static_cast<std::size_t>(cube))
    {
      wantedIn[tree].push_back(static_cast<Id>(i));
    }
  }
  const auto build = [&](std::size_t i)
  {
    const std::size_t cube = this->Crowded[i];
    ReferenceTree::Region region = { grid.BoxOf(cube), grid.ReferenceOf(cube),
      static_cast<double>(grid.ValueAtReference(cube)), {}, std::move(wantedIn[i]) };
    for (const SidedFacet* f = grid.FirstFacet(cube); f != grid.LastFacet(cube); ++f)
    {
      region.Facets.push_back(f->Facet());
    }
    std::sort(region.Facets.begin(), region.Facets.end());
    this->Trees[i] = std::make_unique<const ReferenceTree>(
      this->Facets, wanted, std::move(region), monitor, progress);
  };
  // The largest cubes one by one, each on all threads; then the others in parallel.
  std::vector<std::size_t> small;
  double facets = 0;
  for (std::size_t i = 0; i < trees; ++i)
  {
    const std::size_t cube = this->Crowded[i];
    const std::size_t size = static_cast<std::size_t>(grid.LastFacet(cube) - grid.FirstFacet(cube));
    if (size >= ManyInCube)
    {
      build(i);
      continue;
    }
    small.push_back(i);
    facets += static_cast<double>(size);
  }
  const double nanosecondsPerFacet = 2000;
  ChunkedLoop(static_cast<Id>(small.size()),
    nanosecondsPerFacet * facets / static_cast<double>(small.size() + 1), monitor, progress,
    [&](Id i) { build(small[i]); });
}

/** The tree of the cube if it has one, else that of the next cube that does. */
std::size_t ClosedChainTree::TreeOf(std::size_t cube) const
{
  return static_cast<std::size_t>(
    std::lower_bound(this->Crowded.begin(), this->Crowded.end(), cube) - this->Crowded.begin());
}

/** One tree for the whole chain; the winding number is carried from outside. */
void ClosedChainTree::BuildOneTree(
  const std::vector<Point>* wanted, Monitor& monitor, const ProgressRange& progress)
{
  ReferenceTree::Region all = { this->Facets.BoxOf(0), {}, 0, {} };
  for (Id f = 0; f < this->Facets.Size(); ++f)
  {
    all.Bounds.Add(this->Facets.BoxOf(f));
    all.Facets.push_back(f);
  }
  // Slightly enlarged, so that the box of a flat chain has an interior.
  const double largest = all.Bounds.Extent(all.Bounds.LongestAxis());
  for (int axis = 0; axis < 3; ++axis)
  {
    all.Bounds.Low[axis] -= 0x1p-4 * largest;
    all.Bounds.High[axis] += 0x1p-4 * largest;
  }
  const Point below = { 0.3143, 0.4717, 0.5919 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double extent = all.Bounds.Extent(axis);
    all.Reference[axis] = all.Bounds.Low[axis] - below[axis] * extent - below[axis] * 0x1p-3;
  }
  if (wanted)
  {
    all.Wanted.resize(wanted->size());
    std::iota(all.Wanted.begin(), all.Wanted.end(), 0);
  }
  this->Whole = all.Bounds;
  this->Trees.push_back(
    std::make_unique<const ReferenceTree>(this->Facets, wanted, std::move(all), monitor, progress));
}

bool ClosedChainTree::Locate(const RoundedSite& site, KnownBox& box, double& w) const
{
  if (!this->Grid)
  {
    w = 0;
    if (this->Trees.empty() || !this->Whole.Holds(site.High))
    {
      return false;
    }
    box = this->Trees.front()->At(site);
  }
  else
  {
    const std::ptrdiff_t found = this->Grid->CubeAt(site.High);
    if (found == None)
    {
      w = 0;
      return false;
    }
    const std::size_t cube = static_cast<std::size_t>(found);
    const SidedFacet* const first = this->Grid->FirstFacet(cube);
    const SidedFacet* const last = this->Grid->LastFacet(cube);
    w = this->Grid->ValueAtReference(cube);
    if (!this->IsWanted.empty() && !this->IsWanted[cube])
    {
      w = std::numeric_limits<double>::quiet_NaN();
      return false;
    }
    if (first == last)
    {
      return false;
    }
    box = last - first > MostInCube
      ? this->Trees[this->TreeOf(cube)]->At(site)
      : KnownBox{ this->Grid->BoxOf(cube), this->Grid->ReferenceOf(cube), w, first, last };
  }
  w = box.Value;
  return box.FirstFacet != box.LastFacet;
}

double ClosedChainTree::At(const Site& site) const
{
  KnownBox box;
  double w;
  return this->Locate(RoundedSite(site), box, w)
    ? WindingNumberIn(box, this->Facets, PreparedSite(site))
    : w;
}

double ClosedChainTree::At(const Point& point) const
{
  KnownBox box;
  double w;
  return this->Locate(RoundedSite(point), box, w)
    ? WindingNumberIn(box, this->Facets, PreparedSite(SiteAt(point)))
    : w;
}

void ClosedChainTree::Evaluate(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  EvaluateEach(order.size(), monitor, progress,
    [&](std::size_t i) { w[order[i]] = this->At(sites[order[i]]); });
}

void ClosedChainTree::Evaluate(const std::vector<Point>& points, std::vector<double>& w,
  Monitor& monitor, const ProgressRange& progress) const
{
  EvaluateEach(
    points.size(), monitor, progress, [&](std::size_t i) { w[i] = this->At(points[i]); });
}
} // namespace insideout
