// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConstrainedDelaunay.h"

#include "AssembleMesh.h"
#include "TetgenProcess.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace insideout
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/**
 * TetGen squares and cubes lengths, and its predicates (Shewchuk 1997) are exact only while
 * products of five coordinates neither over- nor underflow: sizes beyond 2 to this power (up or
 * down) are brought to 1 for it.
 */
constexpr int LargestExponent = 32;

void CheckIdsAndCoordinates(const FacetComplex& surface)
{
  if (surface.Facets.empty())
  {
    throw Error(ErrorCode::EmptySurface, "the surface has no facet");
  }
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    for (const double x : surface.Points[p])
    {
      if (!std::isfinite(x))
      {
        throw Error(ErrorCode::PointNotFinite, "point " + std::to_string(p) + " is not finite");
      }
    }
  }
  for (std::size_t f = 0; f < surface.Facets.size(); ++f)
  {
    for (const Id p : surface.Facets[f])
    {
      if (p < 0 || static_cast<std::size_t>(p) >= surface.Points.size())
      {
        throw Error(ErrorCode::PointOutOfRange,
          "facet " + std::to_string(f) + " refers to point " + std::to_string(p) + " of " +
            std::to_string(surface.Points.size()));
      }
    }
  }
}

/** Points in general position so far, one more for each dimension they span. */
void CheckSpansSpace(const std::vector<Point>& points)
{
  std::vector<Kernel::Point_3> base;
  for (const Point& point : points)
  {
    const Kernel::Point_3 p(point[0], point[1], point[2]);
    const bool independent = base.empty() || (base.size() == 1 && p != base[0]) ||
      (base.size() == 2 && !CGAL::collinear(base[0], base[1], p)) ||
      (base.size() == 3 && !CGAL::coplanar(base[0], base[1], base[2], p));
    if (independent)
    {
      base.push_back(p);
      if (base.size() == 4)
      {
        return;
      }
    }
  }
  const std::array<const char*, 3> where = { { "at one point", "on one line", "in one plane" } };
  throw Error(ErrorCode::Planar,
    std::string("all facets lie ") + where[base.size() - 1] + ", so there is no volume to fill");
}

/** The power of two that all coordinates are below; 0 for sizes that TetGen copes with. */
int ExponentToRemove(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& point : points)
  {
    for (const double x : point)
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  const int exponent = std::ilogb(largest) + 1;
  return std::abs(exponent) > LargestExponent ? exponent : 0;
}

void Scale(std::vector<Point>& points, int exponent)
{
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x = std::ldexp(x, exponent);
    }
  }
}

/** TetGen crashes on some surfaces when it has to keep points off the facets: then it need not. */
TetgenAnswer RunTetgenTwice(
  const std::vector<Point>& points, const std::vector<Triangle>& constraints, Monitor& monitor)
{
  try
  {
    return RunTetgen(points, constraints, SurfaceSteinerPoints::Avoid, monitor);
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::TetrahedralizerDied &&
      error.Code != ErrorCode::TetrahedralizerFailed)
    {
      throw;
    }
  }
  return RunTetgen(points, constraints, SurfaceSteinerPoints::Allow, monitor);
}

TetrahedralMesh Tetrahedralize(const FacetComplex& surface, Monitor& monitor)
{
  const std::vector<Triangle> constraints(
    surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
  return AssembleMesh(surface, RunTetgenTwice(surface.Points, constraints, monitor));
}
} // namespace

TetrahedralMesh ConstrainedDelaunay(const FacetComplex& surface, Monitor& monitor)
{
  CheckIdsAndCoordinates(surface);
  CheckSpansSpace(surface.Points);
  const int exponent = ExponentToRemove(surface.Points);
  FacetComplex scaled;
  if (exponent != 0)
  {
    scaled = surface;
    Scale(scaled.Points, -exponent);
    std::vector<Point> restored = scaled.Points;
    Scale(restored, exponent);
    // Where the smallest coordinates would lose bits, TetGen has to cope.
    if (restored == surface.Points)
    {
      TetrahedralMesh mesh = Tetrahedralize(scaled, monitor);
      Scale(mesh.Points, exponent);
      return mesh;
    }
  }
  return Tetrahedralize(surface, monitor);
}
} // namespace insideout
