// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace testmeshes
{
namespace
{
bool Collinear(const Point& a, const Point& b, const Point& c)
{
  const Point u = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const Point v = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  return u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0];
}
} // namespace

TriangleSoup GridSoup(unsigned seed, int triangles, int size)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  std::map<Point, Id> ids;
  std::set<Triangle> taken;
  // A small grid may not hold as many triangles as asked for.
  for (int tries = 0; tries < 100 * triangles && int(soup.Triangles.size()) < triangles; ++tries)
  {
    std::array<Point, 3> corners;
    for (Point& corner : corners)
    {
      for (double& x : corner)
      {
        x = static_cast<double>(random() % size);
      }
    }
    if (Collinear(corners[0], corners[1], corners[2]))
    {
      continue;
    }
    Triangle triangle;
    for (int k = 0; k < 3; ++k)
    {
      const auto inserted = ids.insert({ corners[k], static_cast<Id>(soup.Points.size()) });
      if (inserted.second)
      {
        soup.Points.push_back(corners[k]);
      }
      triangle[k] = inserted.first->second;
    }
    Triangle key = triangle;
    std::sort(key.begin(), key.end());
    if (taken.insert(key).second)
    {
      soup.Triangles.push_back(triangle);
    }
  }
  return soup;
}

TriangleSoup RandomSoup(unsigned seed, int triangles)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  for (Id t = 0; t < triangles; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      Point p;
      for (double& x : p)
      {
        x = random() / 4294967296.0;
      }
      soup.Points.push_back(p);
    }
    soup.Triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  return soup;
}

FacetComplex ToComplex(const TriangleSoup& soup)
{
  FacetComplex complex;
  complex.Points = soup.Points;
  for (Id p = 0; p < static_cast<Id>(soup.Points.size()); ++p)
  {
    complex.Origins.push_back(PointOrigin::Input(p));
  }
  complex.Facets = soup.Triangles;
  complex.Multiplicity.assign(soup.Triangles.size(), 1);
  for (Id t = 0; t < static_cast<Id>(soup.Triangles.size()); ++t)
  {
    complex.Sources.push_back({ t, false });
    complex.SourceOffsets.push_back(t + 1);
  }
  complex.NumberOfConstraints = complex.NumberOfFacets();
  return complex;
}

TriangleSoup Merged(const TriangleSoup& soup)
{
  TriangleSoup merged;
  std::map<Point, Id> ids;
  std::vector<Id> idOf;
  for (const Point& p : soup.Points)
  {
    const auto inserted = ids.insert({ p, static_cast<Id>(merged.Points.size()) });
    if (inserted.second)
    {
      merged.Points.push_back(p);
    }
    idOf.push_back(inserted.first->second);
  }
  for (const Triangle& t : soup.Triangles)
  {
    merged.Triangles.push_back({ idOf[t[0]], idOf[t[1]], idOf[t[2]] });
  }
  return merged;
}

TriangleSoup Fan(int blades)
{
  TriangleSoup fan;
  for (int i = 0; i < blades; ++i)
  {
    const double angle = 3.14159 * i / blades;
    const double x = (1 + 0.1 * i) * std::cos(angle);
    const double y = (1 + 0.1 * i) * std::sin(angle);
    const Id first = 3 * i;
    // The triangle's plane contains the axis exactly: its first two corners are opposite.
    fan.Points.insert(
      fan.Points.end(), { { -x, -y, -0.5 }, { x, y, 0.25 * (i % 3) }, { 0, 0, 2.0 + i % 5 } });
    fan.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return fan;
}

TriangleSoup ThroughOnePoint(unsigned seed, int count)
{
  TriangleSoup soup = RandomSoup(seed, count);
  for (const Triangle& t : soup.Triangles)
  {
    Point& a = soup.Points[t[0]];
    Point& b = soup.Points[t[1]];
    Point& c = soup.Points[t[2]];
    for (int k = 0; k < 3; ++k)
    {
      c[k] = -(a[k] + b[k]);
    }
  }
  return soup;
}

TriangleSoup SlantedFans(int fans, int needles)
{
  TriangleSoup soup;
  for (int fan = 0; fan < fans; ++fan)
  {
    const double lift = 0.0004 * fan; // along (1, 1, -2), the normal of all
    const Id apex = static_cast<Id>(soup.Points.size());
    soup.Points.push_back({ lift, lift, -2 * lift });
    for (Id i = 0; i <= needles; ++i)
    {
      const double aside = 0.7 * i / needles; // along (1, -1, 0)
      soup.Points.push_back({ 100 + lift + aside, 100 + lift - aside, 100 - 2 * lift });
      if (i > 0)
      {
        soup.Triangles.push_back({ apex, apex + i + 1, apex + i });
      }
    }
  }
  return soup;
}

TriangleSoup Comb(int teeth)
{
  TriangleSoup comb;
  comb.Points = { { 0, 0, 0 }, { 1.0 * teeth, 0, 0 }, { 0, 1.0 * teeth, 0 } };
  comb.Triangles = { { 0, 1, 2 } };
  for (Id i = 0; i < teeth; ++i)
  {
    const double x = 0.05 + i / 3.0;
    const Id first = 3 + 3 * i;
    comb.Points.insert(comb.Points.end(), { { x, 0.1, 0 }, { x, 0.2, 1 }, { x + 0.1, 0.1, 1 } });
    comb.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return comb;
}
} // namespace testmeshes
