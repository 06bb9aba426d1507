// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"

#include <vector>

namespace insideout
{
/** Finds the cells of a mesh that hold places, by exact predicates. */
class CellLocator
{
public:
  /** @param[in] mesh has to live as long */
  explicit CellLocator(const TetrahedralMesh& mesh)
    : Mesh(mesh)
  {
  }

  /**
   * @param[in,out] cells per place one to begin with; then the one that holds it. A place that
   *   rounding put outside all cells gets one near it.
   * @throws Error Stopped
   */
  void Locate(const std::vector<Point>& places, std::vector<Id>& cells, Monitor& monitor,
    const ProgressRange& progress) const;

private:
  bool Walk(const Point& place, Id& cell) const;
  bool Holds(Id cell, const Point& place) const;

  const TetrahedralMesh& Mesh;
};
} // namespace insideout
