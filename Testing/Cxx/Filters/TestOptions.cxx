// SPDX-License-Identifier: GPL-3.0-or-later
// What the classes' options are when nobody sets them, and how far they can be set, against the
// parameters of the stages. The structured bindings do not compile once a parameter is added.
#include "vtkConstrainedDelaunay3D.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkProbeWindingNumber.h"
#include "vtkRefineTetrahedra.h"
#include "vtkResolveSelfIntersections.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkRobustTriangulate.h"
#include "vtkSurfaceDefects.h"

#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Listener.h"
#include "Refine/SizingField.h"
#include "WindingNumber/SurfaceWindingNumber.h"
#include "WindingNumber/TetrahedronQuadrature.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <limits>

using namespace insideout;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** Whether a stage finds nothing wrong with its parameters. */
template <typename Stage>
bool IsTaken(const Stage& stage)
{
  try
  {
    stage();
  }
  catch (const Error& error)
  {
    return error.Code != ErrorCode::InvalidParameter;
  }
  return true;
}

/** The value that an option has after an attempt to set it. */
#define SET(filter, Option, value) ((filter)->Set##Option(value), (filter)->Get##Option())

TriangleSoup OneTriangle()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
}

/** The surface of a tetrahedron. */
FacetComplex OneTetrahedron()
{
  Monitor silent;
  const TriangleSoup soup = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } } };
  return CountFacets(soup, {}, silent).Surface;
}

bool TakesMergeTolerance(double value)
{
  return IsTaken(
    [&]()
    {
      Monitor silent;
      CountedChainParameters parameters;
      parameters.MergeTolerance = value;
      CountFacets(OneTriangle(), parameters, silent);
    });
}

bool TakesCut(const GraphCutParameters& parameters)
{
  return IsTaken(
    [&]()
    {
      const CellGraph graph = { { 0.2, 0.7 }, { { 0, 1, 1.0 } } };
      const CutEnergy energy{ RealEnergy(graph, parameters) };
    });
}

bool TakesDelaunay(const ConstrainedDelaunayParameters& parameters)
{
  return IsTaken(
    [&]()
    {
      Monitor silent;
      ConstrainedDelaunay(OneTetrahedron(), parameters, silent);
    });
}

bool TakesWindingNumber(const WindingNumberParameters& parameters)
{
  return IsTaken(
    [&]()
    {
      Monitor silent;
      SurfaceWindingNumber(OneTetrahedron(), parameters, silent).At({ Point{ 3, 0, 0 } }, silent);
    });
}

template <typename Class>
class OptionsOfSurfaces : public testing::Test
{
};
using ClassesWithSurfaces =
  testing::Types<vtkConstrainedDelaunay3D, vtkGeneralizedWindingNumber, vtkImplicitWindingNumber,
    vtkProbeWindingNumber, vtkResolveSelfIntersections, vtkRobustTriangulate>;
TYPED_TEST_SUITE(OptionsOfSurfaces, ClassesWithSurfaces, );

template <typename Class>
class OptionsOfTetrahedra : public testing::Test
{
};
using ClassesWithTetrahedra = testing::Types<vtkConstrainedDelaunay3D, vtkGeneralizedWindingNumber>;
TYPED_TEST_SUITE(OptionsOfTetrahedra, ClassesWithTetrahedra, );

template <typename Class>
class OptionsOfOrientation : public testing::Test
{
};
using ClassesThatOrient = testing::Types<vtkGeneralizedWindingNumber, vtkImplicitWindingNumber,
  vtkProbeWindingNumber, vtkRobustTetrahedralize, vtkRobustTriangulate, vtkSurfaceDefects>;
TYPED_TEST_SUITE(OptionsOfOrientation, ClassesThatOrient, );

template <typename Class>
class OptionsOfFacades : public testing::Test
{
};
using Facades = testing::Types<vtkRobustTetrahedralize, vtkRobustTriangulate>;
TYPED_TEST_SUITE(OptionsOfFacades, Facades, );
} // namespace

TYPED_TEST(OptionsOfSurfaces, AreThoseOfTheStages)
{
  vtkNew<TypeParam> filter;
  const auto [mergeTolerance, countDuplicates] = CountedChainParameters();
  EXPECT_EQ(filter->GetMergeTolerance(), mergeTolerance);
  EXPECT_EQ(filter->GetCountDuplicates(), countDuplicates);
  EXPECT_STREQ(filter->GetNonParticipatingArrayName(), "");

  EXPECT_TRUE(TakesMergeTolerance(SET(filter, MergeTolerance, -1)));
  EXPECT_TRUE(TakesMergeTolerance(SET(filter, MergeTolerance, Infinity)));
  EXPECT_FALSE(TakesMergeTolerance(-1));
  EXPECT_FALSE(TakesMergeTolerance(Infinity));
}

TEST(OptionsOfDefects, AreThoseOfTheStage)
{
  vtkNew<vtkSurfaceDefects> filter;
  EXPECT_EQ(filter->GetMergeTolerance(), CountedChainParameters().MergeTolerance);
  EXPECT_TRUE(TakesMergeTolerance(SET(filter, MergeTolerance, -1)));
  EXPECT_TRUE(TakesMergeTolerance(SET(filter, MergeTolerance, Infinity)));
}

TYPED_TEST(OptionsOfOrientation, AreThoseOfTheStage)
{
  vtkNew<TypeParam> filter;
  const HullMeshParameters parameters;
  EXPECT_EQ(filter->GetOrientation(), static_cast<int>(parameters.Orientation));
  EXPECT_EQ(SET(filter, Orientation, -1), static_cast<int>(Orientation::Automatic));
  EXPECT_EQ(SET(filter, Orientation, 99), static_cast<int>(Orientation::Outward));
}

TYPED_TEST(OptionsOfTetrahedra, AreThoseOfTheStages)
{
  vtkNew<TypeParam> filter;
  const auto [timeBudget, memoryBudget, engine] = ConstrainedDelaunayParameters();
  EXPECT_EQ(filter->GetTimeBudget(), timeBudget);
  EXPECT_EQ(filter->GetMemoryBudget(), memoryBudget);
  EXPECT_EQ(filter->GetEngine(), static_cast<int>(engine));

  for (const double value : { -1.0, Infinity })
  {
    ConstrainedDelaunayParameters parameters;
    parameters.Engine = TetrahedralizationEngine::Exact;
    parameters.TimeBudget = SET(filter, TimeBudget, value);
    parameters.MemoryBudget = SET(filter, MemoryBudget, value);
    EXPECT_TRUE(TakesDelaunay(parameters));
  }
  ConstrainedDelaunayParameters negative;
  negative.TimeBudget = -1;
  EXPECT_FALSE(TakesDelaunay(negative));
  negative = {};
  negative.MemoryBudget = -1;
  EXPECT_FALSE(TakesDelaunay(negative));
  EXPECT_EQ(SET(filter, Engine, -1), static_cast<int>(TetrahedralizationEngine::Automatic));
  EXPECT_EQ(SET(filter, Engine, 99), static_cast<int>(TetrahedralizationEngine::TetGen));
}

TEST(OptionsOfHulls, AreThoseOfTheStages)
{
  vtkNew<vtkGeneralizedWindingNumber> filter;
  const auto [chain, orientation, thicken, budgets, quadratureOrder, partsApart, touchTolerance] =
    HullMeshParameters();
  EXPECT_EQ(filter->GetMergeTolerance(), chain.MergeTolerance);
  EXPECT_EQ(filter->GetCountDuplicates(), chain.CountDuplicates);
  EXPECT_EQ(filter->GetOrientation(), static_cast<int>(orientation));
  EXPECT_EQ(filter->GetThicken(), thicken.Width);
  EXPECT_EQ(filter->GetThickenAll(), thicken.All);
  EXPECT_EQ(SET(filter, Thicken, -1), 0);
  EXPECT_EQ(filter->GetTimeBudget(), budgets.TimeBudget);
  EXPECT_EQ(filter->GetMemoryBudget(), budgets.MemoryBudget);
  EXPECT_EQ(filter->GetEngine(), static_cast<int>(budgets.Engine));
  EXPECT_EQ(filter->GetQuadratureOrder(), quadratureOrder);
  EXPECT_EQ(vtkNew<vtkRobustTetrahedralize>()->GetPartsApart(), partsApart);
  EXPECT_EQ(vtkNew<vtkRobustTetrahedralize>()->GetTouchTolerance(), touchTolerance);

  const auto takesOrder = [](int order)
  { return IsTaken([&]() { TetrahedronQuadrature(order); }); };
  const int lowest = SET(filter, QuadratureOrder, -99);
  const int highest = SET(filter, QuadratureOrder, 99);
  EXPECT_TRUE(takesOrder(lowest));
  EXPECT_FALSE(takesOrder(lowest - 1));
  EXPECT_TRUE(takesOrder(highest));
  EXPECT_FALSE(takesOrder(highest + 1));
}

TEST(OptionsOfSegmentation, AreThoseOfTheStages)
{
  using Filter = vtkGraphCutSegmentation;
  vtkNew<Filter> filter;
  const auto [cut, constrainFacets, fillNonManifold, topology] = SegmentMeshParameters();
  const auto [gamma, sigma, dataTerm] = cut;
  EXPECT_EQ(filter->GetGamma(), gamma);
  EXPECT_EQ(filter->GetSigma(), sigma);
  EXPECT_EQ(filter->GetDataTerm(), static_cast<int>(dataTerm));
  EXPECT_EQ(filter->GetConstrainFacets(), constrainFacets);
  EXPECT_EQ(filter->GetNonManifold() == Filter::NONMANIFOLD_FILL, fillNonManifold);
  EXPECT_EQ(filter->GetNonManifold(), Filter::NONMANIFOLD_KEEP);
  EXPECT_EQ(SET(filter, NonManifold, -1), Filter::NONMANIFOLD_KEEP);
  EXPECT_EQ(SET(filter, NonManifold, 99), Filter::NONMANIFOLD_SPLIT);
  const auto [regions, goal] = topology;
  const auto [largest, least, seeded, fillCavities] = regions;
  EXPECT_EQ(filter->GetLargestRegions(), largest);
  EXPECT_EQ(filter->GetMinimumRegionVolume(), least);
  EXPECT_EQ(filter->GetSeededRegions(), seeded);
  EXPECT_EQ(filter->GetFillCavities(), fillCavities);
  EXPECT_EQ(filter->GetTopology(), static_cast<int>(goal));
  EXPECT_EQ(SET(filter, LargestRegions, -1), 0);
  EXPECT_EQ(SET(filter, MinimumRegionVolume, -1), 0);
  EXPECT_EQ(SET(filter, Topology, -1), Filter::TOPOLOGY_ANY);
  EXPECT_EQ(SET(filter, Topology, 99), Filter::TOPOLOGY_SIMPLY_CONNECTED);

  for (const double value : { -1.0, Infinity })
  {
    GraphCutParameters parameters;
    parameters.Gamma = SET(filter, Gamma, value);
    parameters.Sigma = SET(filter, Sigma, value);
    EXPECT_TRUE(TakesCut(parameters)) << parameters.Gamma << " " << parameters.Sigma;
    parameters.Gamma = value;
    EXPECT_FALSE(TakesCut(parameters));
    parameters.Gamma = 1;
    parameters.Sigma = value;
    EXPECT_FALSE(TakesCut(parameters));
  }
  EXPECT_EQ(SET(filter, DataTerm, -1), static_cast<int>(DataTerm::Uniform));
  EXPECT_EQ(SET(filter, DataTerm, 99), static_cast<int>(DataTerm::VolumeWeighted));
}

TEST(OptionsOfRefinement, AreThoseOfTheStage)
{
  vtkNew<vtkRefineTetrahedra> filter;
  const auto [edgeLength, grading, maximumVolume, lengths, lengthAt, rules, lengthOfCell,
    lengthOfRegion, keepsShorterEdges] = SizingParameters();
  EXPECT_EQ(filter->GetEdgeLength(), edgeLength);
  EXPECT_EQ(filter->GetGrading(), grading);
  EXPECT_EQ(filter->GetMaximumVolume(), maximumVolume);
  EXPECT_TRUE(lengths.empty() && !lengthAt && rules.empty());
  EXPECT_TRUE(lengthOfCell.empty() && lengthOfRegion.empty() && !keepsShorterEdges);
  EXPECT_STREQ(filter->GetSizeRules(), "");
  EXPECT_FALSE(filter->GetQuadraticCells());
  EXPECT_EQ(SET(filter, EdgeLength, -1), 0);
  EXPECT_EQ(SET(filter, MaximumVolume, -1), 0);
  EXPECT_EQ(SET(filter, Grading, 0), 1e-6);
}

/** An option of a facade is that of its stage: setting either sets both. */
#define EXPECT_FORWARDED(filter, stage, Option, one, other) \
  {                                                         \
    (filter)->Set##Option(one);                             \
    EXPECT_EQ((stage)->Get##Option(), one);                 \
    (stage)->Set##Option(other);                            \
    EXPECT_EQ((filter)->Get##Option(), other);              \
  }

TYPED_TEST(OptionsOfFacades, AreThoseOfTheStagesThatTheyHandOut)
{
  vtkNew<TypeParam> filter;
  vtkGraphCutSegmentation* cut = filter->GetSegmentation();
  EXPECT_FORWARDED(filter, cut, Gamma, 0.25, 0.5);
  EXPECT_FORWARDED(filter, cut, ConstrainFacets, true, false);
  EXPECT_FORWARDED(filter, cut, NonManifold, 1, 2);
  EXPECT_FORWARDED(filter, filter->GetRefinement(), EdgeLength, 0.25, 0.5);
}

TEST(vtkRobustTetrahedralize, HandsOutTheStageOfTheWindingNumber)
{
  vtkNew<vtkRobustTetrahedralize> filter;
  vtkGeneralizedWindingNumber* stage = filter->GetWindingNumber();
  EXPECT_FORWARDED(filter, stage, Orientation, 1, 2);
  EXPECT_FORWARDED(filter, stage, Thicken, 0.25, 0.5);
  EXPECT_FORWARDED(filter, stage, MergeTolerance, 0.25, 0.5);
  filter->SetNonParticipatingArrayName("hat");
  EXPECT_STREQ(stage->GetNonParticipatingArrayName(), "hat");
  EXPECT_STREQ(filter->GetNonParticipatingArrayName(), "hat");
}

TYPED_TEST(OptionsOfFacades, ChangeWithTheirStagesWhichAreNeverNull)
{
  vtkNew<TypeParam> filter;
  vtkMTimeType time = filter->GetMTime();
  const auto isChanged = [&]()
  {
    const vtkMTimeType before = time;
    time = filter->GetMTime();
    return time > before;
  };
  EXPECT_FALSE(isChanged());
  filter->GetSegmentation()->SetSigma(0.5);
  EXPECT_TRUE(isChanged());
  filter->GetRefinement()->SetGrading(0.5);
  EXPECT_TRUE(isChanged());
  vtkNew<vtkGraphCutSegmentation> other;
  other->SetSigma(0.25);
  time = filter->GetMTime();
  filter->SetSegmentation(other);
  EXPECT_TRUE(isChanged());
  EXPECT_EQ(filter->GetSegmentation(), other);
  filter->SetSegmentation(other);
  EXPECT_FALSE(isChanged());
  filter->SetSegmentation(nullptr);
  filter->SetRefinement(nullptr);
  EXPECT_EQ(filter->GetSegmentation(), other);
  EXPECT_NE(filter->GetRefinement(), nullptr);
}

TEST(OptionsOfProbe, AreThoseOfTheStage)
{
  vtkNew<vtkProbeWindingNumber> filter;
  const auto [method, approximationOrder, accuracy] = WindingNumberParameters();
  EXPECT_EQ(filter->GetMethod(), static_cast<int>(method));
  EXPECT_EQ(filter->GetApproximationOrder(), approximationOrder);
  EXPECT_EQ(filter->GetAccuracy(), accuracy);

  WindingNumberParameters parameters;
  parameters.Method = WindingNumberMethod::Approximate;
  for (const int beyond : { -1, +1 })
  {
    parameters.ApproximationOrder = SET(filter, ApproximationOrder, beyond * 99);
    EXPECT_TRUE(TakesWindingNumber(parameters));
    parameters.ApproximationOrder += beyond;
    EXPECT_FALSE(TakesWindingNumber(parameters));
  }
  parameters.ApproximationOrder = approximationOrder;
  for (const double value : { 0.0, Infinity })
  {
    parameters.Accuracy = SET(filter, Accuracy, value);
    EXPECT_TRUE(TakesWindingNumber(parameters));
  }
  parameters.Accuracy = 0.999;
  EXPECT_FALSE(TakesWindingNumber(parameters));
  EXPECT_EQ(SET(filter, Method, -1), static_cast<int>(WindingNumberMethod::Exact));
  EXPECT_EQ(SET(filter, Method, 99), static_cast<int>(WindingNumberMethod::Approximate));
}

TEST(Options, OutOfRangeAreTold)
{
  vtkNew<vtkRefineTetrahedra> filter;
  Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetEdgeLength(0);
  filter->SetFeatureAngle(180);
  filter->SetMaximumVolume(Infinity);
  EXPECT_TRUE(warnings.Texts.empty());
  filter->SetEdgeLength(-3);
  EXPECT_TRUE(warnings.Heard("EdgeLength is -3, but must be at least 0: it is taken as 0"));
  filter->SetFeatureAngle(200);
  EXPECT_TRUE(warnings.Heard("FeatureAngle is 200, but must be from 0 to 180: it is taken as 180"));
  EXPECT_EQ(warnings.Texts.size(), 2u);
}
