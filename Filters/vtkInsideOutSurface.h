// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutSurface
 * @brief   Makes the winding number of a raw vtkPolyData, for the filters that need no mesh.
 */
#ifndef vtkInsideOutSurface_h
#define vtkInsideOutSurface_h

#include "Validate/CountedChain.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

struct vtkInsideOutSurfaceOptions
{
  insideout::CountedChainParameters Chain;
  bool Reverse = false; ///< count every facet the other way round
  insideout::WindingNumberParameters WindingNumber;
  std::string NonParticipating; ///< cell array, not 0 where a cell does not count
};

/**
 * The winding number of what counts in a surface, which is neither resolved nor meshed.
 *
 * @param[in,out] warnings gains what was passed over or looks wrong
 * @throws insideout::Error that names the cell or point at fault
 */
std::unique_ptr<const insideout::SurfaceWindingNumber> vtkInsideOutMakeWindingNumber(
  vtkPolyData* surface, const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings);

#endif
