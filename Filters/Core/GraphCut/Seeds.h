// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

#include <functional>
#include <string>

namespace insideout
{
/** A point given as inside or outside. */
struct Seed
{
  Point Position;
  bool Inside;
};

struct SeededCells
{
  std::vector<std::int8_t> Demands;  ///< per cell 1 inside, -1 outside, 0 no seed; see CellGraph
  std::vector<Id> Seeds;             ///< per cell the seed that holds there, None for none
  Id Conflicts = 0;                  ///< seeds without effect
  std::vector<std::string> Warnings; ///< warnings that name them
};

/**
 * The cells that contain the seeds, by exact predicates; on a shared boundary, the cell of the
 * lowest id. The first of several seeds in one cell holds; others that demand the opposite are
 * conflicts. A seed inside that lies in no cell is a conflict, too.
 *
 * @param[in] cells positively oriented
 * @throws Error PointNotFinite, which names the seed
 */
SeededCells FindSeededCells(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  const std::vector<Seed>& seeds);

/**
 * The same in cells of any kind.
 *
 * @param[in] find the cell that contains a point; the lowest of several; None for none
 */
SeededCells FindSeededCells(
  const std::vector<Seed>& seeds, Id numberOfCells, const std::function<Id(const Point&)>& find);
} // namespace insideout
