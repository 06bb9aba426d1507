// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/SurfaceFamilies.h"

#include "Support/TestMeshes.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace testmeshes
{
namespace
{
using Map = std::function<Point(const Point&)>;

TriangleSoup Mapped(TriangleSoup soup, const Map& map)
{
  for (Point& p : soup.Points)
  {
    p = map(p);
  }
  return soup;
}

/** A rotation whose matrix has no simple entry: nothing stays exactly in a plane. By literals, for
 * a compiler's own sine may differ from the library's in the last place. */
Point Rotated(const Point& p)
{
  const double cosA = 0.7648421872844885;
  const double sinA = 0.64421768723769102;
  const double cosB = 0.45359612142557731;
  const double sinB = 0.89120736006143542;
  const Point q = { cosA * p[0] - sinA * p[1], sinA * p[0] + cosA * p[1], p[2] };
  return { q[0], cosB * q[1] - sinB * q[2], sinB * q[1] + cosB * q[2] };
}

/** Rounded to floats. Volatile, for gcc 12 leaves the rounding out of vectorized code. */
Point ToFloat(const Point& p)
{
  Point rounded;
  for (int k = 0; k < 3; ++k)
  {
    volatile float x = static_cast<float>(p[k]);
    rounded[k] = static_cast<double>(x);
  }
  return rounded;
}

Map ScaledBy(double factor)
{
  return [factor](const Point& p) { return Point{ factor * p[0], factor * p[1], factor * p[2] }; };
}

Map MovedBy(const Point& offset)
{
  return [offset](const Point& p) {
    return Point{ p[0] + offset[0], p[1] + offset[1], p[2] + offset[2] };
  };
}

TriangleSoup UnitBoxAt(const Point& low)
{
  return Box(low, { low[0] + 1, low[1] + 1, low[2] + 1 });
}

double Uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (random() / 4294967296.0);
}

/** The rectangle [0, 1] x [0, height] at z = 0, in columns x rows quadrilaterals. */
TriangleSoup Sheet(int columns, int rows, double height = 1)
{
  TriangleSoup sheet;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      sheet.Points.push_back(
        { static_cast<double>(i) / columns, height * static_cast<double>(j) / rows, 0 });
    }
  }
  for (Id j = 0; j < rows; ++j)
  {
    for (Id i = 0; i < columns; ++i)
    {
      const Id p = j * (columns + 1) + i;
      const Id q = p + columns + 1;
      sheet.Triangles.push_back({ p, p + 1, q + 1 });
      sheet.Triangles.push_back({ p, q + 1, q });
    }
  }
  return sheet;
}

/** The mantle of a cylinder about the z axis, in segments x rows quadrilaterals. */
TriangleSoup Cylinder(int segments, int rows)
{
  return Mapped(Sheet(segments, rows),
    [](const Point& p)
    {
      const double angle = 2 * 3.14159265358979323846 * p[0];
      return Point{ std::cos(angle), std::sin(angle), p[1] };
    });
}

/** Random triangles with small integer corners in planes z = m x + n y + c: some in each. */
TriangleSoup OverlapsInPlanes(unsigned seed, int planes, int trianglesPerPlane)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  for (int i = 0; i < planes; ++i)
  {
    const double m = static_cast<double>(random() % 5) - 2;
    const double n = static_cast<double>(random() % 5) - 2;
    const double c = static_cast<double>(random() % 3);
    TriangleSoup flat = GridSoup(random(), trianglesPerPlane, 6);
    for (Point& p : flat.Points)
    {
      p[2] = m * p[0] + n * p[1] + c;
    }
    soup = Join(soup, flat);
  }
  return soup;
}

/** Triangles within each other in one plane, corner on edge, or with a gap between. */
TriangleSoup NestedTriangles(int depth, bool touching)
{
  TriangleSoup soup;
  std::array<Point, 3> t = { { { 0, 0, 0 }, { 4096, 0, 4096 }, { 0, 4096, -4096 } } };
  for (int i = 0; i < depth; ++i)
  {
    const Id first = static_cast<Id>(soup.Points.size());
    soup.Points.insert(soup.Points.end(), t.begin(), t.end());
    soup.Triangles.push_back({ first, first + 1, first + 2 });
    const auto between = [&](int p, int q, double share)
    {
      Point x;
      for (int k = 0; k < 3; ++k)
      {
        x[k] = t[p][k] + share * (t[q][k] - t[p][k]);
      }
      return x;
    };
    t = touching
      ? std::array<Point, 3>{ between(0, 1, 0.5), between(1, 2, 0.5), between(2, 0, 0.5) }
      : std::array<Point, 3>{ t[0], between(0, 1, 0.75), between(0, 2, 0.75) };
  }
  return soup;
}

/** A comb whose teeth go through its back: each cuts a segment out. */
TriangleSoup PiercingComb(int teeth)
{
  TriangleSoup comb = Comb(teeth);
  for (Id tooth = 0; tooth < teeth; ++tooth)
  {
    comb.Points[3 + 3 * tooth][2] = -0.25;
  }
  return comb;
}

/** Facets through the line from (-1, -1, -1) to (1, 1, 1), which is not an edge of any. */
TriangleSoup PlanesThroughLine(unsigned seed, int count)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  for (int i = 0; i < count; ++i)
  {
    // u is any integer vector; u, -u + l and -u - l lie with the line l = (1, 1, 1) in a plane.
    Point u;
    do
    {
      for (double& x : u)
      {
        x = static_cast<double>(random() % 15) - 7;
      }
    } while (u[0] == u[1] && u[1] == u[2]);
    const Id first = static_cast<Id>(soup.Points.size());
    const double l = 1 + static_cast<double>(random() % 5);
    soup.Points.insert(soup.Points.end(),
      { u, { l - u[0], l - u[1], l - u[2] }, { -l - u[0], -l - u[1], -l - u[2] } });
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

/** Boxes within each other, every other one turned over, some through the walls of others. */
TriangleSoup NestedBoxes(int depth, double step)
{
  TriangleSoup soup;
  for (int i = 0; i < depth; ++i)
  {
    const double inset = step * i;
    const TriangleSoup box =
      Box({ inset, inset, inset }, { 64 - inset, 64 + (i % 3 - 1) * inset, 64 - inset });
    soup = Join(soup, i % 2 == 0 ? box : Reversed(box));
  }
  return soup;
}

/** Unit boxes in a block: walls, edges and corners shared. `shift` moves every other layer. */
TriangleSoup StackedBoxes(int side, double shift)
{
  TriangleSoup soup;
  for (int i = 0; i < side * side * side; ++i)
  {
    const int layer = i / (side * side);
    const double moved = layer % 2 == 0 ? 0 : shift;
    soup = Join(
      soup, UnitBoxAt({ i % side + moved, (i / side) % side + moved, static_cast<double>(layer) }));
  }
  return soup;
}

/** Boxes of other sizes that stand on the walls of a cube. */
TriangleSoup BoxesOnWalls()
{
  TriangleSoup soup = Box({ 0, 0, 0 }, { 4, 4, 4 });
  soup = Join(soup, Box({ 4, 1, 1 }, { 6, 3, 3 }));
  soup = Join(soup, Box({ 1, 4, 0 }, { 3, 6, 4 }));
  soup = Join(soup, Box({ -2, 0, 0 }, { 0, 4, 2 }));
  soup = Join(soup, Box({ 0.5, 0.5, 4 }, { 3.5, 1.5, 5 }));
  soup = Join(soup, Box({ 2, 2, -1 }, { 5, 5, 0 }));
  return Join(soup, Box({ 6, 1, 1 }, { 8, 3, 3 }));
}

/** Long thin triangles across each other: a short edge of `width` and a far corner. */
TriangleSoup Needles(unsigned seed, int count, double width)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  for (Id i = 0; i < count; ++i)
  {
    Point a;
    Point c;
    Point b;
    for (int k = 0; k < 3; ++k)
    {
      a[k] = Uniform(random, -1, -0.5);
      c[k] = Uniform(random, 0.5, 1);
      b[k] = a[k] + width * Uniform(random, -1, 1);
    }
    soup.Points.insert(soup.Points.end(), { a, b, c });
    soup.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return soup;
}

/** Triangles with an angle of nearly 180 degrees, the corner `height` off the long edge, and
 * ordinary ones through them. */
TriangleSoup Caps(unsigned seed, int count, double height)
{
  TriangleSoup soup = Needles(seed, count, 1);
  std::mt19937 random(seed + 1);
  for (Id i = 0; i < count; ++i)
  {
    const Point a = soup.Points[3 * i];
    const Point c = soup.Points[3 * i + 2];
    const double t = Uniform(random, 0.2, 0.8);
    for (int k = 0; k < 3; ++k)
    {
      soup.Points[3 * i + 1][k] = a[k] + t * (c[k] - a[k]) + height * Uniform(random, -1, 1);
    }
  }
  return Join(soup,
    Mapped(RandomSoup(seed, count),
      [](const Point& p) {
        return Point{ 2 * p[0] - 1, 2 * p[1] - 1, 2 * p[2] - 1 };
      }));
}

/** Every triangle `times` times, its corners turned around, in both orientations by turns of 3. */
TriangleSoup Repeated(const TriangleSoup& soup, int times)
{
  TriangleSoup repeated = soup;
  repeated.Triangles.clear();
  for (int i = 0; i < times; ++i)
  {
    for (const Triangle& t : soup.Triangles)
    {
      const Triangle turned = { t[i % 3], t[(i + 1) % 3], t[(i + 2) % 3] };
      repeated.Triangles.push_back(
        i % 3 == 2 ? Triangle{ turned[1], turned[0], turned[2] } : turned);
    }
  }
  return repeated;
}

/** member(seed) for every seed from 0 on. */
template <class Member>
std::vector<TriangleSoup> Random(int members, const Member& member)
{
  std::vector<TriangleSoup> soups;
  for (int seed = 0; seed < members; ++seed)
  {
    soups.push_back(member(static_cast<unsigned>(seed)));
  }
  return soups;
}

std::vector<SurfaceFamily> ResolvableFamilies(int members)
{
  return {
    { "coplanar-overlap",
      Random(members, [](unsigned seed) { return OverlapsInPlanes(seed, 1 + seed % 3, 12); }) },
    { "coplanar-nested",
      { NestedTriangles(12, true), NestedTriangles(12, false),
        Join(NestedTriangles(8, true), NestedTriangles(8, false)) } },
    { "comb", { Comb(7), Comb(150), PiercingComb(150), Join(Comb(50), PiercingComb(50)) } },
    { "fan", { Fan(3), Fan(12), Fan(25) } },
    { "through-one-line",
      Random(members, [](unsigned seed) { return PlanesThroughLine(seed, 8 + 4 * (seed % 4)); }) },
    { "through-one-point",
      Random(members, [](unsigned seed) { return ThroughOnePoint(seed, 4 + 4 * (seed % 4)); }) },
    { "nested-boxes", { NestedBoxes(3, 4), NestedBoxes(12, 2), NestedBoxes(6, 0.1) } },
    { "stacked-boxes",
      { StackedBoxes(2, 0), StackedBoxes(3, 0.5), StackedBoxes(2, 0.25), BoxesOnWalls() } },
    { "boxes-turned",
      { Mapped(StackedBoxes(1, 0), Rotated),
        Join(UnitBoxAt({ 0, 0, 0 }), Mapped(UnitBoxAt({ 0, 0, 0 }), Rotated)) } },
    { "duplicates-1000",
      { Repeated(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0, 0 }, { 1.5, 1, 1 })), 1000),
        Repeated(GridSoup(1, 12, 3), 1000) } },
    { "random-soup", Random(members, [](unsigned seed) { return RandomSoup(seed, 20); }) },
    // A decimal factor rounds, so that what was in one plane no longer is.
    { "scale-1e-30",
      Random(members,
        [](unsigned seed) { return Mapped(GridSoup(seed, 20, 2 + seed % 4), ScaledBy(1e-30)); }) },
    { "scale-1e30",
      Random(members,
        [](unsigned seed) { return Mapped(GridSoup(seed, 20, 2 + seed % 4), ScaledBy(1e30)); }) },
    { "scale-2^-100",
      Random(members,
        [](unsigned seed)
        { return Mapped(GridSoup(seed, 20, 2 + seed % 4), ScaledBy(0x1p-100)); }) },
    { "scale-2^100",
      Random(members,
        [](unsigned seed)
        { return Mapped(GridSoup(seed, 20, 2 + seed % 4), ScaledBy(0x1p100)); }) },
    { "offset-1e8",
      Random(members,
        [](unsigned seed) {
          return Mapped(GridSoup(seed, 20, 2 + seed % 4), MovedBy({ 1e8, -1e8, 1e8 }));
        }) },
  };
}

std::vector<SurfaceFamily> NearlyDegenerateFamilies(int members)
{
  const double ulp = std::numeric_limits<double>::epsilon();
  const auto twice = [](const TriangleSoup& a, const TriangleSoup& b, const Map& map)
  { return Mapped(Join(a, b), map); };
  const Map rotatedFloat = [](const Point& p) { return ToFloat(Rotated(p)); };
  const Map movedFar = [](const Point& p) { return MovedBy({ 1e8, 1e8, 1e8 })(Rotated(p)); };
  return {
    { "needles",
      Random(members,
        [](unsigned seed) { return Needles(seed, 12, std::pow(10., -4. * (seed % 4))); }) },
    { "caps",
      Random(
        members, [](unsigned seed) { return Caps(seed, 12, std::pow(10., -4. * (seed % 4))); }) },
    { "corners-nearly-one", Random(members, [](unsigned seed) { return CornersNearlyOne(seed); }) },
    { "sheets-one-ulp-apart",
      { Join(Mapped(Sheet(3, 4), MovedBy({ 0, 0, 1 })),
          Mapped(Sheet(5, 2), MovedBy({ 0, 0, 1 + ulp }))),
        Join(Mapped(Sheet(4, 4),
               [](const Point& p) {
                 return Point{ p[0], p[1], 1 + p[0] };
               }),
          Mapped(Sheet(3, 3),
            [=](const Point& p) {
              return Point{ p[0], p[1], (1 + p[0]) * (1 + ulp * (p[1] > 0.5)) };
            })) } },
    { "sheets-rotated",
      { twice(Sheet(3, 3), Sheet(4, 5), Rotated), twice(Sheet(7, 2), Sheet(3, 8), Rotated) } },
    { "sheets-rotated-float",
      { twice(Sheet(3, 3), Sheet(4, 5), rotatedFloat),
        twice(Sheet(7, 2), Sheet(3, 8), rotatedFloat) } },
    { "sheets-rotated-offset",
      { twice(Sheet(3, 3), Sheet(4, 5), movedFar), twice(Sheet(7, 2), Sheet(3, 8), movedFar) } },
    { "cylinders-tessellated-twice",
      { twice(Cylinder(12, 3), Cylinder(12, 4), Rotated),
        twice(Cylinder(12, 3), Cylinder(24, 2), Rotated),
        twice(Cylinder(12, 3), Cylinder(24, 2), rotatedFloat),
        twice(Cylinder(6, 4), Cylinder(12, 1), Rotated),
        twice(Cylinder(12, 3), Cylinder(36, 3), Rotated) } },
    { "t-junctions-rotated",
      { twice(Sheet(4, 3), Mapped(Sheet(7, 3), MovedBy({ 0, 1, 0 })), Rotated),
        twice(Sheet(4, 3), Mapped(Sheet(7, 3), MovedBy({ 0, 1, 0 })), rotatedFloat),
        twice(Sheet(16, 1), Mapped(Sheet(5, 1), MovedBy({ 0, 1, 0 })), movedFar) } },
    { "boxes-sharing-walls-rotated",
      { Mapped(BoxesOnWalls(), Rotated), Mapped(StackedBoxes(2, 0.25), Rotated),
        Join(BoxesOnWalls(), Mapped(BoxesOnWalls(), Rotated)),
        Mapped(BoxesOnWalls(), rotatedFloat) } },
    { "nearly-in-one-plane",
      Random(members,
        [](unsigned seed)
        {
          return Mapped(RandomSoup(seed, 6),
            [](const Point& p) {
              return Point{ p[0], p[1], p[0] / 3 + p[1] / 7 };
            });
        }) },
    { "box-turned-a-little",
      { Join(UnitBoxAt({ 0, 0, 0 }),
          Mapped(UnitBoxAt({ 0, 0, 0 }),
            [](const Point& p) {
              return Point{ p[0] - 1e-9 * p[1], p[1] + 1e-9 * p[0], p[2] };
            })),
        Join(UnitBoxAt({ 0, 0, 0 }),
          Mapped(UnitBoxAt({ 0, 0, 0 }),
            [](const Point& p) {
              return Point{ p[0] - 1e-15 * p[1], p[1] + 1e-15 * p[0], p[2] };
            })) } },
  };
}
} // namespace

TriangleSoup CornersNearlyOne(unsigned seed)
{
  constexpr int places = 4;
  constexpr Id count = 12;
  std::mt19937 random(seed);
  std::vector<Point> around;
  for (int i = 0; i < places; ++i)
  {
    const double y = Uniform(random, 0, 1);
    around.push_back({ 0, y, Uniform(random, 0, 1) });
  }
  TriangleSoup soup;
  for (Id i = 0; i < count; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      soup.Points.push_back(around[random() % places]);
      soup.Points.back()[0] = 0x1p-56 * (random() % 64);
    }
    const double x = Uniform(random, -0.5, 0.5);
    const double y = Uniform(random, 0, 1);
    soup.Points.push_back({ x, y, Uniform(random, 0, 1) });
    soup.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return soup;
}

std::vector<SurfaceFamily> SurfaceFamilies(int members)
{
  std::vector<SurfaceFamily> families = ResolvableFamilies(members);
  for (SurfaceFamily& family : NearlyDegenerateFamilies(members))
  {
    families.push_back(std::move(family));
  }
  return families;
}

SurfaceFamily GridSoups(int members)
{
  return { "grid-soup",
    Random(members, [](unsigned seed) { return GridSoup(seed, 100, 2 + seed % 7); }) };
}
} // namespace testmeshes
