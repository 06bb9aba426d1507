// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flow is exact because it is made of integers. Whichever label a cell gets, it pays the
// smaller of its two data terms; only their difference goes to a terminal. All capacities are
// scaled by one power of two so that the largest is just below 2^52, and rounded. Residual
// capacities are sums and differences of them that stay below twice the largest, so that doubles
// hold them exactly and a saturated edge has exactly 0 left.
#include "GraphCutSegmentation.h"

#include <maxflow.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
using FlowGraph = maxflow::Graph<double, double, double>;

constexpr int CapacityBits = 52;

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

void CheckCells(const std::vector<double>& w)
{
  for (std::size_t i = 0; i < w.size(); ++i)
  {
    if (!std::isfinite(w[i]))
    {
      ThrowInvalid("the winding number of cell " + std::to_string(i) + " is not finite");
    }
  }
}

void CheckFaces(const std::vector<InteriorFace>& faces, std::size_t cells)
{
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const std::string name = "face " + std::to_string(f);
    for (Id cell : { faces[f].First, faces[f].Second })
    {
      if (cell < 0 || static_cast<std::size_t>(cell) >= cells)
      {
        ThrowInvalid(
          name + " refers to cell " + std::to_string(cell) + " of " + std::to_string(cells));
      }
    }
    if (faces[f].First == faces[f].Second)
    {
      ThrowInvalid(name + " has cell " + std::to_string(faces[f].First) + " on both sides");
    }
    if (!std::isfinite(faces[f].Area) || faces[f].Area < 0)
    {
      ThrowInvalid(name + " has an area that is negative or not finite");
    }
  }
}

/** libmaxflow counts nodes and arcs, two per face, in int. */
void CheckSize(std::size_t cells, std::size_t faces)
{
  const std::size_t most = std::numeric_limits<int>::max();
  if (cells > most || faces > most / 2)
  {
    throw Error(ErrorCode::TooLarge,
      std::to_string(cells) + " cells and " + std::to_string(faces) +
        " faces are too many for the graph cut");
  }
}

/** libmaxflow ends the program if this returns; it reports nothing else with the calls made here.
 */
void ThrowOutOfMemory(const char* message)
{
  throw Error(ErrorCode::TooLarge, std::string("graph cut: ") + message);
}

/** Areas over their mean; all 0 if that is. Scaled first, so that the sum cannot overflow. */
std::vector<double> RelativeAreas(const std::vector<InteriorFace>& faces)
{
  double largest = 0;
  for (const InteriorFace& face : faces)
  {
    largest = std::max(largest, face.Area);
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::vector<double> areas;
  areas.reserve(faces.size());
  double sum = 0;
  for (const InteriorFace& face : faces)
  {
    areas.push_back(std::ldexp(face.Area, -exponent));
    sum += areas.back();
  }
  const double mean = sum / static_cast<double>(faces.size());
  for (double& area : areas)
  {
    area = mean > 0 ? area / mean : 0;
  }
  return areas;
}

/** v_ij for different labels, per face (8.10). */
std::vector<double> SmoothnessTerms(
  const std::vector<double>& w, const std::vector<InteriorFace>& faces, double sigma)
{
  std::vector<double> terms = RelativeAreas(faces);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const double step = (w[faces[f].First] - w[faces[f].Second]) / sigma;
    terms[f] *= std::exp(-step * step / 2);
  }
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

/** Positive exactly where w > 1/2 and 0 where it is 1/2, for 1 - w never rounds across 1/2. */
double GainInside(double w)
{
  return CostOutside(w) - CostInside(w);
}

/** The energy's terms as capacities: integers below 2^52. */
struct Capacities
{
  std::vector<double> Cells; ///< from the source where positive, to the sink where negative
  std::vector<double> Faces; ///< both ways
};

/** Scale so that the largest capacity is just below 2^CapacityBits, and round. */
void RoundToIntegers(Capacities& capacities)
{
  double largest = 0;
  for (const std::vector<double>* values : { &capacities.Cells, &capacities.Faces })
  {
    for (double value : *values)
    {
      largest = std::max(largest, std::abs(value));
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const int shift = CapacityBits - 1 - exponent; // one less, for rounding up
  for (double& value : capacities.Faces)
  {
    value = std::nearbyint(std::ldexp(value, shift));
  }
  for (double& value : capacities.Cells)
  {
    // A preference stays one, however small: without smoothness this is an exact threshold.
    const double rounded = std::nearbyint(std::ldexp(value, shift));
    value = rounded != 0 || value == 0 ? rounded : std::copysign(1.0, value);
  }
}

Capacities MakeCapacities(const std::vector<double>& w, const std::vector<InteriorFace>& faces,
  const std::vector<double>& smoothness, double gamma)
{
  // The energy is divided by a power of two that makes gamma at most 1, so that nothing overflows.
  int exponent = 0;
  std::frexp(gamma, &exponent);
  exponent = std::max(exponent, 0);
  const double scaledGamma = std::ldexp(gamma, -exponent);
  Capacities capacities;
  std::vector<double> around(w.size(), 0.0); // capacity of all of a cell's faces
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const double capacity = scaledGamma * smoothness[f];
    capacities.Faces.push_back(capacity);
    around[faces[f].First] += capacity;
    around[faces[f].Second] += capacity;
  }
  for (std::size_t i = 0; i < w.size(); ++i)
  {
    // More than all faces together outweigh decides alone; capping it keeps a cell with a huge
    // winding number from taking the others' digits. Where there is nothing to outweigh, the sign
    // is all that matters.
    const double gain = GainInside(w[i]);
    const double magnitude = std::min(std::ldexp(std::abs(gain), -exponent), 2 * around[i]);
    const double least = std::numeric_limits<double>::denorm_min();
    capacities.Cells.push_back(gain == 0 ? 0 : std::copysign(std::max(magnitude, least), gain));
  }
  RoundToIntegers(capacities);
  return capacities;
}

/**
 * The cells that the source still reaches when the flow is maximal. They are inside in every
 * minimum, so no minimum has fewer.
 */
std::vector<unsigned char> SmallestMinimumCut(
  const Capacities& capacities, const std::vector<InteriorFace>& faces)
{
  const int cells = static_cast<int>(capacities.Cells.size());
  std::vector<unsigned char> inside(capacities.Cells.size(), 0);
  if (cells == 0)
  {
    return inside;
  }
  FlowGraph graph(cells, static_cast<int>(faces.size()), ThrowOutOfMemory);
  graph.add_node(cells);
  for (int i = 0; i < cells; ++i)
  {
    const double capacity = capacities.Cells[i];
    graph.add_tweights(i, std::max(capacity, 0.0), std::max(-capacity, 0.0));
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (capacities.Faces[f] > 0)
    {
      graph.add_edge(faces[f].First, faces[f].Second, capacities.Faces[f], capacities.Faces[f]);
    }
  }
  graph.maxflow();
  for (int i = 0; i < cells; ++i)
  {
    // The second argument is the answer for cells that neither terminal reaches.
    inside[i] = graph.what_segment(i, FlowGraph::SINK) == FlowGraph::SOURCE;
  }
  return inside;
}

double Energy(const std::vector<unsigned char>& inside, const std::vector<double>& w,
  const std::vector<InteriorFace>& faces, const std::vector<double>& smoothness, double gamma)
{
  double data = 0;
  for (std::size_t i = 0; i < w.size(); ++i)
  {
    data += inside[i] ? CostInside(w[i]) : CostOutside(w[i]);
  }
  double cut = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (inside[faces[f].First] != inside[faces[f].Second])
    {
      cut += smoothness[f];
    }
  }
  return data + gamma * cut;
}
} // namespace

Segmentation GraphCutSegmentation(const std::vector<double>& w,
  const std::vector<InteriorFace>& faces, const GraphCutParameters& parameters, Monitor& monitor)
{
  const char* stage = "segmenting";
  monitor.Check(stage, 0);
  CheckParameters(parameters);
  CheckCells(w);
  CheckSize(w.size(), faces.size());
  CheckFaces(faces, w.size());
  const std::vector<double> smoothness = SmoothnessTerms(w, faces, parameters.Sigma);
  const Capacities capacities = MakeCapacities(w, faces, smoothness, parameters.Gamma);
  monitor.Check(stage, 0.2);
  Segmentation result;
  result.Inside = SmallestMinimumCut(capacities, faces);
  result.Energy = Energy(result.Inside, w, faces, smoothness, parameters.Gamma);
  monitor.Check(stage, 1);
  return result;
}
} // namespace insideout
