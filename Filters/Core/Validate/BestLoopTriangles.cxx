// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/BestLoopTriangles.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// An orientation in doubles is certain above this fraction of its terms (Shewchuk 1997, Adaptive
// precision floating-point arithmetic, has 3.33e-16), and above the possible underflow.
constexpr double SureOrientation = 4e-16;
constexpr double SafelyNormal = 1e-300;

// Sums of the same terms in another order differ by less than this fraction: they count as equal.
constexpr double SameSum = 1e-12;

// A finite badness for triangles without area, so that one is better than two.
constexpr double Degenerate = 1e30;

struct Cost
{
  double Area;
  double Badness;
};

class LoopSearch
{
public:
  LoopSearch(const SmallLoop& loop, int axis, int sign, double margin)
    : Loop(loop)
    , First((axis + 1) % 3)
    , Second((axis + 2) % 3)
    , Sign(sign)
    , Margin(margin)
  {
  }

  std::optional<LoopTriangles> Find();

private:
  int Orientation(int a, int b, int c) const;
  Cost CostOf(int a, int b, int c) const;
  bool IsBetter(const Cost& a, const Cost& b) const;
  void FillIn(int i, int j);

  const SmallLoop& Loop;
  const int First; ///< the projected coordinates
  const int Second;
  const int Sign;
  const double Margin;

  // The best triangulation of the loop from i to j and back: its cost, and the third corner at that
  // edge.
  Cost Best[MostCornersToSearch][MostCornersToSearch];
  int Middle[MostCornersToSearch][MostCornersToSearch];
};

int LoopSearch::Orientation(int a, int b, int c) const
{
  const Point& p = this->Loop.Corners[a];
  const Point& q = this->Loop.Corners[b];
  const Point& r = this->Loop.Corners[c];
  const int u = this->First;
  const int v = this->Second;
  const double left = (p[u] - r[u]) * (q[v] - r[v]);
  const double right = (p[v] - r[v]) * (q[u] - r[u]);
  const double bound = SureOrientation * (std::abs(left) + std::abs(right)) + SafelyNormal;
  if (left - right > bound)
  {
    return 1;
  }
  if (right - left > bound)
  {
    return -1;
  }
  return Orient2D({ p[u], p[v] }, { q[u], q[v] }, { r[u], r[v] });
}

Cost LoopSearch::CostOf(int a, int b, int c) const
{
  const Point first = Difference(this->Loop.Scaled[b], this->Loop.Scaled[a]);
  const Point last = Difference(this->Loop.Scaled[c], this->Loop.Scaled[a]);
  const Point across = Difference(last, first);
  const Point normal = Cross(first, last);
  const double area = std::sqrt(Dot(normal, normal));
  const double lengths = Dot(first, first) + Dot(last, last) + Dot(across, across);
  return { area, lengths < Degenerate * area ? lengths / area : Degenerate };
}

bool LoopSearch::IsBetter(const Cost& a, const Cost& b) const
{
  return a.Area < b.Area - this->Margin ||
    (a.Area <= b.Area + this->Margin && a.Badness < b.Badness * (1 - SameSum));
}

void LoopSearch::FillIn(int i, int j)
{
  Cost best = { Infinity, Infinity };
  for (int k = j - 1; k > i; --k) // downwards: on ties a fan from the first corner remains
  {
    const Cost& left = this->Best[i][k];
    const Cost& right = this->Best[k][j];
    if (left.Area + right.Area < Infinity &&
      (this->Sign == 0 || this->Orientation(i, k, j) == this->Sign))
    {
      const Cost own = this->CostOf(i, k, j);
      const Cost sum = { own.Area + left.Area + right.Area,
        own.Badness + left.Badness + right.Badness };
      if (this->IsBetter(sum, best))
      {
        best = sum;
        this->Middle[i][j] = k;
      }
    }
  }
  this->Best[i][j] = best;
}

std::optional<LoopTriangles> LoopSearch::Find()
{
  const int last = this->Loop.Size - 1;
  for (int i = 0; i < last; ++i)
  {
    this->Best[i][i + 1] = { 0, 0 };
  }
  for (int width = 2; width <= last; ++width)
  {
    for (int i = 0; i + width <= last; ++i)
    {
      this->FillIn(i, i + width);
    }
  }
  LoopTriangles found;
  found.Area = this->Best[0][last].Area;
  if (!(found.Area < Infinity))
  {
    return std::nullopt;
  }
  std::array<std::array<int, 2>, MostCornersToSearch> parts;
  int count = 0;
  int waiting = 0;
  parts[waiting++] = { 0, last };
  while (waiting > 0)
  {
    const auto [i, j] = parts[--waiting];
    if (j - i > 1)
    {
      const int k = this->Middle[i][j];
      found.Corners[count++] = { i, k, j };
      parts[waiting++] = { i, k };
      parts[waiting++] = { k, j };
    }
  }
  return found;
}
} // namespace

std::optional<LoopTriangles> FindBestLoopTriangles(
  const SmallLoop& loop, int axis, int sign, double margin)
{
  return LoopSearch(loop, axis, sign, margin).Find();
}
} // namespace insideout
