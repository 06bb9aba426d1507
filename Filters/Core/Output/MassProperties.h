// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"
#include "Output/Regions.h"

#include <vector>

namespace insideout
{
/** Mass properties of a solid of density 1, in the units of its points. All 0 without a solid. */
struct MassProperties
{
  double Volume = 0;
  Point CenterOfMass = { { 0, 0, 0 } };

  /** The inertia tensor about the center of mass: xx, yy, zz, xy, yz, xz; xx is the integral of y^2
   * + z^2, and xy that of -x y. */
  std::array<double, 6> Inertia = { { 0, 0, 0, 0, 0, 0 } };
};

/**
 * The mass properties of the cells inside, to some units in the last place: each is a sum of the
 * cells' own moments (Tonon 2004, Explicit exact formulas for the 3-D tetrahedron inertia tensor)
 * about their common center, by compensated summation. The same for any number of threads. Infinite
 * on overflow.
 *
 * @param[in] inside one label per cell, not 0 for those inside
 */
MassProperties MeasureMass(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside);

/** The same for each region, about its own center, without the others. */
std::vector<MassProperties> MeasureRegions(
  const TetrahedralMesh& mesh, const SolidRegions& regions);

/** Mass properties as statistics: Volume, CenterOfMassX to Z, InertiaXX to XZ. */
void AppendMass(const MassProperties& mass, Statistics& statistics);
} // namespace insideout
