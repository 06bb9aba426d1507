// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/TetrahedralizeApart.h"

#include "Common/JobsAtOnce.h"
#include "Common/Stages.h"
#include "Common/Team.h"
#include "Mesh/MeshCell.h"
#include "Tetrahedralize/PartsApart.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** A part as a surface of its own, with the indices of its points and facets in the whole. */
struct Part
{
  FacetComplex Surface;
  std::vector<Id> Points;
  std::vector<Id> Facets;
};

Id CountParts(const std::vector<Id>& partOfPoint)
{
  return partOfPoint.empty() ? 0 : 1 + *std::max_element(partOfPoint.begin(), partOfPoint.end());
}

std::vector<Part> SplitIntoParts(const FacetComplex& surface, const std::vector<Id>& partOfPoint)
{
  std::vector<Part> parts(CountParts(partOfPoint));
  std::vector<Id> place; // per point, its index in its part
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    Part& part = parts[partOfPoint[p]];
    place.push_back(static_cast<Id>(part.Points.size()));
    part.Points.push_back(static_cast<Id>(p));
    part.Surface.Points.push_back(surface.Points[p]);
    part.Surface.Origins.push_back(surface.Origins[p]);
  }
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const auto& [a, b, c] = surface.Facets[f];
    Part& part = parts[partOfPoint[a]];
    part.Facets.push_back(f);
    part.Surface.Facets.push_back({ { place[a], place[b], place[c] } });
    part.Surface.Multiplicity.push_back(surface.Multiplicity[f]);
    part.Surface.NumberOfConstraints += f < surface.NumberOfConstraints;
  }
  return parts;
}

std::string NameOf(const Part& part)
{
  return "the part at point " + std::to_string(part.Surface.Origins.front().Points[0]) + ": ";
}

Tetrahedralization TetrahedralizePart(
  const Part& part, const ConstrainedDelaunayParameters& parameters, Monitor& monitor)
{
  try
  {
    Tetrahedralization result = ConstrainedDelaunay(part.Surface, parameters, monitor);
    for (std::string& failure : result.Failures)
    {
      failure.insert(0, NameOf(part));
    }
    return result;
  }
  catch (const Error& error)
  {
    if (error.Code == ErrorCode::Stopped)
    {
      throw;
    }
    throw Error(error.Code, NameOf(part) + error.what());
  }
}

/** An id of the part, as an id of the whole. */
Id Translate(const std::vector<Id>& ids, Id id)
{
  return id == None ? None : ids[id];
}

void Append(const Part& part, const TetrahedralMesh& mesh, TetrahedralMesh& whole)
{
  const Id firstCell = whole.NumberOfCells();
  std::vector<Id> points = part.Points;
  for (std::size_t p = points.size(); p < mesh.Points.size(); ++p)
  {
    points.push_back(static_cast<Id>(whole.Points.size()));
    whole.Points.push_back(mesh.Points[p]);
    whole.Origins.push_back(mesh.Origins[p]);
  }
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    Tetrahedron corners = mesh.Cells[cell];
    std::array<Id, 4> neighbors = mesh.Neighbors[cell];
    std::array<Id, 4> facets = mesh.Facets[cell];
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = points[corners[k]];
      neighbors[k] = neighbors[k] == None ? None : firstCell + neighbors[k];
      facets[k] = Translate(part.Facets, facets[k]);
    }
    whole.Cells.push_back(corners);
    whole.Neighbors.push_back(neighbors);
    whole.Facets.push_back(facets);
  }
  whole.FacetSides.insert(whole.FacetSides.end(), mesh.FacetSides.begin(), mesh.FacetSides.end());
  for (const Id facet : mesh.LostFacets)
  {
    whole.LostFacets.push_back(part.Facets[facet]);
  }
  whole.NumberOfSteinerPoints += mesh.NumberOfSteinerPoints;
  whole.NumberOfSurfaceSteinerPoints += mesh.NumberOfSurfaceSteinerPoints;
}

void CheckSize(const std::vector<Tetrahedralization>& results)
{
  std::size_t cells = 0;
  for (const Tetrahedralization& result : results)
  {
    cells += result.Mesh.Cells.size();
  }
  if (cells > MostNumberedCells)
  {
    throw Error(ErrorCode::TooLarge,
      "the parts have " + std::to_string(cells) + " cells together, too many for one mesh");
  }
}

Tetrahedralization JoinResults(const FacetComplex& surface, const std::vector<Part>& parts,
  std::vector<Tetrahedralization> results)
{
  CheckSize(results);
  Tetrahedralization all;
  all.Parts = static_cast<Id>(parts.size());
  all.Mesh.Points = surface.Points;
  all.Mesh.Origins = surface.Origins;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const Tetrahedralization result = std::move(results[i]);
    Append(parts[i], result.Mesh, all.Mesh);
    all.Rung = std::max(all.Rung, result.Rung);
    all.Failures.insert(all.Failures.end(), result.Failures.begin(), result.Failures.end());
  }
  std::sort(all.Mesh.LostFacets.begin(), all.Mesh.LostFacets.end());
  return all;
}
} // namespace

Tetrahedralization TetrahedralizeApart(
  const FacetComplex& surface, const ConstrainedDelaunayParameters& parameters, Monitor& monitor)
{
  const std::vector<Id> partOfPoint = PartsApart(surface, monitor);
  if (CountParts(partOfPoint) <= 1)
  {
    return ConstrainedDelaunay(surface, parameters, monitor);
  }
  const std::vector<Part> parts = SplitIntoParts(surface, partOfPoint);
  std::vector<double> sizes;
  for (const Part& part : parts)
  {
    sizes.push_back(static_cast<double>(part.Facets.size()));
  }
  std::vector<Tetrahedralization> results(parts.size());
  JobsAtOnce(
    sizes, AllowedThreads(), Stages::Tetrahedralizing,
    [&](std::size_t i, Monitor& own)
    {
      ConstrainedDelaunayParameters share = parameters;
      share.TimeBudget *= sizes[i] / static_cast<double>(surface.Facets.size());
      results[i] = TetrahedralizePart(parts[i], share, own);
    },
    monitor);
  return JoinResults(surface, parts, std::move(results));
}
} // namespace insideout
