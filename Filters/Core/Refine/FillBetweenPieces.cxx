// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/FillBetweenPieces.h"

#include "Common/PartMonitor.h"
#include "Exact/ExactTetrahedralization.h"
#include "Tetrahedralize/AssembleMesh.h"

#include <algorithm>

namespace insideout
{
namespace
{
constexpr Id Unknown = None - 1;

/** Limit of work per point and piece (WorkBudget): where it is not enough, Steiner points would
 * stay on the surface, or pieces would be lost. */
constexpr std::int64_t WorkPerElement = 2000;

/** A region, and a cell of it in the input beside a facet. */
struct Side
{
  Id Region = Unknown;
  Id Cell = None;
};

/** The cells of a surface's convex hull, and the points of the mesh that the first points are. */
struct Hull
{
  TetrahedralMesh Cells;
  std::vector<Id> Points;
};

Hull MakeHull(
  const std::vector<Point>& points, const std::vector<SurfacePiece>& pieces, Monitor& monitor)
{
  Hull hull;
  std::vector<Id> numbers(points.size(), None);
  FacetComplex surface;
  for (const SurfacePiece& piece : pieces)
  {
    Triangle facet = piece.Corners;
    for (Id& corner : facet)
    {
      if (numbers[corner] == None)
      {
        numbers[corner] = static_cast<Id>(surface.Points.size());
        hull.Points.push_back(corner);
        surface.Origins.push_back(PointOrigin::Input(numbers[corner]));
        surface.Points.push_back(points[corner]);
      }
      corner = numbers[corner];
    }
    surface.Facets.push_back(facet);
    surface.Multiplicity.push_back(1);
    surface.Sources.push_back({ surface.NumberOfConstraints, false });
    surface.SourceOffsets.push_back(++surface.NumberOfConstraints);
  }
  hull.Cells = AssembleMesh(surface,
    TetrahedralizeExactly(surface.Points, surface.Facets, monitor, WorkPerElement).Tetrahedra,
    monitor);
  return hull;
}

/** Tells the region and the nearest input cell on either side of a piece. */
class Sides
{
public:
  Sides(const std::vector<SurfacePiece>& pieces, const std::vector<FacetOfInput>& facets,
    const std::vector<Id>& regions)
    : Pieces(pieces)
    , Facets(facets)
    , Regions(regions)
  {
  }

  /** @param[in] isWithin whether on the side from which the piece is counter-clockwise */
  Side At(Id piece, bool isWithin) const
  {
    const auto [first, second] = this->Facets[this->Pieces[piece].Facet].Faces;
    const Side a = this->OfFace(first);
    const Side b = this->OfFace(second);
    return (a.Region > b.Region) == isWithin ? a : b;
  }

private:
  Side OfFace(Id face) const
  {
    return face == None       ? Side{ None, None }
      : this->Regions.empty() ? Side{ 0, face / 4 }
                              : Side{ this->Regions[face / 4], face / 4 };
  }

  const std::vector<SurfacePiece>& Pieces;
  const std::vector<FacetOfInput>& Facets;
  const std::vector<Id>& Regions;
};

/** The side of pieces that each cell is on; empty if they contradict each other. */
std::vector<Side> SidesOfCells(const TetrahedralMesh& mesh, const Sides& sides)
{
  std::vector<Side> found(mesh.Cells.size());
  std::vector<Id> reached;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Facets[c][k] != None)
      {
        const Side side = sides.At(mesh.Facets[c][k], mesh.FacetSides[c][k] < 0);
        if (found[c].Region == Unknown)
        {
          found[c] = side;
          reached.push_back(c);
        }
        else if (found[c].Region != side.Region)
        {
          return {};
        }
      }
    }
  }
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    const Id c = reached[next];
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[c][k];
      if (neighbor == None || mesh.Facets[c][k] != None)
      {
        if (neighbor == None && mesh.Facets[c][k] == None && found[c].Region != None)
        {
          return {};
        }
      }
      else if (found[neighbor].Region == Unknown)
      {
        found[neighbor] = found[c];
        reached.push_back(neighbor);
      }
      else if (found[neighbor].Region != found[c].Region)
      {
        return {};
      }
    }
  }
  const bool isComplete = reached.size() == mesh.Cells.size();
  return isComplete ? found : std::vector<Side>();
}
} // namespace

bool FillBetweenPieces(RefinableMesh& mesh, const std::vector<SurfacePiece>& pieces,
  const std::vector<FacetOfInput>& facets, const std::vector<Id>& regions, SizingField& sizes,
  Monitor& monitor, const ProgressRange& progress)
{
  Hull hull;
  try
  {
    QuietMonitor quiet(monitor, progress);
    hull = MakeHull(mesh.Points, pieces, quiet);
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::Inconsistent && error.Code != ErrorCode::Planar)
    {
      throw;
    }
    return false;
  }
  const TetrahedralMesh& cells = hull.Cells;
  if (!cells.LostFacets.empty() || cells.NumberOfSurfaceSteinerPoints > 0)
  {
    return false;
  }
  const std::vector<Side> sides = SidesOfCells(cells, { pieces, facets, regions });
  if (sides.empty())
  {
    return false;
  }
  std::vector<Id> numbers(cells.Cells.size(), None);
  std::vector<Id> within;
  for (Id c = 0; c < cells.NumberOfCells(); ++c)
  {
    if (sides[c].Region != None)
    {
      numbers[c] = static_cast<Id>(within.size());
      within.push_back(c);
    }
  }
  std::vector<Id> regionsAt(cells.Points.size(), None);
  for (const Id c : within)
  {
    for (const Id corner : cells.Cells[c])
    {
      regionsAt[corner] = sides[c].Region;
    }
  }
  for (std::size_t p = hull.Points.size(); p < cells.Points.size(); ++p)
  {
    Id point = None; // outside
    if (regionsAt[p] != None)
    {
      const double size = sizes.AppendIn(regionsAt[p], cells.Points[p]);
      point = mesh.AddPoint(cells.Points[p], PointKind::Free, size);
    }
    hull.Points.push_back(point);
  }
  mesh.SetAllCells(within.size(),
    [&](Id number)
    {
      const Id c = within[number];
      RefinableCell cell = { { sides[c].Region, sides[c].Cell, 0 }, cells.Cells[c],
        { { None, None, None, None } }, { { None, None, None, None } } };
      for (Id& corner : cell.Corners)
      {
        corner = hull.Points[corner];
      }
      for (int k = 0; k < 4; ++k)
      {
        const Id neighbor = cells.Neighbors[c][k];
        const Id piece = cells.Facets[c][k];
        cell.Neighbors[CornerAcrossFrom[k]] = neighbor == None ? None : numbers[neighbor];
        cell.Facets[CornerAcrossFrom[k]] = piece == None ? None : pieces[piece].Facet;
      }
      return cell;
    });
  return true;
}
} // namespace insideout
