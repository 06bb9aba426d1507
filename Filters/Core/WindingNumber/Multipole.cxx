// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/Multipole.h"

#include "WindingNumber/Pi.h"
#include "WindingNumber/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
// Gauss's rule along the axis and equal angles around it integrate products of two terms exactly.
constexpr int Rings = MultipoleDegree + 1;
constexpr int SamplesPerRing = 2 * Rings;

/** The factor of Q_l-1,m. */
constexpr double Recursion(int l, int m)
{
  return static_cast<double>(l * l - m * m) / static_cast<double>(4 * l * l - 1);
}

/** The same for all terms, and where those of each m begin. */
struct TermTable
{
  constexpr TermTable()
  {
    int term = 0;
    for (int m = 0; m <= MultipoleDegree; ++m)
    {
      this->First[m] = term;
      for (int l = m; l <= MultipoleDegree; ++l)
      {
        this->Factor[term++] = Recursion(l, m);
      }
    }
  }

  int First[MultipoleDegree + 1] = {};
  double Factor[Multipole::NumberOfTerms] = {};
};

constexpr TermTable Terms;

/** A monic Legendre polynomial and its derivative. */
struct Legendre
{
  Legendre(int degree, double z)
  {
    double previous = 0;
    double previousSlope = 0;
    for (int l = 0; l < degree; ++l)
    {
      const double next = z * this->Value - Recursion(l, 0) * previous;
      const double nextSlope = this->Value + z * this->Slope - Recursion(l, 0) * previousSlope;
      previous = this->Value;
      previousSlope = this->Slope;
      this->Value = next;
      this->Slope = nextSlope;
    }
  }

  double Value = 1;
  double Slope = 0;
};

/** The samples, and the sums over them that give the terms. */
struct SphereRule
{
  SphereRule()
  {
    for (int ring = 0; ring < Rings; ++ring)
    {
      double z = std::cos(Pi * (ring + 0.75) / (Rings + 0.5));
      for (int step = 0; step < 8; ++step) // Newton's method, from a guess that is nearly a root
      {
        const Legendre legendre(Rings, z);
        z -= legendre.Value / legendre.Slope;
      }
      const double radius = std::sqrt((1 - z) * (1 + z));
      for (int k = 0; k < SamplesPerRing; ++k)
      {
        const double angle = 2 * Pi * k / SamplesPerRing;
        this->Samples.push_back({ radius * std::cos(angle), radius * std::sin(angle), z });
      }
      const double slope = Legendre(Rings, z).Slope;
      const double weight = 1 / (radius * radius * slope * slope); // but for a factor
      double power = 1;
      for (int m = 0; m <= MultipoleDegree; ++m, power *= radius)
      {
        double previous = 0;
        double value = power;
        for (int l = m; l <= MultipoleDegree; ++l)
        {
          const int term = Terms.First[m] + l - m;
          this->Weights[ring][term] = weight * value;
          this->Squares[term] += weight * value * value;
          const double next = z * value - Terms.Factor[term] * previous;
          previous = value;
          value = next;
        }
      }
    }
    const double sum = this->Squares[0]; // the weights'
    for (int term = 0; term < Multipole::NumberOfTerms; ++term)
    {
      this->Squares[term] /= sum;
      for (auto& weights : this->Weights)
      {
        weights[term] /= sum;
      }
    }
    for (int k = 0; k < SamplesPerRing; ++k)
    {
      this->Cosine[k] = std::cos(2 * Pi * k / SamplesPerRing);
      this->Sine[k] = std::sin(2 * Pi * k / SamplesPerRing);
    }
  }

  std::vector<Point> Samples;
  double Weights[Rings][Multipole::NumberOfTerms]; ///< of the function of z that belongs to a term
  double Squares[Multipole::NumberOfTerms] = {};   ///< of these functions, their weighted sum
  double Cosine[SamplesPerRing];
  double Sine[SamplesPerRing];
};

const SphereRule& Rule()
{
  static const SphereRule rule;
  return rule;
}
} // namespace

const std::vector<Point>& MultipoleSamples()
{
  return Rule().Samples;
}

Multipole MultipoleOf(const std::vector<double>& values)
{
  const SphereRule& rule = Rule();
  Multipole result = {};
  for (int ring = 0; ring < Rings; ++ring)
  {
    const double* const of = &values[static_cast<std::size_t>(ring * SamplesPerRing)];
    for (int m = 0; m <= MultipoleDegree; ++m)
    {
      double real = 0;
      double imaginary = 0;
      for (int k = 0; k < SamplesPerRing; ++k)
      {
        real += of[k] * rule.Cosine[m * k % SamplesPerRing];
        imaginary -= of[k] * rule.Sine[m * k % SamplesPerRing];
      }
      for (int l = m; l <= MultipoleDegree; ++l)
      {
        const int term = Terms.First[m] + l - m;
        const double weight =
          rule.Weights[ring][term] / rule.Squares[term] * (m == 0 ? 1 : 2) / SamplesPerRing;
        result.Real[term] += weight * real;
        result.Imaginary[term] += weight * imaginary;
      }
    }
  }
  return result;
}

/** By the addition theorem a part of one degree is nowhere above its root mean square times the
 * root of the number of its terms. */
std::array<double, MultipoleDegree + 1> MultipoleBounds(const Multipole& multipole)
{
  const SphereRule& rule = Rule();
  std::array<double, MultipoleDegree + 1> bounds = {};
  for (int m = 0; m <= MultipoleDegree; ++m)
  {
    for (int l = m; l <= MultipoleDegree; ++l)
    {
      const int term = Terms.First[m] + l - m;
      const double real = multipole.Real[term];
      const double imaginary = multipole.Imaginary[term];
      bounds[l] += (real * real + imaginary * imaginary) * rule.Squares[term] / (m == 0 ? 1 : 2);
    }
  }
  for (int l = 0; l <= MultipoleDegree; ++l)
  {
    bounds[l] = std::sqrt((2 * l + 1) * bounds[l]);
  }
  return bounds;
}

namespace
{
/** The sum of Multipole's formula, without 1 / r. The recursion of Q_lm has z and `squared` as its
 * factors. */
INSIDEOUT_ALWAYS_INLINE void SumTerms(const Multipole& multipole, int degree,
  const double (&x)[Lanes], const double (&y)[Lanes], const double (&z)[Lanes],
  const double (&squared)[Lanes], double (&sum)[Lanes])
{
  double imaginary[Lanes] = {};
  std::fill(sum, sum + Lanes, 0.0);
  for (int m = degree; m >= 0; --m)
  {
    const int first = Terms.First[m];
    const int count = degree - m + 1;
    const double* const factors = Terms.Factor + first;
    const double* const reals = multipole.Real.data() + first;
    const double* const imaginaries = multipole.Imaginary.data() + first;
    double previous[Lanes] = {};
    double value[Lanes];
    double sumReal[Lanes] = {};
    double sumImaginary[Lanes] = {};
    std::fill(value, value + Lanes, 1.0);
    for (int i = 0; i < count; ++i)
    {
      const double c = reals[i], d = imaginaries[i], factor = factors[i];
#pragma omp simd
      for (int lane = 0; lane < Lanes; ++lane)
      {
        sumReal[lane] += c * value[lane];
        sumImaginary[lane] += d * value[lane];
        const double next = z[lane] * value[lane] - factor * squared[lane] * previous[lane];
        previous[lane] = value[lane];
        value[lane] = next;
      }
    }
#pragma omp simd
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const double turned = sum[lane] * x[lane] - imaginary[lane] * y[lane];
      imaginary[lane] = sum[lane] * y[lane] + imaginary[lane] * x[lane] + sumImaginary[lane];
      sum[lane] = turned + sumReal[lane];
    }
  }
}
} // namespace

INSIDEOUT_VECTOR_CLONES
void AddMultipole(
  const Multipole& multipole, int degree, const double (&at)[3][Lanes], double (&w)[Lanes])
{
  double x[Lanes], y[Lanes], z[Lanes], squared[Lanes], sum[Lanes];
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    squared[lane] =
      1 / (at[0][lane] * at[0][lane] + at[1][lane] * at[1][lane] + at[2][lane] * at[2][lane]);
    x[lane] = at[0][lane] * squared[lane];
    y[lane] = at[1][lane] * squared[lane];
    z[lane] = at[2][lane] * squared[lane];
  }
  SumTerms(multipole, degree, x, y, z, squared, sum);
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    w[lane] += sum[lane] * std::sqrt(squared[lane]);
  }
}

INSIDEOUT_VECTOR_CLONES
void AddLocal(const Multipole& local, int degree, const double (&at)[3][Lanes], double (&w)[Lanes])
{
  double squared[Lanes], sum[Lanes];
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    squared[lane] =
      at[0][lane] * at[0][lane] + at[1][lane] * at[1][lane] + at[2][lane] * at[2][lane];
  }
  SumTerms(local, degree, at[0], at[1], at[2], squared, sum);
#pragma omp simd
  for (int lane = 0; lane < Lanes; ++lane)
  {
    w[lane] += sum[lane];
  }
}
} // namespace insideout
