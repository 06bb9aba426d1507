// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SolidAngleProduct.h"

#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/TurningProduct.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace insideout
{
namespace
{
// Products are normalized after this many facets: (2^-6)^32 to 4^32, times LeastImaginary, is far
// from overflow and underflow.
constexpr int FacetsToNormalize = 32;

// The least |z|^2 at which z is trusted: its error is below 30 * 2^-53, which turns it by less than
// 3e-13 there and by some 1e-16 nearly always.
constexpr double LeastSquaredModulus = 0x1p-12;

// The forward error of u . normal is below 16 u |edge| |edge| with u = 2^-53: 3 from the unit
// vector's components, 6 from the normal and 3 from the product, with room to spare.
constexpr double SideError = 0x1p-48;

// The imaginary part is u . normal over the product of the other two distances; so is its error.
// The error is large where a site is much nearer to two corners than the edges are long, as at the
// short side of a needle. This bound allows some 1e-14, mostly less.
constexpr double MostImaginaryError = 0x1p-45;

// Smaller imaginary parts count as zero: far less than rounding, and far from underflow in
// products. This cannot happen where the real part is negative, because u . normal is above
// LeastSide there.
constexpr double LeastImaginary = 1e-200;
constexpr double LeastSide = 1e-180;

// Unit vectors to points nearer than 2^-48 are not trusted. Sites are known to some 2^-104,
// so that from there on they have full precision.
constexpr double LeastSquaredDistance = 0x1p-96;

/**
 * Multiply each site's product by the facet's z, except for sites where doubles do not decide z:
 * those get a 1 in `undecided`, the others a 0.
 *
 * @return whether any site is undecided
 */
INSIDEOUT_ALWAYS_INLINE bool MultiplyByFacet(const SummedFacet& facet, const UnitVectors& a,
  const UnitVectors& b, const UnitVectors& c, Products& products, double (&undecided)[Lanes])
{
  double any = 0;
#pragma omp simd reduction(max : any)
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double ab = a.X[lane] * b.X[lane] + a.Y[lane] * b.Y[lane] + a.Z[lane] * b.Z[lane];
    const double bc = b.X[lane] * c.X[lane] + b.Y[lane] * c.Y[lane] + b.Z[lane] * c.Z[lane];
    const double ca = a.X[lane] * c.X[lane] + a.Y[lane] * c.Y[lane] + a.Z[lane] * c.Z[lane];
    const double side =
      a.X[lane] * facet.Normal[0] + a.Y[lane] * facet.Normal[1] + a.Z[lane] * facet.Normal[2];
    const double real = 1 + ((ab + ca) + bc); // symmetric in b and c
    const double inverse = b.InverseDistance[lane] * c.InverseDistance[lane];
    const double unflushed = side * inverse;
    const double imaginary = std::abs(unflushed) > LeastImaginary ? unflushed : 0;

    // In this form, NaN is undecided.
    const double exact = facet.UndecidedSide * inverse <= MostImaginaryError ? 1 : 0;
    const double clear = real * real + imaginary * imaginary >= LeastSquaredModulus ? exact : 0;
    const double sided = std::abs(side) > facet.UndecidedSide ? 1 : 0;
    const double decided = real > 0 ? clear : clear * sided;
    Multiply(products, lane, decided > 0 ? real : 1, decided > 0 ? imaginary : 0);
    undecided[lane] = 1 - decided;
    any = std::max(any, undecided[lane]);
  }
  return any > 0;
}

/** a + b = sum + the value returned, exactly (Knuth). */
INSIDEOUT_ALWAYS_INLINE double TwoSum(double a, double b, double& sum)
{
  const double s = a + b;
  const double bRounded = s - a;
  const double aRounded = s - bRounded;
  sum = s;
  return (a - aRounded) + (b - bRounded);
}
} // namespace

Triangle FromBluntCorner(const std::vector<Point>& points, const Triangle& corners)
{
  const auto rank = [&](int k)
  {
    const auto [p, q, r] =
      CornersOf(points, Triangle{ corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3] });
    return std::make_pair(Distance(p, q) * Distance(p, r), corners[k]);
  };
  const int k = std::min({ 0, 1, 2 }, [&](int i, int j) { return rank(i) < rank(j); });
  return { corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3] };
}

void SetGeometry(SummedFacet& facet, const Point& a, const Point& b, const Point& c)
{
  facet.Normal = NormalOf(a, b, c);
  facet.UndecidedSide = SideError * Distance(a, b) * Distance(a, c) + LeastSide;
}

INSIDEOUT_VECTOR_CLONES
void SetSites(SiteBlock& block, const SiteCorners& corners, const SiteWeights& weights)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double high[Lanes] = {};
    double low[Lanes] = {};
    for (int k = 0; k < 4; ++k)
    {
      const double weight = weights[k];
      const double* const corner = corners.Of[k][axis];
      if (weight != 0.25) // which loses no digit
      {
        for (int lane = 0; lane < Lanes; ++lane)
        {
          low[lane] += std::fma(weight, corner[lane], -(weight * corner[lane]));
        }
      }
#pragma omp simd
      for (int lane = 0; lane < Lanes; ++lane)
      {
        low[lane] += TwoSum(high[lane], weight * corner[lane], high[lane]);
      }
    }
#pragma omp simd
    for (int lane = 0; lane < Lanes; ++lane)
    {
      block.Low[axis][lane] = TwoSum(high[lane], low[lane], block.High[axis][lane]);
    }
  }
}

INSIDEOUT_VECTOR_CLONES
void ComputeUnitVectors(
  const Point* points, std::size_t count, const SiteBlock& from, UnitVectors* vectors)
{
  for (std::size_t p = 0; p < count; ++p)
  {
    const double px = points[p][0], py = points[p][1], pz = points[p][2];
    UnitVectors& to = vectors[p];
#pragma omp simd
    for (int lane = 0; lane < Lanes; ++lane)
    {
      // The first difference is exact where it is small, so each component has full precision.
      const double x = (px - from.High[0][lane]) - from.Low[0][lane];
      const double y = (py - from.High[1][lane]) - from.Low[1][lane];
      const double z = (pz - from.High[2][lane]) - from.Low[2][lane];
      const double squared = x * x + y * y + z * z;
      const double inverse = squared > LeastSquaredDistance
        ? 1 / std::sqrt(squared)
        : std::numeric_limits<double>::quiet_NaN();
      to.X[lane] = x * inverse;
      to.Y[lane] = y * inverse;
      to.Z[lane] = z * inverse;
      to.InverseDistance[lane] = inverse;
    }
  }
}

INSIDEOUT_VECTOR_CLONES
const SummedFacet* MultiplyByFacets(const SummedFacet* first, const SummedFacet* last,
  const UnitVectors* vectors, Products& products, double (&undecided)[Lanes])
{
  // A local copy: the compiler knows that nothing aliases it.
  Products local = products;
  const SummedFacet* facet = first;
  bool any = false;
  while (facet != last && !any)
  {
    const SummedFacet* stop = std::min(last, facet + FacetsToNormalize);
    for (; facet != stop && !any; ++facet)
    {
      any = MultiplyByFacet(*facet, vectors[facet->Local[0]], vectors[facet->Local[1]],
        vectors[facet->Local[2]], local, undecided);
    }
    Normalize(local);
  }
  products = local;
  return facet;
}

void MultiplyBy(Products& products, int lane, double real, double imaginary)
{
  Multiply(products, lane, real, imaginary);
}

double WindingNumber(const Products& products, int lane)
{
  // Adding 0 makes -0 positive, so that a negative real number has the argument pi.
  const double argument = std::atan2(products.Imaginary[lane] + 0.0, products.Real[lane]);
  return products.Turns[lane] + argument / (2 * Pi);
}
} // namespace insideout
