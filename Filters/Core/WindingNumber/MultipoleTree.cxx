// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/MultipoleTree.h"

#include "Common/Box.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/TranslateMultipoles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insideout
{
namespace
{
// The most that the terms left out add to a winding number.
constexpr double LeastSeen = 0x1p-51;

// Steps to find the ratio of a radius and a distance: more would not save a degree.
constexpr int Bisections = 24;

// Smaller radii would underflow when squared.
constexpr double LeastRadius = 0x1p-400;

// Keeps bounds valid despite rounding.
constexpr double RoundedUp = 1 + 0x1p-40;

// An expansion takes as long as its group at some 5,000 sites, and pays off where most groups are
// far from most sites.
constexpr std::size_t LeastSites = 65536;
constexpr std::size_t LeastGroups = 16;

/** The largest number from 0 to 1 at which an increasing function is up to a bound. */
template <typename Function>
double LargestBelow(double bound, const Function& function)
{
  double low = 0;
  double high = 1;
  for (int step = 0; step < Bisections; ++step)
  {
    const double middle = (low + high) / 2;
    (function(middle) <= bound ? low : high) = middle;
  }
  return low;
}

Ball BallAround(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
{
  Box box = Box::Empty();
  for (const CountedTriangle& triangle : triangles)
  {
    box.Add(BoundingBox(points, triangle.Corners));
  }
  Ball ball;
  for (int axis = 0; axis < 3; ++axis)
  {
    ball.Centre[axis] = box.Low[axis] / 2 + box.High[axis] / 2;
  }
  ball.Radius = 0;
  for (const CountedTriangle& triangle : triangles)
  {
    for (const Id p : triangle.Corners)
    {
      ball.Radius = std::max(ball.Radius, QuickDistance(ball.Centre, points[p]));
    }
  }
  ball.Radius = std::max(ball.Radius * RoundedUp, LeastRadius);
  return ball;
}
} // namespace

Ball BallAround(const SiteBlock& sites)
{
  Ball ball;
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(sites.High[axis], sites.High[axis] + Lanes);
    ball.Centre[axis] = *low / 2 + *high / 2;
    const double extent = *high / 2 - *low / 2;
    squared += extent * extent;
  }
  ball.Radius = std::sqrt(squared) * RoundedUp;
  return ball;
}

Ball BallAround(const SiteProducts* first, const SiteProducts* last)
{
  Box box = Box::Empty();
  for (const SiteProducts* block = first; block != last; ++block)
  {
    const auto& [x, y, z] = block->Rounded.High;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      box.Add(Point{ x[lane], y[lane], z[lane] });
    }
  }
  Ball ball;
  for (int axis = 0; axis < 3; ++axis)
  {
    ball.Centre[axis] = box.Low[axis] / 2 + box.High[axis] / 2;
  }
  ball.Radius = QuickDistance(ball.Centre, box.High) * RoundedUp;
  return ball;
}

double QuickDistance(const Point& a, const Point& b)
{
  const Point d = Difference(a, b);
  return std::sqrt(Dot(d, d));
}

double AreaOf(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
{
  double area = 0;
  for (const CountedTriangle& triangle : triangles)
  {
    const auto [a, b, c] = CornersOf(points, triangle.Corners);
    area += std::abs(triangle.Count) * Length(NormalOf(a, b, c)) / 2;
  }
  return area * RoundedUp;
}

MultipoleTree::MultipoleTree(const std::vector<Point>& points,
  const std::vector<std::vector<CountedTriangle>>& groups, std::size_t sites, Monitor& monitor,
  const ProgressRange& progress)
  : NumberOfGroups(groups.size())
{
  if (groups.size() < LeastGroups || sites < LeastSites)
  {
    return;
  }
  this->Nodes.reserve(2 * groups.size() - 1);
  this->Build(points, groups, 0, groups.size());
  const std::vector<Tetrahedron> cells = CellsOfPoints(MultipoleSamples().size());
  const Sites samples = { MultipoleSamples(), cells };
  std::vector<Id> order(cells.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<SiteProducts> blocks = MakeBlocks(samples, order, 0, order.size());
  const double nanosecondsPerNode = 3e5;
  // Children are shorter than their parent: level by level, from the groups up.
  std::vector<std::vector<Id>> levels;
  for (std::size_t i = 0; i < this->Nodes.size(); ++i)
  {
    std::size_t level = 0;
    for (std::size_t size = 1; size < this->Nodes[i].Last - this->Nodes[i].First; size *= 2)
    {
      ++level;
    }
    levels.resize(std::max(levels.size(), level + 1));
    levels[level].push_back(static_cast<Id>(i));
  }
  for (const std::vector<Id>& level : levels)
  {
    ParallelLoop(level.size(), nanosecondsPerNode, monitor,
      { progress.Stage, progress.Begin, progress.Begin },
      [&](std::size_t i)
      {
        Node& node = this->Nodes[level[i]];
        if (node.Last - node.First == 1)
        {
          Expand(points, groups[node.First], samples, blocks, node);
          return;
        }
        const Node& left = this->Nodes[level[i] + 1];
        Join(blocks, node, left, this->Nodes[left.Next]);
      });
  }
}

void MultipoleTree::Build(const std::vector<Point>& points,
  const std::vector<std::vector<CountedTriangle>>& groups, std::size_t first, std::size_t last)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.push_back({});
  std::vector<CountedTriangle> all;
  for (std::size_t group = first; group < last; ++group)
  {
    all.insert(all.end(), groups[group].begin(), groups[group].end());
  }
  if (last - first > 1)
  {
    const std::size_t middle = first + (last - first) / 2;
    this->Build(points, groups, first, middle);
    this->Build(points, groups, middle, last);
  }
  Node& node = this->Nodes[index];
  node.First = first;
  node.Last = last;
  node.Next = static_cast<Id>(this->Nodes.size());
  node.Around = BallAround(points, all);
  node.Area = AreaOf(points, all);
  this->SetReach(node);
}

/** Set the distance from which the highest degree serves, by the area and the children. */
void MultipoleTree::SetReach(Node& node) const
{
  // A bound of what the terms above the highest degree add to w, where t is the ball's radius over
  // the distance d. A vector area n at x adds n times the gradients of |x|^l P_l / d^(l+1), which
  // are below l |x|^(l-1) |n| / d^(l+1) by the inequality of Bernstein and Szego.
  const double squared = node.Around.Radius * node.Around.Radius;
  node.Reach.back() = node.Around.Radius /
    LargestBelow(LeastSeen,
      [&](double t)
      {
        const double p = MultipoleDegree;
        return node.Area / (4 * Pi * squared) * std::pow(t, p + 2) * (p + 1 - p * t) /
          ((1 - t) * (1 - t));
      });
  if (node.Last - node.First == 1)
  {
    return;
  }
  const Node* const left = &node + 1;
  for (const Node* child : { left, &this->Nodes[left->Next] })
  {
    const double distance = QuickDistance(node.Around.Centre, child->Around.Centre);
    node.Reach.back() = std::max(node.Reach.back(), (distance + child->Reach.back()) * RoundedUp);
  }
}

/** Set the distances of the other degrees, by the terms that these leave out. */
void MultipoleTree::SharpenReach(Node& node)
{
  const std::array<double, MultipoleDegree + 1> bounds = MultipoleBounds(node.Field);
  const double nearer = node.Reach.back() / (2 * node.Around.Radius);
  node.Largest = 0;
  for (int l = MultipoleDegree; l >= 0; --l)
  {
    node.Largest = (node.Largest + bounds[l]) * nearer;
  }
  for (int p = 0; p < MultipoleDegree; ++p)
  {
    const double t = LargestBelow(LeastSeen,
      [&](double t)
      {
        double sum = 0;
        for (int l = MultipoleDegree; l > p; --l)
        {
          sum = (sum + bounds[l]) * t;
        }
        return sum * std::pow(t, p + 1);
      });
    node.Reach[p] = node.Reach.back() / t; // perhaps infinite
  }
}

/** Make a group's field, from its triangles in units of its reach. */
void MultipoleTree::Expand(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& group, const Sites& samples,
  const std::vector<SiteProducts>& blocks, Node& node)
{
  std::vector<Id> ids;
  for (const CountedTriangle& triangle : group)
  {
    ids.insert(ids.end(), triangle.Corners.begin(), triangle.Corners.end());
  }
  SortUniquely(ids);
  std::vector<CountedTriangle> triangles = group;
  for (CountedTriangle& triangle : triangles)
  {
    for (Id& corner : triangle.Corners)
    {
      corner = IndexIn(ids, corner);
    }
  }
  std::vector<Point> local;
  for (const Id id : ids)
  {
    Point p = Difference(points[id], node.Around.Centre);
    for (double& x : p)
    {
      x /= node.Reach.back();
    }
    local.push_back(p);
  }
  SolidAngleTiles tiles(local);
  const TileRange range = tiles.Add(triangles);
  std::vector<double> values;
  for (SiteProducts block : blocks)
  {
    tiles.Multiply(range, samples, block);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      values.push_back(WindingNumber(block.Product, lane));
    }
  }
  node.Field = MultipoleOf(values);
  SharpenReach(node);
}

/** Make a node's field from those of its children, which reach its samples. */
void MultipoleTree::Join(
  const std::vector<SiteProducts>& blocks, Node& node, const Node& left, const Node& right)
{
  std::vector<double> values;
  for (const SiteProducts& block : blocks)
  {
    double w[Lanes] = {};
    for (const Node* child : { &left, &right })
    {
      const Point offset = Difference(node.Around.Centre, child->Around.Centre);
      double at[3][Lanes];
      for (int axis = 0; axis < 3; ++axis)
      {
        for (int lane = 0; lane < Lanes; ++lane)
        {
          at[axis][lane] = (block.Rounded.High[axis][lane] * node.Reach.back() + offset[axis]) /
            child->Reach.back();
        }
      }
      AddMultipole(child->Field, MultipoleDegree, at, w);
    }
    values.insert(values.end(), w, w + Lanes);
  }
  node.Field = MultipoleOf(values);
  SharpenReach(node);
}

int MultipoleTree::DegreeAt(const Node& node, double distance)
{
  // Reaches decrease.
  const auto serves = std::partition_point(
    node.Reach.begin(), node.Reach.end(), [&](double reach) { return reach > distance; });
  return static_cast<int>(serves - node.Reach.begin());
}

/**
 * The degree up to which a node's field is expanded in a ball around sites; above the highest one
 * if none serves.
 */
int MultipoleTree::LocalDegree(const Node& node, double distance, double radius)
{
  // The field is at most Largest in a ball around the sites' center that ends two radii from the
  // node's. Let t be the sites' radius over that ball's. At the sites the part of degree n is at
  // most root(2 n + 1) t^n Largest, by the addition theorem (MultipoleBounds). The parts from this
  // degree on add up to at most 1 / (1 - t)^2 times that.
  const double t = radius / (distance - 2 * node.Around.Radius);
  if (!(t > 0 && t < 1))
  {
    return MultipoleDegree + 1;
  }
  double rest = node.Largest * t / ((1 - t) * (1 - t));
  int degree = 0;
  while (degree <= MultipoleDegree && rest * std::sqrt(2 * degree + 3) > LeastSeen)
  {
    rest *= t;
    ++degree;
  }
  return degree;
}

std::vector<Id> MultipoleTree::Roots() const
{
  return this->Nodes.empty() ? std::vector<Id>() : std::vector<Id>{ 0 };
}

/** Call far(node, distance of the balls' centers) or near(leaf), which together have all groups. */
template <typename Far, typename Near>
void MultipoleTree::VisitNodes(
  const Ball& sites, const std::vector<Id>& nodes, const Far& far, const Near& near) const
{
  for (const Id root : nodes)
  {
    for (Id i = root; i < this->Nodes[root].Next;)
    {
      const Node& node = this->Nodes[i];
      const double distance = QuickDistance(node.Around.Centre, sites.Centre) / RoundedUp;
      if (distance - sites.Radius >= node.Reach.back())
      {
        far(i, distance);
        i = node.Next;
        continue;
      }
      if (node.Last - node.First == 1)
      {
        near(i);
      }
      ++i;
    }
  }
}

MultipoleTree::Local MultipoleTree::Around(const Ball& sites, const std::vector<Id>& nodes) const
{
  struct Pair
  {
    Id Node;
    int Degree;
    int LocalDegree;
    double Distance;
  };
  std::vector<Pair> pairs;
  Local local;
  local.Sites = sites;
  this->VisitNodes(
    sites, nodes,
    [&](Id i, double distance)
    {
      const Node& node = this->Nodes[i];
      const int degree = LocalDegree(node, distance, sites.Radius);
      if (degree > MultipoleDegree)
      {
        local.Rest.push_back(i);
        return;
      }
      pairs.push_back({ i, DegreeAt(node, distance - sites.Radius), degree, distance * RoundedUp });
    },
    [&](Id leaf) { local.Rest.push_back(leaf); });
  // Nodes side by side share their degrees.
  std::stable_sort(pairs.begin(), pairs.end(),
    [](const Pair& a, const Pair& b)
    { return a.Degree + a.LocalDegree < b.Degree + b.LocalDegree; });
  for (std::size_t first = 0; first < pairs.size(); first += Lanes)
  {
    FarMultipoles far = {};
    int degree = 0;
    int localDegree = 0;
    for (std::size_t k = 0; k < Lanes; ++k)
    {
      const Pair& pair = pairs[std::min(first + k, pairs.size() - 1)];
      const Node& node = this->Nodes[pair.Node];
      far.Fields[k] = &node.Field;
      for (int axis = 0; axis < 3; ++axis)
      {
        far.Direction[axis][k] = (sites.Centre[axis] - node.Around.Centre[axis]) / pair.Distance;
      }
      far.Unit[k] = first + k < pairs.size() ? node.Reach.back() / pair.Distance : 0;
      far.Radius[k] = sites.Radius / pair.Distance;
      degree = std::max(degree, pair.Degree);
      localDegree = std::max(localDegree, pair.LocalDegree);
    }
    TranslateMultipoles(far, degree, localDegree, local.Field);
    local.Degree = std::max(local.Degree, localDegree);
  }
  return local;
}

void MultipoleTree::Select(
  const Ball& sites, const std::vector<Id>& nodes, Selection& selection) const
{
  selection.Far.clear();
  selection.Near.clear();
  if (this->Nodes.empty())
  {
    selection.Near.resize(this->NumberOfGroups);
    std::iota(selection.Near.begin(), selection.Near.end(), 0);
    return;
  }
  this->VisitNodes(
    sites, nodes,
    [&](Id i, double distance) {
      selection.Far.push_back({ i, DegreeAt(this->Nodes[i], distance - sites.Radius) });
    },
    [&](Id leaf) { selection.Near.push_back(static_cast<Id>(this->Nodes[leaf].First)); });
}

void MultipoleTree::Add(const Local& local, const SiteBlock& sites, double (&w)[Lanes]) const
{
  if (local.Degree < 0)
  {
    return;
  }
  double at[3][Lanes];
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int lane = 0; lane < Lanes; ++lane)
    {
      at[axis][lane] =
        ((sites.High[axis][lane] - local.Sites.Centre[axis]) + sites.Low[axis][lane]) /
        local.Sites.Radius;
    }
  }
  AddLocal(local.Field, local.Degree, at, w);
}

void MultipoleTree::Add(
  const Selection& selection, const SiteBlock& sites, double (&w)[Lanes]) const
{
  for (const Selection::Part& part : selection.Far)
  {
    const Node& node = this->Nodes[part.Node];
    const double inverse = 1 / node.Reach.back();
    double at[3][Lanes];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int lane = 0; lane < Lanes; ++lane)
      {
        at[axis][lane] =
          ((sites.High[axis][lane] - node.Around.Centre[axis]) + sites.Low[axis][lane]) * inverse;
      }
    }
    AddMultipole(node.Field, part.Degree, at, w);
  }
}
} // namespace insideout
