// SPDX-License-Identifier: GPL-3.0-or-later
#include "HullMesh.h"
#include "Support/ReadTriangles.h"
#include "Support/TestMeshes.h"
#include "Support/WindingNumberInQuads.h"
#include "WindingNumber/SurfaceWindingNumber.h"
#include "WindingNumber/WalkedWindingNumber.h"
#include "WindingNumber/WindingNumberOfCells.h"
#include "WindingNumber/WindingNumberSum.h"
#include "WindingNumberInDoubleDoubles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>

using namespace insideout;
using namespace testmeshes;

namespace
{
// The fraction against sums with many digits; the sum in doubles itself errs by about 1e-14 times
// the root of the number of facets.
constexpr double MostErrorToManyDigits = 1e-12;
constexpr double MostErrorToSum = 1e-10;

/** Sums in double-doubles; at every n-th site, at most a hundred, also in quads. */
constexpr std::size_t SitesPerQuad = 20;
constexpr std::size_t MostQuads = 100;

constexpr double SliverThickness = 1e-6;

/** How many sites to look at. */
struct Numbers
{
  int Points = 100000; ///< random ones in the surface's box
  int Sample = 1000;   ///< of those, and of each kind on the surface, with many digits
  int Cells = 1000;    ///< likewise, beside all slivers
  int Slivers = std::numeric_limits<int>::max(); ///< limit of them, the thinnest
};

/** Largest difference between values and a reference; not a number where one is none. */
double LargestError(const std::vector<double>& values, const std::vector<double>& reference)
{
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double error = std::abs(values[i] - reference[i]);
    if (std::isnan(error))
    {
      return error;
    }
    largest = std::max(largest, error);
  }
  return largest;
}

/** The same against sums with many digits at some of the sites. */
double LargestErrorToManyDigits(const FacetComplex& surface, const Sites& sites,
  const std::vector<Id>& which, const std::vector<double>& values)
{
  const std::size_t quads = std::min(which.size() / SitesPerQuad + 1, MostQuads);
  std::vector<Id> all = which;
  // A block is full: the last site stands for those that it lacks.
  all.resize((all.size() + SitesAtOnce - 1) / SitesAtOnce * SitesAtOnce, which.back());
  std::vector<double> ours(all.size() + quads);
  std::vector<double> reference(all.size() + quads);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t first = 0; first < all.size(); first += SitesAtOnce)
  {
    std::array<Site, SitesAtOnce> block;
    for (int k = 0; k < SitesAtOnce; ++k)
    {
      block[k] = sites[all[first + k]];
      ours[first + k] = values[all[first + k]];
    }
    const std::array<double, SitesAtOnce> w = WindingNumbersInDoubleDoubles(surface, block);
    std::copy(w.begin(), w.end(), reference.begin() + first);
  }
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < quads; ++i)
  {
    const Id site = which[i * which.size() / quads];
    ours[all.size() + i] = values[site];
    reference[all.size() + i] = WindingNumberInQuads(surface, sites[site]);
  }
  return LargestError(ours, reference);
}

/** Six times the volume over the cube of the longest edge at corner 0, roughly. */
double Thickness(const TetrahedralMesh& mesh, const Tetrahedron& cell)
{
  long double e[3][3];
  long double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      e[k][axis] =
        static_cast<long double>(mesh.Points[cell[k + 1]][axis]) - mesh.Points[cell[0]][axis];
    }
    longest = std::max(longest, std::hypot(e[k][0], e[k][1], e[k][2]));
  }
  const long double volume = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
    e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  return static_cast<double>(std::abs(volume) / (longest * longest * longest));
}

/** The slivers, or as many of the thinnest as are wanted, and other cells at random. */
std::vector<Id> SliversAndOthers(
  const TetrahedralMesh& mesh, const Numbers& numbers, std::size_t& slivers)
{
  std::vector<std::pair<double, Id>> thin;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    const double thickness = Thickness(mesh, mesh.Cells[cell]);
    if (thickness < SliverThickness)
    {
      thin.push_back({ thickness, cell });
    }
  }
  std::sort(thin.begin(), thin.end());
  slivers = thin.size();
  thin.resize(std::min(thin.size(), static_cast<std::size_t>(numbers.Slivers)));
  std::vector<Id> which;
  for (const auto& cell : thin)
  {
    which.push_back(cell.second);
  }
  std::mt19937 random(1);
  for (int i = 0; i < numbers.Cells; ++i)
  {
    which.push_back(static_cast<Id>(random() % mesh.Cells.size()));
  }
  return which;
}

/** Points in the surface's box; then on vertices, edges and facets, and the lines through edges. */
std::vector<Point> PointsAround(const FacetComplex& surface, int inBox, int ofEach)
{
  Point low = surface.Points[surface.Facets[0][0]];
  Point high = low;
  for (const Triangle& t : surface.Facets)
  {
    for (const Id p : t)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], surface.Points[p][axis]);
        high[axis] = std::max(high[axis], surface.Points[p][axis]);
      }
    }
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Point> points(inBox);
  for (Point& p : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = low[axis] + part(random) * (high[axis] - low[axis]);
    }
  }
  for (int i = 0; i < ofEach; ++i)
  {
    const Triangle& t = surface.Facets[random() % surface.Facets.size()];
    const double u = part(random);
    for (const std::array<double, 3>& weights : { std::array<double, 3>{ 1, 0, 0 }, { u, 1 - u, 0 },
           { u / 2, u / 2, 1 - u }, { 1 + u, -u, 0 }, { 0, -u, 1 + u } })
    {
      Point p = { 0, 0, 0 };
      for (int k = 0; k < 3; ++k)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          p[axis] += weights[k] * surface.Points[t[k]][axis];
        }
      }
      points.push_back(p);
    }
  }
  return points;
}

bool Verdict(double toDigits, double toSum)
{
  return toDigits <= MostErrorToManyDigits && toSum <= MostErrorToSum;
}

/**
 * The surface that the cells' w refers to: the mesh's faces in facets, and the facets that are no
 * faces. A Steiner point on a facet is rounded, and a sliver beside it may lie between the facet
 * and its faces.
 */
FacetComplex FacesAndFacetsBeyond(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  FacetComplex result;
  result.Points = mesh.Points;
  const auto add = [&](const Triangle& facet, int count)
  {
    result.Facets.push_back(facet);
    result.Multiplicity.push_back(static_cast<std::int16_t>(count));
  };
  for (const CountedTriangle& face : FaceCounts(surface, mesh).Chain().Triangles)
  {
    add(face.Corners, face.Count);
  }
  for (const Id f : mesh.LostFacets)
  {
    add(surface.Facets[f], surface.Multiplicity[f]);
  }
  for (Id f = surface.NumberOfConstraints; f < surface.NumberOfFacets(); ++f)
  {
    add(surface.Facets[f], surface.Multiplicity[f]);
  }
  result.NumberOfConstraints = result.NumberOfFacets();
  return result;
}

bool JudgeCells(const std::string& name, const TriangleSoup& soup, const Numbers& numbers)
{
  Monitor monitor;
  const HullMesh hull = MeshHull(soup, {}, monitor);
  const Sites sites = { hull.Mesh.Points, hull.Mesh.Cells };
  const FacetComplex faces = FacesAndFacetsBeyond(hull.Surface, hull.Mesh);
  const double toSum = LargestError(hull.W, WindingNumberSum(faces, sites, monitor));
  std::size_t slivers = 0;
  const std::vector<Id> which = SliversAndOthers(hull.Mesh, numbers, slivers);
  const double toDigits = LargestErrorToManyDigits(faces, sites, which, hull.W);
  std::printf("%-28s cells  %s %9d of which %6zu slivers: error to sum %.1e; to digits on %5zu "
              "%.1e  %s\n",
    name.c_str(), IsClosed(hull.Surface) ? "closed" : "open  ", hull.Mesh.NumberOfCells(), slivers,
    toSum, which.size(), toDigits, Verdict(toDigits, toSum) ? "ok" : "VIOLATED");
  return Verdict(toDigits, toSum);
}

bool JudgePoints(const std::string& name, const TriangleSoup& soup, const Numbers& numbers)
{
  Monitor monitor;
  const FacetComplex surface = CountFacets(soup, {}, monitor).Surface;
  const std::vector<Point> points = PointsAround(surface, numbers.Points, numbers.Sample);
  std::vector<Tetrahedron> cells;
  std::vector<Id> which;
  for (Id p = 0; p < static_cast<Id>(points.size()); ++p)
  {
    cells.push_back({ { p, p, p, p } });
    if (p < numbers.Sample || p >= numbers.Points)
    {
      which.push_back(p);
    }
  }
  const Sites sites = { points, cells };
  const std::vector<double> w = SurfaceWindingNumber(surface, {}, monitor).At(points, monitor);
  const double toSum = LargestError(w, WindingNumberSum(surface, sites, monitor));
  const double toDigits = LargestErrorToManyDigits(surface, sites, which, w);
  std::printf("%-28s points        %9zu: error to sum %.1e; to digits on %5zu %.1e  %s\n",
    name.c_str(), points.size(), toSum, which.size(), toDigits,
    Verdict(toDigits, toSum) ? "ok" : "VIOLATED");
  return Verdict(toDigits, toSum);
}

template <typename MakeSoup>
bool Judge(const std::string& name, const MakeSoup& makeSoup, const Numbers& numbers)
{
  bool good = false;
  try
  {
    const TriangleSoup soup = makeSoup();
    const bool pointsAreGood = JudgePoints(name, soup, numbers);
    good = JudgeCells(name, soup, numbers) && pointsAreGood;
  }
  catch (const Error& error)
  {
    std::printf("%-28s %s\n", name.c_str(), error.what());
  }
  std::fflush(stdout);
  return good;
}

bool JudgeFile(const std::string& path, const Numbers& numbers)
{
  return Judge(
    path.substr(path.find_last_of('/') + 1), [&] { return ReadTriangles(path); }, numbers);
}

/** In turn of triangles on a small grid, where everything degenerate happens, and anywhere. */
bool JudgeSoups(int soups, const Numbers& numbers)
{
  bool good = true;
  for (int i = 0; i < soups; ++i)
  {
    const unsigned seed = static_cast<unsigned>(i / 2 + 1);
    const std::string seedName = std::to_string(seed);
    good =
      (i % 2 == 0
          ? Judge(
              "grid soup " + seedName, [&] { return GridSoup(seed, 100, 2 + seed % 7); }, numbers)
          : Judge(
              "random soup " + seedName, [&] { return RandomSoup(seed, 40); }, numbers)) &&
      good;
  }
  return good;
}
} // namespace

/**
 * JudgeWindingNumber [--points P] [--sample N] [--cells N] [--slivers N] [--soups N] SURFACE...:
 * compares w with brute force: in the cells of each surface's hull mesh, at P points of its box
 * (100,000) and at some on the surface. The reference is the sum over all facets, in doubles
 * everywhere. It has 30 digits and more in all slivers (or N, the thinnest) and in N other cells
 * (1000). The same holds at N of the points and N on the surface of each kind (1000). N random
 * soups are treated likewise. The exit status is 1 if w is not right to 1e-12, or a surface cannot
 * be meshed.
 */
int main(int argc, char** argv)
{
  Numbers numbers;
  const std::map<std::string, int*> options = { { "--points", &numbers.Points },
    { "--sample", &numbers.Sample }, { "--cells", &numbers.Cells },
    { "--slivers", &numbers.Slivers } };
  bool allGood = true;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const auto option = options.find(argument);
    if (option != options.end() && i + 1 < argc)
    {
      *option->second = std::max(1, std::atoi(argv[++i]));
    }
    else if (argument == "--soups" && i + 1 < argc)
    {
      allGood = JudgeSoups(std::atoi(argv[++i]), numbers) && allGood;
    }
    else
    {
      allGood = JudgeFile(argument, numbers) && allGood;
    }
  }
  return allGood ? 0 : 1;
}
