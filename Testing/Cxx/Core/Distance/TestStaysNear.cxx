// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distance/StaysNear.h"

#include "Common/Vectors.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

Point Mean(const std::array<Point, 4>& corners, const std::array<double, 4>& weights)
{
  double sum = 0;
  Point mean = { 0, 0, 0 };
  for (int i = 0; i < 4; ++i)
  {
    sum += weights[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      mean[axis] += weights[i] * corners[i][axis];
    }
  }
  return { mean[0] / sum, mean[1] / sum, mean[2] / sum };
}

/** The largest distance from many places in a tetrahedron. */
double FarthestOf(
  const std::array<Point, 4>& corners, const SurfaceDistance& distances, std::mt19937& random)
{
  std::exponential_distribution<double> weight;
  double farthest = 0;
  for (int i = 0; i < 500; ++i)
  {
    std::array<double, 4> weights = { weight(random), weight(random), weight(random),
      weight(random) };
    weights[i % 4] *= i % 3; // on faces, too
    farthest = std::max(farthest, distances.At(Mean(corners, weights)).Distance);
  }
  return farthest;
}

/** Whatever the surface is, also where facets cross. */
TEST(StaysNear, IsTrueWhereEachPlaceIsNear)
{
  int near = 0;
  int far = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0.2, 0.8), size(0.02, 0.3);
    const FacetComplex surface = ToComplex(RandomSoup(seed, 40));
    const SurfaceDistance distances(surface.Points, surface.Facets);
    std::array<Point, 4> corners;
    const Point middle = { place(random), place(random), place(random) };
    const double radius = size(random);
    for (Point& corner : corners)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corner[axis] = middle[axis] + radius * (place(random) - 0.5);
      }
    }
    const double farthest = FarthestOf(corners, distances, random);
    const auto staysNear = [&](double most)
    { return StaysNear(corners, surface.Points, surface.Facets, distances, most); };
    EXPECT_FALSE(staysNear(0.999 * farthest)) << seed;
    near += staysNear(1.2 * farthest);
    far += !staysNear(1.2 * farthest);
  }
  EXPECT_GT(near, 50) << far;
}

/** A tetrahedron over many facets of a plane, with a pit that only its middle is above. */
TEST(StaysNear, SeesAPitBetweenTheCorners)
{
  const auto plane = [](double depth)
  {
    TriangleSoup soup;
    const int size = 9;
    for (int i = 0; i < size * size; ++i)
    {
      soup.Points.push_back({ i % size + 0.0, i / size + 0.0, i == 40 ? -depth : 0.0 });
    }
    for (int i = 0; i + size < size * size; ++i)
    {
      if (i % size + 1 < size)
      {
        soup.Triangles.push_back({ i, i + 1, i + size });
        soup.Triangles.push_back({ i + 1, i + 1 + size, i + size });
      }
    }
    return ToComplex(soup);
  };
  const std::array<Point, 4> flat = { { { 1.1, 1.2, 0.3 }, { 7.1, 1.3, 0.3 }, { 4.2, 7.3, 0.3 },
    { 4.3, 3.4, 0.31 } } };
  const auto staysNear = [&](const FacetComplex& surface, double most)
  {
    return StaysNear(
      flat, surface.Points, surface.Facets, SurfaceDistance(surface.Points, surface.Facets), most);
  };
  EXPECT_TRUE(staysNear(plane(0), 0.3101));
  EXPECT_FALSE(staysNear(plane(0), 0.3099));
  EXPECT_TRUE(staysNear(plane(0.1), 0.41));
  EXPECT_FALSE(staysNear(plane(0.3), 0.32));
  EXPECT_FALSE(staysNear(plane(5), 0.32));
}

TEST(StaysNear, TakesTetrahedraAndFacetsWithoutSize)
{
  const FacetComplex surface =
    ToComplex({ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } } });
  const SurfaceDistance distances(surface.Points, surface.Facets);
  const Point p = { 0.5, 1, 0 };
  const Point q = { 1.5, 1, 0 };
  const std::array<Point, 4> point = { { p, p, p, p } };
  const std::array<Point, 4> line = { { p, p, q, q } };
  for (const auto& cell : { point, line })
  {
    EXPECT_TRUE(StaysNear(cell, surface.Points, surface.Facets, distances, 1.001));
    EXPECT_FALSE(StaysNear(cell, surface.Points, surface.Facets, distances, 0.999));
  }
}
} // namespace
