// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/CapsInGrid.h"

#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/WindingNumberOfCaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace insideout
{
namespace
{
// Nodes of a polynomial along an axis. Its relative error is about rho^-Nodes, rho = d + sqrt(1 +
// d^2), where d is the distance of the nearest singularity in half lengths of the box (Trefethen
// 2013, theorem 8.2). It is 1e-15 of a winding number that is small itself.
constexpr Id Nodes = 24;
constexpr double FarInHalfLengths = 2;

// Keeps bounds valid despite rounding.
constexpr double RoundedUp = 1 + 0x1p-20;

constexpr double NanosecondsPerBox = 1e6;

double DistanceBetween(const Box& a, const Box& b)
{
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double gap = std::max({ 0.0, a.Low[axis] - b.High[axis], b.Low[axis] - a.High[axis] });
    squared += gap * gap;
  }
  return std::sqrt(squared);
}
} // namespace

/** The places of the grid themselves if they are few enough; else Chebyshev nodes. */
CapsInGrid::AxisNodes CapsInGrid::NodesOf(int axis, Id first, Id last) const
{
  const std::vector<double>& places = this->Grid.Axes[axis];
  AxisNodes nodes;
  if (last - first <= Nodes)
  {
    nodes.Places.assign(places.begin() + first, places.begin() + last);
    return nodes;
  }
  const double middle = places[first] / 2 + places[last - 1] / 2;
  const double half = places[last - 1] / 2 - places[first] / 2;
  for (Id k = 0; k < Nodes; ++k)
  {
    const double angle = (2 * k + 1) * Pi / (2 * Nodes);
    nodes.Places.push_back(middle - half * std::cos(angle));
    nodes.Weights.push_back((k % 2 == 0 ? 1 : -1) * std::sin(angle));
  }
  return nodes;
}

/** The Lagrange polynomials of the nodes, evaluated at a place. */
std::vector<double> CapsInGrid::BasisAt(const AxisNodes& nodes, double x)
{
  std::vector<double> basis(nodes.Places.size(), 0);
  const auto node = std::find(nodes.Places.begin(), nodes.Places.end(), x);
  if (node != nodes.Places.end())
  {
    basis[static_cast<std::size_t>(node - nodes.Places.begin())] = 1;
    return basis;
  }
  double sum = 0;
  for (std::size_t k = 0; k < basis.size(); ++k)
  {
    basis[k] = nodes.Weights[k] / (x - nodes.Places[k]);
    sum += basis[k];
  }
  for (double& value : basis)
  {
    value /= sum;
  }
  return basis;
}

CapsInGrid::GridBox CapsInGrid::MakeBox(
  const std::array<Id, 3>& first, const std::array<Id, 3>& last) const
{
  GridBox box;
  box.First = first;
  box.Last = last;
  for (int axis = 0; axis < 3; ++axis)
  {
    box.Nodes[axis] = this->NodesOf(axis, first[axis], last[axis]);
  }
  return box;
}

Box CapsInGrid::Around(const GridBox& box) const
{
  Box around;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& places = this->Grid.Axes[axis];
    around.Low[axis] = places[box.First[axis]];
    around.High[axis] = places[box.Last[axis] - 1];
  }
  return around;
}

/** Whether the box's polynomial can represent the cap's winding number. */
bool CapsInGrid::IsFar(Id cap, const GridBox& box) const
{
  const Box around = this->Around(box);
  double half = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    half = box.Nodes[axis].Weights.empty() ? half : std::max(half, around.Extent(axis) / 2);
  }
  return half == 0 || DistanceBetween(this->BoxOfCap[cap], around) >= FarInHalfLengths * half;
}

/** A bound of the absolute winding number of all caps in the box: the sum of each cap's area over
 * that of the sphere around the place which touches it. */
double CapsInGrid::BoundIn(const GridBox& box) const
{
  const Box around = this->Around(box);
  double bound = 0;
  for (std::size_t cap = 0; cap < this->Caps.size(); ++cap)
  {
    if (!this->Caps[cap].empty())
    {
      const double distance = DistanceBetween(this->BoxOfCap[cap], around);
      bound += this->AreaOfCap[cap] / (4 * Pi * distance * distance);
    }
  }
  return bound * RoundedUp;
}

/** Add the far caps to the values at the nodes. */
void CapsInGrid::AddFarCaps(GridBox& box) const
{
  const auto far = std::stable_partition(
    box.Near.begin(), box.Near.end(), [&](Id cap) { return !this->IsFar(cap, box); });
  if (far == box.Near.end())
  {
    return;
  }
  std::vector<std::vector<CountedTriangle>> caps;
  for (auto cap = far; cap != box.Near.end(); ++cap)
  {
    caps.push_back(this->Caps[*cap]);
  }
  box.Near.erase(far, box.Near.end());
  std::vector<Point> places;
  for (const double z : box.Nodes[2].Places)
  {
    for (const double y : box.Nodes[1].Places)
    {
      for (const double x : box.Nodes[0].Places)
      {
        places.push_back({ x, y, z });
      }
    }
  }
  box.Values.resize(places.size(), 0);
  std::vector<Id> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<Tetrahedron> cells = CellsOfPoints(places.size());
  Monitor silent;
  const ProgressRange unreported = { "", 0, 1 };
  WindingNumberOfCaps(this->Points, caps, 0, silent, unreported)
    .Add({ places, cells }, order, box.Values, silent, unreported);
}

/**
 * The halves of the box across the longest axis that has more places than nodes, with the box's
 * values.
 */
std::array<CapsInGrid::GridBox, 2> CapsInGrid::Halves(const GridBox& box) const
{
  int longest = -1;
  double length = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& places = this->Grid.Axes[axis];
    const double extent = places[box.Last[axis] - 1] - places[box.First[axis]];
    if (!box.Nodes[axis].Weights.empty() && extent > length)
    {
      longest = axis;
      length = extent;
    }
  }
  const Id middle = (box.First[longest] + box.Last[longest]) / 2;
  std::array<GridBox, 2> halves = { this->MakeBox(box.First, box.Last),
    this->MakeBox(box.First, box.Last) };
  halves[0].Last[longest] = middle;
  halves[1].First[longest] = middle;
  std::size_t stride = 1;
  for (int axis = 0; axis < longest; ++axis)
  {
    stride *= box.Nodes[axis].Places.size();
  }
  const std::size_t old = box.Nodes[longest].Places.size();
  for (GridBox& half : halves)
  {
    half.Nodes[longest] = this->NodesOf(longest, half.First[longest], half.Last[longest]);
    half.Near = box.Near;
    const std::vector<double>& nodes = half.Nodes[longest].Places;
    half.Values.resize(box.Values.size() / old * nodes.size(), 0);
    for (std::size_t k = 0; k < nodes.size() && !box.Values.empty(); ++k)
    {
      const std::vector<double> basis = BasisAt(box.Nodes[longest], nodes[k]);
      for (std::size_t rest = 0; rest < box.Values.size() / old; ++rest)
      {
        const std::size_t inner = rest % stride;
        const std::size_t outer = rest / stride;
        double sum = 0;
        for (std::size_t m = 0; m < old; ++m)
        {
          sum += basis[m] * box.Values[(outer * old + m) * stride + inner];
        }
        half.Values[(outer * nodes.size() + k) * stride + inner] = sum;
      }
    }
  }
  return halves;
}

CapsInGrid::CapsInGrid(const std::vector<Point>& points,
  const std::vector<std::vector<CountedTriangle>>& caps, double negligible, const GridPlaces& grid,
  Id first, Id last, Monitor& monitor, const ProgressRange& progress)
  : Points(points)
  , Caps(caps)
  , Grid(grid)
{
  GridBox whole = this->MakeBox({ 0, 0, first }, { grid.Size(0), grid.Size(1), last });
  for (const std::vector<CountedTriangle>& cap : caps)
  {
    Box box = Box::Empty();
    double area = 0;
    for (const CountedTriangle& triangle : cap)
    {
      const auto [a, b, c] = CornersOf(points, triangle.Corners);
      area += std::abs(triangle.Count) * Length(NormalOf(a, b, c)) / 2;
      box.Add(BoundingBox(points, triangle.Corners));
    }
    if (!cap.empty())
    {
      whole.Near.push_back(static_cast<Id>(this->BoxOfCap.size()));
    }
    this->BoxOfCap.push_back(box);
    this->AreaOfCap.push_back(area);
  }
  std::vector<GridBox> level = { std::move(whole) };
  while (!level.empty())
  {
    std::vector<std::vector<GridBox>> parts(level.size());
    ParallelLoop(level.size(), NanosecondsPerBox, monitor,
      { progress.Stage, progress.Begin, progress.Begin },
      [&](std::size_t i)
      {
        if (this->BoundIn(level[i]) < negligible)
        {
          level[i].Near.clear();
          level[i].Values.clear();
          return;
        }
        this->AddFarCaps(level[i]);
        if (!level[i].Near.empty())
        {
          std::array<GridBox, 2> halves = this->Halves(level[i]);
          parts[i] = { std::move(halves[0]), std::move(halves[1]) };
        }
        else if (!level[i].Values.empty())
        {
          this->FindBasis(level[i]);
        }
      });
    std::vector<GridBox> next;
    for (std::size_t i = 0; i < level.size(); ++i)
    {
      if (level[i].Near.empty() && !level[i].Values.empty())
      {
        this->Boxes.push_back(std::move(level[i]));
      }
      std::move(parts[i].begin(), parts[i].end(), std::back_inserter(next));
    }
    level = std::move(next);
  }
}

void CapsInGrid::FindBasis(GridBox& box) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::size_t nodes = box.Nodes[axis].Places.size();
    const std::size_t size = static_cast<std::size_t>(box.Last[axis] - box.First[axis]);
    box.Basis[axis].resize(nodes * size);
    for (std::size_t i = 0; i < size; ++i)
    {
      const double x = this->Grid.Axes[axis][static_cast<std::size_t>(box.First[axis]) + i];
      const std::vector<double> basis = BasisAt(box.Nodes[axis], x);
      for (std::size_t m = 0; m < nodes; ++m)
      {
        box.Basis[axis][axis == 0 ? m * size + i : i * nodes + m] = basis[m];
      }
    }
  }
}

void CapsInGrid::AddInSlice(Id slice, std::vector<double>& w) const
{
  for (const GridBox& box : this->Boxes)
  {
    if (box.First[2] <= slice && slice < box.Last[2])
    {
      this->AddInSlice(box, slice, w);
    }
  }
}

namespace
{
/** Set each of `sum` to the sum of its values over all runs, each times the run's factor. */
void Combine(
  const double* factors, std::size_t runs, const double* values, std::vector<double>& sum)
{
  std::fill(sum.begin(), sum.end(), 0.0);
  for (std::size_t m = 0; m < runs; ++m, values += sum.size())
  {
    const double factor = factors[m];
    for (std::size_t i = 0; factor != 0 && i < sum.size(); ++i)
    {
      sum[i] += factor * values[i];
    }
  }
}
} // namespace

/** One axis after the other. */
void CapsInGrid::AddInSlice(const GridBox& box, Id slice, std::vector<double>& w) const
{
  std::array<std::size_t, 3> nodes;
  std::array<std::size_t, 3> size;
  for (int axis = 0; axis < 3; ++axis)
  {
    nodes[axis] = box.Nodes[axis].Places.size();
    size[axis] = static_cast<std::size_t>(box.Last[axis] - box.First[axis]);
  }
  const std::size_t k = static_cast<std::size_t>(slice - box.First[2]);
  std::vector<double> plane(nodes[0] * nodes[1]);
  Combine(&box.Basis[2][k * nodes[2]], nodes[2], box.Values.data(), plane);
  std::vector<double> atNodes(nodes[0]);
  std::vector<double> atPlaces(size[0]);
  const bool placesAreNodes = box.Nodes[0].Weights.empty();
  for (std::size_t j = 0; j < size[1]; ++j)
  {
    Combine(&box.Basis[1][j * nodes[1]], nodes[1], plane.data(), atNodes);
    if (!placesAreNodes)
    {
      Combine(atNodes.data(), nodes[0], box.Basis[0].data(), atPlaces);
    }
    const std::vector<double>& sums = placesAreNodes ? atNodes : atPlaces;
    const std::size_t row = static_cast<std::size_t>(box.First[1]) + j;
    double* const places =
      &w[row * this->Grid.Axes[0].size() + static_cast<std::size_t>(box.First[0])];
    for (std::size_t i = 0; i < size[0]; ++i)
    {
      places[i] += sums[i];
    }
  }
}
} // namespace insideout
