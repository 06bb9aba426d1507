// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/CutEnergy.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insideout
{
namespace
{
/** The terms around a cell sum to less than 2 to this power, so that doubles hold their sums
 * exactly. */
constexpr int TermBits = 52;

constexpr double NanosecondsPerFace = 7; // for the exponential; rounding takes half of it
constexpr double NanosecondsPerCell = 20;

[[noreturn]] void ThrowInvalid(const std::string& message)
{
  throw Error(ErrorCode::InvalidParameter, message);
}

void CheckParameters(const GraphCutParameters& parameters)
{
  if (!std::isfinite(parameters.Gamma) || parameters.Gamma < 0)
  {
    ThrowInvalid("gamma is " + std::to_string(parameters.Gamma) + ", not a number of at least 0");
  }
  if (!std::isfinite(parameters.Sigma) || parameters.Sigma <= 0)
  {
    ThrowInvalid("sigma is " + std::to_string(parameters.Sigma) + ", not a number above 0");
  }
}

void CheckCells(const CellGraph& graph, DataTerm term)
{
  const auto checkSize = [&](std::size_t size, const char* what)
  {
    if (size != graph.W.size())
    {
      ThrowInvalid(std::to_string(size) + " " + what + " for " + std::to_string(graph.W.size()) +
        " winding numbers");
    }
  };
  const bool weighted = term == DataTerm::VolumeWeighted;
  checkSize(weighted ? graph.Volumes.size() : graph.W.size(), "volumes");
  checkSize(graph.Demands.empty() ? graph.W.size() : graph.Demands.size(), "demands");
  for (std::size_t i = 0; i < graph.W.size(); ++i)
  {
    if (!std::isfinite(graph.W[i]))
    {
      ThrowInvalid("the winding number of cell " + std::to_string(i) + " is not finite");
    }
    if (weighted && (!std::isfinite(graph.Volumes[i]) || graph.Volumes[i] < 0))
    {
      ThrowInvalid("cell " + std::to_string(i) + " has a volume that is negative or not finite");
    }
  }
}

void CheckFaces(const std::vector<InteriorFace>& faces, std::size_t cells)
{
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (const Id cell : { faces[f].First, faces[f].Second })
    {
      if (cell < 0 || static_cast<std::size_t>(cell) >= cells)
      {
        ThrowInvalid("face " + std::to_string(f) + " refers to cell " + std::to_string(cell) +
          " of " + std::to_string(cells));
      }
    }
    if (faces[f].First == faces[f].Second)
    {
      ThrowInvalid("face " + std::to_string(f) + " has cell " + std::to_string(faces[f].First) +
        " on both sides");
    }
    if (!std::isfinite(faces[f].Area) || faces[f].Area < 0)
    {
      ThrowInvalid("face " + std::to_string(f) + " has an area that is negative or not finite");
    }
  }
}

void CheckSize(std::size_t cells)
{
  if (cells > static_cast<std::size_t>(std::numeric_limits<Id>::max()))
  {
    throw Error(
      ErrorCode::TooLarge, std::to_string(cells) + " cells are too many for the graph cut");
  }
}

/**
 * Values divided by their mean; all 0 if the mean is. Scaled first, so that the sum cannot
 * overflow.
 */
void DivideByMean(RawVector<double>& values)
{
  double largest = 0;
  for (const double value : values)
  {
    largest = std::max(largest, value);
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  ParallelLoop(values.size(), NanosecondsPerFace,
    [&](std::size_t i) { values[i] = std::ldexp(values[i], -exponent); });
  const double sum = std::accumulate(values.begin(), values.end(), 0.0); // in one order: it rounds
  const double mean = sum / static_cast<double>(values.size());
  ParallelLoop(values.size(), NanosecondsPerFace,
    [&](std::size_t i) { values[i] = mean > 0 ? values[i] / mean : 0; });
}

/** v_ij for different labels, per face (8.10). */
RawVector<double> SmoothnessTerms(const CellGraph& graph, double sigma)
{
  RawVector<double> terms(graph.Faces.size());
  ParallelLoop(
    terms.size(), NanosecondsPerFace, [&](std::size_t f) { terms[f] = graph.Faces[f].Area; });
  DivideByMean(terms);
  ParallelLoop(terms.size(), NanosecondsPerFace,
    [&](std::size_t f)
    {
      const double step = (graph.W[graph.Faces[f].First] - graph.W[graph.Faces[f].Second]) / sigma;
      terms[f] *= step == 0 ? 1 : std::exp(-step * step / 2);
    });
  return terms;
}

double CostOutside(double w)
{
  return std::max(w, 0.0);
}

double CostInside(double w)
{
  return std::max(1 - w, 0.0);
}

/** Positive exactly if w > 1/2, and 0 if w is 1/2, because 1 - w never rounds across 1/2. */
double GainInside(double w)
{
  return CostOutside(w) - CostInside(w);
}

/** A value of at least 0 times 2^shift, rounded. The result is below 2^TermBits. */
std::int64_t ToInteger(double value, int shift)
{
  return static_cast<std::int64_t>(std::ldexp(value, shift) + 0.5);
}
} // namespace

CutEnergy::CutEnergy(const CellGraph& graph, const GraphCutParameters& parameters)
  : Graph(graph)
  , Gamma(parameters.Gamma)
{
  CheckParameters(parameters);
  CheckSize(graph.W.size());
  CheckCells(graph, parameters.DataTerm);
  CheckFaces(graph.Faces, graph.W.size());
  if (parameters.DataTerm == DataTerm::VolumeWeighted)
  {
    this->Weights.assign(graph.Volumes.begin(), graph.Volumes.end());
    DivideByMean(this->Weights);
  }
  this->Smoothness = SmoothnessTerms(graph, parameters.Sigma);
  this->MakeIntegers();
}

void CutEnergy::MakeIntegers()
{
  const std::vector<InteriorFace>& faces = this->Graph.Faces;
  const std::size_t cells = this->Graph.W.size();
  // The energy is divided by a power of two that makes gamma at most 1, to prevent overflow.
  int gammaExponent = 0;
  std::frexp(this->Gamma, &gammaExponent);
  gammaExponent = std::max(gammaExponent, 0);
  const double scaledGamma = std::ldexp(this->Gamma, -gammaExponent);
  std::vector<double> around(cells, 0.0); // the costs of all of a cell's faces
  double largest = std::numeric_limits<double>::min();
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const double cost = scaledGamma * this->Smoothness[f];
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

  RawVector<std::int64_t> costs(faces.size());
  ParallelLoop(faces.size(), NanosecondsPerFace,
    [&](std::size_t f) { costs[f] = ToInteger(scaledGamma * this->Smoothness[f], shift); });
  this->ListNeighbors(costs);

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
      const double gain = GainInside(this->W(cell));
      const double scaled = std::ldexp(std::abs(gain), -gammaExponent) * this->Weight(cell);
      // A preference keeps its sign, however small: without smoothness this is an exact threshold.
      const std::int64_t least = std::max<std::int64_t>(
        1, scaled < 2 * around[i] ? std::min(ToInteger(scaled, shift), 2 * all) : 2 * all);
      const int demand = this->Demand(cell);
      this->Gains[i] = demand != 0 ? demand * (2 * all + 1)
        : gain > 0                 ? least
        : gain < 0                 ? -least
                                   : 0;
    });
}

void CutEnergy::ListNeighbors(const RawVector<std::int64_t>& costs)
{
  const std::vector<InteriorFace>& faces = this->Graph.Faces;
  this->NeighborsOfCells =
    Buckets<Neighbor>::Unordered(this->Graph.W.size(), faces.size(), NanosecondsPerFace,
      [&](std::size_t f, const auto& visit)
      {
        if (costs[f] > 0)
        {
          const Id first = faces[f].First;
          const Id second = faces[f].Second;
          const auto face = static_cast<std::uint32_t>(f);
          visit(static_cast<std::size_t>(first), Neighbor{ second, face, costs[f] });
          visit(static_cast<std::size_t>(second), Neighbor{ first, face, costs[f] });
        }
      });
}

double CutEnergy::ExtraInside(Id cell) const
{
  return -this->Weight(cell) * GainInside(this->W(cell));
}

double CutEnergy::CostInEnergy(const Neighbor& neighbor) const
{
  return std::ldexp(static_cast<double>(neighbor.Cost), -this->Shift);
}

double CutEnergy::Of(const std::vector<unsigned char>& inside) const
{
  double data = 0;
  for (Id i = 0; i < this->NumberOfCells(); ++i)
  {
    data += this->Weight(i) * (inside[i] ? CostInside(this->W(i)) : CostOutside(this->W(i)));
  }
  double cut = 0;
  for (std::size_t f = 0; f < this->Smoothness.size(); ++f)
  {
    if (inside[this->Graph.Faces[f].First] != inside[this->Graph.Faces[f].Second])
    {
      cut += this->Smoothness[f];
    }
  }
  return data + this->Gamma * cut;
}

bool IsCutByWholeNumbers(const GraphCutParameters& cut)
{
  const GraphCutParameters most;
  return cut.DataTerm == DataTerm::Uniform && cut.Gamma <= most.Gamma && cut.Sigma <= most.Sigma;
}
} // namespace insideout
