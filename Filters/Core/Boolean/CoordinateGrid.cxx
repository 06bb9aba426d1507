// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/CoordinateGrid.h"

#include "Common/Floats.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace insideout
{
namespace
{
/** Decimals with fewer digits may be exact; those with more are as precise as doubles. */
constexpr int FewestDigits = 6;
constexpr int MostDigits = 9;

/** Floats need 8 or 9 digits. If all coordinates need fewer, they were decimals before. */
constexpr int MostDigitsOfDecimalsInFloats = 7;

/**
 * Number of absolute coordinates that have to need all digits except one. A box along the axes has
 * only six coordinates, which may be exact by design.
 */
constexpr std::size_t LeastEvidence = 8;

struct DecimalNumber
{
  int Digits;   ///< significant ones
  int Decimals; ///< decimal places; negative if the last digit stands before the point
};

/** The shortest decimal number that rounds to x. */
template <typename Real>
DecimalNumber ShortestDecimal(Real x)
{
  std::array<char, 32> text;
  const auto end =
    std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific);
  const std::string written(text.data(), end.ptr);
  const std::size_t exponentAt = written.find('e');
  const int digits = static_cast<int>(
    std::count_if(written.begin(), written.begin() + static_cast<std::ptrdiff_t>(exponentAt),
      [](char c) { return c >= '0' && c <= '9'; }));
  return { digits, digits - 1 - std::atoi(written.c_str() + exponentAt + 1) };
}

/** The decimal grid of absolute coordinates, if they lie on one. */
template <typename Real>
std::optional<CoordinateGrid> FindDecimals(const std::vector<double>& sizes, int mostDigits)
{
  DecimalNumber most = { 0, 0 };
  std::array<std::size_t, MostDigits + 1> withDigits{};
  for (const double size : sizes)
  {
    const DecimalNumber number = ShortestDecimal(static_cast<Real>(size));
    if (number.Digits > mostDigits)
    {
      return std::nullopt;
    }
    ++withDigits[number.Digits];
    most.Digits = std::max(most.Digits, number.Digits);
    most.Decimals = std::max(most.Decimals, number.Decimals);
  }
  const std::size_t evidence =
    most.Digits == 0 ? 0 : withDigits[most.Digits] + withDigits[most.Digits - 1];
  return most.Digits >= FewestDigits && evidence >= LeastEvidence
    ? CoordinateGrid(most.Digits, most.Decimals)
    : CoordinateGrid();
}
} // namespace

double CoordinateGrid::RoundingAt(double coordinate) const
{
  const double size = std::abs(coordinate);
  if (size == 0)
  {
    return 0;
  }
  if (this->Digits == 0)
  {
    return std::ldexp(1.0, std::ilogb(size) - 24);
  }
  const double exponent = std::floor(std::log10(size));
  return 0.5 *
    std::max(std::pow(10.0, exponent + 1 - this->Digits), std::pow(10.0, -this->Decimals));
}

std::optional<CoordinateGrid> FindCoordinateGrid(const std::vector<Point>& points)
{
  bool areFloats = true;
  std::vector<double> sizes;
  for (const Point& p : points)
  {
    if (!IsFinite(p))
    {
      continue;
    }
    for (const double x : p)
    {
      if (areFloats && !IsFloat(x))
      {
        areFloats = false;
        if (ShortestDecimal(x).Digits > MostDigits)
        {
          return std::nullopt; // most doubles end here
        }
      }
      if (x != 0)
      {
        sizes.push_back(std::abs(x));
      }
    }
  }
  if (!areFloats)
  {
    SortUniquely(sizes);
    return FindDecimals<double>(sizes, MostDigits);
  }
  SortUniquely(sizes);
  const auto decimals = FindDecimals<float>(sizes, MostDigitsOfDecimalsInFloats);
  return decimals ? decimals : CoordinateGrid();
}
} // namespace insideout
