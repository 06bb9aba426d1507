// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/FarField.h"

#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"

#include <cmath>

namespace insideout
{
namespace
{
/** Indices of pairs of axes in SecondAxes. */
int PairOf(int j, int k)
{
  return j == k ? j : j + k == 1 ? 3 : j + k == 3 ? 4 : 5;
}

/** The sum of m_ij r_j for each i. */
Point Applied(const std::array<double, 6>& m, const Point& r)
{
  return { m[0] * r[0] + m[3] * r[1] + m[5] * r[2], m[3] * r[0] + m[1] * r[1] + m[4] * r[2],
    m[5] * r[0] + m[4] * r[1] + m[2] * r[2] };
}

/** The sum of t_ijk r_j r_k for each i. */
Point TwiceApplied(const std::array<double, 10>& t, const Point& r)
{
  const double xx = r[0] * r[0];
  const double yy = r[1] * r[1];
  const double zz = r[2] * r[2];
  const double xy = 2 * r[0] * r[1];
  const double xz = 2 * r[0] * r[2];
  const double yz = 2 * r[1] * r[2];
  return { t[0] * xx + t[5] * yy + t[7] * zz + t[3] * xy + t[4] * xz + t[9] * yz,
    t[3] * xx + t[1] * yy + t[8] * zz + t[5] * xy + t[9] * xz + t[6] * yz,
    t[4] * xx + t[6] * yy + t[2] * zz + t[9] * xy + t[7] * xz + t[8] * yz };
}

/** The sum of t_ijj over j for each i. */
Point Traces(const std::array<double, 10>& t)
{
  return { t[0] + t[5] + t[7], t[3] + t[1] + t[8], t[4] + t[6] + t[2] };
}
} // namespace

void FarField::Add(const Point& n, const Point& mean, const std::array<double, 6>& meanOfProducts)
{
  for (int i = 0; i < 3; ++i)
  {
    this->First[i] += n[i];
  }
  for (std::size_t s = 0; s < SecondAxes.size(); ++s)
  {
    const auto& [i, j] = SecondAxes[s];
    this->Second[s] += (n[i] * mean[j] + n[j] * mean[i]) / 2;
  }
  const auto product = [&](int j, int k) { return meanOfProducts[PairOf(j, k)]; };
  for (std::size_t s = 0; s < ThirdAxes.size(); ++s)
  {
    const auto& [i, j, k] = ThirdAxes[s];
    this->Third[s] += (n[i] * product(j, k) + n[j] * product(i, k) + n[k] * product(i, j)) / 3;
  }
}

void FarField::AddDipole(const Point& n, const Point& d)
{
  std::array<double, 6> products;
  for (std::size_t s = 0; s < SecondAxes.size(); ++s)
  {
    products[s] = d[SecondAxes[s][0]] * d[SecondAxes[s][1]];
  }
  this->Add(n, d, products);
}

/**
 * The moments times g(r) = r / |r|^3 and its derivatives
 *
 *     d_j g_i = delta_ij / r^3 - 3 r_i r_j / r^5   and, half of it,
 *     d_j d_k g_i = -3 (delta_ij r_k + delta_jk r_i + delta_ik r_j) / r^5 + 15 r_i r_j r_k / r^7.
 */
double FarField::At(const Point& r, int terms) const
{
  const double inverse = 1 / std::sqrt(Dot(r, r));
  const double inverse2 = inverse * inverse;
  const double inverse3 = inverse * inverse2;
  const double inverse5 = inverse3 * inverse2;
  double sum = Dot(this->First, r) * inverse3;
  if (terms >= 2)
  {
    const auto& m = this->Second;
    sum += (m[0] + m[1] + m[2]) * inverse3 - 3 * Dot(r, Applied(m, r)) * inverse5;
  }
  if (terms >= 3)
  {
    sum += -4.5 * Dot(Traces(this->Third), r) * inverse5 +
      7.5 * Dot(r, TwiceApplied(this->Third, r)) * inverse5 * inverse2;
  }
  return sum / (4 * Pi);
}

/** The terms' derivatives by the place: those by r, negated. */
Point FarField::Gradient(const Point& r) const
{
  const double inverse2 = 1 / Dot(r, r);
  const double inverse3 = inverse2 * std::sqrt(inverse2);
  const double inverse5 = inverse3 * inverse2;
  const double inverse7 = inverse5 * inverse2;
  const auto& m = this->Second;
  const Point mr = Applied(m, r);
  const Point traces = Traces(this->Third);
  const Point trr = TwiceApplied(this->Third, r);
  const double along = -3 * (Dot(this->First, r) + m[0] + m[1] + m[2]) * inverse5 +
    (15 * Dot(r, mr) + 22.5 * Dot(traces, r)) * inverse7 - 52.5 * Dot(r, trr) * inverse7 * inverse2;
  Point gradient;
  for (int i = 0; i < 3; ++i)
  {
    const double rise = this->First[i] * inverse3 - (6 * mr[i] + 4.5 * traces[i]) * inverse5 +
      22.5 * trr[i] * inverse7 + along * r[i];
    gradient[i] = -rise / (4 * Pi);
  }
  return gradient;
}
} // namespace insideout
