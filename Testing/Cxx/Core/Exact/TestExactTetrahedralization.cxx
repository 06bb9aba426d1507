// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactTetrahedralization.h"

#include "Common/SortedTriangle.h"
#include "Exact/Phases.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/MeshLaws.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"
#include "Tetrahedralize/AssembleMesh.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <thread>

using namespace insideout;

namespace
{
std::vector<Triangle> ConstraintsOf(const FacetComplex& surface)
{
  return { surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints };
}

ExactTetrahedralization Tetrahedralize(const FacetComplex& surface)
{
  Monitor monitor;
  return TetrahedralizeExactly(surface.Points, ConstraintsOf(surface), monitor);
}

/** Everything that a mesh must hold, whatever is lost. */
TetrahedralMesh LawfulMesh(const FacetComplex& surface, const ExactTetrahedralization& exact)
{
  Monitor monitor;
  const TetrahedralMesh mesh = AssembleMesh(surface, exact.Tetrahedra, monitor);
  testmeshes::ExpectMeshLaws(surface, mesh);
  return mesh;
}

using FacetsByFace = std::map<Triangle, Id>;

FacetsByFace FacetsIn(const ExactTetrahedralization& exact)
{
  FacetsByFace facets;
  for (std::size_t face = 0; face < exact.Tetrahedra.Faces.size(); ++face)
  {
    facets[SortedTriangle(exact.Tetrahedra.Faces[face]).Points] =
      exact.Tetrahedra.FacetOfFaces[face];
  }
  return facets;
}

FacetsByFace FacetsIn(const TetrahedralMesh& mesh)
{
  FacetsByFace facets;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const std::array<int, 3>& corners = TetrahedronFaces[k];
      const Tetrahedron& points = mesh.Cells[cell];
      if (mesh.Facets[cell][k] != None)
      {
        facets[SortedTriangle({ points[corners[0]], points[corners[1]], points[corners[2]] })
                 .Points] = mesh.Facets[cell][k];
      }
    }
  }
  return facets;
}

/** The same, and that assembly agrees about every face: this may differ only where facets cross. */
TetrahedralMesh LawfulMeshOfValid(const FacetComplex& surface)
{
  const ExactTetrahedralization exact = Tetrahedralize(surface);
  TetrahedralMesh mesh = LawfulMesh(surface, exact);
  EXPECT_EQ(FacetsIn(mesh), FacetsIn(exact));
  return mesh;
}

TetrahedralMesh CompleteMesh(const FacetComplex& surface)
{
  TetrahedralMesh mesh = LawfulMeshOfValid(surface);
  EXPECT_TRUE(mesh.LostFacets.empty());
  return mesh;
}

TetrahedralMesh CompleteMesh(const TriangleSoup& soup)
{
  return CompleteMesh(testmeshes::ToComplex(soup));
}

/** The surface that the stages before this one make of a soup. */
FacetComplex Resolved(const TriangleSoup& soup)
{
  Monitor monitor;
  return ResolveSelfIntersections(CountFacets(soup, {}, monitor).Surface, monitor).Surface;
}
} // namespace

TEST(ExactTetrahedralization, FillsABox)
{
  const TetrahedralMesh mesh = CompleteMesh(testmeshes::Box({ 0, 0, 0 }, { 1, 2, 3 }));
  EXPECT_EQ(mesh.NumberOfSteinerPoints, 0);
}

TEST(ExactTetrahedralization, FillsNestedAndTouchingBoxes)
{
  const TriangleSoup nested = testmeshes::Join(testmeshes::Box({ 0, 0, 0 }, { 8, 8, 8 }),
    testmeshes::Join(
      testmeshes::Box({ 1, 1, 1 }, { 7, 7, 7 }), testmeshes::Box({ 2, 2, 2 }, { 6, 6, 6 })));
  CompleteMesh(nested);
  CompleteMesh(Resolved(testmeshes::Join(nested, testmeshes::Box({ 8, 2, 2 }, { 9, 5, 5 }))));
  CompleteMesh(Resolved(testmeshes::Join(nested, testmeshes::Box({ 3, 3, 3 }, { 12, 5, 9 }))));
}

TEST(ExactTetrahedralization, KeepsASingleFacetAndPointsBesideIt)
{
  TriangleSoup soup;
  soup.Points = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } }, { { 1, 1, 2 } },
    { { 1, 1, -2 } }, { { 1, 1, 1 } }, { { 1, 1, -1 } } };
  soup.Triangles = { { { 0, 1, 2 } } };
  CompleteMesh(soup);
}

TEST(ExactTetrahedralization, KeepsAFacetThatAPointLiesWithin)
{
  TriangleSoup soup;
  soup.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0 }, { 1, 1, 1 }, { 1, 1, -1 } };
  soup.Triangles = { { 0, 1, 2 } };
  CompleteMesh(soup);
}

TEST(ExactTetrahedralization, KeepsEveryFacetWherePointsLostTheirOwn)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    CompleteMesh(Resolved(testmeshes::CornersNearlyOne(seed)));
  }
}

TEST(ExactTetrahedralization, FillsSchoenhardtsPolyhedron)
{
  for (const double turn : { 0.1, M_PI / 6, 1.0, -0.1, -M_PI / 6 })
  {
    CompleteMesh(Resolved(testmeshes::TwistedPrism(3, turn)));
  }
  const TetrahedralMesh mesh = CompleteMesh(testmeshes::TwistedPrism(3, -M_PI / 6));
  EXPECT_GE(mesh.NumberOfSteinerPoints, 1);
  EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, 0);
}

TEST(ExactTetrahedralization, FillsTwistedPrisms)
{
  for (int sides = 4; sides < 24; sides += 3)
  {
    CompleteMesh(Resolved(testmeshes::TwistedPrism(sides, M_PI / sides)));
  }
}

TEST(ExactTetrahedralization, FillsChazellesPolyhedron)
{
  CompleteMesh(Resolved(testmeshes::Chazelle(2)));
  CompleteMesh(Resolved(testmeshes::Chazelle(5)));
  CompleteMesh(testmeshes::ToComplex(testmeshes::Chazelle(20)));
}

TEST(ExactTetrahedralization, FillsCosphericalPoints)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    CompleteMesh(Resolved(testmeshes::RingedSphere(seed, 6)));
  }
}

TEST(ExactTetrahedralization, FillsNearlyCoincidentSheets)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    CompleteMesh(testmeshes::NearSheets(seed, 3, 3));
  }
}

TEST(ExactTetrahedralization, KeepsEveryFacetOfResolvedSoups)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    CompleteMesh(Resolved(testmeshes::RandomSoup(seed, 20)));
    CompleteMesh(Resolved(testmeshes::GridSoup(seed, 20, 4)));
  }
}

TEST(ExactTetrahedralization, LosesFacetsThatCross)
{
  TriangleSoup soup;
  soup.Points = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } }, { { 1, 1, -1 } },
    { { 1, 1, 1 } }, { { 5, 5, 0.5 } } };
  soup.Triangles = { { { 0, 1, 2 } }, { { 3, 4, 5 } } };
  for (const FacetComplex& surface :
    { testmeshes::ToComplex(soup), testmeshes::ToComplex(testmeshes::RandomSoup(1, 20)) })
  {
    EXPECT_FALSE(LawfulMesh(surface, Tetrahedralize(surface)).LostFacets.empty());
  }
}

TEST(ExactTetrahedralization, RefusesPointsInAPlane)
{
  Monitor monitor;
  try
  {
    TetrahedralizeExactly(
      { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } } }, {}, monitor);
    FAIL() << "a flat mesh";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Planar);
  }
}

TEST(ExactTetrahedralization, GivesTheSameEachTime)
{
  const FacetComplex surface = Resolved(testmeshes::RandomSoup(3, 40));
  Monitor monitor;
  const ExactTetrahedralization first =
    TetrahedralizeExactly(surface.Points, surface.Facets, monitor);
  const ExactTetrahedralization second =
    TetrahedralizeExactly(surface.Points, surface.Facets, monitor);
  EXPECT_EQ(first.Tetrahedra.Points, second.Tetrahedra.Points);
  EXPECT_EQ(first.Tetrahedra.Cells, second.Tetrahedra.Cells);
  EXPECT_EQ(first.Tetrahedra.Faces, second.Tetrahedra.Faces);
}

TEST(ExactTetrahedralization, GivesTheSameInThreadsSideBySide)
{
  const std::array<FacetComplex, 2> surfaces = { { Resolved(testmeshes::RandomSoup(4, 20)),
    Resolved(testmeshes::GridSoup(5, 30, 5)) } };
  std::array<ExactTetrahedralization, 4> found;
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    threads.emplace_back(
      [&, k]
      {
        Monitor monitor;
        found[k] = TetrahedralizeExactly(surfaces[k % 2].Points, surfaces[k % 2].Facets, monitor);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    Monitor monitor;
    const ExactTetrahedralization alone =
      TetrahedralizeExactly(surfaces[k % 2].Points, surfaces[k % 2].Facets, monitor);
    EXPECT_EQ(found[k].Tetrahedra.Points, alone.Tetrahedra.Points);
    EXPECT_EQ(found[k].Tetrahedra.Cells, alone.Tetrahedra.Cells);
    EXPECT_EQ(found[k].Tetrahedra.Faces, alone.Tetrahedra.Faces);
  }
}

namespace
{
/** Records the reported phases, and stops after this number of reports. */
struct PhaseMonitor : Monitor
{
  explicit PhaseMonitor(int allowed = std::numeric_limits<int>::max())
    : Allowed(allowed)
  {
  }

  bool Continue(const char* phase, double fraction) override
  {
    this->Phases.insert(phase);
    EXPECT_GE(fraction, this->Fractions.empty() ? 0 : this->Fractions.back());
    EXPECT_LE(fraction, 1);
    this->Fractions.push_back(fraction);
    return static_cast<int>(this->Fractions.size()) <= this->Allowed;
  }

  std::set<std::string> Phases;
  std::vector<double> Fractions;

private:
  const int Allowed;
};

} // namespace

TEST(ExactTetrahedralization, NamesItsPhasesAndTheirProgressGrows)
{
  std::set<std::string> known;
  for (const ProgressRange& phase : { Phases::InsertingPoints, Phases::RecoveringSegments,
         Phases::SplittingSegments, Phases::RecoveringFacets, Phases::SplittingFacets,
         Phases::RecoveringLostFacets, Phases::MovingPoints, Phases::RemovingPoints,
         Phases::ShakingPoints, Phases::FindingCrossings, Phases::RoundingPoints })
  {
    known.insert(phase.Stage);
  }
  PhaseMonitor monitor;
  for (const FacetComplex& surface : { testmeshes::ToComplex(testmeshes::Chazelle(12)),
         testmeshes::ToComplex(testmeshes::RandomSoup(1, 20)),
         Resolved(testmeshes::GridSoup(51, 40, 5)), Resolved(testmeshes::GridSoup(104, 40, 5)),
         Resolved(testmeshes::GridSoup(383, 40, 5)) })
  {
    monitor.Fractions.clear();
    TetrahedralizeExactly(surface.Points, ConstraintsOf(surface), monitor);
    const std::set<double> distinct(monitor.Fractions.begin(), monitor.Fractions.end());
    EXPECT_GE(distinct.size(), 10u);
    EXPECT_GE(monitor.Fractions.back(), Phases::SplittingSegments.End);
  }
  EXPECT_EQ(monitor.Phases, known);
}

TEST(ExactTetrahedralization, StopsAtEveryReportOfEachPhase)
{
  const FacetComplex surface = Resolved(testmeshes::Chazelle(2));
  PhaseMonitor patient;
  TetrahedralizeExactly(surface.Points, ConstraintsOf(surface), patient);
  std::set<std::string> stoppedIn;
  for (int allowed = 0; allowed < static_cast<int>(patient.Fractions.size()); ++allowed)
  {
    PhaseMonitor monitor(allowed);
    try
    {
      TetrahedralizeExactly(surface.Points, ConstraintsOf(surface), monitor);
      ADD_FAILURE() << "went on after report " << allowed;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
      stoppedIn.insert(std::string(error.what()).substr(std::strlen("stopped while ")));
    }
    EXPECT_EQ(static_cast<int>(monitor.Fractions.size()), allowed + 1);
  }
  EXPECT_EQ(stoppedIn, patient.Phases);
  EXPECT_GE(stoppedIn.size(), 6u);
}

TEST(ExactTetrahedralization, FindsPlacesWhereFacetsNearlyTouch)
{
  // Segments here pass beside edges of other facets at a distance below any double.
  CompleteMesh(Resolved(testmeshes::GridSoup(1013, 80, 7)));
}

TEST(ExactTetrahedralization, PassesBetweenFacetsOnPointsOnBothSidesOfThem)
{
  // A segment passes between two facets where no double is.
  CompleteMesh(Resolved(testmeshes::GridSoup(80412, 40, 5)));
}

TEST(ExactTetrahedralization, EndsWhenTheWorkIsDone)
{
  // Every ridge is in the way of every other: many cuts, which need more.
  const FacetComplex surface = testmeshes::ToComplex(testmeshes::Chazelle(12));
  const auto elements =
    static_cast<std::int64_t>(surface.Points.size()) + surface.NumberOfConstraints;
  const ExactTetrahedralization patient = Tetrahedralize(surface);
  EXPECT_TRUE(LawfulMesh(surface, patient).LostFacets.empty());
  for (const std::int64_t workPerElement : { 0, 1000, 3000 })
  {
    Monitor monitor;
    const ExactTetrahedralization hasty =
      TetrahedralizeExactly(surface.Points, ConstraintsOf(surface), monitor, workPerElement);
    EXPECT_LT(hasty.Work, patient.Work);
    EXPECT_LT(hasty.Work, 10 * elements * (workPerElement + 1000));
    const TetrahedralMesh mesh = LawfulMesh(surface, hasty);
    EXPECT_FALSE(mesh.LostFacets.empty());
    EXPECT_EQ(FacetsIn(mesh), FacetsIn(hasty));
  }
}

TEST(ExactTetrahedralization, EndsOnASurfaceThatCrossesItselfAllOver)
{
  const FacetComplex surface = testmeshes::ToComplex(testmeshes::RandomSoup(7, 60));
  LawfulMesh(surface, Tetrahedralize(surface));
}
