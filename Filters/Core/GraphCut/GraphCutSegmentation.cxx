// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/GraphCutSegmentation.h"

#include "Common/Stages.h"
#include "GraphCut/CertainCells.h"

#include <maxflow.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>

namespace insideout
{
namespace
{
/**
 * Capacities are integers below 2^52: residual capacities stay below twice that, so that doubles
 * hold them exactly and a saturated edge has exactly 0 left. The library has no 64-bit integers
 * compiled in.
 */
using FlowGraph = maxflow::Graph<double, double, double>;

/** libmaxflow ends the program if this returns; it reports nothing else with the calls made here.
 */
void ThrowOutOfMemory(const char*)
{
  throw std::bad_alloc();
}

/** The open cells, numbered, and the faces between them. */
class OpenGraph
{
public:
  OpenGraph(const CutEnergy& energy, const CertainCells& certain)
    : Cells(certain.Open())
  {
    std::vector<Id> node(energy.NumberOfCells(), None);
    for (std::size_t k = 0; k < this->Cells.size(); ++k)
    {
      node[this->Cells[k]] = static_cast<Id>(k);
    }
    const auto forEachEdge = [&](auto visit)
    {
      for (const Id cell : this->Cells)
      {
        for (const CutEnergy::Neighbor& next : energy.Neighbors(cell))
        {
          if (next.Cell > cell && certain.IsOpen(next.Cell))
          {
            visit(node[cell], node[next.Cell], static_cast<double>(next.Cost));
          }
        }
      }
    };
    std::size_t edges = 0;
    forEachEdge([&](Id, Id, double) { ++edges; });
    if (edges > static_cast<std::size_t>(std::numeric_limits<int>::max() / 2))
    {
      throw Error(ErrorCode::TooLarge, // libmaxflow counts arcs, two per face, in int
        std::to_string(edges) + " faces whose label is open are too many for the graph cut");
    }
    this->Graph = std::make_unique<FlowGraph>(
      static_cast<int>(this->Cells.size()), static_cast<int>(edges), ThrowOutOfMemory);
    this->Graph->add_node(static_cast<int>(this->Cells.size()));
    for (std::size_t k = 0; k < this->Cells.size(); ++k)
    {
      const double gain = static_cast<double>(certain.Gain(this->Cells[k]));
      this->Graph->add_tweights(static_cast<int>(k), std::max(gain, 0.0), std::max(-gain, 0.0));
    }
    forEachEdge([&](Id a, Id b, double cost) { this->Graph->add_edge(a, b, cost, cost); });
  }

  /**
   * Label the cells that the source still reaches at maximum flow. They are inside in every
   * minimum, so no minimum has fewer cells.
   */
  void Cut(std::vector<unsigned char>& inside)
  {
    this->Graph->maxflow();
    for (std::size_t k = 0; k < this->Cells.size(); ++k)
    {
      // The second argument is the answer for cells that neither terminal reaches.
      inside[this->Cells[k]] =
        this->Graph->what_segment(static_cast<int>(k), FlowGraph::SINK) == FlowGraph::SOURCE;
    }
  }

private:
  const std::vector<Id>& Cells;
  std::unique_ptr<FlowGraph> Graph;
};
} // namespace

std::vector<unsigned char> MinimumCut(const CutEnergy& energy)
{
  const CertainCells certain(energy);
  std::vector<unsigned char> inside(energy.NumberOfCells(), 0);
  for (Id cell = 0; cell < energy.NumberOfCells(); ++cell)
  {
    inside[cell] = certain.IsInside(cell);
  }
  if (!certain.Open().empty())
  {
    OpenGraph(energy, certain).Cut(inside);
  }
  return inside;
}

Segmentation GraphCutSegmentation(
  const CellGraph& graph, const GraphCutParameters& parameters, Monitor& monitor)
{
  monitor.Check(Stages::Segmenting, 0);
  const CutEnergy energy{ RealEnergy(graph, parameters) };
  monitor.Check(Stages::Segmenting, 0.2);
  Segmentation result;
  result.Inside = MinimumCut(energy);
  result.Energy = energy.Of(result.Inside);
  monitor.Check(Stages::Segmenting, 1);
  return result;
}
} // namespace insideout
