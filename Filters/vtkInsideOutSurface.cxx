// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutSurface.h"

#include "vtkInsideOutConversion.h"

std::unique_ptr<const insideout::SurfaceWindingNumber> vtkInsideOutMakeWindingNumber(
  vtkPolyData* surface, const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  const vtkInsideOutConversion conversion(surface, options.NonParticipating);
  insideout::CountedChain chain = CountFacets(conversion.Soup, options.Chain, monitor);
  warnings.insert(warnings.end(), chain.Warnings.begin(), chain.Warnings.end());
  warnings.insert(warnings.end(), conversion.Warnings.begin(), conversion.Warnings.end());
  if (options.Reverse)
  {
    for (std::int16_t& multiplicity : chain.Surface.Multiplicity)
    {
      multiplicity = static_cast<std::int16_t>(-multiplicity);
    }
  }
  return std::make_unique<const insideout::SurfaceWindingNumber>(
    chain.Surface, options.WindingNumber, monitor);
}
