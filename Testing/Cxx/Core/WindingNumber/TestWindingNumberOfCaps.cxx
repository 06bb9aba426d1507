// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumberOfCaps.h"

#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SolidAngle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace insideout;

/** Squares one above another, each a cap of two triangles. */
struct Stack
{
  std::vector<Point> Points;
  std::vector<std::vector<CountedTriangle>> Caps;

  explicit Stack(int height)
  {
    for (int i = 0; i < height; ++i)
    {
      const Id first = static_cast<Id>(this->Points.size());
      const double half = 0.1;
      const double z = -0.002 * i;
      this->Points.insert(this->Points.end(),
        { { -half, -half, z }, { half, -half, z }, { half, half, z }, { -half, half, z } });
      this->Caps.push_back(
        { { { first, first + 1, first + 2 }, 1 }, { { first, first + 2, first + 3 }, 1 } });
    }
  }

  double WindingNumberAt(const Point& p) const
  {
    double sum = 0;
    for (const std::vector<CountedTriangle>& cap : this->Caps)
    {
      for (const CountedTriangle& triangle : cap)
      {
        const std::array<Point, 3> corners = CornersOf(this->Points, triangle.Corners);
        sum += std::arg(HalfSolidAngle(corners, SiteAt(p))) / (2 * Pi);
      }
    }
    return sum;
  }
};

TEST(WindingNumberOfCaps, CapsWhoseSumExceedsAHalfAreNotTakenModuloOne)
{
  const Stack stack(60);
  Monitor silent;
  const WindingNumberOfCaps caps(stack.Points, stack.Caps, 0, silent, { "", 0, 1 });
  double largest = 0;
  for (const double z : { 0.001, 0.03, 0.1, 0.15, 0.2, 0.3, 0.6, 1.2, 5. })
  {
    for (const double x : { 0., 0.05, 0.15 })
    {
      const Point site = { x, 0.01, z };
      const double w = stack.WindingNumberAt(site);
      EXPECT_NEAR(caps.At(site), w, 1e-14) << x << " " << z;
      largest = std::max(largest, std::abs(w));
    }
  }
  EXPECT_GT(largest, 10);
}

/** The caps of many sites by multipoles, and those of few without. */
TEST(WindingNumberOfCaps, ManySitesGetTheValuesOfFew)
{
  std::vector<Point> points;
  std::vector<std::vector<CountedTriangle>> caps;
  for (int i = 0; i < 4000; ++i)
  {
    const Id first = static_cast<Id>(points.size());
    const double x = (i % 20) / 20. - 0.5, y = (i / 20 % 20) / 20. - 0.5, z = i / 400 / 10. - 0.5;
    points.insert(points.end(), { { x, y, z }, { x + 0.04, y, z }, { x, y + 0.04, z + 0.01 } });
    caps.push_back({ { { first, first + 1, first + 2 }, 1 } });
  }
  Monitor silent;
  const WindingNumberOfCaps few(points, caps, 0, silent, { "", 0, 1 });
  const WindingNumberOfCaps many(points, caps, 1000000, silent, { "", 0, 1 });
  int byMultipoles = 0; // at least those whose last digits differ
  for (int i = 0; i < 200; ++i)
  {
    const Point site = { 0.6 * std::sin(i), 0.6 * std::sin(2. * i + 1),
      0.6 * std::sin(3. * i + 2) };
    EXPECT_NEAR(many.At(site), few.At(site), 1e-14);
    byMultipoles += many.At(site) != few.At(site);
  }
  EXPECT_GT(byMultipoles, 20);
}
} // namespace
