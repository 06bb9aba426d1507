// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SurfaceCurvature.h"

#include "Common/Edge.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace insideout
{
namespace
{
/**
 * Relative rounding error of coordinates in floats, as files store them: some units in the last
 * place.
 */
constexpr double RoundingOfFloats = 4.0 / (1 << 24);

/** An edge where two facets meet without a corner. */
struct SmoothEdge
{
  Id Other;
  Point Along;   ///< from one end to the other
  double Signed; ///< angle between the normals, positive where it is convex
};

/** The normal, area and smooth edges of a facet. */
struct FlatFacet
{
  Point Normal; ///< of unit length, or 0
  double Area;
  std::vector<SmoothEdge> Edges;
};

/** The curvature of a surface in its tangential plane, times an area. */
struct Tensor
{
  double XX = 0;
  double XY = 0;
  double YY = 0;

  /** The largest absolute eigenvalue. */
  double Largest() const
  {
    const double mean = (this->XX + this->YY) / 2;
    return std::abs(mean) + std::hypot((this->XX - this->YY) / 2, this->XY);
  }
};

Point Scaled(const Point& a, double factor)
{
  return { { factor * a[0], factor * a[1], factor * a[2] } };
}

Triangle CornersIn(const TetrahedralMesh& mesh, const FacetOfInput& facet)
{
  return FaceOf(mesh.Cells[facet.Faces[0] / 4], facet.Faces[0] % 4);
}

Id ApexOf(const Triangle& corners, const Edge& edge)
{
  return *std::find_if(corners.begin(), corners.end(),
    [&](Id corner) { return corner != edge[0] && corner != edge[1]; });
}

class FacetsAlongEdges
{
public:
  FacetsAlongEdges(
    const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets, double featureAngle)
    : Mesh(mesh)
    , Facets(facets)
  {
    std::unordered_map<Edge, std::vector<Id>, HashOfEdge> facetsAt;
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
      const Triangle corners = CornersIn(mesh, facets[f]);
      const std::array<Point, 3> c = CornersOf(mesh.Points, corners);
      const Point normal = NormalOf(c[0], c[1], c[2]);
      const double length = Length(normal);
      this->All.push_back(
        { length > 0 ? Scaled(normal, 1 / length) : Point{ { 0, 0, 0 } }, length / 2, {} });
      for (int k = 0; k < 3; ++k)
      {
        facetsAt[EdgeBetween(corners[k], corners[(k + 1) % 3])].push_back(static_cast<Id>(f));
      }
    }
    const double most = featureAngle * std::acos(-1.0) / 180;
    for (std::size_t f = 0; f < facets.size(); ++f) // in this order, to make sums reproducible
    {
      const Triangle corners = CornersIn(mesh, facets[f]);
      for (int k = 0; k < 3; ++k)
      {
        const Edge edge = EdgeBetween(corners[k], corners[(k + 1) % 3]);
        const std::vector<Id>& there = facetsAt.at(edge);
        if (there.size() == 2)
        {
          this->Connect(
            there[0] == static_cast<Id>(f) ? there : std::vector<Id>{ there[1], there[0] }, edge,
            most);
        }
      }
    }
  }

  double RadiusAt(Id f, double rounding) const
  {
    const FlatFacet& facet = this->All[f];
    const Point x = this->TangentOf(f);
    const Point y = Cross(facet.Normal, x);
    Tensor sum;
    double area = 0;
    double longest = 0;
    const auto add = [&](const FlatFacet& one)
    {
      area += one.Area;
      for (const SmoothEdge& edge : one.Edges)
      {
        const double length = Length(edge.Along);
        longest = std::max(longest, length);
        if (length > 0)
        {
          const double u = Dot(edge.Along, x) / length;
          const double v = Dot(edge.Along, y) / length;
          const double half = edge.Signed * length / 2; // the other half counts for the neighbor
          sum.XX += half * u * u;
          sum.XY += half * u * v;
          sum.YY += half * v * v;
        }
      }
    };
    add(facet);
    for (const SmoothEdge& edge : facet.Edges)
    {
      add(this->All[edge.Other]);
    }
    const double curvature = area > 0 ? sum.Largest() / area : 0;
    const double width = longest > 0 ? 2 * area / longest : 0;
    return curvature * width * width / 8 > rounding ? 1 / curvature
                                                    : std::numeric_limits<double>::infinity();
  }

private:
  /** Note the edge for the first of both facets. */
  void Connect(const std::vector<Id>& both, const Edge& edge, double most)
  {
    const Triangle corners = CornersIn(this->Mesh, this->Facets[both[1]]);
    const Triangle own = CornersIn(this->Mesh, this->Facets[both[0]]);
    const auto runsAlike = [&](const Triangle& t)
    {
      const auto at = std::find(t.begin(), t.end(), edge[0]) - t.begin();
      return t[(at + 1) % 3] == edge[1];
    };
    const Point& normal = this->All[both[0]].Normal;
    // Facets between regions may be seen from different sides.
    const Point other =
      Scaled(this->All[both[1]].Normal, runsAlike(own) == runsAlike(corners) ? -1 : 1);
    const double angle = std::atan2(Length(Cross(normal, other)), Dot(normal, other));
    if (angle > most)
    {
      return;
    }
    const Point& from = this->Mesh.Points[edge[0]];
    const double side = Dot(normal, Difference(this->Mesh.Points[ApexOf(corners, edge)], from));
    this->All[both[0]].Edges.push_back(
      { both[1], Difference(this->Mesh.Points[edge[1]], from), side < 0 ? angle : -angle });
  }

  /** A direction in a facet. */
  Point TangentOf(Id f) const
  {
    const Point edge = Difference(this->Facets[f].Corners[1], this->Facets[f].Corners[0]);
    const double length = Length(edge);
    return length > 0 ? Scaled(edge, 1 / length) : Point{ { 1, 0, 0 } };
  }

  const TetrahedralMesh& Mesh;
  const std::vector<FacetOfInput>& Facets;
  std::vector<FlatFacet> All;
};
} // namespace

std::vector<double> RadiiOfCurvature(
  const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets, double featureAngle)
{
  const FacetsAlongEdges along(mesh, facets, featureAngle);
  const double rounding = RoundingOfFloats * LargestCoordinate(mesh.Points);
  std::vector<double> radii;
  radii.reserve(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    radii.push_back(along.RadiusAt(static_cast<Id>(f), rounding));
  }
  return radii;
}
} // namespace insideout
