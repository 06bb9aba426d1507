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
 * A row that meets an edge or a corner is perturbed symbolically (Edelsbrunner and Muecke 1990): in
 * y, and by still less in z. This keeps the winding number of places off the chain, but not of
 * those on it, which are found and reported. All signs are exact.
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
  std::vector<SliceRange> Slices;      ///< per facet, the slices that it may meet
  std::vector<std::vector<Id>> InSlab; ///< per slab, the facets that may meet one of its slices
};
} // namespace insideout
