// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BenchmarkDistance SURFACE...: distances at the points of a grid around each surface, which
 * share searches with their neighbors. They are compared with the same points one by one, each
 * starting from the facet of the one before. Both have the same distances.
 */
#include "Distance/SurfaceDistance.h"
#include "Measure.h"
#include "Support/ReadTriangles.h"
#include "WindingNumber/SpatialOrder.h"

#include <cmath>
#include <cstdlib>

using namespace insideout;
using namespace benchmark;

namespace
{
constexpr int LongestRow = 100; // points
constexpr double Padding = 0.1; // of the longest side
constexpr Id OneByOne = 1000;   // as many points in a call do not share searches
constexpr Limit Target = AtMost(0.6);

/** Along a curve through space, so that neighbors follow each other. */
std::vector<Point> GridAround(const Box& box)
{
  const double length = box.Extent(box.LongestAxis());
  const double step = length * (1 + 2 * Padding) / (LongestRow - 1);
  std::array<int, 3> size;
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<int>(std::ceil((box.Extent(axis) + 2 * Padding * length) / step)) + 1;
  }
  std::vector<Point> grid;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        grid.push_back({ box.Low[0] - Padding * length + i * step,
          box.Low[1] - Padding * length + j * step, box.Low[2] - Padding * length + k * step });
      }
    }
  }
  std::vector<Point> ordered;
  for (const Id i : SpatialOrder(grid))
  {
    ordered.push_back(grid[i]);
  }
  return ordered;
}

void Measure(const std::string& path)
{
  const TriangleSoup soup = testmeshes::ReadTriangles(path);
  const std::vector<Triangle> facets(soup.Triangles.begin(), soup.Triangles.end());
  const SurfaceDistance distance(soup.Points, facets);
  const std::vector<Point> places = GridAround(BoundingBox(soup.Points));
  std::vector<double> together;
  std::vector<double> apart;
  Monitor monitor;
  const auto ask = [&](Id placesPerCall, std::vector<double>& found)
  {
    found.clear();
    for (std::size_t first = 0; first < places.size(); first += placesPerCall)
    {
      const std::size_t last = std::min(places.size(), first + placesPerCall);
      const std::vector<Point> some(places.begin() + first, places.begin() + last);
      for (const auto& nearest : distance.At(some, monitor, { "", 0, 1 }))
      {
        found.push_back(nearest.Distance);
      }
    }
  };
  const auto seconds =
    MedianSeconds([&] { ask(1 << 16, together); }, [&] { ask(OneByOne, apart); });
  const std::string name = "distance-grid/" + StemOf(path);
  PrintSeconds(name, facets.size(), "together", "one by one", seconds);
  std::printf(
    "%zu points; the same distances: %s\n", places.size(), together == apart ? "yes" : "no");
  PrintRatio(name, seconds[0] / seconds[1], Target);
}
} // namespace

int main(int count, char** arguments)
{
  for (int k = 1; k < count; ++k)
  {
    Measure(arguments[k]);
  }
  return EXIT_SUCCESS;
}
