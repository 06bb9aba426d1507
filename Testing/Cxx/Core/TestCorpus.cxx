// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/SurfaceDefects.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/Corpus.h"
#include "Support/ExactReference.h"
#include "Support/MeshLaws.h"
#include "Support/ResolutionLaws.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace insideout;
using namespace testmeshes;

namespace
{
class CorpusSurfaces : public testing::TestWithParam<CorpusEntry>
{
};
} // namespace

TEST_P(CorpusSurfaces, KeepTheirLawsAndCounts)
{
  const CorpusEntry& expected = GetParam();
  const TriangleSoup soup = CorpusSurface(expected.Name);
  Monitor monitor;
  const SurfaceDefects defects = FindSurfaceDefects(soup, 0, Orientation::Automatic, monitor);
  EXPECT_EQ(defects.Counts.OpenEdges, expected.OpenEdges);

  const FacetComplex counted = CountFacets(soup, {}, monitor).Surface;
  const Resolution resolution = ResolveSelfIntersections(counted, monitor);
  const FacetComplex& resolved = resolution.Surface;
  EXPECT_EQ(resolution.IntersectingPairs, IntersectionsByClipping(counted.Points, counted.Facets));
  EXPECT_EQ(static_cast<Id>(resolution.IntersectingPairs.size()), expected.IntersectingPairs);
  EXPECT_EQ(resolved.NumberOfFacets() - resolved.NumberOfConstraints, expected.LeftOutFacets);
  for (const std::string& violation : JudgeResolution(counted, resolved, 20).Violations)
  {
    ADD_FAILURE() << violation;
  }

  ConstrainedDelaunayParameters parameters;
  parameters.Engine = TetrahedralizationEngine::Exact;
  const Tetrahedralization result = ConstrainedDelaunay(resolved, parameters, monitor);
  ExpectMeshLaws(resolved, result.Mesh);
  EXPECT_EQ(static_cast<Id>(result.Mesh.LostFacets.size()), expected.LostFacets);
}

INSTANTIATE_TEST_SUITE_P(All, CorpusSurfaces, testing::ValuesIn(Corpus()),
  [](const testing::TestParamInfo<CorpusEntry>& info)
  {
    std::string name = info.param.Name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });

TEST(Corpus, ListsEveryFileOnce)
{
  std::vector<std::string> listed;
  for (const CorpusEntry& entry : Corpus())
  {
    listed.push_back(entry.Name);
  }
  EXPECT_FALSE(listed.empty());
  EXPECT_EQ(listed, CorpusFiles()) << "the table is in the order of the alphabet";
}
