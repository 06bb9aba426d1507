// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutMakeWindingNumber.h"

#include "vtkInsideOutReadCloud.h"
#include "vtkInsideOutReadCurve.h"
#include "vtkInsideOutReadSurface.h"

#include <vtkPolyData.h>

namespace
{
void Add(const std::vector<std::string>& more, std::vector<std::string>& warnings)
{
  warnings.insert(warnings.end(), more.begin(), more.end());
}

void RefuseDistance(const vtkInsideOutSurfaceOptions& options, const std::string& what)
{
  if (options.Distance)
  {
    throw insideout::Error(insideout::ErrorCode::InvalidParameter,
      "the surface has " + what + " but no polygons; distances are of polygons only");
  }
}
} // namespace

vtkInsideOutFacets::vtkInsideOutFacets(vtkPolyData* input,
  const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  const vtkInsideOutSurface surface = vtkInsideOutReadSurface(input, options.NonParticipating);
  insideout::CountedChain chain = CountFacets(surface.Soup, options.Chain, monitor);
  Add(chain.Warnings, warnings);
  Add(surface.Warnings, warnings);
  const insideout::FacetTurns turns =
    OrientFacets(chain.Surface, chain.Edges, options.Orientation, monitor);
  Add(turns.Warnings, warnings);
  for (insideout::Id f = 0; options.Distance && f < chain.Surface.NumberOfFacets(); ++f)
  {
    this->Cells.push_back(surface.CellOfFacet(chain.Surface, f, 1));
  }
  this->Surface = std::move(chain.Surface);
}

void vtkInsideOutWindingNumber::OfCurve(vtkPolyData* input,
  const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  RefuseDistance(options, "lines");
  const vtkInsideOutCurve curve =
    vtkInsideOutReadCurve(input, options.Orientation, options.NonParticipating);
  const insideout::PlanarHull hull =
    MeshPlanarHull(curve.Soup, curve.Plane, { options.Chain, options.Orientation }, monitor);
  Add(curve.Warnings, warnings);
  Add(hull.Warnings, warnings);
  this->Curve = std::make_unique<const insideout::CurveWindingNumber>(hull);
}

void vtkInsideOutWindingNumber::OfCloud(vtkPolyData* input,
  const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  RefuseDistance(options, "points");
  insideout::PointCloud cloud = insideout::CheckedCloud(
    vtkInsideOutReadCloud(input, options.Areas), monitor, { insideout::Stages::Validating, 0, 1 });
  if (options.Orientation == insideout::Orientation::Reverse)
  {
    for (insideout::Point& normal : cloud.Normals)
    {
      normal = { -normal[0], -normal[1], -normal[2] };
    }
  }
  else if (insideout::SeemsInsideOut(cloud))
  {
    warnings.emplace_back(
      "the normals of the cloud seem to point inward; Orientation Reverse turns them over");
  }
  this->Cloud = std::make_unique<const insideout::CloudWindingNumber>(
    cloud, options.WindingNumber.Method == insideout::WindingNumberMethod::Naive);
}

vtkInsideOutWindingNumber::vtkInsideOutWindingNumber(vtkPolyData* input,
  const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  if (vtkInsideOutAreLines(input))
  {
    this->OfCurve(input, options, monitor, warnings);
    return;
  }
  if (vtkInsideOutIsCloud(input))
  {
    this->OfCloud(input, options, monitor, warnings);
    return;
  }
  vtkInsideOutFacets facets(input, options, monitor, warnings);
  this->Surface = std::make_unique<const insideout::SurfaceWindingNumber>(
    facets.Surface, options.WindingNumber, monitor);
  if (options.Distance)
  {
    this->Distance = std::make_unique<const insideout::SurfaceDistance>(
      facets.Surface.Points, facets.Surface.Facets);
    this->CellOfFacet = std::move(facets.Cells);
  }
}

vtkInsideOutWindingNumber::vtkInsideOutWindingNumber(const vtkInsideOutPiece& piece,
  const vtkInsideOutSurfaceOptions& options, insideout::Monitor& monitor)
  : Surface(std::make_unique<const insideout::SurfaceWindingNumber>(
      piece.Surface, options.WindingNumber, monitor))
{
}

vtkInsideOutWindingNumber::vtkInsideOutWindingNumber(const vtkInsideOutPiece& piece, int exponent)
  : WholeFacets(piece.WholeFacets)
  , CellOfFacet(piece.Cells)
{
  std::vector<insideout::Triangle> withoutCaps = piece.Surface.Facets;
  withoutCaps.resize(piece.WholeFacets.size());
  this->Distance =
    std::make_unique<const insideout::SurfaceDistance>(piece.Surface.Points, withoutCaps, exponent);
}

double vtkInsideOutWindingNumber::At(const insideout::Point& p) const
{
  return this->Curve ? this->Curve->At(p) : this->Cloud ? this->Cloud->At(p) : this->Surface->At(p);
}

std::vector<double> vtkInsideOutWindingNumber::At(const std::vector<insideout::Point>& points,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress) const
{
  return this->Curve ? this->Curve->At(points, monitor, progress)
    : this->Cloud    ? this->Cloud->At(points, monitor, progress)
                     : this->Surface->At(points, monitor, progress);
}

insideout::Point vtkInsideOutWindingNumber::Gradient(const insideout::Point& p) const
{
  return this->Curve ? this->Curve->Gradient(p)
    : this->Cloud    ? this->Cloud->Gradient(p)
                     : this->Surface->Gradient(p);
}

bool vtkInsideOutWindingNumber::InGrid(const insideout::GridPlaces& grid,
  std::optional<double> sideOf, const insideout::SliceVisitor& visit, insideout::Monitor& monitor,
  const insideout::ProgressRange& progress) const
{
  if (this->Surface)
  {
    this->Surface->InGrid(grid, sideOf, visit, monitor, progress);
  }
  return this->Surface != nullptr;
}

vtkInsideOutNearest vtkInsideOutWindingNumber::InCells(
  const insideout::SurfaceDistance::Nearest& nearest) const
{
  vtkInsideOutNearest found = { nearest, -1 };
  if (nearest.Facet != insideout::None)
  {
    found.Cell = this->CellOfFacet[nearest.Facet];
    found.Facet = this->WholeFacets.empty() ? nearest.Facet : this->WholeFacets[nearest.Facet];
  }
  return found;
}

vtkInsideOutNearest vtkInsideOutWindingNumber::NearestTo(const insideout::Point& p) const
{
  return this->InCells(this->Distance->At(p));
}

std::vector<vtkInsideOutNearest> vtkInsideOutWindingNumber::NearestTo(
  const std::vector<insideout::Point>& points, insideout::Monitor& monitor,
  const insideout::ProgressRange& progress) const
{
  std::vector<vtkInsideOutNearest> nearest;
  nearest.reserve(points.size());
  for (const auto& found : this->Distance->At(points, monitor, progress))
  {
    nearest.push_back(this->InCells(found));
  }
  return nearest;
}
