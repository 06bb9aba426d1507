// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Stages.h"
#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/GridPlaces.h"

#include <memory>
#include <optional>

namespace insideout
{
enum class WindingNumberMethod
{
  Exact,        ///< exact up to rounding, and fastest (ExactWindingNumber.h)
  Naive,        ///< the sum over all facets, exact up to rounding (WindingNumberSum.h)
  Hierarchical, ///< the thesis's hierarchy, exact up to rounding (HierarchicalWindingNumber.h)
  Approximate   ///< the far-field expansion (ApproximateWindingNumber.h)
};

struct WindingNumberParameters
{
  WindingNumberMethod Method = WindingNumberMethod::Exact;
  int ApproximationOrder = 2; ///< 1 to 3, of Approximate
  double Accuracy = 2; ///< at least 1, of Approximate: radii away that are far (Barill et al.)
};

/**
 * The winding number of a surface anywhere: facets may cross each other and need no mesh.
 *
 * On the surface, Exact, Naive and Hierarchical give the mean of the values around the point,
 * weighted by solid angle: on a facet the mean of both sides, on a closed surface's edge the
 * dihedral angle over 2 pi. Points that are not finite have w = NaN.
 */
class SurfaceWindingNumber
{
public:
  /**
   * @param[in] surface every facet counts, none is degenerate; it need not live on
   * @throws Error (Stopped), (InvalidParameter)
   */
  SurfaceWindingNumber(
    const FacetComplex& surface, const WindingNumberParameters& parameters, Monitor& monitor);

  /** The same where the boundary is known; edges of degenerate triangles that the surface lacks may
   * be in it. */
  SurfaceWindingNumber(const FacetComplex& surface, std::vector<CountedEdge> boundary,
    const WindingNumberParameters& parameters, Monitor& monitor);
  ~SurfaceWindingNumber();

  /**
   * One value per point; the values do not depend on the number of threads.
   *
   * @param[in] progress share of the work that these points are
   * @throws Error (Stopped)
   */
  std::vector<double> At(const std::vector<Point>& points, Monitor& monitor,
    const ProgressRange& progress = { Stages::WindingNumbers, 0, 1 }) const;

  /**
   * At all places of a grid, equal to At but for rounding, and much faster if the method is Exact
   * and the grid's places ascend: little more than the time to write the values. Few slices are
   * held at once.
   *
   * @param[in] grid of any places: not finite ones have w = NaN
   * @param[in] sideOf if given, values only tell on which side of it w is; this is faster for open
   * surfaces
   * @throws Error (Stopped)
   */
  void InGrid(const GridPlaces& grid, std::optional<double> sideOf, const SliceVisitor& visit,
    Monitor& monitor, const ProgressRange& progress = { Stages::WindingNumbers, 0, 1 }) const;

  /** At one point. Safe to call from several threads. */
  double At(const Point& point) const;

  /**
   * The gradient of w, by the Biot-Savart integral over the open edges: w is smooth away from the
   * surface and jumps by whole numbers across it, so facets add nothing. On a closed surface the
   * gradient is 0 everywhere. It is 0 on an open edge itself. Safe to call from several threads.
   */
  Point Gradient(const Point& point) const;

  /** Whether w is a whole number away from the surface. */
  bool IsClosed() const;

private:
  void SliceBySlice(const GridPlaces& grid, const SliceVisitor& visit, Monitor& monitor,
    const ProgressRange& progress) const;

  class Implementation;
  std::unique_ptr<const Implementation> Internals;
};
} // namespace insideout
