// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableSurface.h"
#include "Refine/SurfacePiece.h"

#include <array>
#include <map>
#include <vector>

namespace insideout
{
/**
 * Bounds the relative change of each label's area and of each region's volume while a surface
 * changes. Those below 1e-9 of the sum of all are rounding errors, and compared with that; such
 * volumes may also change by that of the smallest cell that a solver accepts.
 */
class SurfaceBudget
{
public:
  static constexpr double LargestChange = 1e-6;

  /** @param[in] mesh before any change */
  SurfaceBudget(const RefinableMesh& mesh, const std::vector<FacetOfInput>& facets);

  /** Whether no change gets too large if fresh pieces replace others. */
  bool Allows(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);

  /** Notification: the last asked replacement was done. */
  void Replace();

private:
  /** A sum, and what it has changed by. */
  struct Sum
  {
    double Before = 0;
    double Change = 0;
  };
  using Sums = std::map<Id, Sum>;
  using Changes = std::map<Id, double>;
  static bool StayWithin(const Sums& sums, double all, const Changes& changes, double least);
  void Add(const std::vector<SurfacePiece>& pieces, double sign, const Point& origin);

  const std::vector<FacetOfInput>& Facets;
  Sums Areas;   ///< by label, doubled
  Sums Volumes; ///< by region, times 6
  double AllAreas = 0;
  double AllVolumes = 0;
  std::map<Id, std::array<Id, 2>> RegionsAt; ///< by label, the region that sees it, and that beyond

  /** By the last replacement asked for. */
  Changes AreaChanges;
  Changes VolumeChanges;
};
} // namespace insideout
