// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/ResolveSelfIntersections.h"

#include "Common/Team.h"
#include "Resolve/FacetsNearOthers.h"
#include "Support/Corpus.h"
#include "Support/ExactReference.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

using namespace insideout;
using namespace testmeshes;

namespace
{
Resolution Resolve(const FacetComplex& surface)
{
  Monitor monitor;
  return ResolveSelfIntersections(surface, monitor);
}

Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Length(const Point& a)
{
  return std::sqrt(Dot(a, a));
}

double Size(const std::vector<Point>& points)
{
  double size = 0;
  for (const Point& p : points)
  {
    size = std::max({ size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return size;
}

Point AreaVector(const std::vector<Point>& points, const Triangle& t)
{
  const Point cross = Cross(Minus(points[t[1]], points[t[0]]), Minus(points[t[2]], points[t[0]]));
  return { cross[0] / 2, cross[1] / 2, cross[2] / 2 };
}

/** The definition of the winding number as a sum of solid angles. */
double WindingNumber(const FacetComplex& surface, const Point& q)
{
  double sum = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Point a = Minus(surface.Points[surface.Facets[f][0]], q);
    const Point b = Minus(surface.Points[surface.Facets[f][1]], q);
    const Point c = Minus(surface.Points[surface.Facets[f][2]], q);
    const double det = Dot(a, Cross(b, c));
    const double div = Length(a) * Length(b) * Length(c) + Dot(a, b) * Length(c) +
      Dot(b, c) * Length(a) + Dot(c, a) * Length(b);
    sum += surface.Multiplicity[f] * std::atan2(det, div);
  }
  return sum / (2 * 3.14159265358979323846);
}

bool SameBits(const std::vector<Point>& a, const std::vector<Point>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0);
}

bool SameSources(const std::vector<FacetSource>& a, const std::vector<FacetSource>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const FacetSource& p, const FacetSource& q)
    { return p.Triangle == q.Triangle && p.Reversed == q.Reversed; });
}

bool SameOrigins(const std::vector<PointOrigin>& a, const std::vector<PointOrigin>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const PointOrigin& p, const PointOrigin& q)
    { return p.Points == q.Points && p.Weights == q.Weights; });
}

void ExpectSame(const FacetComplex& a, const FacetComplex& b)
{
  EXPECT_TRUE(SameBits(a.Points, b.Points));
  EXPECT_TRUE(SameOrigins(a.Origins, b.Origins));
  EXPECT_EQ(a.Facets, b.Facets);
  EXPECT_EQ(a.Multiplicity, b.Multiplicity);
  EXPECT_EQ(a.SourceOffsets, b.SourceOffsets);
  EXPECT_TRUE(SameSources(a.Sources, b.Sources));
  EXPECT_EQ(a.NumberOfConstraints, b.NumberOfConstraints);
}

void ExpectWellFormed(const FacetComplex& surface)
{
  const std::size_t facets = surface.Facets.size();
  ASSERT_EQ(surface.Origins.size(), surface.Points.size());
  ASSERT_EQ(surface.Multiplicity.size(), facets);
  ASSERT_EQ(surface.SourceOffsets.size(), facets + 1);
  ASSERT_EQ(surface.SourceOffsets.back(), static_cast<Id>(surface.Sources.size()));
  ASSERT_LE(surface.NumberOfConstraints, surface.NumberOfFacets());
  std::set<Triangle> taken;
  for (std::size_t f = 0; f < facets; ++f)
  {
    Triangle corners = surface.Facets[f];
    std::sort(corners.begin(), corners.end());
    EXPECT_TRUE(taken.insert(corners).second) << "facet " << f << " is there twice";
    ASSERT_LT(surface.SourceOffsets[f], surface.SourceOffsets[f + 1]);
    for (Id s = surface.SourceOffsets[f] + 1; s < surface.SourceOffsets[f + 1]; ++s)
    {
      EXPECT_LT(surface.Sources[s - 1].Triangle, surface.Sources[s].Triangle);
    }
  }
}

/** Law (a), asked of the definition and not of the code that ends the resolver's loop. */
void ExpectNoCrossings(const FacetComplex& surface)
{
  const std::vector<Triangle> constraints(
    surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
  EXPECT_TRUE(IntersectionsByClipping(surface.Points, constraints).empty());
}

void ExpectInputPointsFirst(const FacetComplex& before, const FacetComplex& after)
{
  const std::size_t count = before.Points.size();
  ASSERT_GE(after.Points.size(), count);
  EXPECT_TRUE(SameBits(before.Points, { after.Points.begin(), after.Points.begin() + count }));
  EXPECT_TRUE(
    SameOrigins(before.Origins, { after.Origins.begin(), after.Origins.begin() + count }));
  EXPECT_TRUE(std::none_of(after.Origins.begin() + count, after.Origins.end(),
    [](const PointOrigin& origin) { return origin.IsInput(); }));
}

/** The points' origins give the points, to the rounding that the resolver may do. */
void ExpectOriginsInterpolate(const FacetComplex& before, const FacetComplex& after)
{
  const double tolerance = 1e-12 * Size(before.Points);
  for (std::size_t p = 0; p < after.Points.size(); ++p)
  {
    const PointOrigin& origin = after.Origins[p];
    Point sum = { 0, 0, 0 };
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_GE(origin.Weights[j], 0);
      for (int k = 0; k < 3; ++k)
      {
        sum[k] += origin.Weights[j] * before.Points[origin.Points[j]][k];
      }
    }
    EXPECT_LT(Length(Minus(sum, after.Points[p])), tolerance) << "point " << p;
    EXPECT_NEAR(origin.Weights[0] + origin.Weights[1] + origin.Weights[2], 1, 1e-14);
  }
}

void ExpectSameAreaVectors(const FacetComplex& before, const FacetComplex& after)
{
  std::vector<Point> sums(before.Facets.size(), { 0, 0, 0 });
  for (Id f = 0; f < after.NumberOfFacets(); ++f)
  {
    const Point area = AreaVector(after.Points, after.Facets[f]);
    for (Id s = after.SourceOffsets[f]; s < after.SourceOffsets[f + 1]; ++s)
    {
      const FacetSource& source = after.Sources[s];
      for (int k = 0; k < 3; ++k)
      {
        sums[source.Triangle][k] += source.Reversed ? -area[k] : area[k];
      }
    }
  }
  for (std::size_t t = 0; t < sums.size(); ++t)
  {
    const Point area = AreaVector(before.Points, before.Facets[t]);
    EXPECT_LE(Length(Minus(sums[t], area)), 1e-9 * Length(area)) << "triangle " << t;
  }
}

void ExpectSameWindingNumbers(const FacetComplex& before, const FacetComplex& after)
{
  std::mt19937 random(7);
  const double size = Size(before.Points);
  for (int i = 0; i < 20; ++i)
  {
    Point q;
    for (double& x : q)
    {
      x = size * (random() / 2147483648.0 - 0.7);
    }
    EXPECT_NEAR(WindingNumber(before, q), WindingNumber(after, q), 1e-9);
  }
}

/** All laws that hold for any complex whose facet f is made of triangle f alone. */
void ExpectLaws(const FacetComplex& before)
{
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Resolution one = Resolve(before);
  omp_set_num_threads(2);
  const Resolution two = Resolve(before);
  omp_set_num_threads(threads);
  ExpectSame(one.Surface, two.Surface);
  EXPECT_EQ(one.Rounds, two.Rounds);
  EXPECT_EQ(one.IntersectingPairs, IntersectionsByClipping(before.Points, before.Facets));

  const FacetComplex& after = one.Surface;
  ExpectWellFormed(after);
  ExpectNoCrossings(after);
  ExpectInputPointsFirst(before, after);
  ExpectOriginsInterpolate(before, after);
  ExpectSameAreaVectors(before, after);
  ExpectSameWindingNumbers(before, after);
  const Resolution again = Resolve(after);
  ExpectSame(again.Surface, after);
  EXPECT_EQ(again.Rounds, 0);
}

void ExpectLawsAndNothingLeftOut(const TriangleSoup& soup)
{
  const FacetComplex complex = ToComplex(soup);
  ExpectLaws(complex);
  const FacetComplex resolved = Resolve(complex).Surface;
  EXPECT_EQ(resolved.NumberOfConstraints, resolved.NumberOfFacets());
}

double AreaOfMultiplicity(const FacetComplex& surface, int multiplicity)
{
  double area = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (surface.Multiplicity[f] == multiplicity)
    {
      area += Length(AreaVector(surface.Points, surface.Facets[f]));
    }
  }
  return area;
}

TriangleSoup Scaled(TriangleSoup soup, int exponent)
{
  for (Point& p : soup.Points)
  {
    p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
  }
  return soup;
}

/** A box turned so that its faces lie in no plane of the axes, and in none exactly. */
TriangleSoup TurnedBox(Point low, Point high, double angle)
{
  TriangleSoup box = Box(low, high);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (Point& p : box.Points)
  {
    p = { c * p[0] - s * p[1], c * (s * p[0] + c * p[1]) - s * p[2],
      s * (s * p[0] + c * p[1]) + c * p[2] };
  }
  return box;
}

/** Stops at its n-th question, and counts them. */
class StopAt : public Monitor
{
public:
  explicit StopAt(int n)
    : Stop(n)
  {
  }
  bool Continue(const char*, double fraction) override
  {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    return ++this->Asked != this->Stop;
  }

  int Asked = 0;

private:
  const int Stop;
};
TEST(ResolveSelfIntersections, IsTheSameWhereCrossingsAreKnown)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const FacetComplex surface = ToComplex(GridSoup(seed, 40, 4));
    const Resolution expected = Resolve(surface);
    KnownCrossings known;
    for (Id f = 0; f < surface.NumberOfFacets(); ++f)
    {
      known.SetOf.push_back(f % static_cast<Id>(1 + seed / 4));
    }
    known.NearOthers = FacetsNearOthers(surface.Points, surface.Facets, known.SetOf, 0);
    for (const auto& pair : expected.IntersectingPairs)
    {
      if (known.SetOf[pair[0]] == known.SetOf[pair[1]])
      {
        known.Pairs.push_back(pair);
      }
    }
    Monitor monitor;
    const Resolution resolution = ResolveSelfIntersections(surface, monitor, known);
    EXPECT_EQ(resolution.IntersectingPairs, expected.IntersectingPairs);
    EXPECT_EQ(resolution.Surface.Points, expected.Surface.Points);
    EXPECT_EQ(resolution.Surface.Facets, expected.Surface.Facets);
    EXPECT_EQ(resolution.Surface.Multiplicity, expected.Surface.Multiplicity);
  }
}
} // namespace

TEST(ResolveSelfIntersections, ReturnsACleanSurfaceAsItIs)
{
  const FacetComplex box = ToComplex(Box({ 0, 0, 0 }, { 1, 2, 3 }));
  const Resolution resolution = Resolve(box);
  ExpectSame(resolution.Surface, box);
  EXPECT_EQ(resolution.Rounds, 0);
  EXPECT_TRUE(resolution.IntersectingPairs.empty());
  ExpectSame(Resolve(FacetComplex()).Surface, FacetComplex());
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnGridSoups)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectLawsAndNothingLeftOut(GridSoup(seed, 8, 2 + seed % 4));
    ASSERT_FALSE(HasFailure());
  }
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnSlantedGridSoups)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE(seed);
    TriangleSoup soup = GridSoup(seed, 8, 2 + seed % 3);
    for (Point& p : soup.Points)
    {
      p = { p[0] + 3 * p[1] + 5 * p[2], 7 * p[0] - p[1] + p[2], p[0] + p[1] - 11 * p[2] };
    }
    ExpectLawsAndNothingLeftOut(soup);
    ASSERT_FALSE(HasFailure());
  }
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnRandomSoups)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectLawsAndNothingLeftOut(RandomSoup(seed, 16));
  }
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnFans)
{
  for (const int blades : { 2, 3, 5, 9 })
  {
    SCOPED_TRACE(blades);
    ExpectLawsAndNothingLeftOut(Fan(blades));
  }
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnFacetsThroughOnePoint)
{
  for (const int count : { 3, 6, 9 })
  {
    SCOPED_TRACE(count);
    ExpectLawsAndNothingLeftOut(ThroughOnePoint(count, count));
  }
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnCombs)
{
  ExpectLawsAndNothingLeftOut(Comb(3));
  ExpectLawsAndNothingLeftOut(Comb(40));
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnBoxes)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const std::vector<TriangleSoup> others = {
    Box({ 0.25, 0.25, 0.25 }, { 0.75, 0.75, 0.75 }), // nested
    Box({ 0.5, 0.5, 0.5 }, { 1.5, 1.5, 1.5 }),       // through each other
    Box({ 0.5, 0, 0 }, { 1.5, 1, 1 }),               // four common planes
    Box({ 1, 0.1, 0.3 }, { 2, 0.7, 0.9 }),           // face in face
    Box({ 1, 1, 0.5 }, { 2, 2, 1.5 }),               // along a part of an edge
    Box({ 1, 1, 1 }, { 2, 2, 2 }),                   // at a corner
    TurnedBox({ 0.1, 0.1, 0.1 }, { 1.1, 1.1, 1.1 }, 0.3),
    TurnedBox({ 0, 0, 0 }, { 1, 1, 1 }, 1e-9),
  };
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    SCOPED_TRACE(i);
    ExpectLawsAndNothingLeftOut(Merged(Join(box, others[i])));
  }
}

TEST(ResolveSelfIntersections, HoldsItsLawsOnEqualPointsUnderSeveralIds)
{
  ExpectLawsAndNothingLeftOut(
    Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0, 0 }, { 1.5, 1, 1 })));
  ExpectLawsAndNothingLeftOut(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 0, 0 }, { 2, 1, 1 })));
  ExpectLawsAndNothingLeftOut(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0, 0, 0 }, { 1, 1, 1 })));
}

TEST(ResolveSelfIntersections, HoldsItsLawsNearlyInOnePlane)
{
  // Layers that cross along lines as good as parallel: rounding makes ever new crossings, so that
  // facets are left out. The rest must be free of crossings all the same, and w what it was.
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    TriangleSoup soup = RandomSoup(seed, 6);
    for (Point& p : soup.Points)
    {
      p[2] = p[0] / 3 + p[1] / 7;
    }
    ExpectLaws(ToComplex(soup));
  }
}

TEST(ResolveSelfIntersections, ScalesExactly)
{
  const TriangleSoup soup = Merged(Join(GridSoup(5, 8, 3), RandomSoup(5, 8)));
  const FacetComplex expected = Resolve(ToComplex(soup)).Surface;
  for (const int exponent : { -100, 100 })
  {
    const FacetComplex scaled = Resolve(ToComplex(Scaled(soup, exponent))).Surface;
    TriangleSoup back = Scaled({ scaled.Points, scaled.Facets }, -exponent);
    EXPECT_TRUE(SameBits(back.Points, expected.Points));
    EXPECT_EQ(back.Triangles, expected.Facets);
  }
}

TEST(ResolveSelfIntersections, AddsTheMultiplicitiesOfOverlaps)
{
  const TriangleSoup left = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleSoup right = Box({ 0.5, 0, 0 }, { 1.5, 1, 1 });
  const FacetComplex sum = Resolve(ToComplex(Merged(Join(left, right)))).Surface;
  EXPECT_DOUBLE_EQ(AreaOfMultiplicity(sum, 2), 2);
  EXPECT_DOUBLE_EQ(AreaOfMultiplicity(sum, 1), 8);
  const FacetComplex difference = Resolve(ToComplex(Merged(Join(left, Reversed(right))))).Surface;
  EXPECT_DOUBLE_EQ(AreaOfMultiplicity(difference, 0), 2);
  EXPECT_DOUBLE_EQ(AreaOfMultiplicity(difference, 1), 8);
}

TEST(ResolveSelfIntersections, CarriesMultiplicitiesAndSourcesOver)
{
  // Facet 0 counts 3 and is made of triangles 4 and, reversed, 9; facet 1 overlaps it upside down.
  FacetComplex complex;
  complex.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 2, 1, 0 } };
  for (Id p = 0; p < 6; ++p)
  {
    complex.Origins.push_back(PointOrigin::Input(p));
  }
  complex.Facets = { { 0, 1, 2 }, { 3, 4, 5 } };
  complex.Multiplicity = { 3, 5 };
  complex.Sources = { { 4, false }, { 9, true }, { 6, false } };
  complex.SourceOffsets = { 0, 2, 3 };
  complex.NumberOfConstraints = 2;
  const FacetComplex resolved = Resolve(complex).Surface;
  EXPECT_DOUBLE_EQ(AreaOfMultiplicity(resolved, -2), 0.5);
  EXPECT_DOUBLE_EQ(AreaOfMultiplicity(resolved, 3), 7.5);
  for (Id f = 0; f < resolved.NumberOfFacets(); ++f)
  {
    const std::vector<FacetSource> sources(resolved.Sources.begin() + resolved.SourceOffsets[f],
      resolved.Sources.begin() + resolved.SourceOffsets[f + 1]);
    EXPECT_TRUE(SameSources(sources,
      resolved.Multiplicity[f] == 3
        ? std::vector<FacetSource>{ { 4, false }, { 9, true } }
        : std::vector<FacetSource>{ { 4, false }, { 6, true }, { 9, true } }));
  }
}

TEST(ResolveSelfIntersections, LeavesWhatIsNoConstraintAlone)
{
  FacetComplex complex =
    ToComplex(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0.5, 0.5 }, { 2, 2, 2 })));
  complex.NumberOfConstraints = 12;
  const Resolution resolution = Resolve(complex);
  EXPECT_TRUE(resolution.IntersectingPairs.empty());
  ExpectSame(resolution.Surface, complex);
}

TEST(ResolveSelfIntersections, UsesACornerOnAFacetByItsId)
{
  const FacetComplex resolved = Resolve(ToComplex(CorpusSurface("corner-on-a-facet"))).Surface;
  EXPECT_EQ(resolved.Points.size(), 6u);
  EXPECT_EQ(resolved.NumberOfFacets(), 4);
}

TEST(ResolveSelfIntersections, KnowsANewPointFromTheCornerThatItIsNextTo)
{
  ExpectLawsAndNothingLeftOut(
    { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1e-20, 1e-20, -1 } },
        { { 1e-20, 1e-20, 1 } }, { { 2, 2, 0 } } },
      { { { 0, 1, 2 } }, { { 3, 4, 5 } } } });
}

TEST(ResolveSelfIntersections, CutsAFacetThatAThousandTouch)
{
  const FacetComplex resolved = Resolve(ToComplex(Comb(1000))).Surface;
  // Tooth i touches the long triangle in a corner: 1000 inner points make 1 + 2000 triangles.
  EXPECT_EQ(resolved.NumberOfFacets(), 1000 + 2001);
}

TEST(ResolveSelfIntersections, CanBeStoppedAtAnyTime)
{
  const FacetComplex complex = ToComplex(GridSoup(1, 10, 4));
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1); // so that the questions are always the same
  StopAt never(0);
  const Resolution expected = ResolveSelfIntersections(complex, never);
  ASSERT_GT(never.Asked, 10);
  for (int n = 1; n <= never.Asked; ++n)
  {
    StopAt monitor(n);
    try
    {
      ResolveSelfIntersections(complex, monitor);
      ADD_FAILURE() << "went on at question " << n;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
    EXPECT_EQ(monitor.Asked, n);
  }
  omp_set_num_threads(threads);
  ExpectSame(Resolve(complex).Surface, expected.Surface);
}
