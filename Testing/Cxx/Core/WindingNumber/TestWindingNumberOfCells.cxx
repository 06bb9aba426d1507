// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumberOfCells.h"

#include "Common/Team.h"
#include "Support/AllowedThreads.h"
#include "Support/TestMeshes.h"
#include "Support/TestTetrahedra.h"
#include "Support/WindingNumberInQuads.h"
#include "WindingNumber/SolidAngle.h"
#include "WindingNumber/SurfaceWindingNumber.h"
#include "WindingNumber/WindingNumberSum.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstring>

namespace
{
using namespace insideout;
using testmeshes::WindingNumberInQuads;
using testtetrahedra::BoundaryOfLabels;
using testtetrahedra::Grid;
using testtetrahedra::RandomFaces;
using testtetrahedra::RandomLabels;

/** Meshes of all kinds: well shaped, flat as paper, with slivers. */
enum Shape
{
  Plain,
  Squeezed,
  SqueezedHard,
  Flattened,
  FlattenedAndSqueezed,
  NumberOfShapes
};

TetrahedralMesh MakeMesh(int shape, unsigned seed, int size = 3)
{
  TetrahedralMesh mesh = Grid(seed, size);
  if (shape == Flattened || shape == FlattenedAndSqueezed)
  {
    EXPECT_GT(testtetrahedra::Flatten(mesh, seed), 2);
  }
  if (shape == Squeezed || shape == SqueezedHard)
  {
    testtetrahedra::Squeeze(mesh, seed % 3, shape == Squeezed ? 1e-8 : 1e-15);
  }
  if (shape == FlattenedAndSqueezed)
  {
    testtetrahedra::Squeeze(mesh, seed % 3, 0x1p-20); // exactly, so that all cells stay positive
  }
  EXPECT_TRUE(testtetrahedra::AllPositive(mesh));
  return mesh;
}

/** The barycenter of a cell. */
Site SiteOf(const TetrahedralMesh& mesh, std::size_t cell)
{
  return Sites{ mesh.Points, mesh.Cells }[cell];
}

std::vector<double> Sum(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  Monitor monitor;
  return WindingNumberSum(surface, { mesh.Points, mesh.Cells }, monitor);
}

std::vector<double> Stage(
  const FacetComplex& surface, const TetrahedralMesh& mesh, int quadratureOrder = 1)
{
  Monitor monitor;
  return WindingNumberOfCells(surface, mesh, monitor, quadratureOrder);
}

bool SameBytes(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), 8 * a.size()) == 0;
}

ErrorCode CodeOf(const FacetComplex& surface, const TetrahedralMesh& mesh, std::string& message)
{
  try
  {
    Stage(surface, mesh);
  }
  catch (const Error& error)
  {
    message = error.what();
    return error.Code;
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorCode::EmptySurface;
}

/** One cell whose barycenter is `centre`: the corners lie around it. */
TetrahedralMesh CellAround(Point centre, double size)
{
  TetrahedralMesh mesh;
  mesh.Points = { { centre[0] + size, centre[1] + size, centre[2] + size },
    { centre[0] - size, centre[1] - size, centre[2] + size },
    { centre[0] - size, centre[1] + size, centre[2] - size },
    { centre[0] + size, centre[1] - size, centre[2] - size } };
  mesh.Cells = { { { 0, 1, 2, 3 } } };
  return mesh;
}

TEST(IsClosed, CountsEdgesWithMultiplicityAndOrientation)
{
  FacetComplex box = testmeshes::ToComplex(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }));
  EXPECT_TRUE(IsClosed(box));
  EXPECT_TRUE(IsClosed(FacetComplex()));
  std::swap(box.Facets[5][0], box.Facets[5][1]);
  EXPECT_FALSE(IsClosed(box));
  box.Multiplicity[5] = -1;
  EXPECT_TRUE(IsClosed(box));
  box.Multiplicity[5] = 0;
  EXPECT_FALSE(IsClosed(box));
  box.Multiplicity.assign(12, 0);
  EXPECT_TRUE(IsClosed(box));
  box.Multiplicity.assign(12, 32767);
  box.Multiplicity[5] = -32767;
  EXPECT_TRUE(IsClosed(box));
  box.Multiplicity[5] = -32766;
  EXPECT_FALSE(IsClosed(box));
}

TEST(WindingNumberOfCells, EqualsTheLabelsOnClosedComplexes)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed, 3);
    const std::vector<int> labels = RandomLabels(mesh, seed);
    const FacetComplex surface = BoundaryOfLabels(mesh, labels, seed);
    ASSERT_TRUE(IsClosed(surface));
    EXPECT_EQ(Stage(surface, mesh), std::vector<double>(labels.begin(), labels.end()));
  }
}

/** Make it as if the mesh had no faces of this facet. */
void LoseFacet(TetrahedralMesh& mesh, Id facet)
{
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Facets[cell][k] == facet)
      {
        mesh.Facets[cell][k] = None;
        mesh.FacetSides[cell][k] = 0;
      }
    }
  }
}

/** Some facets at random are lost by the mesh, and the last ones left out of it. */
void LoseFacets(FacetComplex& surface, TetrahedralMesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  surface.NumberOfConstraints -= 2;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const bool lost = random() % 16 == 0;
    if (f >= surface.NumberOfConstraints || lost)
    {
      LoseFacet(mesh, f);
    }
    if (f < surface.NumberOfConstraints && lost)
    {
      mesh.LostFacets.push_back(f);
    }
  }
}

TEST(WindingNumberOfCells, IsAnIntegerOnClosedComplexesWithFacetsThatTheMeshLacks)
{
  for (unsigned seed = 0; seed < 2 * NumberOfShapes; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed);
    const std::vector<int> labels = RandomLabels(mesh, seed);
    FacetComplex surface = BoundaryOfLabels(mesh, labels, seed);
    LoseFacets(surface, mesh, seed);
    ASSERT_FALSE(mesh.LostFacets.empty());
    for (const int order : { 1, 3, 5 })
    {
      EXPECT_EQ(Stage(surface, mesh, order), std::vector<double>(labels.begin(), labels.end()));
    }
  }
}

TEST(WindingNumberOfCells, NamesTheCellsBetweenWhichTheCountIsWrong)
{
  TetrahedralMesh mesh = MakeMesh(Plain, 1);
  std::vector<int> labels(mesh.Cells.size(), 0);
  labels[50] = 1;
  const FacetComplex surface = BoundaryOfLabels(mesh, labels, 1);
  TetrahedralMesh wrong = mesh;
  const int face = wrong.Neighbors[50][0] == None ? 1 : 0;
  const Id neighbor = wrong.Neighbors[50][face];
  ASSERT_NE(neighbor, None);
  wrong.FacetSides[50][face] = static_cast<std::int8_t>(-wrong.FacetSides[50][face]);
  std::string first;
  EXPECT_EQ(CodeOf(surface, wrong, first), ErrorCode::Inconsistent);
  EXPECT_NE(first.find("cell 50"), std::string::npos) << first;
  EXPECT_NE(first.find("cell " + std::to_string(neighbor)), std::string::npos) << first;

  // With more of them, threads meet them in any order.
  for (std::size_t cell = 0; cell < wrong.Cells.size(); cell += 3)
  {
    wrong.FacetSides[cell] = { { 1, 1, 1, 1 } };
    wrong.Facets[cell] = { { 0, 0, 0, 0 } };
  }
  EXPECT_EQ(CodeOf(surface, wrong, first), ErrorCode::Inconsistent);
  const WholeTeams teams;
  for (const int threads : { 1, 2, 8 })
  {
    const testthreads::Allowed allowed(threads);
    std::string message;
    EXPECT_EQ(CodeOf(surface, wrong, message), ErrorCode::Inconsistent);
    EXPECT_EQ(message, first);
  }
}

TEST(WindingNumberOfCells, NamesACellThatCannotBeReached)
{
  TetrahedralMesh mesh = MakeMesh(Plain, 1);
  const FacetComplex surface = BoundaryOfLabels(mesh, std::vector<int>(mesh.Cells.size(), 1), 1);
  mesh.Cells.push_back(mesh.Cells[0]);
  mesh.Cells.push_back(mesh.Cells[1]);
  const Id last = mesh.NumberOfCells() - 1;
  mesh.Neighbors.push_back({ { last, last, last, last } });
  mesh.Neighbors.push_back({ { last - 1, last - 1, last - 1, last - 1 } });
  mesh.Facets.resize(mesh.Cells.size(), { { None, None, None, None } });
  mesh.FacetSides.resize(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  std::string message;
  EXPECT_EQ(CodeOf(surface, mesh, message), ErrorCode::Inconsistent);
  EXPECT_EQ(message, "cell 162 cannot be reached from the hull");
}

/** The largest difference between the stage's values and quadruple precision. */
double WorstError(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  const std::vector<double> w = Stage(surface, mesh);
  double worst = 0;
  for (std::size_t cell = 0; cell < w.size(); ++cell)
  {
    const double error = std::abs(w[cell] - WindingNumberInQuads(surface, SiteOf(mesh, cell)));
    EXPECT_FALSE(std::isnan(error)) << "cell " << cell;
    worst = std::max(worst, error);
  }
  return worst;
}

TEST(WindingNumberOfCells, EqualsQuadruplePrecisionOnOpenComplexes)
{
  for (unsigned seed = 0; seed < 5 * NumberOfShapes; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed);
    const FacetComplex surface = RandomFaces(mesh, seed);
    ASSERT_FALSE(IsClosed(surface));
    EXPECT_LT(WorstError(surface, mesh), 1e-13) << "seed " << seed;
  }
}

TEST(WindingNumberOfCells, EqualsQuadruplePrecisionOnClosedComplexesWithHoles)
{
  for (unsigned seed = 0; seed < 2 * NumberOfShapes; ++seed)
  {
    // A few holes of one facet and one large one in the boundary of half of a grid.
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed, 4);
    std::vector<int> labels(mesh.Cells.size(), 0);
    std::fill(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(labels.size() / 2), 1);
    FacetComplex surface = BoundaryOfLabels(mesh, labels, seed);
    std::mt19937 random(seed);
    for (int hole = 0; hole < 4; ++hole)
    {
      surface.Multiplicity[random() % surface.Multiplicity.size()] = 0;
    }
    for (Id f = 0; f < surface.NumberOfFacets() / 8; ++f)
    {
      surface.Multiplicity[f] = 0;
    }
    ASSERT_FALSE(IsClosed(surface));
    EXPECT_LT(WorstError(surface, mesh), 1e-13) << "seed " << seed;
  }
}

TEST(WindingNumberOfCells, EqualsQuadruplePrecisionOnOpenComplexesWithFacetsThatTheMeshLacks)
{
  for (unsigned seed = 0; seed < 2 * NumberOfShapes; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed);
    FacetComplex surface = RandomFaces(mesh, seed);
    LoseFacets(surface, mesh, seed);
    EXPECT_LT(WorstError(surface, mesh), 1e-13) << "seed " << seed;
  }
}

TEST(WindingNumberOfCells, EqualsQuadruplePrecisionInOtherCellsThatFacetsCross)
{
  Monitor monitor;
  for (unsigned seed = 0; seed < 5 * NumberOfShapes; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed);
    FacetComplex surface = RandomFaces(mesh, seed);
    LoseFacets(surface, mesh, seed);
    const TetrahedralMesh other = Grid(seed + 1, 2);
    const std::vector<double> w =
      WindingNumberOfOtherCells(surface, mesh, other.Points, other.Cells, 1, monitor, { "", 0, 1 });
    ASSERT_EQ(w.size(), other.Cells.size());
    for (std::size_t c = 0; c < w.size(); ++c)
    {
      ASSERT_NEAR(w[c], WindingNumberInQuads(surface, SiteOf(other, c)), 1e-13) << "seed " << seed;
    }
  }
}

/** The integral of the gradient of w along a line, which no facet crosses: how much w changes. */
double SmoothChange(const SurfaceWindingNumber& w, const Point& from, const Point& to)
{
  // Gauss and Legendre's rule with three places, on many parts of the line.
  const int parts = 150;
  const double places[3] = { 0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15) };
  const double weights[3] = { 5. / 18, 8. / 18, 5. / 18 };
  double sum = 0;
  for (int part = 0; part < parts; ++part)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double t = (part + places[k]) / parts;
      Point p;
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = from[axis] + t * (to[axis] - from[axis]);
      }
      const Point gradient = w.Gradient(p);
      for (int axis = 0; axis < 3; ++axis)
      {
        sum += weights[k] / parts * gradient[axis] * (to[axis] - from[axis]);
      }
    }
  }
  return sum;
}

Point Mean(const TetrahedralMesh& mesh, const std::vector<Id>& corners)
{
  Point mean = { 0, 0, 0 };
  for (const Id p : corners)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      mean[axis] += mesh.Points[p][axis] / static_cast<double>(corners.size());
    }
  }
  return mean;
}

TEST(WindingNumberOfCells, RisesAcrossEveryFaceByMultiplicityAndTheBoundarysPart)
{
  Monitor monitor;
  for (unsigned seed = 0; seed < 2; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(Plain, seed);
    const FacetComplex surface = RandomFaces(mesh, seed);
    ASSERT_FALSE(IsClosed(surface));
    const SurfaceWindingNumber smooth(surface, {}, monitor);
    const std::vector<double> w = Stage(surface, mesh);
    int counted = 0;
    for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      const Tetrahedron& t = mesh.Cells[cell];
      for (int k = 0; k < 4; ++k)
      {
        const Id neighbor = mesh.Neighbors[cell][k];
        if (neighbor == None || neighbor > cell)
        {
          continue;
        }
        const Tetrahedron& u = mesh.Cells[neighbor];
        const std::array<int, 3>& corners = TetrahedronFaces[k];
        const Point middle = Mean(mesh, { t[corners[0]], t[corners[1]], t[corners[2]] });
        const double change = SmoothChange(smooth, Mean(mesh, { u[0], u[1], u[2], u[3] }), middle) +
          SmoothChange(smooth, middle, Mean(mesh, { t[0], t[1], t[2], t[3] }));
        const int multiplicity = MultiplicityOnEntering(surface, mesh, cell, k);
        counted += multiplicity != 0;
        EXPECT_NEAR(w[cell] - w[neighbor], multiplicity + change, 1e-9)
          << "cells " << cell << " and " << neighbor << ", seed " << seed;
      }
    }
    EXPECT_GT(counted, 10);
  }
}

TEST(WindingNumberSum, EqualsTheLabelsOnClosedComplexes)
{
  for (unsigned seed = 0; seed < 5 * NumberOfShapes; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed);
    const std::vector<int> labels = RandomLabels(mesh, seed);
    const FacetComplex surface = BoundaryOfLabels(mesh, labels, seed);
    const std::vector<double> w = Sum(surface, mesh);
    for (std::size_t cell = 0; cell < labels.size(); ++cell)
    {
      EXPECT_NEAR(w[cell], labels[cell], 1e-13) << "cell " << cell << ", seed " << seed;
    }
  }
}

TEST(WindingNumberSum, ChangesByTwiceTheSolidAngleOfAFacetThatIsTurnedOver)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(Flattened, seed);
    FacetComplex surface = RandomFaces(mesh, seed);
    surface.Multiplicity[0] = 2;
    const std::vector<double> before = Sum(surface, mesh);
    surface.Multiplicity[0] = -2;
    const std::vector<double> after = Sum(surface, mesh);
    FacetComplex difference = surface;
    difference.Facets = { surface.Facets[0] };
    difference.Multiplicity = { 4 };
    for (std::size_t cell = 0; cell < before.size(); ++cell)
    {
      const double expected = WindingNumberInQuads(difference, SiteOf(mesh, cell));
      EXPECT_NEAR(before[cell] - after[cell], expected, 1e-13);
    }
  }
}

TEST(WindingNumberSum, DoesNotDependOnScale)
{
  for (unsigned seed = 0; seed < NumberOfShapes; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed);
    FacetComplex surface = RandomFaces(mesh, seed);
    const std::vector<double> w = Sum(surface, mesh);
    for (double factor : { 0x1p-100, 0x1p100, 0x1p-400, 0x1p500 })
    {
      TetrahedralMesh scaledMesh = mesh;
      FacetComplex scaled = surface;
      for (int axis = 0; axis < 3; ++axis)
      {
        testtetrahedra::Squeeze(scaledMesh, axis, factor);
      }
      scaled.Points = scaledMesh.Points;
      EXPECT_TRUE(SameBytes(Sum(scaled, scaledMesh), w)) << factor;
    }
  }
}

TEST(WindingNumberSum, KeepsItsDigitsAtTheShortSidesOfNeedles)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-1, 1);
  const double small = 0x1p-20;
  for (int i = 0; i < 200; ++i)
  {
    FacetComplex needle;
    needle.Points = { { part(random), part(random), 1 + part(random) },
      { small * part(random), small * part(random), small * part(random) },
      { small * part(random), small * part(random), small * part(random) } };
    needle.Facets = { { { i % 3, (i + 1) % 3, (i + 2) % 3 } } };
    needle.Multiplicity = { 1 };
    needle.NumberOfConstraints = 1;
    const std::vector<Point> near = { { small * part(random), small * part(random),
      small * part(random) } };
    const std::vector<Tetrahedron> cells = { { { 0, 0, 0, 0 } } };
    const Sites sites = { near, cells };
    Monitor monitor;
    EXPECT_NEAR(
      WindingNumberSum(needle, sites, monitor)[0], WindingNumberInQuads(needle, sites[0]), 1e-14)
      << i;
  }
}

TEST(WindingNumberSum, KeepsItsDigitsFarFromTheOrigin)
{
  TetrahedralMesh mesh = MakeMesh(Plain, 5);
  FacetComplex surface = RandomFaces(mesh, 5);
  const std::vector<double> w = Sum(surface, mesh);
  for (Point& p : mesh.Points)
  {
    // Exact, for these are integers; barycenters no longer fit in a double.
    p = { p[0] + 0x1p51, p[1] - 0x1p51, p[2] + 0x1p51 };
  }
  surface.Points = mesh.Points;
  const std::vector<double> far = Sum(surface, mesh);
  for (std::size_t cell = 0; cell < w.size(); ++cell)
  {
    EXPECT_NEAR(far[cell], w[cell], 1e-14);
  }
}

TEST(WindingNumberSum, GivesTheSameBytesForAnyNumberOfThreads)
{
  TetrahedralMesh mesh = MakeMesh(Flattened, 7, 4);
  const FacetComplex surface = RandomFaces(mesh, 7);
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const std::vector<double> w = Sum(surface, mesh);
  for (int n : { 2, 3, 8 })
  {
    omp_set_num_threads(n);
    EXPECT_TRUE(SameBytes(Sum(surface, mesh), w)) << n << " threads";
  }
  omp_set_num_threads(threads);
}

TEST(WindingNumberSum, NegatesWhenAllFacetsAreTurnedOver)
{
  for (unsigned seed = 0; seed < NumberOfShapes; ++seed)
  {
    TetrahedralMesh mesh = MakeMesh(seed % NumberOfShapes, seed);
    FacetComplex surface = RandomFaces(mesh, seed);
    std::vector<double> w = Sum(surface, mesh);
    for (Triangle& facet : surface.Facets)
    {
      std::swap(facet[1], facet[2]);
    }
    for (double& value : w)
    {
      value = -value;
    }
    EXPECT_EQ(Sum(surface, mesh), w);
  }
}

TEST(WindingNumberSum, CountsEveryTurnOfLargeMultiplicities)
{
  // A twelfth of the sum per facet: products fall on and next to both half-axes all the time.
  FacetComplex box = testmeshes::ToComplex(testmeshes::Box({ -1, -1, -1 }, { 1, 1, 1 }));
  for (int multiplicity : { 1, 2, 3, 7, 1000, 32767, -1, -2, -5, -32767 })
  {
    box.Multiplicity.assign(12, static_cast<std::int16_t>(multiplicity));
    EXPECT_NEAR(Sum(box, CellAround({ 0, 0, 0 }, 0.25))[0], multiplicity, 1e-10);
    EXPECT_NEAR(Sum(box, CellAround({ 0.5, 0.25, -0.125 }, 0.125))[0], multiplicity, 1e-10);
    EXPECT_NEAR(Sum(box, CellAround({ 2, 0, 0 }, 0.25))[0], 0, 1e-10);
  }
}

TEST(WindingNumberSum, KeepsProductsOfManySmallFactorsInRange)
{
  // From a hundredth of its length beside an edge, |z| is a few hundredths.
  FacetComplex surface;
  surface.Points = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  surface.Facets = { { { 0, 1, 2 } } };
  surface.Multiplicity = { 1 };
  for (Point centre :
    { Point{ 0, -0.02, 0.01 }, Point{ 0, 0.03, -0.01 }, Point{ 0.1, 0.01, 0.02 } })
  {
    const TetrahedralMesh mesh = CellAround(centre, 0x1p-10);
    surface.Multiplicity[0] = 1;
    const double once = WindingNumberInQuads(surface, SiteOf(mesh, 0));
    surface.Multiplicity[0] = 30000;
    EXPECT_NEAR(Sum(surface, mesh)[0], 30000 * once, 1e-10);
  }
}

TEST(WindingNumberSum, CountsAHalfOnAFacetAndNothingBesideIt)
{
  FacetComplex box = testmeshes::ToComplex(testmeshes::Box({ -1, -1, -1 }, { 1, 1, 1 }));
  EXPECT_EQ(Sum(box, CellAround({ 0.25, 0.5, 1 }, 0.25))[0], 0.5);
  EXPECT_NEAR(Sum(box, CellAround({ 0.25, 0.5, std::nextafter(1, 0) }, 0x1p-30))[0], 1, 1e-14);
  EXPECT_NEAR(Sum(box, CellAround({ 3, 0.5, 1 }, 0.25))[0], 0, 1e-15);
  box.Facets.resize(2); // its bottom
  box.Multiplicity.resize(2);
  EXPECT_EQ(Sum(box, CellAround({ 0.25, 0.5, -1 }, 0.25))[0], 0);
  EXPECT_NEAR(Sum(box, CellAround({ 8, 0.5, -1 }, 0.25))[0], 0, 1e-17);
}

TEST(WindingNumberSum, TakesAnythingEmpty)
{
  Monitor monitor;
  FacetComplex box = testmeshes::ToComplex(testmeshes::Box({ -1, -1, -1 }, { 1, 1, 1 }));
  const std::vector<Point> noPoints;
  const std::vector<Tetrahedron> noCells;
  EXPECT_TRUE(WindingNumberSum(box, { noPoints, noCells }, monitor).empty());
  EXPECT_EQ(Sum(FacetComplex(), CellAround({ 1, 2, 3 }, 1)), std::vector<double>{ 0 });
}

/** Stops after a number of reports; records what it saw. */
class CountingMonitor : public Monitor
{
public:
  bool Continue(const char* stage, double fraction) override
  {
    EXPECT_STREQ(stage, "winding numbers");
    EXPECT_EQ(omp_in_parallel(), 0);
    EXPECT_GE(fraction, this->Last);
    EXPECT_LE(fraction, 1);
    this->Last = fraction;
    return ++this->Calls <= this->Allowed;
  }

  int Allowed = 1 << 30;
  int Calls = 0;
  double Last = 0;
};

TEST(WindingNumberOfCells, StopsAtEveryCheckAndThenRunsAgain)
{
  for (bool open : { false, true })
  {
    TetrahedralMesh mesh = MakeMesh(Plain, 3, 7);
    FacetComplex surface = open ? RandomFaces(mesh, 3)
                                : BoundaryOfLabels(mesh, std::vector<int>(mesh.Cells.size(), 1), 3);
    CountingMonitor all;
    const std::vector<double> w = WindingNumberOfCells(surface, mesh, all);
    EXPECT_EQ(all.Last, 1);
    EXPECT_GE(all.Calls, 3);
    for (int allowed = 0; allowed < all.Calls; ++allowed)
    {
      CountingMonitor monitor;
      monitor.Allowed = allowed;
      try
      {
        WindingNumberOfCells(surface, mesh, monitor);
        ADD_FAILURE() << "did not stop at check " << allowed;
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::Stopped);
      }
    }
    EXPECT_TRUE(SameBytes(Stage(surface, mesh), w));
  }
}

/** Six times the volume of a cell with integer coordinates. */
std::int64_t SixfoldVolume(const TetrahedralMesh& mesh, const Tetrahedron& cell)
{
  std::array<std::array<std::int64_t, 3>, 3> v;
  for (int k = 0; k < 3; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      v[k][axis] =
        static_cast<std::int64_t>(mesh.Points[cell[k + 1]][axis] - mesh.Points[cell[0]][axis]);
    }
  }
  return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
    v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
    v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

TEST(SignedContent, IsExactOnIntegersAndNegativeInsideOut)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    TetrahedralMesh mesh = Grid(seed, 3);
    const std::vector<Tetrahedron> once = mesh.Cells;
    mesh.Cells.insert(mesh.Cells.end(), once.begin(), once.end());
    std::vector<double> w;
    std::int64_t expected = 0;
    for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
    {
      // The second half cancels the huge part of the first, which hides the rest from a plain sum.
      const int small = static_cast<int>(cell % 5) - 1;
      w.push_back((cell < once.size() ? 0x1p30 : -0x1p30) + small);
      expected += small * SixfoldVolume(mesh, mesh.Cells[cell]);
    }
    EXPECT_GT(expected, 0);
    EXPECT_EQ(SignedContent(mesh, w), static_cast<double>(expected) / 6);
    for (double& value : w)
    {
      value = -value;
    }
    EXPECT_EQ(SignedContent(mesh, w), -static_cast<double>(expected) / 6);
  }
}
} // namespace
