// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/CellsOfExpression.h"
#include "Boolean/SurfaceOfExpression.h"

#include "Support/ExpectSound.h"
#include "Support/TestMeshes.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <cmath>
#include <memory>
#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

struct Made
{
  ResolvedBodies Bodies;
  std::optional<ExpressionSurface> Found;

  TriangleSoup Surface() const
  {
    return SoupOf(this->Bodies.Surface.Points, this->Found->Boundary);
  }
};

std::vector<std::string> Letters(std::size_t count)
{
  std::vector<std::string> letters;
  for (std::size_t i = 0; i < count; ++i)
  {
    letters.emplace_back(1, static_cast<char>('A' + i));
  }
  return letters;
}

Made Make(const std::vector<TriangleSoup>& soups, const std::string& text)
{
  const SetExpression expression(text, Letters(soups.size()));
  std::vector<Body> bodies;
  Id points = 0;
  Id triangles = 0;
  for (const Id b : expression.Bodies())
  {
    bodies.push_back(MakeBody(Letters(soups.size())[b], soups[b], points, triangles));
    points += static_cast<Id>(soups[b].Points.size());
    triangles += static_cast<Id>(soups[b].Triangles.size());
  }
  Monitor monitor;
  Made made;
  made.Bodies = ResolveBodies(std::move(bodies), {}, monitor);
  made.Found = SurfaceOfExpression(made.Bodies, expression, monitor);
  return made;
}

double VolumeOf(const TriangleSoup& soup)
{
  double volume = 0;
  for (const Triangle& t : soup.Triangles)
  {
    const Point& a = soup.Points[t[0]];
    const Point& b = soup.Points[t[1]];
    const Point& c = soup.Points[t[2]];
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6;
  }
  return volume;
}

double VolumeOf(const std::vector<TriangleSoup>& soups, const std::string& text)
{
  return VolumeOf(Make(soups, text).Surface());
}

/** Boxes with corners on a grid, so that they cross, touch, coincide and contain each other; each
 * body of one to three, which overlap and face either way. */
std::vector<TriangleSoup> GridBodies(unsigned seed, int count)
{
  std::mt19937 random(seed);
  const auto coordinate = [&]() { return static_cast<double>(random() % 4); };
  std::vector<TriangleSoup> bodies;
  for (int b = 0; b < count; ++b)
  {
    TriangleSoup body;
    for (unsigned i = 0; i <= random() % 3; ++i)
    {
      const Point low = { coordinate(), coordinate(), coordinate() };
      const Point high = { low[0] + 1 + coordinate() / 2, low[1] + 1 + coordinate() / 2,
        low[2] + 1 + coordinate() / 2 };
      body = Join(body, Box(low, high));
    }
    bodies.push_back(random() % 4 == 0 ? Reversed(body) : body);
  }
  return bodies;
}

/** Everything is turned a bit, so that no plane is along an axis and corners have all digits. */
TriangleSoup Turned(TriangleSoup soup, double angle)
{
  for (Point& p : soup.Points)
  {
    const double x = p[0] * std::cos(angle) - p[1] * std::sin(angle);
    const double y = p[0] * std::sin(angle) + p[1] * std::cos(angle);
    p = { { x, y * 0.8 - p[2] * 0.6, y * 0.6 + p[2] * 0.8 } };
  }
  return soup;
}

const std::vector<std::string> Expressions = { "A | B | C", "A & B & C", "A - B - C", "A ^ B ^ C",
  "A - (B | C)", "(A ^ B) & C", "A & B | C", "C - A", "B" };

void ExpectWhatTheExpressionHolds(
  const std::vector<TriangleSoup>& soups, const std::string& text, unsigned seed)
{
  const Made made = Make(soups, text);
  ASSERT_TRUE(made.Found);
  const TriangleSoup surface = made.Surface();
  ExpectSound(surface);
  Monitor monitor;
  const SetExpression expression(text, Letters(soups.size()));
  std::vector<std::unique_ptr<SurfaceWindingNumber>> alone;
  for (const Id b : expression.Bodies())
  {
    FacetComplex chain = CountFacets(soups[b], {}, monitor).Surface;
    OrientFacets(chain, SortedFacetEdges(chain.Facets), Orientation::Automatic, monitor);
    alone.push_back(
      std::make_unique<SurfaceWindingNumber>(chain, WindingNumberParameters(), monitor));
  }
  std::unique_ptr<SurfaceWindingNumber> whole;
  if (!surface.Triangles.empty())
  {
    whole = std::make_unique<SurfaceWindingNumber>(
      CountFacets(surface, {}, monitor).Surface, WindingNumberParameters(), monitor);
  }
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-6, 6);
  for (int i = 0; i < 100; ++i)
  {
    const Point p = { place(random), place(random), place(random) };
    std::vector<char> isIn;
    for (const auto& w : alone)
    {
      isIn.push_back(w->At(p) > 0.5);
    }
    EXPECT_EQ(whole ? whole->At(p) : 0, expression.Holds(isIn)) << text << " " << seed;
  }
}

TEST(SurfaceOfExpression, BoundsWhatTheExpressionHolds)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    const std::vector<TriangleSoup> soups = GridBodies(seed, 3);
    for (const std::string& text : Expressions)
    {
      ExpectWhatTheExpressionHolds(soups, text, seed);
    }
  }
}

TEST(SurfaceOfExpression, BoundsItWhereCoplanarFacesAreSoUpToRoundingOnly)
{
  for (unsigned seed = 20; seed < 23; ++seed)
  {
    std::vector<TriangleSoup> soups = GridBodies(seed, 3);
    for (TriangleSoup& soup : soups)
    {
      soup = Turned(soup, 0.3);
    }
    ExpectWhatTheExpressionHolds(soups, Expressions[seed % Expressions.size()], seed);
  }
}

TEST(SurfaceOfExpression, HasVolumesThatAddUp)
{
  for (unsigned seed = 40; seed < 44; ++seed)
  {
    std::vector<TriangleSoup> soups = GridBodies(seed, 2);
    soups[1] = Turned(soups[1], seed * 0.1);
    const double a = VolumeOf(soups, "A");
    const double b = VolumeOf(soups, "B");
    const double both = VolumeOf(soups, "A & B");
    EXPECT_NEAR(a + b, VolumeOf(soups, "A | B") + both, 1e-9 * (a + b));
    EXPECT_NEAR(VolumeOf(soups, "A - B"), a - both, 1e-9 * a);
    EXPECT_NEAR(VolumeOf(soups, "A ^ B"), a + b - 2 * both, 1e-9 * (a + b));
  }
}

TEST(SurfaceOfExpression, OfABodyWithItselfIsExact)
{
  const TriangleSoup box = Turned(Box({ 0, 0, 0 }, { 1, 2, 3 }), 1);
  EXPECT_EQ(Make({ box, box }, "A | B").Found->Boundary.size(), 12u);
  EXPECT_EQ(Make({ box, Reversed(box) }, "A & B").Found->Boundary.size(), 12u);
  EXPECT_TRUE(Make({ box, box }, "A - B").Found->Boundary.empty());
  EXPECT_TRUE(Make({ box, box }, "A ^ B").Found->Boundary.empty());
}

TEST(SurfaceOfExpression, KnowsTheInputTriangleOfEachOfItsOwn)
{
  // The part that B cuts out of A is bounded by B, turned over.
  const std::vector<TriangleSoup> soups = { Box({ 0, 0, 0 }, { 4, 4, 4 }),
    Box({ 1, 1, 1 }, { 2, 2, 2 }) };
  const Made made = Make(soups, "A - B");
  ASSERT_EQ(made.Found->Boundary.size(), 24u);
  for (const BoundaryTriangle& triangle : made.Found->Boundary)
  {
    const bool isOfB = triangle.Source >= 12;
    const Point& corner = made.Bodies.Surface.Points[triangle.Corners[0]];
    EXPECT_EQ(isOfB, corner[0] >= 1 && corner[0] <= 2);
  }
}

TEST(SurfaceOfExpression, IsTheBoundaryOfTheCells)
{
  for (unsigned seed = 60; seed < 62; ++seed)
  {
    std::vector<TriangleSoup> soups = GridBodies(seed, 2);
    soups[1] = Turned(soups[1], seed % 2 * 0.4);
    for (const char* text : { "A | B", "A - B", "A ^ B" })
    {
      const Made made = Make(soups, text);
      Monitor monitor;
      const CellsOfExpression cells =
        FindCellsOfExpression(made.Bodies, Letters(2), SetExpression(text, Letters(2)), 0, monitor);
      const double volume = VolumeWithin(made.Bodies.Surface.Points, made.Found->Boundary);
      EXPECT_NEAR(VolumeWithin(cells.Mesh.Points, cells.Boundary), volume, 1e-9 * volume);
      ExpectSound(SoupOf(cells.Mesh.Points, cells.Boundary));
    }
  }
}

TEST(CellsOfExpression, AreNoneInAPlane)
{
  const TriangleSoup flat = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const Made made = Make({ flat, flat }, "A | B");
  EXPECT_FALSE(made.Found);
  Monitor monitor;
  const CellsOfExpression cells = FindCellsOfExpression(
    made.Bodies, Letters(2), SetExpression(SetOperation::Union, 2), 0, monitor);
  EXPECT_TRUE(cells.Boundary.empty());
  EXPECT_EQ(cells.Warnings.size(), 1u);
}

TEST(SurfaceOfExpression, IsNotMadeOfOpenBodies)
{
  TriangleSoup open = Box({ 0, 0, 0 }, { 1, 1, 1 });
  open.Triangles.pop_back();
  const std::vector<TriangleSoup> soups = { open, Box({ 0.5, 0.5, 0.5 }, { 2, 2, 2 }) };
  EXPECT_FALSE(Make(soups, "A | B").Found);
  EXPECT_TRUE(Make(soups, "B").Found);
}
} // namespace
