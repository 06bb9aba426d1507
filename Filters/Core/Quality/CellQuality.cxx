// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/CellQuality.h"

#include "Common/DoubleDouble.h"
#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
/**
 * Six volumes over the cubed longest edge, below which doubles do not suffice: above it normals and
 * volume have at least 30 reliable bits.
 */
constexpr double ThinVolume = 0x1p-20;

/** Range of sizes in which products of eight neither overflow nor underflow. */
constexpr double SmallestSize = 1e-15;
constexpr double LargestSize = 1e15;

constexpr double DegreesPerRadian = 57.295779513082320876798154814105;

using Corners = std::array<Point, 4>;

/** The two faces at each edge (TetrahedronEdges), by their opposite corners. */
constexpr std::array<std::array<int, 2>, 6> FacesAtEdges = { { { { 2, 3 } }, { { 0, 3 } },
  { { 1, 3 } }, { { 1, 2 } }, { { 0, 2 } }, { { 0, 1 } } } };

/** a - b, exact unless it underflows. */
DoubleDouble ExactDifference(double a, double b)
{
  return TwoSum(a, -b);
}

template <typename Number>
Vector<Number> Edge(const Corners& corners, int from, int to);

template <>
Vector<double> Edge(const Corners& corners, int from, int to)
{
  return Difference(corners[to], corners[from]);
}

template <>
Vector<DoubleDouble> Edge(const Corners& corners, int from, int to)
{
  const Point& a = corners[to];
  const Point& b = corners[from];
  return { ExactDifference(a[0], b[0]), ExactDifference(a[1], b[1]), ExactDifference(a[2], b[2]) };
}

template <typename Number>
Vector<Number> Scaled(const Number& factor, const Vector<Number>& a)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

template <typename Number>
Vector<Number> Sum(const Vector<Number>& a, const Vector<Number>& b, const Vector<Number>& c)
{
  return { a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2] };
}

template <typename Number>
double LengthOf(const Vector<Number>& a)
{
  return std::sqrt(static_cast<double>(Dot(a, a)));
}

/** The quantities from which quality is computed. */
struct Sizes
{
  std::array<double, 6> Cosines; ///< of TetrahedronEdges: times both faces' areas, doubled
  std::array<double, 6> Sines;   ///< the same
  std::array<double, 6> Lengths; ///< of TetrahedronEdges
  double Volume;                 ///< times six
  double Radius;                 ///< of the circumsphere, times twelve volumes
};

template <typename Number>
Sizes SizesOf(const Corners& corners)
{
  std::array<Vector<Number>, 6> edges;
  Sizes sizes;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    edges[e] = Edge<Number>(corners, TetrahedronEdges[e][0], TetrahedronEdges[e][1]);
    sizes.Lengths[e] = LengthOf(edges[e]);
  }
  const Vector<Number>& a = edges[0]; // from corner 0 to 1
  const Vector<Number> b = Edge<Number>(corners, 0, 2);
  const Vector<Number>& c = edges[3]; // to 3
  const Vector<Number> ab = Cross(a, b);
  const Vector<Number> bc = Cross(b, c);
  const Vector<Number> ca = Cross(c, a);
  // The inward normals of the faces opposite to each corner; their length is twice the area.
  const std::array<Vector<Number>, 4> normals = { Cross(edges[4], edges[1]), bc, ca, ab };
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const Vector<Number>& one = normals[FacesAtEdges[e][0]];
    const Vector<Number>& other = normals[FacesAtEdges[e][1]];
    sizes.Cosines[e] = -static_cast<double>(Dot(one, other));
    sizes.Sines[e] = LengthOf(Cross(one, other));
  }
  sizes.Volume = static_cast<double>(Dot(a, bc));
  sizes.Radius = LengthOf(Sum(Scaled(Dot(a, a), bc), Scaled(Dot(b, b), ca), Scaled(Dot(c, c), ab)));
  return sizes;
}

/**
 * Six times the volume, from the edge whose faces are farthest from parallel: their normals' cross
 * product is the edge times that number. This is accurate for needles, unlike a determinant.
 */
double VolumeBySines(const Sizes& sizes)
{
  double volume = 0;
  double widest = -1;
  for (std::size_t e = 0; e < sizes.Sines.size(); ++e)
  {
    const double tangent = sizes.Sines[e] / std::abs(sizes.Cosines[e]);
    if (tangent > widest)
    {
      widest = tangent;
      volume = sizes.Sines[e] / sizes.Lengths[e];
    }
  }
  return volume;
}

/** The corners times a power of two, so that no product overflows or underflows. */
Corners InRange(Corners corners)
{
  double size = 0;
  for (const auto& [i, j] : TetrahedronEdges)
  {
    for (int k = 0; k < 3; ++k)
    {
      size = std::max(size, std::abs(corners[i][k] / 2 - corners[j][k] / 2));
    }
  }
  if (size > LargestSize || (size < SmallestSize && size > 0))
  {
    int exponent = 0;
    std::frexp(size, &exponent);
    for (Point& p : corners)
    {
      for (double& x : p)
      {
        x = std::ldexp(x, -exponent);
      }
    }
  }
  return corners;
}

/**
 * In doubles if these suffice, else in double-doubles with exact signs; a flat cell has no sines.
 */
Sizes ReliableSizes(const Corners& given)
{
  const Corners corners = InRange(given);
  const Sizes sizes = SizesOf<double>(corners);
  const double longest = *std::max_element(sizes.Lengths.begin(), sizes.Lengths.end());
  if (std::abs(sizes.Volume) >= ThinVolume * longest * longest * longest && longest > 0)
  {
    return sizes;
  }
  Sizes precise = SizesOf<DoubleDouble>(corners);
  const int sign = Orient3D(given[0], given[1], given[2], given[3]);
  precise.Volume = sign == 0 ? 0 : sign * VolumeBySines(precise);
  if (sign == 0)
  {
    precise.Sines.fill(0);
  }
  return precise;
}
} // namespace

CellQuality QualityOfCell(const Corners& corners)
{
  const Sizes sizes = ReliableSizes(corners);
  CellQuality quality;
  double squares = 0;
  for (std::size_t e = 0; e < sizes.Lengths.size(); ++e)
  {
    const bool hasAngle = sizes.Sines[e] != 0 || sizes.Cosines[e] != 0;
    quality.DihedralAngles[e] =
      hasAngle ? DegreesPerRadian * std::atan2(sizes.Sines[e], sizes.Cosines[e]) : 0;
    squares += sizes.Lengths[e] * sizes.Lengths[e];
  }
  const double volume = std::abs(sizes.Volume);
  const double shortest = *std::min_element(sizes.Lengths.begin(), sizes.Lengths.end());
  const double bound = 2 * volume * shortest;
  quality.RadiusEdgeRatio =
    bound > 0 ? sizes.Radius / bound : std::numeric_limits<double>::infinity();
  // Independent of the size, so that rounding of the root is the same for all sizes.
  const double root = std::cbrt(volume / (2 * squares * std::sqrt(squares)));
  quality.MeanRatio = volume > 0 ? std::copysign(12 * root * root, sizes.Volume) : 0;
  return quality;
}

CellQuality QualityOfCell(const std::vector<Point>& points, const Tetrahedron& cell)
{
  return QualityOfCell(CornersOf(points, cell));
}
} // namespace insideout
