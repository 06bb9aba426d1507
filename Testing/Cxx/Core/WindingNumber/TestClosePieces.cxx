// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ClosePieces.h"

#include "Common/Box.h"
#include "Common/Vectors.h"
#include "Support/SurfaceFamilies.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace insideout;

/** Each triangle counts, as often as it is there: in pieces as in the whole. */
FacetComplex Counted(const TriangleSoup& soup)
{
  Monitor silent;
  return CountFacets(soup, { 0, true }, silent).Surface;
}

/** A ball whose corners are not on common planes, and the same without some of its triangles. */
TriangleSoup BumpyBall(double share)
{
  TriangleSoup ball;
  const int rows = 12;
  const int columns = 20;
  const auto at = [&](int row, int column)
  {
    if (row % rows == 0)
    {
      ball.Points.push_back({ 0, 0, row == 0 ? 1.0 : -1.0 });
      return static_cast<Id>(ball.Points.size() - 1);
    }
    const double latitude = M_PI * row / rows;
    const double longitude = 2 * M_PI * (column % columns) / columns;
    const double radius = 1 + 0.1 * std::sin(5 * row + 3 * (column % columns));
    ball.Points.push_back({ radius * std::sin(latitude) * std::cos(longitude),
      radius * std::sin(latitude) * std::sin(longitude), radius * std::cos(latitude) });
    return static_cast<Id>(ball.Points.size() - 1);
  };
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const Triangle corners = { at(row, column), at(row + 1, column), at(row + 1, column + 1) };
      ball.Triangles.push_back(corners);
      ball.Triangles.push_back({ corners[0], corners[2], at(row, column + 1) });
    }
  }
  ball.Triangles.resize(
    static_cast<std::size_t>(share * static_cast<double>(ball.Triangles.size())));
  return testmeshes::Merged(ball);
}

/** Open, closed, crossing themselves, non-manifold, soups. */
std::vector<TriangleSoup> Surfaces()
{
  using namespace testmeshes;
  std::vector<TriangleSoup> soups = { BumpyBall(1), BumpyBall(0.7),
    Join(BumpyBall(0.4), Join(testmeshes::Box({ 0, 0, 0 }, { 2, 2, 2 }), RandomSoup(7, 40))) };
  for (const SurfaceFamily& family : SurfaceFamilies(1))
  {
    if (family.Members.front().Triangles.size() >= 5)
    {
      soups.push_back(family.Members.front());
    }
  }
  return soups;
}

/** The same with its triangles in any order. */
TriangleSoup Shuffled(TriangleSoup soup)
{
  std::mt19937 random(3);
  for (std::size_t k = soup.Triangles.size(); k > 1; --k)
  {
    std::swap(soup.Triangles[k - 1], soup.Triangles[random() % k]);
  }
  return soup;
}

/** Triangles in turn in `pieces` files, each with the points it needs. */
std::vector<TriangleSoup> InFiles(const TriangleSoup& soup, std::size_t pieces)
{
  std::vector<TriangleSoup> files(pieces);
  const std::size_t size = soup.Triangles.size();
  for (std::size_t k = 0; k < pieces; ++k)
  {
    for (std::size_t t = size * k / pieces; t < size * (k + 1) / pieces; ++t)
    {
      const Id first = static_cast<Id>(files[k].Points.size());
      for (const Id p : soup.Triangles[t])
      {
        files[k].Points.push_back(soup.Points[p]);
      }
      files[k].Triangles.push_back({ first, first + 1, first + 2 });
    }
  }
  return files;
}

std::vector<Point> RandomPlaces(const TriangleSoup& surface)
{
  std::mt19937 random(11);
  const insideout::Box box = BoundingBox(surface.Points);
  std::vector<Point> places(200);
  for (Point& place : places)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = box.Low[axis] + box.Extent(axis) * (1.2 * random() / random.max() - 0.1);
    }
  }
  return places;
}

std::vector<Point> CornersAndMiddles(const FacetComplex& surface)
{
  std::vector<Point> places;
  for (const Triangle& facet : surface.Facets)
  {
    const Point& a = surface.Points[facet[0]];
    const Point& b = surface.Points[facet[1]];
    places.push_back(a);
    places.push_back({ (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 });
  }
  return places;
}

std::vector<double> WindingNumbers(const CountedPiece& piece, const std::vector<Point>& places)
{
  Monitor silent;
  return SurfaceWindingNumber(piece.Surface, piece.Boundary, {}, silent).At(places, silent);
}

/** The sum over pieces that are held one after the other. */
std::vector<double> InTurn(const std::vector<TriangleSoup>& files, const std::vector<Point>& places)
{
  ClosePieces pieces;
  std::vector<double> sums(places.size());
  const auto add = [&](const CountedPiece& piece)
  {
    const std::vector<double> w = WindingNumbers(piece, places);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      sums[i] = piece.Boundary.empty() ? SumOfClosed(sums[i] + w[i]) : sums[i] + w[i];
    }
  };
  for (const TriangleSoup& file : files)
  {
    CountedPiece piece = { Counted(file), {}, {} };
    pieces.Close(piece.Surface);
    add(piece);
  }
  for (const CountedPiece& rest : pieces.Rest())
  {
    add(rest);
  }
  return sums;
}

bool IsClosed(const FacetComplex& surface)
{
  return CountedBoundary(CountedFacets(surface), static_cast<Id>(surface.Points.size())).empty();
}

TEST(ClosePieces, GiveTheWindingNumbersOfTheWholeBitByBit)
{
  Monitor silent;
  for (const TriangleSoup& soup : Surfaces())
  {
    const FacetComplex whole = Counted(soup);
    const SurfaceWindingNumber expected(whole, {}, silent);
    const std::vector<Point> places = RandomPlaces(soup);
    const std::vector<Point> onSurface = CornersAndMiddles(whole);
    for (const std::size_t pieces : { 1, 2, 5 })
    {
      const std::vector<TriangleSoup> files = InFiles(soup, pieces);
      EXPECT_EQ(InTurn(files, places), expected.At(places, silent)) << pieces << " pieces";
      EXPECT_EQ(InTurn(InFiles(Shuffled(soup), pieces), places), expected.At(places, silent));
      const std::vector<double> there = InTurn(files, onSurface);
      const std::vector<double> expectedThere = expected.At(onSurface, silent);
      for (std::size_t i = 0; i < onSurface.size(); ++i)
      {
        ASSERT_NEAR(there[i], expectedThere[i], 1e-12) << pieces << " pieces";
      }
    }
  }
}

/** On edges of caps: off the surface all values are whole numbers. */
TEST(ClosePieces, HaveNoRoundingErrorsOnCaps)
{
  Monitor silent;
  const TriangleSoup ball = BumpyBall(1);
  const std::vector<TriangleSoup> files = InFiles(ball, 3);
  ClosePieces pieces;
  std::vector<Point> places;
  for (const TriangleSoup& file : files)
  {
    FacetComplex piece = Counted(file);
    const std::size_t facets = piece.Facets.size();
    pieces.Close(piece);
    for (std::size_t cap = facets; cap < piece.Facets.size(); ++cap)
    {
      const auto [a, b, c] = CornersOf(piece.Points, piece.Facets[cap]);
      for (const double t : { 0.25, 0.5, 0.625 })
      {
        places.push_back(
          { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) });
      }
    }
  }
  const std::vector<double> expected =
    SurfaceWindingNumber(Counted(ball), {}, silent).At(places, silent);
  const std::vector<double> found = InTurn(files, places);
  int within = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (expected[i] == 0 || expected[i] == 1)
    {
      EXPECT_EQ(found[i], expected[i]);
      within += expected[i] == 1;
    }
  }
  EXPECT_GT(within, 10);
}

TEST(ClosePieces, LeaveNothingOfAClosedSurfaceOpen)
{
  ClosePieces pieces;
  const std::vector<TriangleSoup> files = InFiles(BumpyBall(1), 3);
  for (const TriangleSoup& file : files)
  {
    FacetComplex piece = Counted(file);
    EXPECT_FALSE(IsClosed(piece));
    pieces.Close(piece);
    EXPECT_TRUE(IsClosed(piece));
  }
  const std::vector<CountedPiece> rest = pieces.Rest();
  ASSERT_EQ(rest.size(), 1u);
  EXPECT_TRUE(rest[0].Boundary.empty());
  EXPECT_TRUE(IsClosed(rest[0].Surface));
}

/** If facets count more often than one facet can. */
TEST(ClosePieces, HaveCapsThatCountAsOftenAsItTakes)
{
  ClosePieces pieces;
  std::vector<CountedPiece> all;
  for (const TriangleSoup& file : InFiles(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }), 2))
  {
    CountedPiece& piece = all.emplace_back(CountedPiece{ Counted(file), {}, {} });
    FacetComplex& surface = piece.Surface;
    std::fill(surface.Multiplicity.begin(), surface.Multiplicity.end(), std::int16_t(30000));
    const std::vector<Triangle> facets = surface.Facets;
    surface.Facets.insert(surface.Facets.end(), facets.begin(), facets.end());
    surface.Multiplicity.resize(surface.Facets.size(), 30000);
    pieces.Close(surface);
    EXPECT_TRUE(IsClosed(surface));
  }
  for (CountedPiece& rest : pieces.Rest())
  {
    all.push_back(std::move(rest));
  }
  double sum = 0;
  for (const CountedPiece& piece : all)
  {
    sum += WindingNumbers(piece, { { 0.1, 0.2, 0.3 } }).front();
  }
  EXPECT_EQ(sum, 60000);
}
} // namespace
