// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/StraightCapProduct.h"

#include "Common/DoubleDouble.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/TurningProduct.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
// See SolidAngleProduct.cxx.
constexpr double LeastSquaredModulus = 0x1p-12;
constexpr double SideError = 0x1p-48;
constexpr double MostImaginaryError = 0x1p-42;

// A bound for the difference of unit vectors. A site at least this far from all corners, and any
// place within the reach of a cap (2^-46), have unit vectors that differ by at most 2^-10. At a
// place on the triangle z is a negative real number or 0. So next to it z has a negative real part,
// or a modulus less than the least one.
constexpr double LeastSquaredDistance = 0x1p-72;

// Products are normalized after this many triangles. Factors are from 2^-6 (2^-36)^3 to 2^8, and
// the imaginary part of a negative one is above 2^-170: far from underflow, and from overflow.
constexpr int TrianglesToNormalize = 6;

// Smaller imaginary parts count as zero: far less than rounding.
constexpr double LeastImaginary = 0x1p-200;

// A sliver's solid angle is taken from real and imaginary part without an arctangent, up to this
// quotient; its error is 2^-52 of the sphere at most.
constexpr double MostQuotient = 0x1p-20;
constexpr double MostSliverError = 0x1p-50;

/** z times |a||b||c|. */
struct Factor
{
  double Real;
  double Imaginary;
  double First;       ///< |a|
  double Others;      ///< |b||c|
  double All;         ///< |a||b||c|
  double LeastSquare; ///< of the three lengths
};

INSIDEOUT_ALWAYS_INLINE Factor FactorOf(
  const std::array<Point, 3>& corners, const Point& normal, const SiteBlock& from, int lane)
{
  const double ax = (corners[0][0] - from.High[0][lane]) - from.Low[0][lane];
  const double ay = (corners[0][1] - from.High[1][lane]) - from.Low[1][lane];
  const double az = (corners[0][2] - from.High[2][lane]) - from.Low[2][lane];
  const double bx = (corners[1][0] - from.High[0][lane]) - from.Low[0][lane];
  const double by = (corners[1][1] - from.High[1][lane]) - from.Low[1][lane];
  const double bz = (corners[1][2] - from.High[2][lane]) - from.Low[2][lane];
  const double cx = (corners[2][0] - from.High[0][lane]) - from.Low[0][lane];
  const double cy = (corners[2][1] - from.High[1][lane]) - from.Low[1][lane];
  const double cz = (corners[2][2] - from.High[2][lane]) - from.Low[2][lane];
  const double aa = ax * ax + ay * ay + az * az;
  const double bb = bx * bx + by * by + bz * bz;
  const double cc = cx * cx + cy * cy + cz * cz;
  const double a = std::sqrt(aa);
  const double b = std::sqrt(bb);
  const double c = std::sqrt(cc);
  const double ab = ax * bx + ay * by + az * bz;
  const double bc = bx * cx + by * cy + bz * cz;
  const double ca = ax * cx + ay * cy + az * cz;
  Factor factor;
  factor.First = a;
  factor.Others = b * c;
  factor.All = a * factor.Others;
  factor.Real = factor.All + ((ab * c + bc * a) + ca * b);
  factor.Imaginary = ax * normal[0] + ay * normal[1] + az * normal[2];
  factor.LeastSquare = std::min(std::min(aa, bb), cc);
  return factor;
}

INSIDEOUT_ALWAYS_INLINE bool MultiplyByTriangle(const CapTriangle& triangle, const SiteBlock& sites,
  Products& products, double (&undecided)[Lanes])
{
  double any = 0;
#pragma omp simd reduction(max : any)
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const Factor f = FactorOf(triangle.Corners, triangle.Normal, sites, lane);
    const double side = std::abs(f.Imaginary);
    const double imaginary = side > LeastImaginary ? f.Imaginary : 0;
    // In this form, NaN is undecided.
    const double apart = f.LeastSquare >= LeastSquaredDistance ? 1 : 0;
    const double exact = triangle.UndecidedSide <= MostImaginaryError * f.Others ? apart : 0;
    const double clear =
      f.Real * f.Real + imaginary * imaginary >= LeastSquaredModulus * (f.All * f.All) ? exact : 0;
    const double sided = side > triangle.UndecidedSide * f.First + triangle.Thickness ? clear : 0;
    const double decided = f.Real > 0 ? clear : sided;
    Multiply(products, lane, decided > 0 ? f.Real : 1, decided > 0 ? imaginary : 0);
    undecided[lane] = 1 - decided;
    any = std::max(any, undecided[lane]);
  }
  return any > 0;
}
} // namespace

CapTriangle MakeCapTriangle(const std::array<Point, 3>& corners, double height)
{
  CapTriangle triangle;
  triangle.Corners = corners;
  triangle.Normal = NormalOf(corners[0], corners[1], corners[2]);
  triangle.UndecidedSide =
    SideError * Distance(corners[0], corners[1]) * Distance(corners[0], corners[2]);
  triangle.Thickness = height * Length(triangle.Normal) * (1 + 0x1p-20);
  return triangle;
}

INSIDEOUT_VECTOR_CLONES
const CapTriangle* MultiplyByTriangles(const CapTriangle* first, const CapTriangle* last,
  const SiteBlock& sites, Products& products, double (&undecided)[Lanes])
{
  // A local copy: the compiler knows that nothing aliases it.
  Products local = products;
  const CapTriangle* triangle = first;
  bool any = false;
  while (triangle != last && !any)
  {
    const CapTriangle* stop =
      last - triangle < TrianglesToNormalize ? last : triangle + TrianglesToNormalize;
    for (; triangle != stop && !any; ++triangle)
    {
      any = MultiplyByTriangle(*triangle, sites, local, undecided);
    }
    Normalize(local);
  }
  products = local;
  return triangle;
}

Sliver MakeSliver(const std::array<Point, 3>& corners, int count)
{
  // The edges' cross product is about as large as rounding errors.
  std::array<Vector<DoubleDouble>, 2> edges;
  double lengths = 1;
  for (int k = 0; k < 2; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      edges[k][axis] = TwoSum(corners[k + 1][axis], -corners[0][axis]);
    }
    lengths *= Distance(corners[0], corners[k + 1]);
  }
  const Vector<DoubleDouble> normal = Cross(edges[0], edges[1]);
  Sliver sliver;
  sliver.Corners = corners;
  for (int axis = 0; axis < 3; ++axis)
  {
    sliver.Normal[axis] = count * normal[axis].High;
  }
  sliver.NormalError =
    std::abs(count) * (8 * DoubleDoubleEpsilon * lengths) + 0x1p-51 * Length(sliver.Normal);
  return sliver;
}

void SetLine(SliverLines& lines, int lane, const Sliver& sliver)
{
  const Point along = Difference(sliver.Corners[2], sliver.Corners[0]);
  for (int axis = 0; axis < 3; ++axis)
  {
    lines.From[axis][lane] = sliver.Corners[0][axis];
    lines.Along[axis][lane] = along[axis];
  }
  const double twiceArea = Length(sliver.Normal) + sliver.NormalError;
  lines.InverseSquare[lane] = 1 / Dot(along, along);
  lines.Area[lane] = twiceArea / (8 * Pi);
  lines.Width[lane] = twiceArea / Length(along) / (2 * Pi);
}

INSIDEOUT_VECTOR_CLONES
void SeeSlivers(const SliverLines& lines, const Point& centre, double radius, double leastSeen,
  double (&seen)[Lanes])
{
  const double px = centre[0], py = centre[1], pz = centre[2];
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double x = px - lines.From[0][lane];
    const double y = py - lines.From[1][lane];
    const double z = pz - lines.From[2][lane];
    const double ex = lines.Along[0][lane], ey = lines.Along[1][lane], ez = lines.Along[2][lane];
    const double along = (x * ex + y * ey + z * ez) * lines.InverseSquare[lane];
    const double part = std::min(std::max(along, 0.0), 1.0);
    const double dx = x - part * ex, dy = y - part * ey, dz = z - part * ez;
    const double distance = std::max(std::sqrt(dx * dx + dy * dy + dz * dz) - radius, 0.0);
    const double wide = lines.Width[lane] > leastSeen * distance ? 1 : 0;
    seen[lane] = lines.Area[lane] > leastSeen * (distance * distance) ? wide : 0;
  }
}

INSIDEOUT_VECTOR_CLONES
bool AddSliver(
  const Sliver& sliver, const SiteBlock& sites, double (&sums)[Lanes], double (&undecided)[Lanes])
{
  double any = 0;
#pragma omp simd reduction(max : any)
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const Factor f = FactorOf(sliver.Corners, sliver.Normal, sites, lane);
    const double size = std::abs(f.Imaginary);
    // The real part errs by some 2^-50 of All. In this form, NaN is undecided.
    const double small = size <= MostQuotient * f.Real ? 1 : 0;
    const double sharp = 4 * size * f.All <= f.Real * f.Real ? small : 0;
    const double exact = sliver.NormalError * f.First <= MostSliverError * f.Real ? sharp : 0;
    const double decided = f.Real > 0 ? exact : 0;
    sums[lane] += decided > 0 ? f.Imaginary / f.Real : 0;
    undecided[lane] = 1 - decided;
    any = std::max(any, undecided[lane]);
  }
  return any > 0;
}
} // namespace insideout
