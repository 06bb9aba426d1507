// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/ChainFacets.h"
#include "WindingNumber/GridPlaces.h"

namespace insideout
{
/**
 * The winding number of a closed chain at all places of a grid: along each row it changes only
 * where a facet crosses the row, and beyond the chain's box it is 0.
 *
 * A row that meets an edge or a corner is moved aside, by less than any number that is not 0
 * (Edelsbrunner and Muecke 1990): in y, and in z by still less. A place off the chain has the same
 * winding number after it as before. Places on the chain do not; they are found and told. All signs
 * are exact.
 */
class LabelsInRows
{
public:
  /** @param[in] facets, grid have to live as long as this object; the grid's axes ascend strictly
   */
  LabelsInRows(const ChainFacets& facets, const GridPlaces& grid);

  /**
   * Safe to call from several threads.
   *
   * @param[out] w one per place of the slice; undefined where the place lies on the chain
   * @param[out] onChain the places of the slice that may lie on the chain, and all that do;
   *   ascending
   */
  void InSlice(Id slice, std::vector<double>& w, std::vector<std::size_t>& onChain) const;

private:
  struct Row;

  void AddRises(
    Id facet, Id slice, std::vector<double>& rises, std::vector<std::size_t>& onChain) const;
  void AddRise(
    Id facet, const Row& row, std::vector<double>& rises, std::vector<std::size_t>& onChain) const;
  int SideOf(Id facet, const Row& row, std::size_t i) const;

  const ChainFacets& Facets;
  const GridPlaces& Grid;

  struct SliceRange
  {
    Id First;
    Id Last; ///< not included
  };
  std::vector<SliceRange> Slices;      ///< of each facet: those that it may meet
  std::vector<std::vector<Id>> InSlab; ///< the facets that may meet some slice of each slab
};
} // namespace insideout
