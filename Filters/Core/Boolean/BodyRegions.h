// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/Regions.h"

#include <string>

namespace insideout
{
/** The regions of overlapping bodies. */
enum class RegionRule
{
  Priority, ///< a region for each body; a cell in several belongs to the first
  All       ///< a region for each combination of bodies that has cells
};

/** Regions, and their bodies. */
struct BodyRegions
{
  SolidRegions Regions;
  std::vector<std::vector<Id>> Bodies; ///< of each region, ascending
};

/**
 * The bodies by priority: named ones first, then the others.
 *
 * @param[in] bodies the names of all
 * @param[in] first the names of some
 * @return indices into `bodies`, each once
 * @throws Error InvalidParameter for an unknown or repeated name
 */
std::vector<Id> PriorityOf(
  const std::vector<std::string>& bodies, const std::vector<std::string>& first);

/** The order in which bodies count on a mesh, and its reasons. */
struct BodyOrder
{
  std::vector<Id> Priority;            ///< from the highest priority on
  std::vector<Id> Given;               ///< as PriorityOf gave it
  std::size_t Named = 0;               ///< number of named ones, which come first
  std::vector<std::vector<Id>> Within; ///< for each body the bodies nested in it, ascending
};

/**
 * The given order, except that the inner one of two nested bodies without a name counts first. A
 * body is nested in another one that has all its cells, and more. Bodies with the same cells keep
 * their order.
 *
 * @param[in] inside per body and cell, not 0 if the body has the cell
 */
BodyOrder InnerFirst(const std::vector<std::vector<unsigned char>>& inside,
  const std::vector<Id>& given, std::size_t named);

/**
 * The region of each cell. With Priority, regions have the numbers of the bodies, including fully
 * covered ones, so some may have no cell. With All they are numbered by their bodies in
 * lexicographic order: {0}, {0, 1}, {0, 1, 2}, {0, 2}, {1}, ...
 *
 * @param[in] inside per body and cell, not 0 if the body has the cell
 * @param[in] priority all bodies in the order in which they count; unused for All
 * @throws Error Stopped
 */
BodyRegions FindBodyRegions(const std::vector<std::vector<unsigned char>>& inside, RegionRule rule,
  const std::vector<Id>& priority, Monitor& monitor, const ProgressRange& progress);

/** The names of regions: those of their bodies, joined by "+". */
std::vector<std::string> NamesOfRegions(
  const BodyRegions& regions, const std::vector<std::string>& bodies);
} // namespace insideout
