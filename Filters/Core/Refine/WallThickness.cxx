// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/WallThickness.h"

#include "Common/LoopProgress.h"
#include "Common/Vectors.h"
#include "Refine/FacetAhead.h"
#include "Refine/SurfacePiece.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace insideout
{
namespace
{
/** Facets whose planes include at most an angle of this cosine face each other: 45 degrees. */
const double LeastCosineFacing = std::sqrt(0.5);

/**
 * Limit of the parts into which all facets are halved, for work and memory on thin sheets. Fewer
 * and larger parts measure the thickness at fewer places.
 */
constexpr double MostParts = 1 << 17;

constexpr double Infinite = std::numeric_limits<double>::infinity();

Point UnitNormalOf(const std::array<Point, 3>& t)
{
  const Point normal = NormalOf(t[0], t[1], t[2]);
  const double length = Length(normal);
  return length > 0 ? Point{ { normal[0] / length, normal[1] / length, normal[2] / length } }
                    : Point{ { 0, 0, 0 } };
}

class WallFinder
{
public:
  WallFinder(const RefinableMesh& mesh, Id facets)
    : Mesh(mesh)
    , MostHalvings(std::max(0, std::ilogb(MostParts / std::max<Id>(facets, 1))))
  {
  }

  void AddFace(Id cell, int k)
  {
    this->Cell = cell;
    this->Face = k;
    this->Corners = this->Mesh.FaceCorners(cell, k);
    const std::array<Point, 3> t = CornersOf(this->Mesh.Points, this->Corners);
    this->Inward = UnitNormalOf(t);
    if (Length(this->Inward) > 0)
    {
      this->AddPart(t, 0);
    }
  }

  std::vector<WallPart> Walls;

private:
  void AddPart(const std::array<Point, 3>& t, int halvings)
  {
    const double thickness = this->ThicknessAt(t);
    int longest = 0;
    for (int k = 1; k < 3; ++k)
    {
      longest =
        Distance(t[k], t[(k + 1) % 3]) > Distance(t[longest], t[(longest + 1) % 3]) ? k : longest;
    }
    const Point& a = t[longest];
    const Point& b = t[(longest + 1) % 3];
    const Point& c = t[(longest + 2) % 3];
    if (thickness < Distance(a, b) && halvings < this->MostHalvings)
    {
      const Point middle = Midpoint(a, b);
      this->AddPart({ { a, middle, c } }, halvings + 1);
      this->AddPart({ { middle, b, c } }, halvings + 1);
      return;
    }
    if (thickness < Infinite)
    {
      WallPart part = { t, thickness };
      for (Point& corner : part.Middle)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          corner[axis] += thickness / 2 * this->Inward[axis];
        }
      }
      this->Walls.push_back(part);
    }
  }

  /** The distance from the center of a part to a facet that faces it; else infinite. */
  double ThicknessAt(const std::array<Point, 3>& t) const
  {
    const FacetAhead ahead = FindFacetAhead(
      this->Mesh, { CentreOf(t), this->Cell, this->Face, -1 }, this->Inward, Infinite);
    if (ahead.Cell == None || !(ahead.Way > 0))
    {
      return Infinite;
    }
    const Triangle other = this->Mesh.FaceCorners(ahead.Cell, ahead.Face);
    const bool touches = std::any_of(other.begin(), other.end(),
      [&](Id corner) {
        return std::find(this->Corners.begin(), this->Corners.end(), corner) != this->Corners.end();
      });
    const double cosine = -Dot(this->Inward, UnitNormalOf(CornersOf(this->Mesh.Points, other)));
    return touches || cosine < LeastCosineFacing ? Infinite : ahead.Way;
  }

  const RefinableMesh& Mesh;
  const int MostHalvings; ///< of each facet
  Id Cell = None;
  int Face = 0;
  Triangle Corners = { { None, None, None } };
  Point Inward = { { 0, 0, 0 } };
};

/**
 * The large parts, and the thinnest of the small parts in each cube. Cubes have a quarter of the
 * parts' thickness, rounded to a power of two.
 */
std::vector<WallPart> WithoutCrowds(const std::vector<WallPart>& walls)
{
  std::vector<WallPart> kept;
  std::map<std::array<double, 4>, WallPart> thinnest;
  for (const WallPart& wall : walls)
  {
    const double side = std::ldexp(0.25, std::ilogb(wall.Thickness));
    const std::array<Point, 3>& t = wall.Middle;
    if (std::max({ Distance(t[0], t[1]), Distance(t[1], t[2]), Distance(t[2], t[0]) }) > side)
    {
      kept.push_back(wall);
      continue;
    }
    const auto [found, isNew] =
      thinnest.insert({ { { side, std::floor(t[0][0] / side), std::floor(t[0][1] / side),
                          std::floor(t[0][2] / side) } },
        wall });
    if (!isNew && wall.Thickness < found->second.Thickness)
    {
      found->second = wall;
    }
  }
  std::transform(thinnest.begin(), thinnest.end(), std::back_inserter(kept),
    [](const auto& one) { return one.second; });
  return kept;
}
} // namespace

std::vector<WallPart> WallsOf(
  const RefinableMesh& mesh, Monitor& monitor, const ProgressRange& progress)
{
  Id facets = 0; // from both sides
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    const auto& own = mesh.Cell(c).Facets;
    facets += static_cast<Id>(4 - std::count(own.begin(), own.end(), None));
  }
  WallFinder finder(mesh, facets);
  const LoopProgress looked(monitor, progress, static_cast<std::size_t>(mesh.NumberOfCells()));
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    looked.Check(static_cast<std::size_t>(c));
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Cell(c).Facets[k] != None)
      {
        finder.AddFace(c, k);
      }
    }
  }
  return WithoutCrowds(finder.Walls);
}
} // namespace insideout
