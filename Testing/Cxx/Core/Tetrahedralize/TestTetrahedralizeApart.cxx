// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/TetrahedralizeApart.h"

#include "Support/AllowedThreads.h"
#include "Support/StandInHelper.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{
using namespace insideout;

TriangleSoup Moved(TriangleSoup soup, double by)
{
  for (Point& p : soup.Points)
  {
    p[0] += by;
  }
  return soup;
}

/** Closed surfaces without crossings, whose boxes do not meet, some with Steiner points. */
std::vector<TriangleSoup> Pieces()
{
  std::vector<TriangleSoup> pieces;
  for (int i = 0; i < 12; ++i)
  {
    pieces.push_back(Moved(testmeshes::TwistedPrism(3 + i * 5 % 12, i % 3 ? -0.3 : 0.2), 10 * i));
  }
  return pieces;
}

FacetComplex Together(const std::vector<TriangleSoup>& pieces)
{
  TriangleSoup all;
  for (const TriangleSoup& piece : pieces)
  {
    all = testmeshes::Join(std::move(all), piece);
  }
  return testmeshes::ToComplex(all);
}

Tetrahedralization Apart(
  const FacetComplex& surface, TetrahedralizationEngine engine = TetrahedralizationEngine::Exact)
{
  Monitor silent;
  ConstrainedDelaunayParameters parameters;
  parameters.Engine = engine;
  return TetrahedralizeApart(surface, parameters, silent);
}

void ExpectSame(const TetrahedralMesh& a, const TetrahedralMesh& b)
{
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.Cells, b.Cells);
  EXPECT_EQ(a.Neighbors, b.Neighbors);
  EXPECT_EQ(a.Facets, b.Facets);
  EXPECT_EQ(a.FacetSides, b.FacetSides);
  EXPECT_EQ(a.LostFacets, b.LostFacets);
  EXPECT_EQ(a.NumberOfSteinerPoints, b.NumberOfSteinerPoints);
  EXPECT_EQ(a.NumberOfSurfaceSteinerPoints, b.NumberOfSurfaceSteinerPoints);
  ASSERT_EQ(a.Origins.size(), b.Origins.size());
  for (std::size_t p = 0; p < a.Origins.size(); ++p)
  {
    EXPECT_EQ(a.Origins[p].Points, b.Origins[p].Points) << p;
    EXPECT_EQ(a.Origins[p].Weights, b.Origins[p].Weights) << p;
  }
}

/** One mesh behind the other. */
void AppendMesh(const TetrahedralMesh& piece, std::size_t given, Id firstPoint, Id firstFacet,
  TetrahedralMesh& all)
{
  const Id firstCell = all.NumberOfCells();
  const Id steiner = static_cast<Id>(all.Points.size() - given);
  const auto shift = [](Id id, Id by) { return id == None ? None : id + by; };
  for (Id cell = 0; cell < piece.NumberOfCells(); ++cell)
  {
    all.Cells.push_back(piece.Cells[cell]);
    all.Neighbors.push_back(piece.Neighbors[cell]);
    all.Facets.push_back(piece.Facets[cell]);
    all.FacetSides.push_back(piece.FacetSides[cell]);
    for (int k = 0; k < 4; ++k)
    {
      Id& corner = all.Cells.back()[k];
      corner += static_cast<std::size_t>(corner) < given ? firstPoint : steiner;
      all.Neighbors.back()[k] = shift(all.Neighbors.back()[k], firstCell);
      all.Facets.back()[k] = shift(all.Facets.back()[k], firstFacet);
    }
  }
  for (std::size_t p = given; p < piece.Points.size(); ++p)
  {
    PointOrigin origin = piece.Origins[p];
    for (Id& point : origin.Points)
    {
      point = shift(point, firstPoint);
    }
    all.Points.push_back(piece.Points[p]);
    all.Origins.push_back(origin);
  }
  all.NumberOfSteinerPoints += piece.NumberOfSteinerPoints;
  all.NumberOfSurfaceSteinerPoints += piece.NumberOfSurfaceSteinerPoints;
}
} // namespace

TEST(TetrahedralizeApart, EachPartIsTheMeshOfItAlone)
{
  const std::vector<TriangleSoup> pieces = Pieces();
  const FacetComplex surface = Together(pieces);
  const Tetrahedralization apart = Apart(surface);
  EXPECT_EQ(apart.Parts, static_cast<Id>(pieces.size()));
  EXPECT_EQ(apart.Rung, 1);
  EXPECT_TRUE(apart.Failures.empty());
  TetrahedralMesh expected;
  expected.Points = surface.Points;
  expected.Origins = surface.Origins;
  Id firstPoint = 0;
  Id firstFacet = 0;
  for (const TriangleSoup& piece : pieces)
  {
    Monitor silent;
    AppendMesh(ConstrainedDelaunay(testmeshes::ToComplex(piece), silent), piece.Points.size(),
      firstPoint, firstFacet, expected);
    firstPoint += static_cast<Id>(piece.Points.size());
    firstFacet += static_cast<Id>(piece.Triangles.size());
  }
  EXPECT_GT(expected.NumberOfSteinerPoints, 0);
  ExpectSame(apart.Mesh, expected);
}

TEST(TetrahedralizeApart, IsTheSameOnAnyNumberOfThreads)
{
  const FacetComplex surface = Together(Pieces());
  const testthreads::Allowed one(1);
  const Tetrahedralization expected = Apart(surface);
  for (const int threads : { 2, 8 })
  {
    const testthreads::Allowed allowed(threads);
    ExpectSame(Apart(surface).Mesh, expected.Mesh);
  }
}

TEST(TetrahedralizeApart, OnePartIsTheMeshThatItWouldBe)
{
  const FacetComplex surface =
    Together({ testmeshes::Box({ -9, -9, -9 }, { 9, 9, 9 }), testmeshes::TwistedPrism(5, -0.3) });
  Monitor silent;
  const Tetrahedralization apart = Apart(surface);
  EXPECT_EQ(apart.Parts, 1);
  ExpectSame(apart.Mesh, ConstrainedDelaunay(surface, silent));
}

TEST(TetrahedralizeApart, ErrorsNameTheirPart)
{
  const FacetComplex surface =
    Together({ testmeshes::TwistedPrism(3, -0.5), Moved(testmeshes::TwistedPrism(3, -0.5), 100) });
  const standin::StandIn broken("exit 3");
  const Tetrahedralization result = Apart(surface, TetrahedralizationEngine::TetGen);
  EXPECT_EQ(result.Parts, 2);
  for (const std::string name : { "the part at point 0: TetGen", "the part at point 6: TetGen" })
  {
    EXPECT_TRUE(std::any_of(result.Failures.begin(), result.Failures.end(),
      [&](const std::string& failure) { return failure.find(name) == 0; }))
      << name;
  }
  EXPECT_TRUE(std::is_sorted(result.Mesh.LostFacets.begin(), result.Mesh.LostFacets.end()));
  EXPECT_GT(result.Mesh.LostFacets.size(), 1u);
  std::vector<std::string> warnings;
  AddWarnings(result, warnings);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
    [](const std::string& warning)
    { return warning.find("the tetrahedra of some parts come from: ") == 0; }));
}

TEST(TetrahedralizeApart, AnErrorNamesItsPart)
{
  const FacetComplex surface = Together(
    { testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }), testmeshes::Box({ 2, 0, 0 }, { 3, 1, 1 }) });
  ConstrainedDelaunayParameters parameters;
  parameters.MemoryBudget = -1;
  Monitor silent;
  try
  {
    TetrahedralizeApart(surface, parameters, silent);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    EXPECT_EQ(std::string(error.what()).find("the part at point 0: "), 0u) << error.what();
  }
}

TEST(TetrahedralizeApart, StopsAtEveryReport)
{
  class Counting : public Monitor
  {
  public:
    explicit Counting(int allowed)
      : Allowed(allowed)
    {
    }
    bool Continue(const char*, double fraction) override
    {
      EXPECT_GE(fraction, this->Last);
      this->Last = fraction;
      return ++this->Reports <= this->Allowed;
    }
    double Last = 0;
    int Reports = 0;

  private:
    const int Allowed;
  };
  const testthreads::Allowed one(1); // so that reports are as many each time
  const FacetComplex surface = Together({ testmeshes::TwistedPrism(4, -0.5),
    Moved(testmeshes::TwistedPrism(5, -0.3), 100), Moved(testmeshes::TwistedPrism(3, 0.2), 200) });
  Counting patient(std::numeric_limits<int>::max());
  TetrahedralizeApart(surface, {}, patient);
  EXPECT_NEAR(patient.Last, 1, 1e-6);
  EXPECT_GT(patient.Reports, 3);
  for (int allowed = 0; allowed < patient.Reports; ++allowed)
  {
    Counting monitor(allowed);
    try
    {
      TetrahedralizeApart(surface, {}, monitor);
      ADD_FAILURE() << "went on after report " << allowed;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
  }
}
