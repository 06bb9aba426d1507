// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/BoundaryProduct.h"

#include "WindingNumber/VectorClones.h"

#include <cmath>

namespace insideout
{
namespace
{
// Normalize after this many factors. They are from 2^-97 to 2^104, for sites may be 2^50 away, or
// from 2^-20 to 2^10 for sites ahead: no product overflows or underflows.
constexpr int EdgesToNormalize = 8;
constexpr int EdgesAheadToNormalize = 32;

/** From each site to one point: the spinor (A + i B, C + i D), not normalized. */
struct Spinors
{
  double A[Lanes];
  double B[Lanes];
  double C[Lanes];
  double D[Lanes];
};

INSIDEOUT_ALWAYS_INLINE void SetSpinors(
  const Point& point, const SiteBlock& sites, Spinors& spinors)
{
  const double px = point[0], py = point[1], pz = point[2];
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double x = (px - sites.High[0][lane]) - sites.Low[0][lane];
    const double y = (py - sites.High[1][lane]) - sites.Low[1][lane];
    const double z = (pz - sites.High[2][lane]) - sites.Low[2][lane];
    const double sum = std::sqrt(x * x + y * y + z * z) + std::abs(z);
    spinors.A[lane] = z >= 0 ? sum : x;
    spinors.B[lane] = z >= 0 ? 0 : -y;
    spinors.C[lane] = z >= 0 ? x : sum;
    spinors.D[lane] = z >= 0 ? y : 0;
  }
}

/** Sites to which all points have a positive third coordinate in this frame. */
struct SitesAhead
{
  const SiteBlock& Sites;
  const Frame& Axes;
};

/** From each of them to one point: (A, C + i D). */
struct ForwardSpinors
{
  double A[Lanes];
  double C[Lanes];
  double D[Lanes];
};

INSIDEOUT_ALWAYS_INLINE void SetSpinors(
  const Point& point, const SitesAhead& from, ForwardSpinors& spinors)
{
  const Frame& frame = from.Axes;
  const double px = point[frame.X], py = point[frame.Y], pz = frame.Sign * point[frame.Z];
  const double* const sx = from.Sites.High[frame.X];
  const double* const sy = from.Sites.High[frame.Y];
  const double* const sz = from.Sites.High[frame.Z];
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double x = px - sx[lane];
    const double y = py - sy[lane];
    const double z = pz - frame.Sign * sz[lane];
    spinors.A[lane] = std::sqrt(x * x + y * y + z * z) + z;
    spinors.C[lane] = x;
    spinors.D[lane] = y;
  }
}

/** Multiply by <u | v>. */
INSIDEOUT_ALWAYS_INLINE void MultiplyByEdge(
  const ForwardSpinors& u, const ForwardSpinors& v, PhaseProducts& products)
{
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double real = u.A[lane] * v.A[lane] + (u.C[lane] * v.C[lane] + u.D[lane] * v.D[lane]);
    const double imaginary = u.C[lane] * v.D[lane] - u.D[lane] * v.C[lane];
    const double pReal = products.Real[lane];
    const double pImaginary = products.Imaginary[lane];
    products.Real[lane] = pReal * real - pImaginary * imaginary;
    products.Imaginary[lane] = pReal * imaginary + pImaginary * real;
  }
}

/** Multiply by <u | v>. */
INSIDEOUT_ALWAYS_INLINE void MultiplyByEdge(
  const Spinors& u, const Spinors& v, PhaseProducts& products)
{
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double real = (u.A[lane] * v.A[lane] + u.B[lane] * v.B[lane]) +
      (u.C[lane] * v.C[lane] + u.D[lane] * v.D[lane]);
    const double imaginary = (u.A[lane] * v.B[lane] - u.B[lane] * v.A[lane]) +
      (u.C[lane] * v.D[lane] - u.D[lane] * v.C[lane]);
    const double pReal = products.Real[lane];
    const double pImaginary = products.Imaginary[lane];
    products.Real[lane] = pReal * real - pImaginary * imaginary;
    products.Imaginary[lane] = pReal * imaginary + pImaginary * real;
  }
}

/** Scale to a modulus from 1/2 to 1. */
INSIDEOUT_ALWAYS_INLINE void Normalize(PhaseProducts& products)
{
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double inverse = 1 / (std::abs(products.Real[lane]) + std::abs(products.Imaginary[lane]));
    products.Real[lane] *= inverse;
    products.Imaginary[lane] *= inverse;
  }
}

/**
 * Multiply by all edges of closed loops. A point's root is computed while the edges before it are
 * multiplied, for instruction-level parallelism.
 *
 * @param[in] sites a block or SitesAhead, with the spinors that serve these
 */
template <typename AnySpinors, typename AnySites>
INSIDEOUT_ALWAYS_INLINE void MultiplyByLoops(
  const BoundaryLoops& loops, const AnySites& sites, int edgesToNormalize, PhaseProducts& products)
{
  // A local copy: the compiler knows that nothing aliases it.
  PhaseProducts local = products;
  int edges = 0;
  const Point* point = loops.Points;
  for (const std::int32_t* size = loops.FirstSize; size != loops.LastSize; ++size)
  {
    AnySpinors first;
    AnySpinors others[2];
    SetSpinors(*point++, sites, first);
    const AnySpinors* previous = &first;
    for (std::int32_t i = 1; i < *size; ++i)
    {
      AnySpinors& next = others[i % 2];
      SetSpinors(*point++, sites, next);
      MultiplyByEdge(*previous, next, local);
      previous = &next;
      if (++edges == edgesToNormalize)
      {
        Normalize(local);
        edges = 0;
      }
    }
    MultiplyByEdge(*previous, first, local);
    if (++edges >= edgesToNormalize)
    {
      Normalize(local);
      edges = 0;
    }
  }
  Normalize(local);
  products = local;
}
} // namespace

INSIDEOUT_VECTOR_CLONES
void MultiplyByBoundary(const BoundaryLoops& loops, const SiteBlock& sites, PhaseProducts& products)
{
  MultiplyByLoops<Spinors>(loops, sites, EdgesToNormalize, products);
}

INSIDEOUT_VECTOR_CLONES
void MultiplyByBoundaryAhead(
  const BoundaryLoops& loops, const Frame& frame, const SiteBlock& sites, PhaseProducts& products)
{
  MultiplyByLoops<ForwardSpinors>(
    loops, SitesAhead{ sites, frame }, EdgesAheadToNormalize, products);
}
} // namespace insideout
