// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/TetrahedralizationFamilies.h"

#include "Support/TestMeshes.h"

#include <array>
#include <cmath>
#include <random>

namespace testmeshes
{
TriangleSoup TwistedPrism(int sides, double turn)
{
  TriangleSoup soup;
  const Id n = sides;
  for (Id k = 0; k < 2 * n; ++k)
  {
    const double angle = 2 * M_PI * (k % n) / n + (k < n ? 0 : turn);
    soup.Points.push_back({ { std::cos(angle), std::sin(angle), k < n ? 0.0 : 1.0 } });
  }
  for (Id k = 0; k < n; ++k)
  {
    const Id next = (k + 1) % n;
    soup.Triangles.push_back({ { k, next, k + n } });
    soup.Triangles.push_back({ { next, next + n, k + n } });
    if (k > 0 && k + 1 < n)
    {
      soup.Triangles.push_back({ { 0, next, k } });
      soup.Triangles.push_back({ { n, k + n, next + n } });
    }
  }
  return soup;
}

TriangleSoup Chazelle(int notches)
{
  TriangleSoup soup;
  const double gap = 1.0 / 64;
  for (int k = 0; k < 2 * notches; ++k)
  {
    const bool below = k < notches;
    const double at = k % notches + 0.5;
    const double end = notches;
    const double surface = (below ? -gap : gap);
    const double far = below ? -1.0 - end * end : 1.0 + end * end;
    const Id first = static_cast<Id>(soup.Points.size());
    // The ridge lies on z = x y: along x below, along y above.
    for (const double along : { 0.0, end })
    {
      const double z = at * along + surface;
      const auto place = [&](double aside, double height) -> Point {
        return below ? Point{ { along, at + aside, height } }
                     : Point{ { at + aside, along, height } };
      };
      soup.Points.push_back(place(0, z));
      soup.Points.push_back(place(-0.25, far));
      soup.Points.push_back(place(0.25, far));
    }
    for (const Id side : { 1, 2 })
    {
      soup.Triangles.push_back({ { first, first + 3, first + 3 + side } });
      soup.Triangles.push_back({ { first, first + 3 + side, first + side } });
    }
  }
  return soup;
}

TriangleSoup NearSheets(unsigned seed, int sheets, int size)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  double z = 1;
  for (int sheet = 0; sheet < sheets; ++sheet)
  {
    const Id first = static_cast<Id>(soup.Points.size());
    for (int k = 0; k < (size + 1) * (size + 1); ++k)
    {
      soup.Points.push_back(
        { { static_cast<double>(k % (size + 1)), static_cast<double>(k / (size + 1)), z } });
    }
    for (int k = 0; k < size * size; ++k)
    {
      const Id a = first + k % size + (size + 1) * (k / size);
      const Id b = a + 1;
      const Id c = a + size + 1;
      const Id d = c + 1;
      if (random() % 2 == 0)
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, d } }, { { a, d, c } } });
      }
      else
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, c } }, { { b, d, c } } });
      }
    }
    z = std::nextafter(z, 2);
  }
  soup.Points.push_back({ { 0.5, 0.5, 2 } });
  return soup;
}

TriangleSoup RingedSphere(unsigned seed, int rings)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  const int around = 12;
  for (int r = 0; r < rings; ++r)
  {
    const double height = -0.9 + 1.8 * r / (rings - 1);
    for (int k = 0; k < around; ++k)
    {
      const double angle = 2 * M_PI * k / around;
      const double radius = std::sqrt(1 - height * height);
      soup.Points.push_back({ { radius * std::cos(angle), radius * std::sin(angle), height } });
    }
  }
  for (int r = 0; r + 1 < rings; ++r)
  {
    for (int k = 0; k < around; ++k)
    {
      const Id a = r * around + k;
      const Id b = r * around + (k + 1) % around;
      const Id c = a + around;
      const Id d = b + around;
      if (random() % 2 == 0)
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, d } }, { { a, d, c } } });
      }
      else
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, c } }, { { b, d, c } } });
      }
    }
  }
  return soup;
}

TriangleSoup Needles(unsigned seed, int count)
{
  std::mt19937 random(seed);
  const auto number = [&random]() { return static_cast<double>(random()) / 4294967296.0; };
  TriangleSoup soup;
  for (Id t = 0; t < count; ++t)
  {
    const Point a = { { number(), number(), number() } };
    const Point b = { { number(), number(), number() } };
    soup.Points.insert(soup.Points.end(),
      { a, b, { { b[0] + 1e-6 * number(), b[1] + 1e-6 * number(), b[2] + 1e-6 * number() } } });
    soup.Triangles.push_back({ { 3 * t, 3 * t + 1, 3 * t + 2 } });
  }
  return soup;
}

TriangleSoup GridBoxes(unsigned seed, int count)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  for (int k = 0; k < count; ++k)
  {
    Point low;
    Point high;
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = static_cast<double>(random() % 8);
      high[axis] = low[axis] + 1 + static_cast<double>(random() % 6);
    }
    soup = Join(soup, Box(low, high));
  }
  return soup;
}

std::vector<SurfaceFamily> TetrahedralizationFamilies(unsigned seed)
{
  const int step = static_cast<int>(seed % 16);
  const int triangles = 10 << seed % 5;
  return { { "random", { RandomSoup(seed, triangles) } },
    { "grid", { GridSoup(seed, triangles, 2 + static_cast<int>(seed % 7)) } },
    { "needles", { Needles(seed, 25 + 10 * step) } },
    { "sheets", { NearSheets(seed, 2 + step % 4, 4 + step) } },
    { "rings", { RingedSphere(seed, 4 + 4 * step) } }, { "boxes", { GridBoxes(seed, 2 + step) } },
    { "prism", { TwistedPrism(3 + static_cast<int>(seed % 40), (seed % 7 + 1) * 0.2) } },
    { "chazelle", { Chazelle(2 + step) } }, { "comb", { Comb(10 + 5 * step) } } };
}
} // namespace testmeshes
