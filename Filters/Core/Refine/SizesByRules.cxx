// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SizesByRules.h"

#include "Common/Stages.h"
#include "Refine/MakeRefinable.h"
#include "Refine/SizeSources.h"
#include "Refine/SurfaceCurvature.h"
#include "Refine/WallThickness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace insideout
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

void AddCurvature(const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets,
  double featureAngle, double edges, std::vector<SizeSource>& sources)
{
  const std::vector<double> radii = RadiiOfCurvature(mesh, facets, featureAngle);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    if (radii[f] < Infinite)
    {
      sources.push_back({ facets[f].Corners, 2 * std::acos(-1.0) * radii[f] / edges });
    }
  }
}

void AddWalls(const std::vector<WallPart>& walls, double cells, std::vector<SizeSource>& sources)
{
  for (const WallPart& wall : walls)
  {
    sources.push_back({ wall.Middle, wall.Thickness / cells, wall.Thickness / 2 });
  }
}

void AddTag(const std::vector<FacetOfInput>& facets, const std::vector<std::array<Id, 4>>& labels,
  const SizeRule& rule, std::vector<SizeSource>& sources)
{
  for (const FacetOfInput& facet : facets)
  {
    const auto isTagged = [&](Id face)
    { return face != None && !labels.empty() && labels[face / 4][face % 4] == rule.Label; };
    if (std::any_of(facet.Faces.begin(), facet.Faces.end(), isTagged))
    {
      sources.push_back({ facet.Corners, rule.Value });
    }
  }
}

/** Lengths of regions extend beyond their boundaries. */
void AddRegions(const std::vector<FacetOfInput>& facets, const std::vector<double>& ofCell,
  std::vector<SizeSource>& sources)
{
  for (const FacetOfInput& facet : facets)
  {
    double least = Infinite;
    for (const Id face : facet.Faces)
    {
      least = std::min(least, face == None ? Infinite : ofCell[face / 4]);
    }
    if (least < Infinite)
    {
      sources.push_back({ facet.Corners, least });
    }
  }
}
} // namespace

SizingParameters SizesByRules(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<FacetOfInput>& facets, const RefinementParameters& parameters, Monitor& monitor)
{
  SizingParameters sizes = parameters.Sizes;
  std::vector<SizeSource> sources;
  std::vector<WallPart> walls;
  const bool asksForCells = std::any_of(sizes.Rules.begin(), sizes.Rules.end(),
    [](const SizeRule& rule) { return rule.What == SizeRule::Kind::Gap; });
  if (asksForCells)
  {
    walls = WallsOf(MakeRefinable(mesh, regions, facets), monitor, { Stages::Refining, 0, 0 });
  }
  bool asksForCurvature = false;
  for (const SizeRule& rule : sizes.Rules)
  {
    switch (rule.What)
    {
      case SizeRule::Kind::Curvature:
        AddCurvature(mesh, facets, parameters.FeatureAngle, rule.Value, sources);
        asksForCurvature = true;
        break;
      case SizeRule::Kind::Gap:
        AddWalls(walls, rule.Value, sources);
        break;
      case SizeRule::Kind::Tag:
        AddTag(facets, parameters.Labels, rule, sources);
        break;
      case SizeRule::Kind::Point:
        sources.push_back(
          { { { rule.Center, rule.Center, rule.Center } }, rule.Value, rule.Radius });
        break;
      case SizeRule::Kind::Region:
        break; // a length of cells
    }
  }
  if (!sizes.LengthOfCell.empty())
  {
    AddRegions(facets, sizes.LengthOfCell, sources);
    sizes.LengthOfRegion.assign(1, Infinite);
    for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
    {
      const std::size_t region = regions.empty() ? 0 : regions[c];
      sizes.LengthOfRegion.resize(std::max(sizes.LengthOfRegion.size(), region + 1), Infinite);
      sizes.LengthOfRegion[region] = sizes.LengthOfCell[c];
    }
  }
  if (sources.empty())
  {
    return sizes;
  }
  sizes.KeepsShorterEdges = !asksForCurvature && !(sizes.EdgeLength > 0) &&
    !(sizes.MaximumVolume > 0) && sizes.Lengths.empty() && !sizes.LengthAt;
  const auto ofRules = std::make_shared<SizeSources>(sources, sizes.Grading);
  const std::function<double(const Point&)> given = sizes.LengthAt;
  sizes.LengthAt = [ofRules, given](const Point& place)
  { return std::min(ofRules->LengthAt(place), given ? given(place) : Infinite); };
  return sizes;
}
} // namespace insideout
