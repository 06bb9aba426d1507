// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefineTetrahedra.h"

#include "Common/PointPredicates.h"
#include "Common/ScaledPoints.h"
#include "Common/SortedTriangle.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/FillWithPoints.h"
#include "Refine/ImproveCells.h"
#include "Refine/LocateCells.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

namespace insideout
{
namespace
{
/** VTK's face k is across from this corner. */
constexpr std::array<int, 4> AcrossFrom = { { 2, 0, 1, 3 } };

/** Of cells that are to be: a mesh may need some times as many while it is made. */
constexpr double MostCells = std::numeric_limits<Id>::max() / 16.0;

/** Beyond 2 to this power products of lengths might over- or underflow: sizes are scaled then. */
constexpr int LargestOrdinaryExponent = 60;

/** Whether a face has a cell that sees it from the same side as its neighbour does. */
bool Overlaps(const TetrahedralMesh& mesh, Id cell, int k)
{
  const SortedTriangle face(FaceOf(mesh.Cells[cell], k));
  const Tetrahedron& other = mesh.Cells[mesh.Neighbors[cell][k]];
  for (int i = 0; i < 4; ++i)
  {
    const SortedTriangle twin(FaceOf(other, i));
    if (twin.Points == face.Points && twin.Turned == face.Turned)
    {
      return true;
    }
  }
  return false;
}

void CheckInput(const TetrahedralMesh& mesh, const SizingParameters& parameters)
{
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (Orient3D(mesh.Points, mesh.Cells[c]) <= 0)
    {
      throw Error(ErrorCode::InvalidParameter, "cell " + std::to_string(c) + " has no volume");
    }
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[c][k] != None && Overlaps(mesh, c, k))
      {
        throw Error(ErrorCode::InvalidParameter,
          "cells " + std::to_string(c) + " and " + std::to_string(mesh.Neighbors[c][k]) +
            " overlap: they are on the same side of a face");
      }
    }
  }
  for (std::size_t p = 0; p < parameters.Lengths.size(); ++p)
  {
    if (!(parameters.Lengths[p] > 0))
    {
      throw Error(ErrorCode::InvalidParameter,
        "the edge length at point " + std::to_string(p) + " is not positive");
    }
  }
}

/** Faces of the boundary and between regions are its facets, and their points are fixed. */
RefinableMesh MakeRefinable(const TetrahedralMesh& mesh, const std::vector<Id>& regions)
{
  RefinableMesh result;
  for (const Point& point : mesh.Points)
  {
    result.AddPoint(point, false, std::numeric_limits<double>::infinity());
  }
  Id facets = 0;
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    const Id region = regions.empty() ? 0 : regions[c];
    RefinableCell cell = { mesh.Cells[c], { { None, None, None, None } },
      { { None, None, None, None } }, region, static_cast<Id>(c) };
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[c][k];
      cell.Neighbors[AcrossFrom[k]] = neighbor;
      if (neighbor == None || (!regions.empty() && regions[neighbor] != region))
      {
        cell.Facets[AcrossFrom[k]] = facets++;
        for (const Id corner : FaceOf(mesh.Cells[c], k))
        {
          result.IsFixed[corner] = 1;
        }
      }
    }
    result.AddCell(cell);
  }
  return result;
}

RefinedMesh Compress(const RefinableMesh& mesh, const std::vector<Point>& input)
{
  RefinedMesh result;
  std::vector<Id> numbers(mesh.Points.size(), None);
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (!mesh.IsDead(c))
    {
      result.Cells.push_back(mesh.Cell(c).Corners);
      result.OriginalCells.push_back(mesh.Cell(c).Parent);
    }
  }
  for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); ++p)
  {
    if (mesh.CellAt(p) != None)
    {
      numbers[p] = static_cast<Id>(result.Points.size());
      result.Points.push_back(mesh.Points[p]);
      const bool isOriginal = p < static_cast<Id>(input.size()) && mesh.Points[p] == input[p];
      result.OriginalPoints.push_back(isOriginal ? p : None);
      result.CellsOfPoints.push_back(mesh.Cell(mesh.CellAt(p)).Parent);
    }
  }
  for (Tetrahedron& cell : result.Cells)
  {
    for (Id& corner : cell)
    {
      corner = numbers[corner];
    }
  }
  return result;
}

Id CountLargeCells(const RefinedMesh& mesh, double maximumVolume)
{
  return static_cast<Id>(std::count_if(mesh.Cells.begin(), mesh.Cells.end(),
    [&](const Tetrahedron& cell)
    {
      const std::array<Point, 4> c = CornersOf(mesh.Points, cell);
      return Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0])) >
        6 * maximumVolume;
    }));
}

RefinedMesh RefineNearUnitSize(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const SizingParameters& parameters, Monitor& monitor)
{
  monitor.Check(Stages::Refining, 0);
  RefinableMesh refinable = MakeRefinable(mesh, regions);
  SizingField sizes(refinable, parameters);
  if (const double cells = sizes.EstimatedCells(); !(cells < MostCells))
  {
    std::ostringstream words;
    words << "edges as short as asked for would make about " << std::setprecision(2) << cells
          << " cells, more than can be counted";
    throw Error(ErrorCode::TooLarge, words.str());
  }
  monitor.Check(Stages::Refining, 0.05);
  ThinPoints(refinable);
  FillWithPoints(
    refinable, sizes, parameters.MaximumVolume, monitor, { Stages::Refining, 0.1, 0.3 });
  ImproveCells(refinable, sizes, monitor, { Stages::Refining, 0.3, 0.9 });

  RefinedMesh result = Compress(refinable, mesh.Points);
  std::vector<Point> barycentres(result.Cells.size());
  for (std::size_t c = 0; c < result.Cells.size(); ++c)
  {
    barycentres[c] = Barycentre(result.Points, result.Cells[c]);
  }
  const CellLocator locator(mesh);
  const std::vector<Id> near = result.OriginalCells;
  locator.Locate(barycentres, result.OriginalCells, monitor, { Stages::Refining, 0.9, 0.97 });
  for (std::size_t c = 0; c < near.size() && !regions.empty(); ++c)
  {
    // The rounded barycentre of a sliver may be beyond a face between regions.
    Id& found = result.OriginalCells[c];
    found = regions[found] == regions[near[c]] ? found : near[c];
  }
  locator.Locate(result.Points, result.CellsOfPoints, monitor, { Stages::Refining, 0.97, 1 });

  const auto kept = static_cast<Id>(result.OriginalPoints.size() -
    std::count(result.OriginalPoints.begin(), result.OriginalPoints.end(), None));
  result.Statistics = { { "AddedPoints", static_cast<double>(result.Points.size()) - kept },
    { "RemovedPoints", static_cast<double>(mesh.Points.size()) - kept } };
  if (parameters.MaximumVolume > 0)
  {
    result.Statistics.emplace_back(
      "CellsAboveMaximumVolume", CountLargeCells(result, parameters.MaximumVolume));
  }
  return result;
}

/** Not 0, which has a meaning of its own, unless the size is. */
double ScaledSize(double size, int exponent)
{
  return size > 0 ? std::max(std::ldexp(size, exponent), std::numeric_limits<double>::min()) : 0;
}

/** The parameters for a mesh that is 2^exponent times as large. */
SizingParameters Scaled(const SizingParameters& parameters, int exponent)
{
  SizingParameters scaled = parameters;
  scaled.EdgeLength = ScaledSize(parameters.EdgeLength, exponent);
  scaled.MaximumVolume = ScaledSize(parameters.MaximumVolume, 3 * exponent);
  for (double& length : scaled.Lengths)
  {
    length = ScaledSize(length, exponent);
  }
  if (parameters.LengthAt)
  {
    scaled.LengthAt = [&parameters, exponent](const Point& place)
    {
      const Point there = { { std::ldexp(place[0], -exponent), std::ldexp(place[1], -exponent),
        std::ldexp(place[2], -exponent) } };
      return std::ldexp(parameters.LengthAt(there), exponent);
    };
  }
  return scaled;
}
} // namespace

RefinedMesh RefineTetrahedra(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const SizingParameters& parameters, Monitor& monitor)
{
  CheckInput(mesh, parameters);
  const int exponent = LargestExponent(mesh.Points);
  if (std::abs(exponent) <= LargestOrdinaryExponent)
  {
    return RefineNearUnitSize(mesh, regions, parameters, monitor);
  }
  TetrahedralMesh scaled = mesh;
  scaled.Points = ScaledPoints(mesh.Points, -exponent);
  RefinedMesh result = RefineNearUnitSize(scaled, regions, Scaled(parameters, -exponent), monitor);
  result.Points = ScaledPoints(result.Points, exponent);
  for (std::size_t p = 0; p < result.Points.size(); ++p)
  {
    if (result.OriginalPoints[p] != None)
    {
      result.Points[p] = mesh.Points[result.OriginalPoints[p]];
    }
  }
  for (const Tetrahedron& cell : result.Cells)
  {
    if (Orient3D(result.Points, cell) <= 0)
    {
      throw Error(ErrorCode::InvalidParameter,
        "the points are too large and too small at once for cells between them to be refined");
    }
  }
  return result;
}
} // namespace insideout
