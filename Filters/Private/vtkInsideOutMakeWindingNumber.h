// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Makes the winding number of a raw vtkPolyData, for the classes that need no mesh.
 */
#pragma once

#include "WindingNumber/SurfaceWindingNumber.h"
#include "vtkInsideOutOptions.h"

class vtkPolyData;

struct vtkInsideOutSurfaceOptions
{
  insideout::CountedChainParameters Chain;
  insideout::Orientation Orientation;
  insideout::WindingNumberParameters WindingNumber;
  std::string NonParticipating; ///< cell array, not 0 where a cell does not count
};

/** The options that those classes have in common. */
template <typename Class>
vtkInsideOutSurfaceOptions vtkInsideOutReadSurfaceOptions(Class* object)
{
  vtkInsideOutSurfaceOptions options;
  options.Chain = vtkInsideOutChainParameters(object);
  options.Orientation = vtkInsideOutOrientation(object);
  options.NonParticipating = object->GetNonParticipatingArrayName();
  return options;
}

/**
 * The winding number of what counts in a surface, which is neither resolved nor meshed.
 *
 * @param[in,out] warnings gains what was passed over or looks wrong
 * @throws insideout::Error that names the cell or point at fault
 */
std::unique_ptr<const insideout::SurfaceWindingNumber> vtkInsideOutMakeWindingNumber(
  vtkPolyData* input, const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings);
