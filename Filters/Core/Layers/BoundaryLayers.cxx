// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/BoundaryLayers.h"

#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Layers/LayerColumns.h"
#include "Layers/LayerHeights.h"
#include "Layers/MakeLayeredMesh.h"
#include "Layers/WallDirections.h"
#include "Refine/CellShape.h"
#include "Refine/FillWithPoints.h"
#include "Refine/ImproveCells.h"
#include "Refine/MakeRefinable.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace insideout
{
namespace
{
/** Limit of rounds. They end earlier when fewer than this share of the points move. */
constexpr int MostRounds = 24;
constexpr double LeastShareOfMoved = 0.05;

/**
 * Passes over the cells after each round, and after the last one; the next round repairs the rest.
 */
constexpr int PassesOfRound = 2;
constexpr int PassesAtEnd = 4;

/**
 * Sizes beyond 2 to this power are scaled, because products of lengths might over- or underflow.
 */
constexpr int LargestOrdinaryExponent = 60;

[[noreturn]] void Refuse(const std::string& what)
{
  throw Error(ErrorCode::InvalidParameter, what);
}

/** Refuse wall faces that do not exist, have a second cell or are repeated. */
void CheckWall(const TetrahedralMesh& mesh, const std::vector<Id>& wall)
{
  std::vector<char> isOfWall(4 * mesh.Cells.size(), 0);
  for (const Id face : wall)
  {
    if (face < 0 || static_cast<std::size_t>(face) >= isOfWall.size())
    {
      Refuse("face " + std::to_string(face) + " of the wall is none of the " +
        std::to_string(isOfWall.size()) + " faces of the cells");
    }
    const std::string name =
      "face " + std::to_string(face % 4) + " of cell " + std::to_string(face / 4);
    if (mesh.Neighbors[face / 4][face % 4] != None)
    {
      Refuse(name + " is between two cells; layers are made at the boundary");
    }
    if (isOfWall[face] != 0)
    {
      Refuse(name + " is twice in the wall");
    }
    isOfWall[face] = 1;
  }
}

void CheckParameters(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<Id>& wall, const LayerParameters& parameters)
{
  CheckLayerParameters(parameters);
  if (!regions.empty() && regions.size() != mesh.Cells.size())
  {
    Refuse("there are " + std::to_string(regions.size()) + " regions of " +
      std::to_string(mesh.Cells.size()) + " cells");
  }
  CheckWall(mesh, wall);
  CheckCells(mesh);
}

/** Refuse more points or cells than ids can count, with room for the ids of their faces. */
void CheckSize(const TetrahedralMesh& mesh, const LayerWall& wall, int layers)
{
  constexpr double most = std::numeric_limits<Id>::max() / 16.0;
  const auto check = [&](std::size_t given, std::size_t perLayer, const char* what)
  {
    const double all = static_cast<double>(given) + static_cast<double>(perLayer) * layers;
    if (all > most)
    {
      throw Error(ErrorCode::TooLarge,
        std::to_string(layers) + " layers make " + std::to_string(std::llround(all)) + what +
          ", more than " + std::to_string(std::llround(most)));
    }
  };
  check(mesh.Points.size(), wall.Points.size(), " points");
  check(mesh.Cells.size(), wall.Triangles.size(), " cells");
}

/** The mean length of the edges at each point. */
std::vector<double> LengthsOf(const TetrahedralMesh& mesh)
{
  std::vector<double> sums(mesh.Points.size(), 0);
  std::vector<double> counts(mesh.Points.size(), 0);
  for (const Tetrahedron& cell : mesh.Cells)
  {
    for (const auto& edge : TetrahedronEdges)
    {
      const double length = Distance(mesh.Points[cell[edge[0]]], mesh.Points[cell[edge[1]]]);
      for (const int end : edge)
      {
        sums[cell[end]] += length;
        counts[cell[end]] += 1;
      }
    }
  }
  for (std::size_t p = 0; p < sums.size(); ++p)
  {
    sums[p] = counts[p] > 0 ? sums[p] / counts[p] : std::numeric_limits<double>::infinity();
  }
  return sums;
}

LayeredMesh MakeNearUnitSize(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<Id>& wallFaces, const std::vector<std::array<Id, 4>>& labels,
  const LayerParameters& parameters, Monitor& caller)
{
  ForwardMonitor monitor(caller);
  monitor.Check(Stages::Layering, 0);
  const std::vector<FacetOfInput> facets = FacetsOf(mesh, regions, labels);
  RefinableMesh refinable = MakeRefinable(mesh, regions, facets);
  const std::vector<char> locked;
  RefinableSurface surface(refinable, facets, locked, SurfaceTreatment::Split, 0);
  SizingParameters lengthsNow;
  lengthsNow.Lengths = LengthsOf(mesh);
  SizingField sizes(refinable, lengthsNow);

  std::vector<Triangle> triangles;
  for (const Id face : wallFaces)
  {
    triangles.push_back(FaceOf(mesh.Cells[face / 4], face % 4));
  }
  const LayerWall wall(mesh.Points.size(), std::move(triangles));
  CheckSize(mesh, wall, parameters.Layers);
  const WallRims rims = FindWallRims(mesh, facets, surface, wallFaces, wall);
  for (const Id point : rims.PointsInPlanes)
  {
    refinable.Kinds[point] = PointKind::InFacet;
  }
  const double height = HeightOfAll(parameters);
  const std::vector<WallDirection> directions =
    FindWallDirections(mesh.Points, wall, InwardNormals(mesh.Points, wall), rims.AtPoints, height);
  Id narrow = 0;
  const std::vector<double> heights = LimitHeights(mesh.Points, wall, directions,
    WaysToFacets(refinable, wall, directions, height), height, narrow);
  const std::vector<double> fractions = FractionsOfLayers(parameters.Layers, parameters.Growth);

  PushedWall pushed(refinable, { wall, directions, heights, fractions });
  const std::int64_t first = refinable.NumberOfChanges();
  const auto improve = [&](std::int64_t since, int passes, double begin, double end)
  {
    SurfaceBound bound(refinable, facets, SurfaceTreatment::Split, 0); // of the wall as it is now
    ImproveCells(
      refinable, surface, bound, sizes, monitor, { Stages::Layering, begin, end }, since, passes);
  };
  for (int round = 0; round < MostRounds; ++round)
  {
    const std::int64_t before = refinable.NumberOfChanges();
    const Id moved = pushed.Advance(1.0 / (MostRounds - round));
    if (moved == 0)
    {
      break;
    }
    // Edges of the moved wall are shorter: edges as long as the former ones would be in the way.
    sizes.FollowSurface();
    ThinPoints(refinable);
    improve(before, PassesOfRound, 0.6 * round / MostRounds, 0.6 * (round + 1) / MostRounds);
    if (static_cast<double>(moved) < LeastShareOfMoved * static_cast<double>(wall.Points.size()))
    {
      break;
    }
  }
  if (refinable.NumberOfChanges() > first)
  {
    FillWithPoints(
      refinable, sizes, 0, SurfaceTreatment::Kept, monitor, { Stages::Layering, 0.6, 0.7 });
    improve(first, PassesAtEnd, 0.7, 0.9);
  }

  const PushedSolid solid = { mesh, regions, wallFaces, refinable, wall, rims.Edges, pushed,
    fractions };
  LayeredMesh result = MakeLayeredMesh(solid, monitor);
  const std::size_t ofLayers = result.Tetrahedra.size() - result.NumberOfCellsBehind;
  result.Statistics = { { "Layers", parameters.Layers }, { "Prisms", result.Prisms.size() },
    { "Pyramids", result.Pyramids.size() }, { "LayerTetrahedra", ofLayers } };
  std::vector<double> reached(mesh.Points.size(), 0);
  for (const Id p : wall.Points)
  {
    reached[p] = pushed.Height(p);
  }
  std::vector<double> areas;
  for (const Triangle& t : wall.Triangles)
  {
    areas.push_back(Length(NormalOf(mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]])));
  }
  result.Statistics.emplace_back("WallTriangles", wall.Triangles.size());
  AppendHeights(SharesOfHeight(wall, directions, reached, height), wall, wall.Triangles, areas,
    result.Statistics);
  result.Statistics.emplace_back("NarrowPoints", narrow);
  result.Statistics.emplace_back("EndPoints",
    std::count_if(
      wall.Points.begin(), wall.Points.end(), [&](Id p) { return directions[p].Cosine == 0; }));
  return result;
}
} // namespace

LayeredMesh MakeBoundaryLayers(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<Id>& wall, const std::vector<std::array<Id, 4>>& labels,
  const LayerParameters& parameters, Monitor& monitor)
{
  CheckParameters(mesh, regions, wall, parameters);
  const int exponent = LargestExponent(mesh.Points);
  if (std::abs(exponent) <= LargestOrdinaryExponent)
  {
    return MakeNearUnitSize(mesh, regions, wall, labels, parameters, monitor);
  }
  TetrahedralMesh scaled = mesh;
  scaled.Points = ScaledPoints(mesh.Points, -exponent);
  CheckCells(scaled);
  LayerParameters other = parameters;
  other.FirstHeight =
    std::max(std::ldexp(parameters.FirstHeight, -exponent), std::numeric_limits<double>::min());
  LayeredMesh result = MakeNearUnitSize(scaled, regions, wall, labels, other, monitor);
  result.Points = ScaledPoints(result.Points, exponent);
  return result;
}
} // namespace insideout
