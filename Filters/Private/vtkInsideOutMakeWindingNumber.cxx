// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutMakeWindingNumber.h"

#include "vtkInsideOutReadSurface.h"

std::unique_ptr<const insideout::SurfaceWindingNumber> vtkInsideOutMakeWindingNumber(
  vtkPolyData* input, const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  const vtkInsideOutSurface surface = vtkInsideOutReadSurface(input, options.NonParticipating);
  insideout::CountedChain chain = CountFacets(surface.Soup, options.Chain, monitor);
  warnings.insert(warnings.end(), chain.Warnings.begin(), chain.Warnings.end());
  warnings.insert(warnings.end(), surface.Warnings.begin(), surface.Warnings.end());
  const insideout::FacetTurns turns = OrientFacets(chain.Surface, options.Orientation, monitor);
  warnings.insert(warnings.end(), turns.Warnings.begin(), turns.Warnings.end());
  return std::make_unique<const insideout::SurfaceWindingNumber>(
    chain.Surface, options.WindingNumber, monitor);
}
