// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <vector>

namespace insideout
{
/** Removes points that are on no facet, by contracting an edge to a neighbor. */
class Contraction
{
public:
  explicit Contraction(RefinableMesh& mesh)
    : Mesh(mesh)
  {
  }

  /**
   * Contract a point into the neighbor that gives the best cells, if their shapes are above
   * `wanted` and no edge gets longer than `longest` times the sizes at its ends.
   */
  bool Remove(Id point, double wanted, double longest);

  /** The worst shape around a point. */
  double WorstAround(Id point);

private:
  RefinableMesh& Mesh;
  std::vector<Id> Cells;
  std::vector<Triangle> Walls;
  std::vector<Id> Targets;
  std::vector<Tetrahedron> Fresh;
};
} // namespace insideout
