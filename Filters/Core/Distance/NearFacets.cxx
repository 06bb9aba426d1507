// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distance/NearFacets.h"

#include "Common/Vectors.h"
#include "WindingNumber/VectorClones.h"

#include <algorithm>

namespace insideout
{
namespace
{
constexpr int Lanes = PointBlock::Lanes;

// Doubles do not determine a needle's normal well. Facets with a squared sine at a corner below
// this, or a squared normal that may have lost digits, are left to the exact distance.
constexpr double LeastSquaredSine = 0x1p-15;
constexpr double LeastSquaredNormal = 0x1p-960;

// The error of any other facet's distance d is below e = 2^-38 L, with L the root of the summed
// squares of the lengths in its computation. With t = 2^-20, (d - e)^2 is at least d^2 (1 - t) -
// e^2 / t, and (d + e)^2 at most d^2 (1 + t) + 2 e^2 / t.
constexpr double RelativeError = 0x1p-20;
constexpr double SquaredError = 0x1p-55;

struct LaneDistances
{
  double Squared[Lanes];
  double Sum; ///< of all lanes
};

INSIDEOUT_ALWAYS_INLINE void MeasureBox(
  const Box& box, const PointBlock& block, LaneDistances& distances)
{
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (int lane = 0; lane < Lanes; ++lane)
  {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double below = box.Low[axis] - block.Of[axis][lane];
      const double above = block.Of[axis][lane] - box.High[axis];
      const double beyond = below > above ? below : above;
      squared += beyond > 0 ? beyond * beyond : 0;
    }
    distances.Squared[lane] = squared;
    sum += squared;
  }
  distances.Sum = sum;
}

INSIDEOUT_ALWAYS_INLINE bool IsNear(const LaneDistances& distances, const PointBlock& block)
{
  long isNear = 0;
#pragma omp simd reduction(| : isNear)
  for (int lane = 0; lane < Lanes; ++lane)
  {
    isNear |= distances.Squared[lane] <= block.Bound[lane] ? 1 : 0;
  }
  return isNear != 0;
}

INSIDEOUT_ALWAYS_INLINE double ClampedToUnit(double t)
{
  t = t > 0 ? t : 0;
  return t < 1 ? t : 1;
}

/** The facet's data for each lane's distance. */
struct FacetFrame
{
  std::array<Point, 3> Edges;   ///< edge k leads from corner k to the next
  std::array<Point, 3> Outward; ///< in the facet's plane, perpendicular to its edges
  Point Normal;
  double SquaredEdges[3];
  double SquaredNormal;

  explicit FacetFrame(const std::array<Point, 3>& corners)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Edges[k] = Difference(corners[(k + 1) % 3], corners[k]);
      this->SquaredEdges[k] = Dot(this->Edges[k], this->Edges[k]);
    }
    this->Normal = Cross(this->Edges[0], this->Edges[1]);
    this->SquaredNormal = Dot(this->Normal, this->Normal);
    for (int k = 0; k < 3; ++k)
    {
      this->Outward[k] = Cross(this->Edges[k], this->Normal);
    }
  }

  bool IsNeedle() const
  {
    const double* e = this->SquaredEdges;
    return !(this->SquaredNormal > LeastSquaredNormal &&
      this->SquaredNormal > LeastSquaredSine * e[0] * e[1] &&
      this->SquaredNormal > LeastSquaredSine * e[1] * e[2] &&
      this->SquaredNormal > LeastSquaredSine * e[2] * e[0]);
  }
};

/** Update the least squared distances by the facet, and lower the bounds to it. */
INSIDEOUT_ALWAYS_INLINE void MeasureFacet(
  const std::array<Point, 3>& corners, PointBlock& block, double (&least)[Lanes])
{
  const FacetFrame facet(corners);
  if (facet.IsNeedle())
  {
    return;
  }
  const double lengths = facet.SquaredEdges[0] + facet.SquaredEdges[1] + facet.SquaredEdges[2];
  const double perNormal = 1 / facet.SquaredNormal;
  const double perEdge[3] = { 1 / facet.SquaredEdges[0], 1 / facet.SquaredEdges[1],
    1 / facet.SquaredEdges[2] };
  double low[Lanes];
  double high[Lanes];
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    double side = 0; // above 0 if the projection is beyond an edge
    double outline = 0;
    double seen = 0;
    double height = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Point& edge = facet.Edges[k];
      const Point& out = facet.Outward[k];
      const double x = block.Of[0][lane] - corners[k][0];
      const double y = block.Of[1][lane] - corners[k][1];
      const double z = block.Of[2][lane] - corners[k][2];
      const double beyond = x * out[0] + y * out[1] + z * out[2];
      const double t = ClampedToUnit((x * edge[0] + y * edge[1] + z * edge[2]) * perEdge[k]);
      const double u = x - t * edge[0];
      const double v = y - t * edge[1];
      const double w = z - t * edge[2];
      const double squared = u * u + v * v + w * w;
      const double along = x * facet.Normal[0] + y * facet.Normal[1] + z * facet.Normal[2];
      side = k == 0 || beyond > side ? beyond : side;
      outline = k == 0 || squared < outline ? squared : outline;
      seen = k == 0 ? x * x + y * y + z * z : seen;
      height = k == 0 ? along * along * perNormal : height;
    }
    const double squared = side > 0 ? outline : height;
    const double error = SquaredError * (seen + lengths);
    low[lane] = squared * (1 - RelativeError) - error;
    high[lane] = squared * (1 + RelativeError) + error + block.Room[lane];
  }
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    least[lane] = least[lane] > low[lane] ? least[lane] : low[lane];
    block.Bound[lane] = block.Bound[lane] < high[lane] ? block.Bound[lane] : high[lane];
  }
}
} // namespace

// Functions that it calls are inlined, to be compiled for the same processor.
INSIDEOUT_VECTOR_CLONES __attribute__((flatten)) void FindNearFacets(const BoxTree& tree,
  const std::vector<std::array<Point, 3>>& facets, PointBlock& block, std::vector<NearFacet>& found)
{
  PointBlock local = block; // local, so that nothing aliases it
  found.clear();
  tree.VisitNearFirst<LaneDistances>([&](const Box& box, LaneDistances& distances)
    { MeasureBox(box, local, distances); },
    [&](const LaneDistances& distances) { return IsNear(distances, local); },
    [](const LaneDistances& a, const LaneDistances& b) { return a.Sum <= b.Sum; },
    [&](Id facet, LaneDistances& distances)
    {
      MeasureFacet(facets[facet], local, distances.Squared);
      if (IsNear(distances, local))
      {
        found.emplace_back();
        found.back().Facet = facet;
        std::copy_n(distances.Squared, Lanes, found.back().Least);
      }
    });
  block = local;
}
} // namespace insideout
