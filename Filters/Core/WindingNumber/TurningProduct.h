// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/SolidAngleProduct.h"
#include "WindingNumber/VectorClones.h"

#include <cmath>

namespace insideout
{
/**
 * Multiply one site's product by z.
 *
 * Arguments are in (-pi, pi], and an imaginary part of -0 counts as 0. The argument of a product
 * wraps around only if those of both factors are in [0, pi] and the product's is not, or the
 * reverse. The one exception, two negative real factors, cannot happen: z is never a negative real
 * number. Rounding does no harm. If the arguments add up to nearly 0 or 2 pi, both summands of the
 * imaginary part have the same sign. So the product stays on the right side of the real axis. If
 * they add up to nearly pi, it may change sides, but then the turn is counted accordingly.
 */
INSIDEOUT_ALWAYS_INLINE void Multiply(Products& products, int lane, double zReal, double zImaginary)
{
  const double pReal = products.Real[lane];
  const double pImaginary = products.Imaginary[lane];
  const double qReal = pReal * zReal - pImaginary * zImaginary;
  const double qImaginary = pReal * zImaginary + pImaginary * zReal;
  const double pBelow = pImaginary < 0 ? 1 : 0;
  const double zBelow = zImaginary < 0 ? 1 : 0;
  const double qBelow = qImaginary < 0 ? 1 : 0;
  products.Turns[lane] += pBelow == zBelow ? qBelow - pBelow : 0;
  products.Real[lane] = qReal;
  products.Imaginary[lane] = qImaginary;
}

/** Give each product the modulus 1. */
INSIDEOUT_ALWAYS_INLINE void Normalize(Products& products)
{
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double inverse = 1 /
      std::sqrt(products.Real[lane] * products.Real[lane] +
        products.Imaginary[lane] * products.Imaginary[lane]);
    products.Real[lane] *= inverse;
    products.Imaginary[lane] *= inverse;
  }
}
} // namespace insideout
