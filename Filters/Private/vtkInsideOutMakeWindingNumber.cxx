// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutMakeWindingNumber.h"

#include "vtkInsideOutReadCurve.h"
#include "vtkInsideOutReadSurface.h"

#include <vtkPolyData.h>

vtkInsideOutWindingNumber::vtkInsideOutWindingNumber(vtkPolyData* input,
  const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  const auto add = [&warnings](const std::vector<std::string>& more)
  { warnings.insert(warnings.end(), more.begin(), more.end()); };
  if (vtkInsideOutAreLines(input))
  {
    const vtkInsideOutCurve curve =
      vtkInsideOutReadCurve(input, options.Orientation, options.NonParticipating);
    const insideout::PlanarHull hull =
      MeshPlanarHull(curve.Soup, curve.Plane, { options.Chain, options.Orientation }, monitor);
    add(curve.Warnings);
    add(hull.Warnings);
    this->Curve = std::make_unique<const insideout::CurveWindingNumber>(hull);
    return;
  }
  const vtkInsideOutSurface surface = vtkInsideOutReadSurface(input, options.NonParticipating);
  insideout::CountedChain chain = CountFacets(surface.Soup, options.Chain, monitor);
  add(chain.Warnings);
  add(surface.Warnings);
  const insideout::FacetTurns turns = OrientFacets(chain.Surface, options.Orientation, monitor);
  add(turns.Warnings);
  this->Surface = std::make_unique<const insideout::SurfaceWindingNumber>(
    chain.Surface, options.WindingNumber, monitor);
}

double vtkInsideOutWindingNumber::At(const insideout::Point& p) const
{
  return this->Curve ? this->Curve->At(p) : this->Surface->At(p);
}

std::vector<double> vtkInsideOutWindingNumber::At(const std::vector<insideout::Point>& points,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress) const
{
  return this->Curve ? this->Curve->At(points, monitor, progress)
                     : this->Surface->At(points, monitor, progress);
}

insideout::Point vtkInsideOutWindingNumber::Gradient(const insideout::Point& p) const
{
  return this->Curve ? this->Curve->Gradient(p) : this->Surface->Gradient(p);
}
