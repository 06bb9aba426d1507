// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryProduct.h"

#include "VectorClones.h"

#include <cmath>

namespace insideout
{
namespace
{
// Factors are from 2^-97 to 48, so that this many of them neither overflow nor underflow.
constexpr std::size_t EdgesToNormalize = 8;

struct ForwardSpinors
{
  double A[Lanes];
  double C[Lanes];
  double D[Lanes];
};

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

/**
 * The same from sites that see the point with a positive third coordinate, when the coordinates are
 * taken in another order: (A, C + i D).
 */
INSIDEOUT_ALWAYS_INLINE void SetForwardSpinors(
  const Point& point, const Frame& frame, const SiteBlock& sites, ForwardSpinors& spinors)
{
  const double px = point[frame.X], py = point[frame.Y], pz = frame.Sign * point[frame.Z];
  const double* const sx = sites.High[frame.X];
  const double* const sy = sites.High[frame.Y];
  const double* const sz = sites.High[frame.Z];
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

/** To a modulus from 1/2 to 1. */
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

/** Multiply by the edges between points, given the points' spinors. */
template <typename AnySpinors>
INSIDEOUT_ALWAYS_INLINE void MultiplyByEdges(const AnySpinors* spinors, const TileEdge* edges,
  std::size_t numberOfEdges, PhaseProducts& products)
{
  // Kept apart from the argument, so that nothing else can refer to it.
  PhaseProducts local = products;
  for (std::size_t first = 0; first < numberOfEdges; first += EdgesToNormalize)
  {
    const std::size_t last =
      first + EdgesToNormalize < numberOfEdges ? first + EdgesToNormalize : numberOfEdges;
    for (std::size_t e = first; e < last; ++e)
    {
      MultiplyByEdge(spinors[edges[e].From], spinors[edges[e].To], local);
    }
    Normalize(local);
  }
  products = local;
}
} // namespace

INSIDEOUT_VECTOR_CLONES
void MultiplyByBoundary(const Point* points, std::size_t numberOfPoints, const TileEdge* edges,
  std::size_t numberOfEdges, const SiteBlock& sites, PhaseProducts& products)
{
  Spinors spinors[MostTilePoints];
  for (std::size_t p = 0; p < numberOfPoints; ++p)
  {
    SetSpinors(points[p], sites, spinors[p]);
  }
  MultiplyByEdges(spinors, edges, numberOfEdges, products);
}

INSIDEOUT_VECTOR_CLONES
void MultiplyByBoundaryAhead(const Point* points, std::size_t numberOfPoints, const TileEdge* edges,
  std::size_t numberOfEdges, const Frame& frame, const SiteBlock& sites, PhaseProducts& products)
{
  ForwardSpinors spinors[MostTilePoints];
  for (std::size_t p = 0; p < numberOfPoints; ++p)
  {
    SetForwardSpinors(points[p], frame, sites, spinors[p]);
  }
  MultiplyByEdges(spinors, edges, numberOfEdges, products);
}
} // namespace insideout
