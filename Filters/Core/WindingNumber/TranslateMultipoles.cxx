// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/TranslateMultipoles.h"

#include "WindingNumber/VectorClones.h"

#include <algorithm>
#include <cmath>

// Derivatives of a harmonic function f along a vector (d_x, d_y, d_z) of length 0 form spinors:
// with
//
//   d_x + i d_y = u^2      d_x - i d_y = -v^2      d_z = u v,
//
// those of degree l are u^(l + m) v^(l - m) f, -l <= m <= l, where -m gives (-1)^m times the
// conjugate of m. A rotation acts on (u, v), so that its effect on any degree is a product of
// linear forms. The derivatives of 1 / r are solid harmonics: for m = 0, at a place on the z axis,
// (-1)^l l! / r^(l + 1), and 0 for the others. A multipole is a sum of products of these and the
// components of a spinor b, with (-1)^m b_-m / ((l + m)! (l - m)!), which no rotation changes. So
//
//   u^(j + k) v^(j - k) f = (-1)^(j + k) sum over l of (-1)^l b_lk (j + l)! / ((l + k)! (l - k)!)
//
// at a distance of 1 on the z axis. The components of f and b are c_lm times Scale, up to
// conjugates, signs that cancel, and, for f, the inverse of Scale.
namespace insideout
{
namespace
{
/** Per lane a complex number. */
struct LaneTerm
{
  double Real[Lanes];
  double Imaginary[Lanes];
};

/** Terms sorted by l, then m. */
using LaneTerms = std::array<LaneTerm, Multipole::NumberOfTerms>;

constexpr int IndexOf(int l, int m)
{
  return l * (l + 1) / 2 + m;
}

struct TranslationTable
{
  TranslationTable()
  {
    this->Factorial[0] = 1;
    for (int n = 1; n <= 2 * MultipoleDegree; ++n)
    {
      this->Factorial[n] = n * this->Factorial[n - 1];
    }
    double odd = 1; // 1 * 3 * ... * (2 l - 1)
    for (int l = 0; l <= MultipoleDegree; ++l)
    {
      for (int m = 0; m <= l; ++m)
      {
        const double product = this->Factorial[l + m] * this->Factorial[l - m];
        this->Inverse[IndexOf(l, m)] = 1 / product;
        this->Scale[IndexOf(l, m)] = product / odd / (m == 0 ? 1 : 2);
        this->AddTurn(l, m);
      }
      odd *= 2 * l + 1;
    }
  }

  /** The coefficients of (v + u)^(l + k) (v - u)^(l - k): integers below 2^53, hence exact. */
  void AddTurn(int l, int k)
  {
    double powers[2 * MultipoleDegree + 1] = { 1 };
    for (int factor = 0; factor < 2 * l; ++factor)
    {
      for (int i = factor; i >= 0; --i)
      {
        powers[i + 1] += factor < l + k ? powers[i] : -powers[i];
      }
    }
    for (int m = 0; m <= l; ++m)
    {
      this->Turn.push_back(std::ldexp(powers[l + m] * (m == 0 ? 1 : 2), -l));
    }
  }

  double Factorial[2 * MultipoleDegree + 1];
  double Inverse[Multipole::NumberOfTerms]; ///< 1 / ((l + m)! (l - m)!)
  double Scale[Multipole::NumberOfTerms];
  std::vector<double> Turn; ///< the matrix of a rotation from x to z: of each l, for k, the m
};

const TranslationTable& Table()
{
  static const TranslationTable table;
  return table;
}

/** Rotate from the x to the z axis. A term has the real parts of every other m, and the imaginary
 * parts of those between. */
INSIDEOUT_ALWAYS_INLINE void QuarterTurn(
  const double* turn, int degree, const LaneTerms& from, LaneTerms& to)
{
  for (int l = 0; l <= degree; ++l)
  {
    const LaneTerm* const terms = &from[IndexOf(l, 0)];
    for (int k = 0; k <= l; ++k, turn += l + 1)
    {
      LaneTerm sum = {};
      for (int m = (l - k) % 2; m <= l; m += 2)
      {
#pragma omp simd
        for (int lane = 0; lane < Lanes; ++lane)
        {
          sum.Real[lane] += turn[m] * terms[m].Real[lane];
        }
      }
      for (int m = (l - k + 1) % 2; m <= l; m += 2)
      {
#pragma omp simd
        for (int lane = 0; lane < Lanes; ++lane)
        {
          sum.Imaginary[lane] += turn[m] * terms[m].Imaginary[lane];
        }
      }
      to[IndexOf(l, k)] = sum;
    }
  }
}

/** Rotate around the z axis: multiply the terms with m by the m-th power of c + i d. */
INSIDEOUT_ALWAYS_INLINE void Spin(
  const double (&c)[Lanes], const double (&d)[Lanes], int degree, LaneTerms& terms)
{
  double real[Lanes];
  double imaginary[Lanes] = {};
  std::fill(real, real + Lanes, 1.0);
  for (int m = 1; m <= degree; ++m)
  {
#pragma omp simd
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const double turned = real[lane] * c[lane] - imaginary[lane] * d[lane];
      imaginary[lane] = real[lane] * d[lane] + imaginary[lane] * c[lane];
      real[lane] = turned;
    }
    for (int l = m; l <= degree; ++l)
    {
      LaneTerm& term = terms[IndexOf(l, m)];
#pragma omp simd
      for (int lane = 0; lane < Lanes; ++lane)
      {
        const double turned = term.Real[lane] * real[lane] - term.Imaginary[lane] * imaginary[lane];
        term.Imaginary[lane] =
          term.Real[lane] * imaginary[lane] + term.Imaginary[lane] * real[lane];
        term.Real[lane] = turned;
      }
    }
  }
}

/** From multipoles to local terms at a distance of 1 on the z axis, but for (-1)^j. */
INSIDEOUT_ALWAYS_INLINE void Shift(
  const TranslationTable& table, int degree, int localDegree, const LaneTerms& from, LaneTerms& to)
{
  for (int j = 0; j <= localDegree; ++j)
  {
    for (int k = 0; k <= j; ++k)
    {
      LaneTerm sum = {};
      for (int l = k; l <= degree; ++l)
      {
        const double factor = table.Factorial[j + l] * table.Inverse[IndexOf(l, k)];
        const LaneTerm& term = from[IndexOf(l, k)];
#pragma omp simd
        for (int lane = 0; lane < Lanes; ++lane)
        {
          sum.Real[lane] += factor * term.Real[lane];
          sum.Imaginary[lane] += factor * term.Imaginary[lane];
        }
      }
      to[IndexOf(j, k)] = sum;
    }
  }
}

/** Read the multipoles' terms up to a degree, in units of their distances. */
INSIDEOUT_ALWAYS_INLINE void Load(
  const TranslationTable& table, const FarMultipoles& far, int degree, LaneTerms& terms)
{
  double power[Lanes];
  std::copy(far.Unit, far.Unit + Lanes, power);
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      LaneTerm& term = terms[IndexOf(l, m)];
      const double scale = table.Scale[IndexOf(l, m)];
      for (int lane = 0; lane < Lanes; ++lane)
      {
        const double factor = scale * power[lane];
        term.Real[lane] = factor * far.Fields[lane]->Real[Multipole::TermOf(l, m)];
        term.Imaginary[lane] = factor * far.Fields[lane]->Imaginary[Multipole::TermOf(l, m)];
      }
    }
    for (int lane = 0; lane < Lanes; ++lane)
    {
      power[lane] *= far.Unit[lane];
    }
  }
}

/** Add the lanes' terms to the function inside the ball, in units of its radius. */
INSIDEOUT_ALWAYS_INLINE void Store(const TranslationTable& table, const FarMultipoles& far,
  const LaneTerms& terms, int degree, Multipole& local)
{
  double power[Lanes];
  std::fill(power, power + Lanes, 1.0);
  for (int j = 0; j <= degree; ++j)
  {
    for (int k = 0; k <= j; ++k)
    {
      double real = 0;
      double imaginary = 0;
      for (int lane = 0; lane < Lanes; ++lane)
      {
        real += power[lane] * terms[IndexOf(j, k)].Real[lane];
        imaginary += power[lane] * terms[IndexOf(j, k)].Imaginary[lane];
      }
      local.Real[Multipole::TermOf(j, k)] += real / table.Scale[IndexOf(j, k)];
      local.Imaginary[Multipole::TermOf(j, k)] += imaginary / table.Scale[IndexOf(j, k)];
    }
    for (int lane = 0; lane < Lanes; ++lane)
    {
      power[lane] *= -far.Radius[lane];
    }
  }
}
} // namespace

INSIDEOUT_VECTOR_CLONES
void TranslateMultipoles(const FarMultipoles& far, int degree, int localDegree, Multipole& local)
{
  // The direction is (sine x, sine y, cosine). A rotation by its polar angle around the y axis is
  // one around z between two quarter turns.
  double x[Lanes], y[Lanes], minusX[Lanes], minusY[Lanes];
  double sine[Lanes], minusSine[Lanes], minusCosine[Lanes];
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double dx = far.Direction[0][lane], dy = far.Direction[1][lane];
    sine[lane] = std::sqrt(dx * dx + dy * dy);
    x[lane] = sine[lane] > 0 ? dx / sine[lane] : 1;
    y[lane] = sine[lane] > 0 ? dy / sine[lane] : 0;
    minusX[lane] = -x[lane];
    minusY[lane] = -y[lane];
    minusSine[lane] = -sine[lane];
    minusCosine[lane] = -far.Direction[2][lane];
  }
  const TranslationTable& table = Table();
  const double* const turn = table.Turn.data();
  LaneTerms a, b;
  Load(table, far, degree, a);
  Spin(y, minusX, degree, a);
  QuarterTurn(turn, degree, a, b);
  Spin(minusCosine, minusSine, degree, b);
  QuarterTurn(turn, degree, b, a);
  Shift(table, degree, localDegree, a, b);
  QuarterTurn(turn, localDegree, b, a);
  Spin(minusCosine, sine, localDegree, a);
  QuarterTurn(turn, localDegree, a, b);
  Spin(minusY, minusX, localDegree, b);
  Store(table, far, b, localDegree, local);
}
} // namespace insideout
