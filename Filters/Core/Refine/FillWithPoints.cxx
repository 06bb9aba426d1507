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
#include <vector>

namespace insideout
{
namespace
{
/**
 * Of the length that edges are to have there: the largest radius of a circumsphere, that of a
 * regular cell being 0.61, and how near another point may be. Edges come out near that length then
 * at the median; where the second is as large as the first, gaps beside facets stay open.
 */
constexpr double LargestRadius = 0.8;
constexpr double LeastSpacing = 0.7;

/**
 * Of the shortest edge of a cell: radii may be this large (Shewchuk 1998). Beside short edges of a
 * surface cells are small then, also where lengths that are means of short and long edges are not.
 */
constexpr double LargestRadiusEdgeRatio = 2;

/** Larger cavities would be of places far from the cell that is to go. */
constexpr std::size_t LargestCavity = 2000;

/** Of the length, where edges are shorter: beside two points that are all but one there would be
 * points without number. */
constexpr double LeastSpacingBesideShort = 0.01;

/** Per point that is there, so many are inserted for radii of thin cells at most: only a budget. */
constexpr std::size_t MostBesideShort = 4;

/**
 * Where one length is asked for, the surface is remeshed to it, and its edges are not shorter than
 * this part of it, points lie on a body-centerd cubic lattice: its cells are congruent, and their
 * edges are as long as the side of a cube and 0.87 of it.
 */
constexpr double LeastUniformShare = 0.8;

/** Shares of the length: the side of the lattice's cubes, the largest radius of a circumsphere
 * beside the lattice, and how near a point of it may be to others. Most edges are longer than the
 * length then: cells of a mesh whose median edge is as long are 1.6 times as many as gmsh makes. */
constexpr double LatticeSide = 1.36;
constexpr double LargestUniformRadius = 0.86;
constexpr double LeastLatticeSpacing = 0.75;

/** The lattice's cells have this share of the largest volume, so that rounding makes none larger.
 */
constexpr double ShareOfVolume = 0.99;

/** Points nearer to another than this part of the length are taken out. */
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

/** A cell to look at, and its version, by which one knows whether it is still there. */
struct Candidate
{
  Id Cell;
  Id Version;
};

class Filling
{
public:
  Filling(RefinableMesh& mesh, SizingField& sizes, double maximumVolume, bool isUniform)
    : Mesh(mesh)
    , Sizes(sizes)
    , MaximumVolume(maximumVolume)
    , Insertion(mesh)
    , Budget(MostBesideShort * mesh.Points.size())
    , Side(isUniform ? LatticeSide * sizes.Most() : std::numeric_limits<double>::infinity())
  {
    const Box box = BoundingBox(mesh.Points);
    if (isUniform && maximumVolume > 0)
    {
      this->Side = std::min(this->Side, std::cbrt(12 * ShareOfVolume * maximumVolume));
    }
    // Beside the middle, where points of the input may be.
    this->Origin = Midpoint(box.Low, box.High);
    for (int k = 0; k < 3 && this->HasLattice(); ++k)
    {
      this->Origin[k] += (k + 1) / 7.0 * this->Side;
    }
  }

  /** Insert points of the lattice where one length is wanted. */
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
    std::deque<Candidate> queue; // what was looked at goes: there are far more than cells
    for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      queue.push_back({ cell, this->Mesh.Cell(cell).Version });
    }
    // Each cell that there will be is looked at some times.
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
    const double largest = LargestRadiusEdgeRatio * shortest;
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

  /** Insert the place that was located, unless another point is near. */
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

  /** Whether a length is the one that is asked for everywhere, or nearly. */
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

  /** The nearest point of the lattice: a corner of a cube, or its middle. */
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
  std::size_t Budget; ///< of points for thin cells
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
  const bool isUniform = surface == SurfaceTreatment::Remeshed;
  Filling filling(mesh, sizes, maximumVolume, isUniform);
  filling.FillWithLattice(monitor, { progress.Stage, progress.At(0), progress.At(0.6) });
  filling.FillWithCenters(monitor, { progress.Stage, progress.At(0.6), progress.At(1) });
}
} // namespace insideout
