// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"

#include <vector>

namespace insideout
{
/** Locates places in the cells of a mesh, by exact predicates. */
class CellLocator
{
public:
  /** @param[in] mesh has to outlive this object */
  explicit CellLocator(const TetrahedralMesh& mesh)
    : Mesh(mesh)
  {
  }

  /**
   * @param[in,out] cells per place a cell to start from, replaced by the cell that contains the
   * place, or a near one if rounding put the place outside all cells
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
