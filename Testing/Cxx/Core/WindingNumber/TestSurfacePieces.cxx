// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SurfacePieces.h"

#include "Common/ScaledPoints.h"
#include "Distance/SurfaceDistance.h"
#include "Support/SurfaceFamilies.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace
{
using namespace insideout;

FacetComplex Counted(const TriangleSoup& soup)
{
  Monitor silent;
  return CountFacets(soup, {}, silent).Surface;
}

/** The faces of a box, each cut into n x n squares, with whole coordinates. */
TriangleSoup CutBox(int n)
{
  TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n })
    {
      const auto at = [&](int i, int j)
      {
        Point p;
        p[axis] = side;
        p[(axis + 1) % 3] = i;
        p[(axis + 2) % 3] = j;
        soup.Points.push_back(p);
        return static_cast<Id>(soup.Points.size() - 1);
      };
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          const Id a = at(i, j);
          const Id b = at(i + 1, j);
          const Id c = at(i + 1, j + 1);
          const Id d = at(i, j + 1);
          soup.Triangles.push_back(side ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } });
          soup.Triangles.push_back(side ? Triangle{ { a, c, d } } : Triangle{ { a, d, c } });
        }
      }
    }
  }
  return testmeshes::Merged(soup);
}

/** Closed, with tunnels and cavities, open, crossing themselves, non-manifold, soups. */
std::vector<FacetComplex> Surfaces()
{
  using namespace testmeshes;
  const TriangleSoup box = CutBox(6);
  TriangleSoup holed = box;
  holed.Triangles.erase(holed.Triangles.begin() + 40, holed.Triangles.begin() + 75);
  holed.Triangles.erase(holed.Triangles.begin() + 7);
  std::vector<TriangleSoup> soups = { box, holed,
    Merged(Join(box,
      Join(testmeshes::Box({ 3, 3, 3 }, { 8, 9, 7 }),
        Reversed(testmeshes::Box({ 1, 1, 1 }, { 3, 3, 3 }))))),
    GridSoup(5, 80, 6), Join(holed, RandomSoup(7, 40)) };
  for (const SurfaceFamily& family : SurfaceFamilies(1))
  {
    soups.push_back(family.Members.front());
  }
  std::vector<FacetComplex> surfaces;
  for (const TriangleSoup& soup : soups)
  {
    surfaces.push_back(Counted(soup));
  }
  return surfaces;
}

/** At random, on a lattice, and on corners, edges and facets. */
std::vector<Point> PlacesAround(const FacetComplex& surface)
{
  std::mt19937 random(11);
  const insideout::Box box = BoundingBox(surface.Points);
  std::vector<Point> places;
  for (int i = 0; i < 40; ++i)
  {
    Point p;
    Point onLattice;
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = box.Low[axis] + box.Extent(axis) * (1.2 * random() / random.max() - 0.1);
      onLattice[axis] = std::round(p[axis] * 2) / 2;
    }
    places.insert(places.end(), { p, onLattice });
    const Triangle& t = surface.Facets[random() % surface.Facets.size()];
    const Point& a = surface.Points[t[0]];
    const Point& b = surface.Points[t[1]];
    const Point& c = surface.Points[t[2]];
    places.push_back(a);
    places.push_back({ (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 });
    places.push_back(
      { (2 * a[0] + b[0] + c[0]) / 4, (2 * a[1] + b[1] + c[1]) / 4, (2 * a[2] + b[2] + c[2]) / 4 });
  }
  return places;
}

TEST(SurfacePieces, HaveEachFacetOnceAndNoMoreThanAsked)
{
  Monitor silent;
  for (const FacetComplex& whole : Surfaces())
  {
    const Id facets = whole.NumberOfFacets();
    for (const Id most : { Id(1), Id(7), facets / 2 + 1, facets, std::numeric_limits<Id>::max() })
    {
      const std::vector<CountedPiece> pieces = CutIntoPieces(whole, most, silent);
      EXPECT_EQ(static_cast<Id>(pieces.size()), (facets - 1) / most + 1);
      std::vector<Id> found;
      for (const CountedPiece& piece : pieces)
      {
        const std::vector<Id>& names = piece.WholeFacets;
        ASSERT_LE(static_cast<Id>(names.size()), most);
        ASSERT_EQ(piece.Surface.Facets.size(), names.size());
        EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
        for (std::size_t i = 0; i < names.size(); ++i)
        {
          EXPECT_EQ(piece.Surface.Multiplicity[i], whole.Multiplicity[names[i]]);
          for (int k = 0; k < 3; ++k)
          {
            EXPECT_EQ(piece.Surface.Points[piece.Surface.Facets[i][k]],
              whole.Points[whole.Facets[names[i]][k]]);
          }
        }
        found.insert(found.end(), names.begin(), names.end());
      }
      std::sort(found.begin(), found.end());
      std::vector<Id> all(facets);
      std::iota(all.begin(), all.end(), 0);
      EXPECT_EQ(found, all);
    }
  }
}

TEST(SurfacePieces, HaveNearestWhatTheWholeHas)
{
  Monitor silent;
  for (FacetComplex whole : Surfaces())
  {
    for (Point& p : whole.Points)
    {
      p[0] = std::ldexp(p[0], -30); // so that some pieces are small by themselves
    }
    std::vector<Point> places = PlacesAround(whole);
    places.push_back({ 1e30, 0, 0 });
    const int exponent = LargestExponent(whole.Points);
    const SurfaceDistance ofWhole(whole.Points, whole.Facets);
    std::vector<SurfaceDistance::Nearest> best;
    for (const CountedPiece& piece : CutIntoPieces(whole, whole.NumberOfFacets() / 9 + 1, silent))
    {
      const SurfaceDistance ofPiece(piece.Surface.Points, piece.Surface.Facets, exponent);
      best.resize(places.size(), { 0, {}, None, std::numeric_limits<double>::infinity() });
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        SurfaceDistance::Nearest nearest = ofPiece.At(places[i]);
        nearest.Facet = piece.WholeFacets[nearest.Facet];
        best[i] = nearest.IsNearerThan(best[i]) ? nearest : best[i];
      }
    }
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const SurfaceDistance::Nearest expected = ofWhole.At(places[i]);
      EXPECT_EQ(best[i].Distance, expected.Distance);
      EXPECT_EQ(best[i].Place, expected.Place);
      EXPECT_EQ(best[i].Facet, expected.Facet);
    }
  }
}

TEST(SurfacePieces, CanBeStopped)
{
  struct Stop : Monitor
  {
    bool Continue(const char*, double) override { return false; }
  } stop;
  EXPECT_THROW(CutIntoPieces(Counted(CutBox(3)), 20, stop), Error);
}
} // namespace
