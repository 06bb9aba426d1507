// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/FillWithPoints.h"

#include "Common/Box.h"
#include "Common/LoopProgress.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractEdge.h"
#include "Refine/InsertPoint.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace insideout
{
namespace
{
/**
 * Relative to the required edge length: the largest circumradius (0.61 for a regular cell), and the
 * least distance to another point. The median edge is then near that length. If the second were as
 * large as the first, gaps beside facets would remain.
 */
constexpr double LargestRadius = 0.8;
constexpr double LeastSpacing = 0.7;

/**
 * Limit of the circumradius relative to a cell's shortest edge (Shewchuk 1998). It makes cells
 * beside short edges of a surface small, even where the required length, a mean of short and long
 * edges, is not.
 */
constexpr double LargestRadiusEdgeRatio = 2;

/** The same where the surface is split, so that it has fewer short edges. */
constexpr double LargestRadiusEdgeRatioWhereSplit = 1.7;

/** Larger cavities are refused: their places are far from the cell to be removed. */
constexpr std::size_t LargestCavity = 2000;

/**
 * Least distance to other points beside shorter edges, relative to the length. It bounds the number
 * of points beside two nearly coincident ones.
 */
constexpr double LeastSpacingBesideShort = 0.01;

/** Limit of points inserted for the radii of thin cells, per existing point. */
constexpr std::size_t MostBesideShort = 4;

/**
 * The body-centered cubic lattice is used if one length is wanted, the surface is remeshed to it,
 * and its edges are at least this fraction of it. Its cells are congruent; their edges are 1 and
 * 0.87 times the side of a cube.
 */
constexpr double LeastUniformShare = 0.8;

/** Relative to the length: the side of the lattice's cubes, the largest circumradius next to the
 * lattice, and the least distance of a lattice point to others. Most edges are then longer than the
 * length: a mesh with that median length has 1.6 times as many cells as gmsh's. */
constexpr double LatticeSide = 1.36;
constexpr double LargestUniformRadius = 0.86;
constexpr double LeastLatticeSpacing = 0.75;

/** The volume of the lattice's cells relative to the largest volume, so that rounding makes none
 * larger. */
constexpr double ShareOfVolume = 0.99;

/** Points closer to another than this fraction of the length are removed. */
constexpr double CrowdedSpacing = 0.5;

double ShortestEdgeOf(const std::array<Point, 4>& c)
{
  return std::min({ Distance(c[0], c[1]), Distance(c[0], c[2]), Distance(c[0], c[3]),
    Distance(c[1], c[2]), Distance(c[1], c[3]), Distance(c[2], c[3]) });
}

double NearestNeighbor(const RefinableMesh& mesh, Id point, std::vector<Id>& star)
{
  star.clear();
  mesh.Star(point, star);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Id cell : star)
  {
    for (const Id other : mesh.Cell(cell).Corners)
    {
      if (other != point)
      {
        nearest = std::min(nearest, Distance(mesh.Points[point], mesh.Points[other]));
      }
    }
  }
  return nearest;
}

class Filling
{
public:
  Filling(RefinableMesh& mesh, SizingField& sizes, double maximumVolume, SurfaceTreatment surface)
    : Mesh(mesh)
    , Sizes(sizes)
    , MaximumVolume(maximumVolume)
    , Insertion(mesh)
    , Budget(MostBesideShort * mesh.Points.size())
    , MostRadiusEdgeRatio(surface == SurfaceTreatment::Split ? LargestRadiusEdgeRatioWhereSplit
                                                             : LargestRadiusEdgeRatio)
    , Side(surface == SurfaceTreatment::Remeshed ? LatticeSide * sizes.Most()
                                                 : std::numeric_limits<double>::infinity())
  {
    const Box box = BoundingBox(mesh.Points);
    if (this->HasLattice() && maximumVolume > 0)
    {
      this->Side = std::min(this->Side, std::cbrt(12 * ShareOfVolume * maximumVolume));
    }
    // Off-center, because points of the input may be at the center.
    this->Origin = Midpoint(box.Low, box.High);
    for (int k = 0; k < 3 && this->HasLattice(); ++k)
    {
      this->Origin[k] += (k + 1) / 7.0 * this->Side;
    }
  }

  /** Insert lattice points where one length is wanted. */
  void FillWithLattice(Monitor& monitor, const ProgressRange& progress)
  {
    if (this->HasLattice())
    {
      this->Run([this](Id cell) { return this->InsertFromLattice(cell); }, monitor, progress);
    }
  }

  /** Insert circumcenters of cells that are too large. */
  void FillWithCenters(Monitor& monitor, const ProgressRange& progress)
  {
    this->Run([this](Id cell) { return this->InsertCenter(cell); }, monitor, progress);
  }

private:
  template <class Insert>
  void Run(const Insert& insert, Monitor& monitor, const ProgressRange& progress)
  {
    // Cells to check, with their versions, which tell whether they still exist. Checked ones are
    // dropped: they far outnumber the cells of the mesh.
    std::deque<std::pair<Id, Id>> queue;
    for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      queue.push_back({ cell, this->Mesh.Cell(cell).Version });
    }
    // Each resulting cell is checked several times.
    const LoopProgress looked(monitor, progress,
      static_cast<std::size_t>(2 * this->Sizes.EstimatedCells()) + 2 * queue.size());
    for (std::size_t turn = 0; !queue.empty(); ++turn)
    {
      looked.Check(turn);
      const auto [cell, version] = queue.front();
      queue.pop_front();
      if (!this->Mesh.IsDead(cell) && this->Mesh.Cell(cell).Version == version && insert(cell))
      {
        for (const Id fresh : this->Mesh.Fresh())
        {
          queue.push_back({ fresh, this->Mesh.Cell(fresh).Version });
        }
      }
    }
  }

  bool InsertFromLattice(Id cell)
  {
    const Circumsphere sphere = this->SphereAround(cell);
    if (!this->IsTooLarge(cell, sphere))
    {
      return false;
    }
    const Point site = this->SiteNear(sphere.Center);
    if (!(SquaredDistance(site, sphere.Center) < sphere.SquaredRadius) ||
      !this->Insertion.Locate(cell, site))
    {
      return false;
    }
    const double size = this->Sizes.At(this->Insertion.Holder(), site);
    return this->IsUniform(size) && this->InsertApart(site, size, LeastLatticeSpacing * size);
  }

  bool InsertCenter(Id cell)
  {
    const Circumsphere sphere = this->SphereAround(cell);
    const double shortest =
      ShortestEdgeOf(CornersOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners));
    const double largest = this->MostRadiusEdgeRatio * shortest;
    const bool isThin = this->Budget > 0 && sphere.SquaredRadius > largest * largest;
    if ((!isThin && !this->IsTooLarge(cell, sphere)) ||
      !this->Insertion.Locate(cell, sphere.Center))
    {
      return false;
    }
    const double size = this->Sizes.At(this->Insertion.Holder(), sphere.Center);
    const double least = isThin ? std::max(shortest, LeastSpacingBesideShort * size) : size;
    if (!this->InsertApart(sphere.Center, size, std::min(LeastSpacing * size, least)))
    {
      return false;
    }
    this->Budget -= isThin ? 1 : 0;
    return true;
  }

  /** Insert the located place, unless another point is near. */
  bool InsertApart(const Point& place, double size, double spacing)
  {
    if (this->Insertion.SquaredDistanceToHolder() < spacing * spacing ||
      !this->Insertion.FindCavity(LargestCavity) ||
      this->Insertion.SquaredSpacing() < spacing * spacing)
    {
      return false;
    }
    this->Sizes.Append(this->Insertion.Holder(), place);
    this->Insertion.Insert(size);
    return true;
  }

  bool HasLattice() const { return this->Side < std::numeric_limits<double>::infinity(); }

  /** Whether a length is (nearly) the one wanted everywhere. */
  bool IsUniform(double size) const
  {
    return this->HasLattice() && size >= LeastUniformShare * this->Sizes.Most();
  }

  Circumsphere SphereAround(Id cell) const
  {
    const std::array<Point, 4> c = CornersOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners);
    return CircumsphereOf(c[0], c[1], c[2], c[3]);
  }

  bool IsTooLarge(Id cell, const Circumsphere& sphere) const
  {
    if (!IsFinite(sphere.Center))
    {
      return false;
    }
    const double size = this->Sizes.At(cell, sphere.Center);
    const double most = (this->IsUniform(size) ? LargestUniformRadius : LargestRadius) * size;
    if (sphere.SquaredRadius > most * most)
    {
      return true;
    }
    const std::array<Point, 4> c = CornersOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners);
    return this->MaximumVolume > 0 &&
      Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0])) >
      6 * this->MaximumVolume;
  }

  /** The nearest lattice point: a corner or the center of a cube. */
  Point SiteNear(const Point& place) const
  {
    Point corner;
    Point middle;
    for (int k = 0; k < 3; ++k)
    {
      const double steps = (place[k] - this->Origin[k]) / this->Side;
      corner[k] = this->Origin[k] + this->Side * std::round(steps);
      middle[k] = this->Origin[k] + this->Side * (std::floor(steps) + 0.5);
    }
    return SquaredDistance(corner, place) < SquaredDistance(middle, place) ? corner : middle;
  }

  RefinableMesh& Mesh;
  SizingField& Sizes;
  const double MaximumVolume; ///< of a cell; 0: any
  PointInsertion Insertion;
  std::size_t Budget; ///< points left for thin cells
  const double MostRadiusEdgeRatio;
  double Side;
  Point Origin;
};
} // namespace

void ThinPoints(RefinableMesh& mesh)
{
  Contraction contraction(mesh);
  std::vector<Id> star;
  for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); ++p)
  {
    if (mesh.CellAt(p) != None && mesh.Kinds[p] == PointKind::Free &&
      NearestNeighbor(mesh, p, star) < CrowdedSpacing * mesh.Sizes[p])
    {
      contraction.Remove(p, 0, std::numeric_limits<double>::infinity());
    }
  }
}

void FillWithPoints(RefinableMesh& mesh, SizingField& sizes, double maximumVolume,
  SurfaceTreatment surface, Monitor& monitor, const ProgressRange& progress)
{
  Filling filling(mesh, sizes, maximumVolume, surface);
  filling.FillWithLattice(monitor, { progress.Stage, progress.At(0), progress.At(0.6) });
  filling.FillWithCenters(monitor, { progress.Stage, progress.At(0.6), progress.At(1) });
}
} // namespace insideout
