// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/CutReference.h"

// In optimized builds gcc 12 suspects uninitialized values all over Boost's algorithm.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace testcut
{
namespace
{
using Capacity = std::int64_t;
using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using Edge = Traits::edge_descriptor;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS,
  boost::property<boost::vertex_index_t, long,
    boost::property<boost::vertex_color_t, boost::default_color_type,
      boost::property<boost::vertex_distance_t, long,
        boost::property<boost::vertex_predecessor_t, Edge>>>>,
  boost::property<boost::edge_capacity_t, Capacity,
    boost::property<boost::edge_residual_capacity_t, Capacity,
      boost::property<boost::edge_reverse_t, Edge>>>>;

/** The factor of each cell's data term. */
std::vector<double> Weights(const CellGraph& graph, const GraphCutParameters& parameters)
{
  if (parameters.DataTerm == DataTerm::Uniform)
  {
    return std::vector<double>(graph.W.size(), 1);
  }
  std::vector<double> weights = graph.Volumes;
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights)
  {
    weight *= static_cast<double>(weights.size()) / sum;
  }
  return weights;
}
} // namespace

std::vector<double> Smoothness(const CellGraph& graph, const GraphCutParameters& parameters)
{
  double sum = 0;
  for (const InteriorFace& face : graph.Faces)
  {
    sum += face.Area;
  }
  std::vector<double> terms;
  for (const InteriorFace& face : graph.Faces)
  {
    const double step = graph.W[face.First] - graph.W[face.Second];
    terms.push_back(face.Area / (sum / static_cast<double>(graph.Faces.size())) *
      std::exp(-step * step / (2 * parameters.Sigma * parameters.Sigma)));
  }
  return terms;
}

double EnergyOf(const CellGraph& graph, const GraphCutParameters& parameters,
  const std::vector<unsigned char>& inside)
{
  const std::vector<double> weights = Weights(graph, parameters);
  const std::vector<double> smoothness = Smoothness(graph, parameters);
  double energy = 0;
  for (std::size_t i = 0; i < graph.W.size(); ++i)
  {
    const double w = graph.W[i];
    energy += weights[i] * (inside[i] ? std::max(1 - w, 0.0) : std::max(w, 0.0));
  }
  for (std::size_t f = 0; f < graph.Faces.size(); ++f)
  {
    if (inside[graph.Faces[f].First] != inside[graph.Faces[f].Second])
    {
      energy += parameters.Gamma * smoothness[f];
    }
  }
  return energy;
}

double LeastEnergy(const CellGraph& graph, const GraphCutParameters& parameters)
{
  const std::vector<double> weights = Weights(graph, parameters);
  const std::vector<double> smoothness = Smoothness(graph, parameters);
  const int cells = static_cast<int>(graph.W.size());
  double all = 0;
  for (int i = 0; i < cells; ++i)
  {
    all += weights[i] * std::max(graph.W[i], 0.0);
  }
  const double unit = std::ldexp(1, std::max(std::ilogb(all), 0) - 60); // the flow fits in 63 bits
  const double most = std::ldexp(unit, 61); // larger than any flow: as good as infinite
  Graph boost(cells + 2);
  const auto add = [&](int a, int b, double forth, double back)
  {
    const Edge ab = boost::add_edge(a, b, boost).first;
    const Edge ba = boost::add_edge(b, a, boost).first;
    boost::put(boost::edge_capacity, boost, ab, std::llround(std::min(forth, most) / unit));
    boost::put(boost::edge_capacity, boost, ba, std::llround(std::min(back, most) / unit));
    boost::put(boost::edge_reverse, boost, ab, ba);
    boost::put(boost::edge_reverse, boost, ba, ab);
  };
  for (int i = 0; i < cells; ++i)
  {
    add(cells, i, weights[i] * std::max(graph.W[i], 0.0), 0);
    add(i, cells + 1, weights[i] * std::max(1 - graph.W[i], 0.0), 0);
  }
  for (std::size_t f = 0; f < graph.Faces.size(); ++f)
  {
    const double capacity = parameters.Gamma * smoothness[f];
    add(graph.Faces[f].First, graph.Faces[f].Second, capacity, capacity);
  }
  return unit * static_cast<double>(boost::boykov_kolmogorov_max_flow(boost, cells, cells + 1));
}

NotManifold CountNotManifold(
  const std::vector<Tetrahedron>& cells, const std::vector<unsigned char>& inside)
{
  std::map<std::set<Id>, int> faces; // how many inside cells have them
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (int left = 0; inside[c] && left < 4; ++left)
    {
      std::set<Id> face(cells[c].begin(), cells[c].end());
      face.erase(cells[c][left]);
      ++faces[face];
    }
  }
  std::map<std::set<Id>, std::vector<std::set<Id>>> around; // boundary faces of each edge
  std::map<Id, std::vector<std::set<Id>>> at;               // and point
  for (const auto& [face, sides] : faces)
  {
    for (const Id p : face)
    {
      if (sides == 1)
      {
        std::set<Id> edge = face;
        edge.erase(p);
        around[edge].push_back(face);
        at[p].push_back(face);
      }
    }
  }
  NotManifold count;
  for (const auto& edge : around)
  {
    count.Edges += edge.second.size() != 2;
  }
  for (const auto& [point, fan] : at)
  {
    // Walk from face to face across edges at the point; one fan is reached as a whole.
    std::set<std::set<Id>> reached = { fan.front() };
    std::vector<std::set<Id>> next = { fan.front() };
    while (!next.empty())
    {
      const std::set<Id> face = next.back();
      next.pop_back();
      for (const Id p : face)
      {
        for (const std::set<Id>& other :
          p == point ? std::vector<std::set<Id>>() : around[{ p, point }])
        {
          if (reached.insert(other).second)
          {
            next.push_back(other);
          }
        }
      }
    }
    count.Points += reached.size() != fan.size();
  }
  return count;
}
} // namespace testcut
