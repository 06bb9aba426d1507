// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/CutEnergy.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace insideout
{
namespace
{
/** The terms around a cell sum to less than 2 to this power, so that doubles hold their sums
 * exactly. */
constexpr int TermBits = 52;

constexpr double NanosecondsPerFace = 4; // to round
constexpr double NanosecondsPerCell = 20;

/** A value of at least 0 times 2^shift, rounded. The result is below 2^TermBits. */
std::int64_t ToInteger(double value, int shift)
{
  return static_cast<std::int64_t>(std::ldexp(value, shift) + 0.5);
}
} // namespace

CutEnergy::CutEnergy(RealEnergy energy)
  : Energy(std::move(energy))
{
  const std::vector<InteriorFace>& faces = this->Cells().Faces;
  const std::size_t cells = this->Cells().W.size();
  const double gamma = this->Energy.Gamma();
  // The energy is divided by a power of two that makes gamma at most 1, to prevent overflow.
  int gammaExponent = 0;
  std::frexp(gamma, &gammaExponent);
  gammaExponent = std::max(gammaExponent, 0);
  const double scaledGamma = std::ldexp(gamma, -gammaExponent);
  std::vector<double> around(cells, 0.0); // the costs of all of a cell's faces
  double largest = std::numeric_limits<double>::min();
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const double cost = scaledGamma * this->Energy.Smoothness(f);
    around[faces[f].First] += cost;
    around[faces[f].Second] += cost;
  }
  for (const double sum : around)
  {
    largest = std::max(largest, sum);
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  // a gain may be twice the sum of faces, and all may round up
  const int shift = TermBits - 3 - exponent;
  this->Shift = shift - gammaExponent;

  this->NeighborsOfCells = Buckets<Neighbor>::Unordered(cells, faces.size(), NanosecondsPerFace,
    [&](std::size_t f, const auto& visit)
    {
      const std::int64_t cost = ToInteger(scaledGamma * this->Energy.Smoothness(f), shift);
      if (cost > 0)
      {
        const auto& [first, second, area] = faces[f];
        const auto face = static_cast<std::uint32_t>(f);
        visit(static_cast<std::size_t>(first), Neighbor{ second, face, cost });
        visit(static_cast<std::size_t>(second), Neighbor{ first, face, cost });
      }
    });

  this->Gains.resize(cells);
  ParallelLoop(cells, NanosecondsPerCell,
    [&](std::size_t i)
    {
      const Id cell = static_cast<Id>(i);
      this->NeighborsOfCells.Sort(
        i, [](const Neighbor& a, const Neighbor& b) { return a.Face < b.Face; });
      std::int64_t all = 0;
      for (const Neighbor& neighbor : this->Neighbors(cell))
      {
        all += neighbor.Cost;
      }
      const double scaled = std::ldexp(std::abs(this->Energy.Gain(cell)), -gammaExponent);
      // A preference keeps its sign, however small: without smoothness this is an exact threshold.
      const std::int64_t least = std::max<std::int64_t>(
        1, scaled < 2 * around[i] ? std::min(ToInteger(scaled, shift), 2 * all) : 2 * all);
      const int demand = this->Demand(cell);
      this->Gains[i] = demand != 0 ? demand * (2 * all + 1)
        : this->W(cell) > 0.5      ? least
        : this->W(cell) < 0.5      ? -least
                                   : 0;
    });
}

double CutEnergy::CostInEnergy(const Neighbor& neighbor) const
{
  return std::ldexp(static_cast<double>(neighbor.Cost), -this->Shift);
}
} // namespace insideout
