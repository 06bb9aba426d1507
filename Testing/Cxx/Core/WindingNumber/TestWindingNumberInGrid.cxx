// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace
{
using namespace insideout;

FacetComplex Counted(const TriangleSoup& soup)
{
  Monitor monitor;
  return CountFacets(soup, {}, monitor).Surface;
}

/** From `low` on, `size` values `step` apart. */
std::vector<double> Axis(double low, double step, int size)
{
  std::vector<double> axis;
  for (int i = 0; i < size; ++i)
  {
    axis.push_back(low + i * step);
  }
  return axis;
}

GridPlaces Grid(
  const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z)
{
  return { { { x, y, z } } };
}

std::vector<double> InGrid(
  const SurfaceWindingNumber& surface, const GridPlaces& grid, std::optional<double> sideOf = {})
{
  Monitor monitor;
  std::vector<double> all(grid.SizeOfSlice() * grid.Axes[2].size());
  surface.InGrid(
    grid, sideOf,
    [&](Id slice, const std::vector<double>& w)
    {
      std::copy(
        w.begin(), w.end(), all.begin() + static_cast<std::ptrdiff_t>(grid.SizeOfSlice()) * slice);
    },
    monitor);
  return all;
}

std::vector<double> AtPlaces(const SurfaceWindingNumber& surface, const GridPlaces& grid)
{
  Monitor monitor;
  std::vector<Point> places;
  for (Id slice = 0; slice < grid.Size(2); ++slice)
  {
    for (std::size_t i = 0; i < grid.SizeOfSlice(); ++i)
    {
      places.push_back(grid.InSlice(slice, i));
    }
  }
  return surface.At(places, monitor);
}

/** The largest difference; infinity where one is a number and the other is none. */
double Difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double most = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
  {
    const double difference = std::abs(a[i] - b[i]);
    most =
      std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(most, difference);
  }
  return most;
}

/** Closed ones with whole coordinates: rows meet their corners and edges, and lie in their facets.
 */
std::vector<TriangleSoup> ClosedSurfaces()
{
  using namespace testmeshes;
  TriangleSoup octahedron = { { { 8, 0, 0 }, { -8, 0, 0 }, { 0, 8, 0 }, { 0, -8, 0 }, { 0, 0, 8 },
                                { 0, 0, -8 } },
    { { { 0, 2, 4 } }, { { 2, 1, 4 } }, { { 1, 3, 4 } }, { { 3, 0, 4 } }, { { 2, 0, 5 } },
      { { 1, 2, 5 } }, { { 3, 1, 5 } }, { { 0, 3, 5 } } } };
  const TriangleSoup boxes =
    Join(Box({ -8, -8, -8 }, { 1, 2, 3 }), Box({ -3, -2, -1 }, { 8, 8, 8 }));
  TriangleSoup soup = GridSoup(3, 60, 16);
  for (Point& p : soup.Points)
  {
    p = { p[0] - 8, p[1] - 8, p[2] - 8 };
  }
  // Doubled, turned over and moved, so that nothing is open.
  TriangleSoup tetrahedra;
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    const Id first = static_cast<Id>(tetrahedra.Points.size());
    for (int k = 0; k < 3; ++k)
    {
      tetrahedra.Points.push_back(soup.Points[soup.Triangles[t][k]]);
    }
    tetrahedra.Points.push_back(soup.Points[soup.Triangles[(t + 1) % soup.Triangles.size()][0]]);
    for (const auto& face : TetrahedronFaces)
    {
      tetrahedra.Triangles.push_back({ { first + face[0], first + face[1], first + face[2] } });
    }
  }
  return { octahedron, boxes, Join(octahedron, Reversed(boxes)), tetrahedra };
}

/** On whole coordinates, on halves, between, and far too large. */
std::vector<GridPlaces> Grids()
{
  return { Grid(Axis(-9, 1, 19), Axis(-9, 1, 19), Axis(-9, 1, 19)),
    Grid(Axis(-8, 0.5, 33), Axis(-9, 1, 19), Axis(0, 1, 1)),
    Grid(Axis(-8.03, 0.37, 40), Axis(-7, 1.0 / 3, 30), { -8, -7.5, 0, 0x1p-60, 3, 7.999 }),
    Grid({ -1e30, -8, 0, 1e300 }, { -1e9, -8, 1 }, { -8, 0, 1e7 }),
    Grid({ -1e12, -8, 0, 1e10 }, { -1e9, -8, 1 }, { -8, 0, 1e7 }) };
}

TEST(WindingNumberInGrid, IsBitByBitThatAtThePlacesWhereTheSurfaceIsClosed)
{
  Monitor monitor;
  for (const TriangleSoup& soup : ClosedSurfaces())
  {
    const SurfaceWindingNumber surface(Counted(soup), {}, monitor);
    ASSERT_TRUE(surface.IsClosed());
    for (const GridPlaces& grid : Grids())
    {
      EXPECT_EQ(InGrid(surface, grid), AtPlaces(surface, grid));
    }
  }
}

TEST(WindingNumberInGrid, IsThatAtThePlacesWhereTheSurfaceIsOpen)
{
  Monitor monitor;
  for (TriangleSoup soup : ClosedSurfaces())
  {
    soup.Triangles.erase(soup.Triangles.begin(), soup.Triangles.begin() + 3);
    const SurfaceWindingNumber surface(Counted(soup), {}, monitor);
    ASSERT_FALSE(surface.IsClosed());
    for (const GridPlaces& grid : Grids())
    {
      EXPECT_LT(Difference(InGrid(surface, grid), AtPlaces(surface, grid)), 1e-13);
    }
  }
}

/** Boxes of many places have polynomials, and several sizes of boxes meet. */
TEST(WindingNumberInGrid, IsRightToRoundingByPolynomialsToo)
{
  Monitor monitor;
  TriangleSoup soup = testmeshes::Box({ -8, -8, -8 }, { 8, 8, 8 });
  soup.Triangles.pop_back();
  for (const int shift : { 0, 3 })
  {
    TriangleSoup small = testmeshes::Box({ 1.0 + shift, 2, 3 }, { 1.25 + shift, 2.25, 3.25 });
    small.Triangles.pop_back();
    soup = testmeshes::Join(soup, small);
  }
  const SurfaceWindingNumber surface(Counted(soup), {}, monitor);
  for (const GridPlaces& grid : { Grid(Axis(-30, 0.61, 100), Axis(-20, 0.7, 50), Axis(-9, 1.3, 70)),
         Grid(Axis(-5, 0.01, 300), Axis(10, 0.2, 17), Axis(-9, 4, 3)),
         Grid(Axis(20, 0.1, 40), Axis(20, 0.2, 40), Axis(20, 0.3, 40)) })
  {
    const std::vector<double> w = InGrid(surface, grid);
    EXPECT_LT(Difference(w, AtPlaces(surface, grid)), 2e-14);
  }
}

TEST(WindingNumberInGrid, TellsTheSideOfAThresholdAlone)
{
  Monitor monitor;
  for (TriangleSoup soup : ClosedSurfaces())
  {
    soup.Triangles.erase(soup.Triangles.begin(), soup.Triangles.begin() + 3);
    const SurfaceWindingNumber surface(Counted(soup), {}, monitor);
    for (const GridPlaces& grid : Grids())
    {
      const std::vector<double> w = AtPlaces(surface, grid);
      for (const double threshold : { 0.5, 0.25, 1.0, -0.875 })
      {
        const std::vector<double> sides = InGrid(surface, grid, threshold);
        for (std::size_t i = 0; i < w.size(); ++i)
        {
          EXPECT_TRUE(
            (sides[i] > threshold) == (w[i] > threshold) || std::abs(w[i] - threshold) < 1e-13)
            << w[i] << " and " << sides[i] << " of " << threshold;
        }
      }
    }
  }
}

TEST(WindingNumberInGrid, IsThatOfEachMethod)
{
  Monitor monitor;
  TriangleSoup soup = testmeshes::Box({ -8, -8, -8 }, { 8, 8, 8 });
  soup.Triangles.pop_back();
  const GridPlaces grid = Grid(Axis(-9, 1.1, 18), Axis(-9, 1.2, 15), Axis(-7, 4, 4));
  for (const WindingNumberMethod method : { WindingNumberMethod::Naive,
         WindingNumberMethod::Hierarchical, WindingNumberMethod::Approximate })
  {
    const SurfaceWindingNumber surface(Counted(soup), { method }, monitor);
    EXPECT_LT(Difference(InGrid(surface, grid), AtPlaces(surface, grid)), 1e-13);
  }
}
} // namespace
