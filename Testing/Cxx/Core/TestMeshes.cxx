// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestMeshes.h"

#include <algorithm>
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
} // namespace testmeshes
