// SPDX-License-Identifier: GPL-3.0-or-later
#include "Probe/InputWindingNumber.h"

#include "In/ReadCloud.h"
#include "In/ReadCurve.h"
#include "In/ReadSurface.h"

#include <vtkPolyData.h>

namespace vtkInsideOut
{
namespace
{
void Add(const std::vector<std::string>& more, std::vector<std::string>& warnings)
{
  warnings.insert(warnings.end(), more.begin(), more.end());
}

void RefuseDistance(const SurfaceOptions& options, const std::string& what)
{
  if (options.Distance)
  {
    throw insideout::Error(insideout::ErrorCode::InvalidParameter,
      "the surface has " + what + " but no polygons; distances are of polygons only");
  }
}
} // namespace

Facets::Facets(vtkPolyData* input, const SurfaceOptions& options, insideout::Monitor& monitor,
  std::vector<std::string>& warnings)
{
  vtkInsideOut::Surface surface = ReadSurface(input, options.NonParticipating);
  if (options.CountsAsGiven && surface.Soup.Multiplicity.empty())
  {
    surface.Soup.Multiplicity.assign(surface.Soup.Triangles.size(), 1);
  }
  insideout::CountedChain chain = CountFacets(surface.Soup, options.Chain, monitor);
  Add(chain.Warnings, warnings);
  Add(surface.Warnings, warnings);
  const insideout::FacetTurns turns =
    OrientFacets(chain.Surface, chain.Edges, options.Orientation, monitor);
  Add(turns.Warnings, warnings);
  Add(turns.UncountedWarnings, warnings);
  for (insideout::Id f = 0; options.Distance && f < chain.Surface.NumberOfFacets(); ++f)
  {
    this->Cells.push_back(surface.CellOfFacet(chain.Surface, f, 1));
  }
  this->Surface = std::move(chain.Surface);
}

void InputWindingNumber::OfCurve(vtkPolyData* input, const SurfaceOptions& options,
  insideout::Monitor& monitor, std::vector<std::string>& warnings)
{
  RefuseDistance(options, "lines");
  const vtkInsideOut::Curve curve = ReadCurve(input, options.Orientation, options.NonParticipating);
  const insideout::PlanarHull hull =
    MeshPlanarHull(curve.Soup, curve.Plane, { options.Chain, options.Orientation }, monitor);
  Add(curve.Warnings, warnings);
  Add(hull.Warnings, warnings);
  this->Curve = std::make_unique<const insideout::CurveWindingNumber>(hull);
}

void InputWindingNumber::OfCloud(vtkPolyData* input, const SurfaceOptions& options,
  insideout::Monitor& monitor, std::vector<std::string>& warnings)
{
  RefuseDistance(options, "points");
  insideout::PointCloud cloud = insideout::CheckedCloud(
    ReadCloud(input, options.Areas), monitor, { insideout::Stages::Validating, 0, 1 });
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

InputWindingNumber::InputWindingNumber(vtkPolyData* input, const SurfaceOptions& options,
  insideout::Monitor& monitor, std::vector<std::string>& warnings)
{
  if (AreLines(input))
  {
    this->OfCurve(input, options, monitor, warnings);
    return;
  }
  if (IsCloud(input))
  {
    this->OfCloud(input, options, monitor, warnings);
    return;
  }
  Facets facets(input, options, monitor, warnings);
  this->Surface = std::make_unique<const insideout::SurfaceWindingNumber>(
    facets.Surface, options.WindingNumber, monitor);
  if (options.Distance)
  {
    this->Distance = std::make_unique<const insideout::SurfaceDistance>(
      facets.Surface.Points, facets.Surface.Facets);
    this->CellOfFacet = std::move(facets.Cells);
  }
}

InputWindingNumber::InputWindingNumber(
  const insideout::CountedPiece& piece, const SurfaceOptions& options, insideout::Monitor& monitor)
  : Surface(std::make_unique<const insideout::SurfaceWindingNumber>(
      piece.Surface, piece.Boundary, options.WindingNumber, monitor))
{
}

InputWindingNumber::InputWindingNumber(const SurfaceChunk& piece, int exponent)
  : WholeFacets(piece.WholeFacets)
  , CellOfFacet(piece.Cells)
{
  std::vector<insideout::Triangle> withoutCaps = piece.Surface.Facets;
  withoutCaps.resize(piece.WholeFacets.size());
  this->Distance =
    std::make_unique<const insideout::SurfaceDistance>(piece.Surface.Points, withoutCaps, exponent);
}

double InputWindingNumber::At(const insideout::Point& p) const
{
  return this->Curve ? this->Curve->At(p) : this->Cloud ? this->Cloud->At(p) : this->Surface->At(p);
}

std::vector<double> InputWindingNumber::At(const std::vector<insideout::Point>& points,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress) const
{
  return this->Curve ? this->Curve->At(points, monitor, progress)
    : this->Cloud    ? this->Cloud->At(points, monitor, progress)
                     : this->Surface->At(points, monitor, progress);
}

insideout::Point InputWindingNumber::Gradient(const insideout::Point& p) const
{
  return this->Curve ? this->Curve->Gradient(p)
    : this->Cloud    ? this->Cloud->Gradient(p)
                     : this->Surface->Gradient(p);
}

bool InputWindingNumber::InGrid(const insideout::GridPlaces& grid, std::optional<double> sideOf,
  const insideout::SliceVisitor& visit, insideout::Monitor& monitor,
  const insideout::ProgressRange& progress) const
{
  if (this->Surface)
  {
    this->Surface->InGrid(grid, sideOf, visit, monitor, progress);
  }
  return this->Surface != nullptr;
}

NearestPoint InputWindingNumber::InCells(const insideout::SurfaceDistance::Nearest& nearest) const
{
  NearestPoint found = { nearest, -1 };
  if (nearest.Facet != insideout::None)
  {
    found.Cell = this->CellOfFacet[nearest.Facet];
    found.Facet = this->WholeFacets.empty() ? nearest.Facet : this->WholeFacets[nearest.Facet];
  }
  return found;
}

NearestPoint InputWindingNumber::NearestTo(const insideout::Point& p) const
{
  return this->InCells(this->Distance->At(p));
}

std::vector<NearestPoint> InputWindingNumber::NearestTo(const std::vector<insideout::Point>& points,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress) const
{
  std::vector<NearestPoint> nearest;
  nearest.reserve(points.size());
  for (const auto& found : this->Distance->At(points, monitor, progress))
  {
    nearest.push_back(this->InCells(found));
  }
  return nearest;
}
} // namespace vtkInsideOut
