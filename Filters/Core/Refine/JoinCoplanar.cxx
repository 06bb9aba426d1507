// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/JoinCoplanar.h"

#include "Common/Box.h"
#include "Common/Buckets.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insideout
{
namespace
{
/** Relative to the largest coordinate: points this near to a plane are on it, up to rounding. */
constexpr double Rounding = 16 * std::numeric_limits<double>::epsilon();

/** Relative to the longest edge of the bounding box: the same where a file rounded coordinates to
 * some six digits, if the normals differ by at most an angle, in degrees. */
constexpr double RoundingOfFiles = 1e-6;
constexpr double LargestAngle = 0.1;

/** Decimal digits of such a file at most, counted from the first one of the longest edge. */
constexpr int MostDigits = 9;

/** Relative to a unit of the last digit: coordinates this near to a multiple are one, for rounding
 * of a conversion between units leaves less. */
constexpr double RoundingOfDigits = 1e-6;

/** An edge of a facet. */
struct EdgeUse
{
  Edge Ends;
  Id Facet;

  bool operator<(const EdgeUse& other) const
  {
    return this->Ends != other.Ends ? this->Ends < other.Ends : this->Facet < other.Facet;
  }
};

/** The facets of one label beyond the edges of each. */
Buckets<Id> NeighborsOf(const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets)
{
  std::vector<EdgeUse> uses;
  uses.reserve(3 * facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    const Id face = facets[f].Faces[0];
    const Triangle corners = FaceOf(mesh.Cells[face / 4], face % 4);
    for (int i = 0; i < 3; ++i)
    {
      uses.push_back({ EdgeBetween(corners[i], corners[(i + 1) % 3]), static_cast<Id>(f) });
    }
  }
  std::sort(uses.begin(), uses.end());
  return Buckets<Id>(facets.size(),
    [&](const auto& visit)
    {
      for (std::size_t first = 0, last = 0; first < uses.size(); first = last)
      {
        for (last = first; last < uses.size() && uses[last].Ends == uses[first].Ends; ++last)
        {
        }
        const Id one = uses[first].Facet;
        const Id other = uses[last - 1].Facet;
        if (last - first == 2 && facets[one].Label == facets[other].Label)
        {
          visit(one, other);
          visit(other, one);
        }
      }
    });
}

/** How near to a plane its points are where a file rounded at least half of the facets' corners:
 * intersections, which the others may be, have more digits. 0 if none did. */
double RoundingByDigits(const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets)
{
  const Box box = BoundingBox(mesh.Points);
  const double size = box.Extent(box.LongestAxis());
  const double unit = std::pow(10, std::floor(std::log10(size)) + 1 - MostDigits);
  const auto isRounded = [unit](const Point& corner)
  {
    return std::all_of(corner.begin(), corner.end(),
      [unit](double x)
      {
        return x == static_cast<float>(x) ||
          std::abs(x / unit - std::round(x / unit)) < RoundingOfDigits;
      });
  };
  std::size_t rounded = 0;
  for (const FacetOfInput& facet : facets)
  {
    rounded += std::count_if(facet.Corners.begin(), facet.Corners.end(), isRounded);
  }
  return 2 * rounded >= 3 * facets.size() ? RoundingOfFiles * size : 0;
}
} // namespace

void JoinCoplanar(
  const TetrahedralMesh& mesh, const std::vector<char>& locked, std::vector<FacetOfInput>& facets)
{
  const Buckets<Id> neighbors = NeighborsOf(mesh, facets);
  const double byDigits = RoundingByDigits(mesh, facets);
  const double leastCosine = std::cos(LargestAngle * std::acos(-1.0) / 180);
  std::vector<Point> normals;
  double most = 0;
  for (const FacetOfInput& facet : facets)
  {
    normals.push_back(NormalOf(facet.Corners[0], facet.Corners[1], facet.Corners[2]));
    for (const Point& corner : facet.Corners)
    {
      most = std::max({ most, std::abs(corner[0]), std::abs(corner[1]), std::abs(corner[2]) });
    }
  }
  std::vector<Id> largestFirst(facets.size());
  std::iota(largestFirst.begin(), largestFirst.end(), 0);
  std::stable_sort(largestFirst.begin(), largestFirst.end(),
    [&](Id f, Id g) { return Dot(normals[f], normals[f]) > Dot(normals[g], normals[g]); });

  std::vector<Id> patches(facets.size(), None);
  std::vector<Id> joined;
  for (const Id largest : largestFirst)
  {
    if (patches[largest] != None)
    {
      continue;
    }
    const Point& normal = normals[largest];
    const double length = Length(normal);
    const auto isInPlane = [&](Id f)
    {
      const double product = Dot(normals[f], normal);
      const bool isParallel = product >= leastCosine * length * Length(normals[f]);
      const double highest = std::max(Rounding * most, isParallel ? byDigits : 0) * length;
      return product > 0 &&
        std::all_of(facets[f].Corners.begin(), facets[f].Corners.end(),
          [&](const Point& corner) {
            return std::abs(Dot(Difference(corner, facets[largest].Corners[0]), normal)) <= highest;
          });
    };
    patches[largest] = largest;
    joined.assign(1, largest);
    for (std::size_t next = 0; next < joined.size() && locked[largest] == 0; ++next)
    {
      for (const Id other : neighbors[joined[next]])
      {
        if (patches[other] == None && locked[other] == 0 && isInPlane(other))
        {
          patches[other] = largest;
          joined.push_back(other);
        }
      }
    }
  }
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    facets[f].Label = patches[f];
  }
}
} // namespace insideout
