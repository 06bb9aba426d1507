// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ArgumentSum.h"

#include <array>

namespace insideout
{
namespace
{
/** Points of a leaf: their arctangents cost about as much as a series. */
constexpr std::size_t LeafSize = 8;

/** Series terms needed at this many radii or farther: the truncation error is then below 2^-53 per
 * point. */
struct Precision
{
  double Radii;
  int Terms;
};
constexpr std::array<Precision, 3> Precisions = { { { 100, 8 }, { 10, 16 }, { 3, 32 } } };
constexpr std::size_t MostTerms = 32;

/** At smaller distances squares underflow. */
constexpr double LeastDistance = 1e-140;
} // namespace

CountsAbove::CountsAbove(std::vector<std::pair<double, double>> counted)
  : Counted(std::move(counted))
{
  std::sort(this->Counted.begin(), this->Counted.end());
  double sum = 0;
  for (auto one = this->Counted.rbegin(); one != this->Counted.rend(); ++one)
  {
    sum += one->second;
    one->second = sum;
  }
}

ArgumentSum::ArgumentSum(std::vector<CountedPlace> places, const PlanarMetric& metric)
  : Places(std::move(places))
  , Metric(metric)
{
  if (!this->Places.empty())
  {
    this->Build(0, this->Places.size());
  }
}

ArgumentSum::Complex ArgumentSum::Direction(const PlanarPoint& offset) const
{
  const PlanarPoint mapped = this->Metric.Map(offset);
  return { mapped[0] + 0.0, mapped[1] + 0.0 }; // adding 0: no -0
}

void ArgumentSum::Build(std::size_t begin, std::size_t end)
{
  const std::size_t index = this->Nodes.size();
  PlanarPoint low = this->Places[begin].Place;
  PlanarPoint high = low;
  for (std::size_t i = begin; i < end; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], this->Places[i].Place[k]);
      high[k] = std::max(high[k], this->Places[i].Place[k]);
    }
  }
  Node node = { { low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2 }, 0, 0, begin, end, 0,
    this->Moments.size(), {} };
  std::vector<std::pair<double, double>> heights;
  this->Moments.resize(this->Moments.size() + MostTerms);
  for (std::size_t i = begin; i < end; ++i)
  {
    const auto& [place, count] = this->Places[i];
    const Complex offset =
      this->Direction({ place[0] - node.Center[0], place[1] - node.Center[1] });
    heights.emplace_back(place[1], count);
    node.Radius = std::max(node.Radius, std::abs(offset));
    node.Count += count;
    Complex power = count;
    for (std::size_t k = 0; k < MostTerms; ++k)
    {
      power *= -offset;
      this->Moments[node.Moments + k] -= power / static_cast<double>(k + 1);
    }
  }
  node.Above = CountsAbove(std::move(heights));
  this->Nodes.push_back(std::move(node));
  if (end - begin > LeafSize)
  {
    const int axis = high[0] - low[0] > high[1] - low[1] ? 0 : 1;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto first = this->Places.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin),
      first + static_cast<std::ptrdiff_t>(middle), first + static_cast<std::ptrdiff_t>(end),
      [axis](const CountedPlace& a, const CountedPlace& b)
      { return a.Place[axis] < b.Place[axis]; });
    this->Build(begin, middle);
    this->Build(middle, end);
  }
  this->Nodes[index].Next = this->Nodes.size();
}

/** Number of terms for a node's series, with the center in the given direction; 0 if too near. */
int ArgumentSum::TermsFor(const Node& node, const Complex& center)
{
  const double distance = std::sqrt(std::norm(center));
  const auto precision = std::find_if(Precisions.begin(), Precisions.end(),
    [&](const Precision& one)
    { return distance > std::max(one.Radii * node.Radius, LeastDistance); });
  return precision == Precisions.end() ? 0 : precision->Terms;
}

/** Whether a far node certainly does not meet the ray. A node that may meet it lies entirely to the
 * left. */
bool ArgumentSum::IsBesideRay(const Node& node, const Complex& center)
{
  return center.real() > 0 || std::abs(center.imag()) > 2 * node.Radius;
}

/**
 * The sum over a node with the center in the given direction, taking its arguments as close to the
 * center's.
 */
double ArgumentSum::FarField(const Node& node, const Complex& center, int terms) const
{
  const Complex inverse = std::conj(center) / std::norm(center);
  const Complex* moments = &this->Moments[node.Moments];
  double re = 0; // Horner's rule, by hand: products of std::complex check for infinities
  double im = 0;
  for (int k = terms; k-- > 0;)
  {
    const double x = re + moments[k].real();
    const double y = im + moments[k].imag();
    re = x * inverse.real() - y * inverse.imag();
    im = x * inverse.imag() + y * inverse.real();
  }
  return node.Count * std::atan2(center.imag(), center.real()) + im;
}
} // namespace insideout
