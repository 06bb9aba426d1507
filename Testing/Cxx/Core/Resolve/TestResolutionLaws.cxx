// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/ResolutionLaws.h"

#include "Support/ExactReference.h"
#include "Support/SurfaceFamilies.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace insideout;
using namespace testmeshes;

/** The judge finds what is wrong: each test spoils a good result in one way. */
namespace
{
class SpoiledResolution : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Before =
      ToComplex(Merged(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0.25, 0.3 }, { 2, 2, 2 }))));
    Monitor monitor;
    this->After = ResolveSelfIntersections(this->Before, monitor).Surface;
    this->FirstNew = static_cast<Id>(this->Before.Points.size());
    ASSERT_TRUE(this->Violations().empty());
    ASSERT_GT(this->After.Points.size(), this->Before.Points.size());
  }

  std::vector<std::string> Violations() const
  {
    return JudgeResolution(this->Before, this->After, 200).Violations;
  }

  bool Complains(const std::string& of) const
  {
    const std::vector<std::string> violations = this->Violations();
    return std::any_of(violations.begin(), violations.end(),
      [&](const std::string& violation) { return violation.find(of) != std::string::npos; });
  }

  void RemoveLastFacet()
  {
    this->After.Facets.pop_back();
    this->After.Multiplicity.pop_back();
    this->After.SourceOffsets.pop_back();
    this->After.Sources.resize(this->After.SourceOffsets.back());
    --this->After.NumberOfConstraints;
  }

  FacetComplex Before;
  FacetComplex After;
  Id FirstNew = None;
};
} // namespace

TEST_F(SpoiledResolution, WithAMissingPiece)
{
  this->RemoveLastFacet();
  EXPECT_TRUE(this->Complains("area"));
  EXPECT_TRUE(this->Complains("gap"));
  EXPECT_TRUE(this->Complains("came open"));
  EXPECT_TRUE(this->Complains("w differs"));
}

TEST_F(SpoiledResolution, WithAMovedInputPoint)
{
  this->After.Points[0][0] = std::nextafter(this->After.Points[0][0], 1);
  EXPECT_TRUE(this->Complains("bit by bit"));
}

TEST_F(SpoiledResolution, WithANewPointOffItsFacet)
{
  this->After.Points[this->FirstNew][0] += 1e-11;
  this->After.Points[this->FirstNew][1] += 1e-11;
  this->After.Points[this->FirstNew][2] += 1e-11;
  EXPECT_TRUE(this->Complains("stand off"));
}

TEST_F(SpoiledResolution, WithAPointThatNoFacetHas)
{
  this->After.Points.push_back(this->After.Points.back());
  this->After.Origins.push_back(this->After.Origins.back());
  EXPECT_TRUE(this->Complains("no facet has new point"));
}

TEST_F(SpoiledResolution, WithAPointWithinAFacetOrAnEdge)
{
  const Triangle& t = this->After.Facets[0];
  const Point& a = this->After.Points[t[0]];
  const Point& b = this->After.Points[t[1]];
  // All points have short coordinates: nothing is rounded here.
  const Point middle = { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
  for (FacetComplex* complex : { &this->Before, &this->After })
  {
    complex->Points.insert(complex->Points.begin(), middle);
    complex->Origins.insert(complex->Origins.begin(), PointOrigin::Input(0));
    for (Triangle& corners : complex->Facets)
    {
      corners = { corners[0] + 1, corners[1] + 1, corners[2] + 1 };
    }
  }
  EXPECT_TRUE(this->Complains("within facet 0 lies point 0"));
  this->After.Points[0][0] = this->Before.Points[0][0] = 0.5;
  this->After.Points[0][1] = this->Before.Points[0][1] = 0.125;
  this->After.Points[0][2] = this->Before.Points[0][2] = 0;
  EXPECT_TRUE(this->Complains("lies point 0"));
  this->After.Points[0][2] = this->Before.Points[0][2] = 1e-300;
  EXPECT_TRUE(this->Violations().empty());
}

TEST_F(SpoiledResolution, WithAFacetTurnedOver)
{
  std::swap(this->After.Facets.back()[0], this->After.Facets.back()[1]);
  EXPECT_TRUE(this->Complains("area"));
  EXPECT_TRUE(this->Complains("w differs"));
}

TEST_F(SpoiledResolution, WithAWrongMultiplicity)
{
  ++this->After.Multiplicity.back();
  EXPECT_TRUE(this->Complains("came open"));
  EXPECT_TRUE(this->Complains("w differs"));
  EXPECT_TRUE(this->Complains("does not count as often"));
}

TEST_F(SpoiledResolution, WithAFacetTwice)
{
  this->After.Facets.back() = this->After.Facets[this->After.Facets.size() - 2];
  EXPECT_TRUE(this->Complains("twice"));
}

TEST_F(SpoiledResolution, WithAForeignSource)
{
  this->After.Sources.back().Triangle = 1000;
  EXPECT_TRUE(this->Complains("source"));
}

TEST_F(SpoiledResolution, WithFacetsUncut)
{
  this->After = this->Before;
  EXPECT_TRUE(this->Complains("crossing pairs"));
}

TEST_F(SpoiledResolution, WithAPointMovedByOneUnitInTheLastPlace)
{
  // So little that only exact arithmetic tells whether something crosses now.
  const Point good = this->After.Points[this->FirstNew];
  for (int k = 0; k < 3; ++k)
  {
    this->After.Points[this->FirstNew] = good;
    double& x = this->After.Points[this->FirstNew][k];
    x = std::nextafter(x, 9);
    EXPECT_EQ(IntersectionsBySweep(this->After.Points, this->After.Facets),
      IntersectionsByClipping(this->After.Points, this->After.Facets));
  }
}

TEST(ExactReference, TheSweepFindsWhatClippingFinds)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    TriangleSoup soup = GridSoup(seed, 14, 2 + seed % 4);
    if (seed % 2 == 1)
    {
      for (Point& p : soup.Points)
      {
        p = { p[0] + 3 * p[1] + 5 * p[2], 7 * p[0] - p[1] + p[2], p[0] + p[1] - 11 * p[2] };
      }
    }
    ASSERT_EQ(IntersectionsBySweep(soup.Points, soup.Triangles),
      IntersectionsByClipping(soup.Points, soup.Triangles))
      << "seed " << seed;
  }
}

TEST(ExactReference, TheSweepFindsWhatClippingFindsInEveryFamily)
{
  for (const SurfaceFamily& family : SurfaceFamilies(4))
  {
    for (const TriangleSoup& member : family.Members)
    {
      if (member.Triangles.size() < 60)
      {
        Monitor monitor;
        const FacetComplex surface = CountFacets(member, {}, monitor).Surface;
        ASSERT_EQ(IntersectionsBySweep(surface.Points, surface.Facets),
          IntersectionsByClipping(surface.Points, surface.Facets))
          << family.Name;
      }
    }
  }
}
