// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/RealEnergy.h"

#include "Common/Error.h"
#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerFace = 7; // for the exponential; a division takes half of it

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
} // namespace

RealEnergy::RealEnergy(const CellGraph& graph, const GraphCutParameters& parameters)
  : Graph(graph)
  , SmoothnessWeight(parameters.Gamma)
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
  this->OfFaces = SmoothnessTerms(graph, parameters.Sigma);
}

double RealEnergy::Gain(Id cell) const
{
  return this->Weight(cell) * GainInside(this->Graph.W[cell]);
}

double RealEnergy::Of(const std::vector<unsigned char>& inside) const
{
  double data = 0;
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    const double w = this->Graph.W[i];
    data += this->Weight(static_cast<Id>(i)) * (inside[i] ? CostInside(w) : CostOutside(w));
  }
  double cut = 0;
  for (std::size_t f = 0; f < this->OfFaces.size(); ++f)
  {
    if (inside[this->Graph.Faces[f].First] != inside[this->Graph.Faces[f].Second])
    {
      cut += this->OfFaces[f];
    }
  }
  return data + this->SmoothnessWeight * cut;
}

bool IsCutByWholeNumbers(const GraphCutParameters& cut)
{
  const GraphCutParameters most;
  return cut.DataTerm == DataTerm::Uniform && cut.Gamma <= most.Gamma && cut.Sigma <= most.Sigma;
}
} // namespace insideout
