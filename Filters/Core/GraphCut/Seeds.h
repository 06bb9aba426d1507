// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

#include <functional>
#include <string>

namespace insideout
{
/** A place that somebody says is inside or outside. */
struct Seed
{
  Point Position;
  bool Inside;
};

struct SeededCells
{
  std::vector<std::int8_t> Demands;  ///< per cell 1 inside, -1 outside, 0 no seed; see CellGraph
  std::vector<Id> Seeds;             ///< per cell the seed that counts there, None for none
  Id Conflicts = 0;                  ///< seeds that do not count
  std::vector<std::string> Warnings; ///< that name them
};

/**
 * The cells that contain the seeds, by exact predicates; of several that share the seed's place,
 * the one of the lowest id. The first of several seeds in one cell counts; the others are
 * conflicts where they ask for the opposite; so is a seed that is to be inside and lies outside all
 * cells.
 *
 * @param[in] cells positively oriented
 * @throws Error PointNotFinite, which names the seed
 */
SeededCells FindSeededCells(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  const std::vector<Seed>& seeds);

/**
 * The same in cells of any kind.
 *
 * @param[in] find the cell that contains a place, of several the lowest; None for none
 */
SeededCells FindSeededCells(
  const std::vector<Seed>& seeds, Id numberOfCells, const std::function<Id(const Point&)>& find);
} // namespace insideout
