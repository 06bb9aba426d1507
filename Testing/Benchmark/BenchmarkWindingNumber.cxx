// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChangedSurfaces.h"
#include "HullMesh.h"
#include "Measure.h"
#include "Support/ReadTriangles.h"
#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/SurfaceWindingNumber.h"
#include "WindingNumber/WindingNumberOfCells.h"
#include "WindingNumber/WindingNumberSum.h"
#include "WindingNumberByEmbree.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <omp.h>
#include <random>

using namespace insideout;
using namespace benchmark;

namespace
{
/** How many times as fast as others the exact method has to be. */
struct Targets
{
  Limit CellsToHierarchical;
  Limit CellsToEmbree;
  Limit PointsToHierarchical;
  Limit PointsToApproximate;
  Limit PointsToEmbree;
};
constexpr Targets Closed = { AtLeast(100), AtLeast(3), AtLeast(10), AtLeast(1), AtLeast(1) };
constexpr Targets Open = { AtLeast(10), AtLeast(10), AtLeast(5), AtLeast(1), AtLeast(1) };
constexpr Limit GrowthTarget = { Limit::Side::AtMost, 1 };
constexpr Limit SoupTarget = AtMost(1);
constexpr Limit OpenTarget = AtMost(1);

constexpr int Threads = 2;
constexpr int PointsInBox = 200000;
const char* const SurfaceToOpen = "Beast";
constexpr int Holes = 20;
constexpr std::size_t EdgesPerHole = 60;

// Random triangles, the smaller the more, so that each of them crosses about as many others.
constexpr int SoupSizes[] = { 250, 500, 1000, 2000 };
constexpr int SoupOfUnitSize = 250;

// Open edges of the surfaces that w of cells is compared with the expansion on.
constexpr std::size_t LeastOpenEdges = 100;
constexpr std::size_t MostOpenEdges = 5000;

// As for the thesis's figures 8.10 and 8.11.
constexpr int PointsOfFigures = 1000;
const char* const SubdividedSurface = "dino";
constexpr int SubdivisionLevels = 5;

FacetComplex Validated(const TriangleSoup& soup)
{
  Monitor monitor;
  return CountFacets(soup, {}, monitor).Surface;
}

std::vector<Point> RandomPoints(const std::vector<Point>& around, int number)
{
  Point low = around.front();
  Point high = low;
  for (const Point& p : around)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Point> points(static_cast<std::size_t>(number));
  for (Point& p : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = low[axis] + part(random) * (high[axis] - low[axis]);
    }
  }
  return points;
}

std::vector<Point> Barycentres(const TetrahedralMesh& mesh)
{
  std::vector<Point> centres;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    Point centre = { 0, 0, 0 };
    for (const Id p : cell)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] += mesh.Points[p][axis] / 4;
      }
    }
    centres.push_back(centre);
  }
  return centres;
}

/** Values at points by one of the methods, what it builds included. */
std::vector<double> AtPoints(
  const FacetComplex& surface, const std::vector<Point>& points, WindingNumberMethod method)
{
  Monitor monitor;
  WindingNumberParameters parameters;
  parameters.Method = method;
  return SurfaceWindingNumber(surface, parameters, monitor).At(points, monitor);
}

using Work = std::function<std::vector<double>()>;

/** How many values are off by more than rounding. */
std::size_t NumberWrong(const std::vector<double>& values, const std::vector<double>& right)
{
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    wrong += std::abs(values[i] - right[i]) > 1e-9;
  }
  return wrong;
}

/** Times ours against another way, and says how often that one errs. */
void Compare(const std::string& name, std::size_t facets, const Work& ours, const char* otherName,
  const Work& other, const Limit& limit)
{
  const std::vector<double> right = ours();
  const std::size_t wrong = NumberWrong(other(), right);
  const auto seconds = MedianSeconds([&] { ours(); }, [&] { other(); });
  PrintSeconds(name, facets, "exact", otherName, seconds);
  if (wrong > 0)
  {
    std::printf(
      "%-28s %9zu of %zu values by %s err\n", name.c_str(), wrong, right.size(), otherName);
  }
  PrintRatio(name + "/" + otherName, seconds[1] / seconds[0], limit);
}

/** The stage on the hull's cells, against others at the same barycenters. */
void MeasureCells(const std::string& name, const TriangleSoup& soup)
{
  Monitor monitor;
  const HullMesh hull = MeshHull(soup, {}, monitor);
  const std::vector<Point> centres = Barycentres(hull.Mesh);
  const Targets& targets = IsClosed(hull.Surface) ? Closed : Open;
  const std::size_t facets = hull.Surface.Facets.size();
  const Work stage = [&] { return WindingNumberOfCells(hull.Surface, hull.Mesh, monitor); };
  std::printf("w/cells/%-20s %9zu cells\n", name.c_str(), centres.size());
  Compare(
    "w/cells/" + name, facets, stage, "embree",
    [&] { return WindingNumberByEmbree(hull.Surface).At(centres); }, targets.CellsToEmbree);
  Compare(
    "w/cells/" + name, facets, stage, "hierarchical",
    [&] { return AtPoints(hull.Surface, centres, WindingNumberMethod::Hierarchical); },
    targets.CellsToHierarchical);
}

void MeasurePoints(const std::string& name, const FacetComplex& surface)
{
  const std::vector<Point> points = RandomPoints(surface.Points, PointsInBox);
  const Targets& targets = IsClosed(surface) ? Closed : Open;
  const std::size_t facets = surface.Facets.size();
  const auto by = [&](WindingNumberMethod method)
  { return [&, method] { return AtPoints(surface, points, method); }; };
  const Work exact = by(WindingNumberMethod::Exact);
  Compare(
    "w/points/" + name, facets, exact, "embree",
    [&] { return WindingNumberByEmbree(surface).At(points); }, targets.PointsToEmbree);
  Compare("w/points/" + name, facets, exact, "approximate", by(WindingNumberMethod::Approximate),
    targets.PointsToApproximate);
  Compare("w/points/" + name, facets, exact, "hierarchical", by(WindingNumberMethod::Hierarchical),
    targets.PointsToHierarchical);
}

void Measure(const std::string& name, const TriangleSoup& soup)
{
  MeasurePoints(name, Validated(soup));
  MeasureCells(name, soup);
  if (name == SurfaceToOpen)
  {
    Measure(name + "-with-holes", WithHoles(soup, Holes, EdgesPerHole));
  }
}

/** Random triangles, each with its corners in a cube somewhere. */
TriangleSoup TrianglesInCubes(int number)
{
  const double size = std::cbrt(static_cast<double>(SoupOfUnitSize) / number);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  TriangleSoup soup;
  for (Id t = 0; t < number; ++t)
  {
    const Point corner = { part(random), part(random), part(random) };
    for (int k = 0; k < 3; ++k)
    {
      Point p = corner;
      for (double& x : p)
      {
        x += size * part(random);
      }
      soup.Points.push_back(p);
    }
    soup.Triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  return soup;
}

/** The stage on the cells of a soup's hull, against the plain sum over the soup's own triangles. */
void MeasureSoup(int number)
{
  Monitor monitor;
  const TriangleSoup soup = TrianglesInCubes(number);
  const HullMesh hull = MeshHull(soup, {}, monitor);
  const FacetComplex given = Validated(soup);
  const Sites sites = { hull.Mesh.Points, hull.Mesh.Cells };
  const std::string name = "soup/" + std::to_string(number);
  std::printf("%-28s %9zu cells\n", name.c_str(), hull.Mesh.Cells.size());
  const auto seconds =
    MedianSeconds([&] { WindingNumberOfCells(hull.Surface, hull.Mesh, monitor); },
      [&] { WindingNumberSum(given, sites, monitor); });
  PrintSeconds(name, hull.Surface.Facets.size(), "exact", "sum", seconds);
  PrintRatio(name, seconds[0] / seconds[1], SoupTarget);
}

/** The stage on the cells of an open surface's hull, against the expansion at its usual setting. */
void MeasureOpen(const std::string& stem, const TriangleSoup& soup)
{
  const FacetComplex given = Validated(soup);
  const std::size_t open =
    CountedBoundary(CountedFacets(given), static_cast<Id>(given.Points.size())).size();
  if (open < LeastOpenEdges || open > MostOpenEdges)
  {
    return;
  }
  Monitor monitor;
  const HullMesh hull = MeshHull(soup, {}, monitor);
  const std::vector<Point> centres = Barycentres(hull.Mesh);
  const std::string name = "open/" + stem;
  std::printf("%-28s %9zu cells\n", name.c_str(), centres.size());
  const auto seconds =
    MedianSeconds([&] { WindingNumberOfCells(hull.Surface, hull.Mesh, monitor); },
      [&] { AtPoints(hull.Surface, centres, WindingNumberMethod::Approximate); });
  PrintSeconds(name, hull.Surface.Facets.size(), "exact", "approximate", seconds);
  PrintRatio(name, seconds[0] / seconds[1], OpenTarget);
}

/**
 * Seconds per evaluation by one method, without what it builds: the least of some runs, for these
 * are so short that other programs disturb many of them.
 */
double SecondsPerPoint(
  const FacetComplex& surface, const std::vector<Point>& points, WindingNumberMethod method)
{
  Monitor monitor;
  WindingNumberParameters parameters;
  parameters.Method = method;
  const SurfaceWindingNumber w(surface, parameters, monitor);
  const int runs = method == WindingNumberMethod::Naive ? 2 : 20;
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run)
  {
    least = std::min(least, SecondsOf([&] { w.At(points, monitor); }));
  }
  return least / static_cast<double>(points.size());
}

/** The methods of the figures: the thesis's two, then those of today. The last is ours. */
const std::array<std::pair<const char*, WindingNumberMethod>, 4> MethodsOfFigures = {
  { { "naive", WindingNumberMethod::Naive }, { "hierarchical", WindingNumberMethod::Hierarchical },
    { "approximate", WindingNumberMethod::Approximate }, { "exact", WindingNumberMethod::Exact } }
};

/**
 * A line of a figure's table: facets, whether the surface is closed, seconds by each method.
 * @return those of the last
 */
double WriteRow(std::FILE* table, const std::string& name, const FacetComplex& surface)
{
  const std::vector<Point> points = RandomPoints(surface.Points, PointsOfFigures);
  std::fprintf(table, "%s,%zu,%d", name.c_str(), surface.Facets.size(), IsClosed(surface) ? 1 : 0);
  double seconds = 0;
  for (const auto& [word, method] : MethodsOfFigures)
  {
    seconds = SecondsPerPoint(surface, points, method);
    std::fprintf(table, ",%g", seconds);
  }
  std::fprintf(table, "\n");
  std::fflush(table);
  return seconds;
}

std::FILE* OpenTable(const std::string& path)
{
  std::FILE* table = std::fopen(path.c_str(), "w");
  if (!table)
  {
    throw Error(ErrorCode::FileUnwritable, path + " cannot be written");
  }
  std::fprintf(table, "name,facets,closed");
  for (const auto& method : MethodsOfFigures)
  {
    std::fprintf(table, ",%s", method.first);
  }
  std::fprintf(table, "\n");
  return table;
}

/** Figure 8.10: time per evaluation of one surface, subdivided again and again. */
void DrawGrowth(const std::string& folder, TriangleSoup soup)
{
  std::FILE* table = OpenTable(folder + "/figure-8.10.csv");
  std::vector<double> perLogarithm;
  for (int level = 0; level < SubdivisionLevels; ++level)
  {
    const FacetComplex surface = Validated(soup);
    const double seconds =
      WriteRow(table, SubdividedSurface + ("-" + std::to_string(level)), surface);
    perLogarithm.push_back(seconds / std::log(static_cast<double>(surface.Facets.size())));
    soup = Subdivided(soup);
  }
  std::fclose(table);
  PrintRatio("w/growth", perLogarithm.back() / perLogarithm.front(), GrowthTarget);
}

/** Figure 8.11: time per evaluation over a set of surfaces. */
void DrawFigures(const std::string& folder, const std::vector<std::string>& paths)
{
  std::FILE* table = OpenTable(folder + "/figure-8.11.csv");
  for (const std::string& path : paths)
  {
    const TriangleSoup soup = testmeshes::ReadTriangles(path);
    WriteRow(table, StemOf(path), Validated(soup));
    if (StemOf(path) == SubdividedSurface)
    {
      DrawGrowth(folder, soup);
    }
  }
  std::fclose(table);
}
} // namespace

/**
 * BenchmarkWindingNumber SURFACE...: times w on cells and at points against its peers.
 * BenchmarkWindingNumber --soups: times w on the cells of soups.
 * BenchmarkWindingNumber --open SURFACE...: times w on the cells of those with some open edges.
 * BenchmarkWindingNumber --figures FOLDER SURFACE...: writes the tables of the thesis's
 * figures 8.10 and 8.11, which plot-figures.py draws. Lines as in Measure.h; on two threads.
 */
int main(int argc, char** argv)
{
  omp_set_num_threads(Threads);
  try
  {
    if (argc > 3 && std::strcmp(argv[1], "--figures") == 0)
    {
      DrawFigures(argv[2], std::vector<std::string>(argv + 3, argv + argc));
      return 0;
    }
    if (argc > 1 && std::strcmp(argv[1], "--soups") == 0)
    {
      for (const int number : SoupSizes)
      {
        MeasureSoup(number);
      }
      return 0;
    }
    if (argc > 1 && std::strcmp(argv[1], "--open") == 0)
    {
      for (int i = 2; i < argc; ++i)
      {
        MeasureOpen(StemOf(argv[i]), testmeshes::ReadTriangles(argv[i]));
      }
      return 0;
    }
    for (int i = 1; i < argc; ++i)
    {
      Measure(StemOf(argv[i]), testmeshes::ReadTriangles(argv[i]));
    }
  }
  catch (const Error& error)
  {
    std::printf("%s\n", error.what());
    return 1;
  }
  return 0;
}
