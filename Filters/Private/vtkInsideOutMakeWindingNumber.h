// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Makes the winding number of a raw vtkPolyData, for the classes that need no mesh.
 */
#pragma once

#include "Common/Stages.h"
#include "Planar/CurveWindingNumber.h"
#include "WindingNumber/SurfaceWindingNumber.h"
#include "vtkInsideOutOptions.h"

#include <memory>

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

/** The winding number of a surface; or, of lines without polygons, that of the curve in their
 * plane, at the places above and below it too. */
class vtkInsideOutWindingNumber
{
public:
  /**
   * Of what counts in a surface, which is neither resolved nor meshed.
   *
   * @param[in,out] warnings gains what was passed over or looks wrong
   * @throws insideout::Error that names the cell or point at fault
   */
  vtkInsideOutWindingNumber(vtkPolyData* input, const vtkInsideOutSurfaceOptions& options,
    insideout::Monitor& monitor, std::vector<std::string>& warnings);

  /** As of SurfaceWindingNumber. */
  double At(const insideout::Point& p) const;
  std::vector<double> At(const std::vector<insideout::Point>& points, insideout::Monitor& monitor,
    const insideout::ProgressRange& progress = { insideout::Stages::WindingNumbers, 0, 1 }) const;
  insideout::Point Gradient(const insideout::Point& p) const;

private:
  std::unique_ptr<const insideout::SurfaceWindingNumber> Surface; ///< one of the two
  std::unique_ptr<const insideout::CurveWindingNumber> Curve;
};
