// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/Regions.h"

#include <string>

namespace insideout
{
/** What becomes a region where bodies overlap. */
enum class RegionRule
{
  Priority, ///< a region for each body; a cell is of the one of its bodies that comes first
  All       ///< a region for each combination of bodies that has cells
};

/** Regions, and the bodies that they are of. */
struct BodyRegions
{
  SolidRegions Regions;
  std::vector<std::vector<Id>> Bodies; ///< of each region, ascending
};

/**
 * The bodies in the order in which they count: those that are named first, then the others.
 *
 * @param[in] bodies the names of all
 * @param[in] first the names of some
 * @return indices into `bodies`, each once
 * @throws Error InvalidParameter that names what is no body, or is named twice
 */
std::vector<Id> PriorityOf(
  const std::vector<std::string>& bodies, const std::vector<std::string>& first);

/** In which order bodies count on a mesh, and why. */
struct BodyOrder
{
  std::vector<Id> Priority;            ///< from the one that has cells before all others
  std::vector<Id> Given;               ///< as PriorityOf gave it
  std::size_t Named = 0;               ///< how many of these, the first, are named
  std::vector<std::vector<Id>> Within; ///< of each body, ascending, those nested in it
};

/**
 * The order that is given, but that of two nested bodies which are not named the inner one counts
 * first: the one that has cells, all of which the other has, too, and more. Bodies with the same
 * cells keep their order.
 *
 * @param[in] inside of each body, not 0 for the cells that it has
 */
BodyOrder InnerFirst(const std::vector<std::vector<unsigned char>>& inside,
  const std::vector<Id>& given, std::size_t named);

/**
 * Which region each cell is of. By Priority they have the numbers of the bodies, also of those that
 * others cover whole, so that some may have no cell. With All they are numbered by their bodies in
 * the order of dictionaries: {0}, {0, 1}, {0, 1, 2}, {0, 2}, {1}, ...
 *
 * @param[in] inside of each body, not 0 for the cells that it has
 * @param[in] priority all bodies in the order in which they count; All needs none
 * @throws Error Stopped
 */
BodyRegions FindBodyRegions(const std::vector<std::vector<unsigned char>>& inside, RegionRule rule,
  const std::vector<Id>& priority, Monitor& monitor, const ProgressRange& progress);

/** The names of regions: by their bodies, joined by "+" where these are several. */
std::vector<std::string> NamesOfRegions(
  const BodyRegions& regions, const std::vector<std::string>& bodies);
} // namespace insideout
