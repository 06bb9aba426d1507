// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"
#include "GraphCut/RealEnergy.h"

/** What the cut and its constraints promise, found by other means. */
namespace testcut
{
using namespace insideout;

/** v_ij for different labels, per face, as RealEnergy.h has it. */
std::vector<double> Smoothness(const CellGraph& graph, const GraphCutParameters& parameters);

/** E of a labelling, term by term. */
double EnergyOf(const CellGraph& graph, const GraphCutParameters& parameters,
  const std::vector<unsigned char>& inside);

/**
 * The least E of all labellings, by Boost's maximum flow on the whole graph in 64-bit integers.
 * Without demands.
 */
double LeastEnergy(const CellGraph& graph, const GraphCutParameters& parameters);

/** Edges of the inside cells' boundary that do not have two of its faces, and points whose faces
 * are not one fan; counted without the mesh's neighbors. */
struct NotManifold
{
  int Edges = 0;
  int Points = 0;
};
NotManifold CountNotManifold(
  const std::vector<Tetrahedron>& cells, const std::vector<unsigned char>& inside);
} // namespace testcut
