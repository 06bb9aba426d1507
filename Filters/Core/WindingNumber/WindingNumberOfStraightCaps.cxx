// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumberOfStraightCaps.h"

#include "Common/ChunkedLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/ChainFacets.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/PlaceInBox.h"
#include "WindingNumber/SolidAngle.h"
#include "WindingNumber/SpatialOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
// From a site among the pieces a line leads to a point at this height above them, anywhere in a
// cube of half that size. It fails only where it meets an edge or a corner exactly.
constexpr double Above = 0x1p-30;
constexpr int MostLines = 64;

// Neighboring caps form a group.
constexpr std::size_t CapsPerGroup = 16;

std::vector<Id> OrderOfCaps(const std::vector<Point>& points, const std::vector<StraightCap>& caps)
{
  std::vector<Point> corners;
  corners.reserve(caps.size());
  for (const StraightCap& cap : caps)
  {
    corners.push_back(points[cap.Whole.Corners[0]]);
  }
  return SpatialOrder(corners);
}

/** Error bound of a height in long doubles, in units of their rounding error. */
constexpr long double RoundingErrors = 16;
} // namespace

WindingNumberOfStraightCaps::WindingNumberOfStraightCaps(const std::vector<Point>& points,
  const StraightCaps& caps, std::size_t sites, Monitor& monitor, const ProgressRange& progress)
  : Points(points)
  , Caps(caps)
  , Slivers(points, caps.Slivers)
{
  std::vector<std::vector<CountedTriangle>> groups;
  for (const Id i : OrderOfCaps(points, caps.Caps))
  {
    const StraightCap& cap = caps.Caps[i];
    if (groups.empty() || groups.back().size() == CapsPerGroup)
    {
      groups.emplace_back();
      this->FirstOfGroup.push_back(this->Triangles.size());
    }
    groups.back().push_back(cap.Whole);
    const Triangle corners = FromBluntCorner(points, cap.Whole.Corners);
    const CapTriangle triangle = MakeCapTriangle(CornersOf(points, corners), cap.Height);
    const std::size_t count = static_cast<std::size_t>(cap.Whole.Count);
    this->Triangles.insert(this->Triangles.end(), count, triangle);
    this->CapOf.insert(this->CapOf.end(), count, static_cast<std::size_t>(i));
  }
  this->FirstOfGroup.push_back(this->Triangles.size());
  this->Tree = std::make_unique<const MultipoleTree>(points, groups, sites, monitor, progress);
  this->Trees.assign(caps.Caps.size(), BoxTree(std::vector<Box>()));
  this->IsTreeMade = std::make_unique<std::once_flag[]>(caps.Caps.size());
}

/**
 * The triangles of a cap's pieces, then of its slivers. Made on demand, because few caps need it.
 */
const BoxTree& WindingNumberOfStraightCaps::TreeOf(std::size_t index) const
{
  const StraightCap& cap = this->Caps.Caps[index];
  const auto make = [&]
  {
    std::vector<Box> boxes;
    for (std::size_t k = cap.FirstPiece; k < cap.LastPiece; ++k)
    {
      boxes.push_back(BoundingBox(this->Points, this->Caps.Pieces[k].Corners));
    }
    for (std::size_t k = cap.FirstSliver; k < cap.LastSliver; ++k)
    {
      boxes.push_back(BoundingBox(this->Points, this->Caps.Slivers[k].Corners));
    }
    this->Trees[index] = BoxTree(std::move(boxes));
  };
  std::call_once(this->IsTreeMade[index], make);
  return this->Trees[index];
}

/** False only if the site is certainly farther from the cap's plane than all pieces. */
bool WindingNumberOfStraightCaps::MayBeAmid(const StraightCap& cap, const RoundedSite& site) const
{
  const std::array<Point, 3> corners = CornersOf(this->Points, cap.Whole.Corners);
  std::array<Vector<long double>, 3> d;
  for (int axis = 0; axis < 3; ++axis)
  {
    d[0][axis] = (static_cast<long double>(corners[0][axis]) - site.High[axis]) - site.Low[axis];
    for (int k = 1; k < 3; ++k)
    {
      d[k][axis] = static_cast<long double>(corners[k][axis]) - corners[0][axis];
    }
  }
  const Vector<long double> normal = Cross(d[1], d[2]);
  const long double lengths = std::sqrt(Dot(d[0], d[0]) * Dot(d[1], d[1]) * Dot(d[2], d[2]));
  const long double error = RoundingErrors * std::numeric_limits<long double>::epsilon() * lengths;
  return !(std::abs(Dot(d[0], normal)) > cap.Height * std::sqrt(Dot(normal, normal)) + error);
}

/** The triangles of pieces, less triangle and slivers, that may meet the box. */
std::vector<CountedTriangle> WindingNumberOfStraightCaps::ChainAround(
  std::size_t cap, const Box& box) const
{
  const StraightCap& of = this->Caps.Caps[cap];
  const Id pieces = static_cast<Id>(of.LastPiece - of.FirstPiece);
  std::vector<CountedTriangle> chain = { { of.Whole.Corners, -of.Whole.Count } };
  this->TreeOf(cap).Visit(box,
    [&](Id i)
    {
      if (i < pieces)
      {
        chain.push_back(this->Caps.Pieces[of.FirstPiece + static_cast<std::size_t>(i)]);
        return;
      }
      const CountedTriangle& sliver =
        this->Caps.Slivers[of.FirstSliver + static_cast<std::size_t>(i - pieces)];
      chain.push_back({ sliver.Corners, -sliver.Count });
    });
  return chain;
}

double WindingNumberOfStraightCaps::Label(std::size_t cap, const Site& site) const
{
  const PreparedSite from(site);
  const auto [a, b, c] = CornersOf(this->Points, this->Caps.Caps[cap].Whole.Corners);
  const Point normal = NormalOf(a, b, c);
  const double scale = Above / Length(normal);
  Point low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = from.High[axis] + scale * normal[axis];
    low[axis] = middle - Above / 4;
    high[axis] = middle + Above / 4;
  }
  Box box = { from.High, from.High };
  box.Add({ low, high });
  const std::vector<CountedTriangle> chain =
    this->ChainAround(cap, box.Widened(ReachOfStraightCap));
  const ChainFacets facets(this->Points, chain);
  for (int line = 0; line < MostLines; ++line)
  {
    const Point to = PlaceInBox(low, high, line);
    std::vector<SidedFacet> sided;
    for (Id f = 0; f < facets.Size(); ++f)
    {
      sided.emplace_back(f, facets.SideOf(f, to));
    }
    std::vector<Id> touched;
    double label = 0;
    if (facets.CountCrossings(sided.data(), sided.data() + sided.size(), from, to, &touched, label))
    {
      return touched.empty() ? label : label - facets.AngleOfTouched(std::move(touched), from, to);
    }
  }
  throw Error(ErrorCode::Inconsistent,
    "no line from a site beside the pieces of a triangle avoids the edges of all of them");
}

/** @return the label that belongs to the triangle */
double WindingNumberOfStraightCaps::MultiplyByUndecided(
  std::size_t triangle, const Site& site, Products& products, int lane) const
{
  const std::complex<double> z = HalfSolidAngle(this->Triangles[triangle].Corners, site);
  MultiplyBy(products, lane, z.real(), z.imag());
  const std::size_t cap = this->CapOf[triangle];
  const bool isFirst = triangle == 0 || this->CapOf[triangle - 1] != cap;
  return isFirst && this->MayBeAmid(this->Caps.Caps[cap], RoundedSite(site))
    ? this->Label(cap, site)
    : 0;
}

/** Multiply by the triangles of some groups, and add their labels. */
void WindingNumberOfStraightCaps::AddTriangles(const std::vector<Id>& groups, const Sites& sites,
  SiteProducts& block, double (&labels)[Lanes]) const
{
  const CapTriangle* const begin = this->Triangles.data();
  for (const Id group : groups)
  {
    const CapTriangle* const end = begin + this->FirstOfGroup[group + 1];
    for (const CapTriangle* triangle = begin + this->FirstOfGroup[group]; triangle != end;)
    {
      double undecided[Lanes] = {};
      triangle = MultiplyByTriangles(triangle, end, block.Rounded, block.Product, undecided);
      for (int lane = 0; lane < Lanes; ++lane)
      {
        // The last site fills the block.
        if (undecided[lane] > 0 && (lane == 0 || block.Index[lane] != block.Index[lane - 1]))
        {
          labels[lane] += this->MultiplyByUndecided(static_cast<std::size_t>(triangle - 1 - begin),
            sites[block.Index[lane]], block.Product, lane);
        }
      }
    }
  }
}

void WindingNumberOfStraightCaps::AddBlocks(const Sites& sites, const std::vector<Id>& order,
  std::size_t first, std::size_t last, SiteProducts* blocks, const MultipoleTree::Local& outer,
  std::vector<double>& w) const
{
  const std::size_t count = (last - first + Lanes - 1) / Lanes;
  Box box = Box::Empty();
  for (std::size_t i = 0; i < count; ++i)
  {
    box.Add(BoxOfSites(blocks[i].Rounded));
  }
  const MultipoleTree::Local inner =
    this->Tree->Around(BallAround(blocks, blocks + count), outer.Rest);
  const SliverTree::Selection slivers = this->Slivers.Select(box);
  MultipoleTree::Selection groups;
  for (std::size_t i = first; i < last; i += Lanes)
  {
    SiteProducts& block = blocks[(i - first) / Lanes];
    this->Tree->Select(BallAround(block.Rounded), inner.Rest, groups);
    double far[Lanes] = {};
    this->Tree->Add(outer, block.Rounded, far);
    this->Tree->Add(inner, block.Rounded, far);
    this->Tree->Add(groups, block.Rounded, far);
    double labels[Lanes] = {};
    this->AddTriangles(groups.Near, sites, block, labels);
    double halfAngles[Lanes] = {};
    this->Slivers.Add(slivers, sites, block, halfAngles);
    for (std::size_t k = i; k < std::min(last, i + Lanes); ++k)
    {
      const int lane = static_cast<int>(k - i);
      w[order[k]] += labels[lane] +
        (WindingNumber(block.Product, lane) + far[lane] + halfAngles[lane] / (2 * Pi));
    }
  }
}

void WindingNumberOfStraightCaps::Add(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  if (this->Triangles.empty())
  {
    return;
  }
  const std::size_t sitesPerRun = MultipoleTree::BlocksPerRun * Lanes;
  const std::size_t sitesPerCall = this->Tree->RunsPerCall() * sitesPerRun;
  const Id calls = static_cast<Id>((order.size() + sitesPerCall - 1) / sitesPerCall);
  const double nanosecondsPerTriangle = 2;
  ChunkedLoop(calls,
    nanosecondsPerTriangle * sitesPerCall * static_cast<double>(this->Triangles.size()), monitor,
    progress,
    [&](Id call)
    {
      const std::size_t first = static_cast<std::size_t>(call) * sitesPerCall;
      const std::size_t last = std::min(order.size(), first + sitesPerCall);
      std::vector<SiteProducts> blocks = MakeBlocks(sites, order, first, last);
      const MultipoleTree::Local outer = this->Tree->Around(
        BallAround(blocks.data(), blocks.data() + blocks.size()), this->Tree->Roots());
      for (std::size_t i = first; i < last; i += sitesPerRun)
      {
        this->AddBlocks(
          sites, order, i, std::min(last, i + sitesPerRun), &blocks[(i - first) / Lanes], outer, w);
      }
    });
}
} // namespace insideout
