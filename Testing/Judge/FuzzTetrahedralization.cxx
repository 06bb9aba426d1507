// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactTetrahedralization.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/Corpus.h"
#include "Support/MeshLaws.h"
#include "Support/SurfaceFamilies.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"
#include "Tetrahedralize/AssembleMesh.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

using namespace insideout;

namespace
{
/** What came of all surfaces so far. */
struct Tally
{
  int Surfaces = 0;
  int Incomplete = 0; ///< surfaces with lost facets
  int Broken = 0;     ///< laws broken, errors, or too much work
  long Facets = 0;
  long Lost = 0;
  long Points = 0;
  long SteinerPoints = 0;
};

/** Stops a surface that takes more work than any should: ten times what the hardest has taken. */
class WorkLimit : public Monitor
{
public:
  bool Continue(const char*, double) override { return ++this->Reports <= MostReports; }

private:
  static constexpr long MostReports = 1000000;
  long Reports = 0;
};

void TetrahedralizeOne(const std::string& name, const TriangleSoup& soup, Tally& tally)
{
  try
  {
    Monitor patient;
    const FacetComplex surface =
      ResolveSelfIntersections(CountFacets(soup, {}, patient).Surface, patient).Surface;
    const std::vector<Triangle> facets(
      surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
    WorkLimit limit;
    const ExactTetrahedralization exact = TetrahedralizeExactly(surface.Points, facets, limit);
    const TetrahedralMesh mesh = AssembleMesh(surface, exact.Tetrahedra, patient);
    testing::TestPartResultArray violations;
    {
      const testing::ScopedFakeTestPartResultReporter reporter(&violations);
      testmeshes::ExpectMeshLaws(surface, mesh);
    }
    ++tally.Surfaces;
    tally.Facets += static_cast<long>(facets.size());
    tally.Lost += static_cast<long>(mesh.LostFacets.size());
    tally.Points += static_cast<long>(surface.Points.size());
    tally.SteinerPoints += mesh.NumberOfSteinerPoints;
    if (!mesh.LostFacets.empty())
    {
      ++tally.Incomplete;
      std::printf(
        "%s: %zu of %zu facets lost\n", name.c_str(), mesh.LostFacets.size(), facets.size());
    }
    if (violations.size() > 0)
    {
      ++tally.Broken;
      std::printf("%s: %d laws broken: %.300s\n", name.c_str(), violations.size(),
        violations.GetTestPartResult(0).summary());
    }
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::Planar && error.Code != ErrorCode::EmptySurface)
    {
      ++tally.Surfaces;
      ++tally.Broken;
      std::printf("%s: %s\n", name.c_str(), error.what());
    }
  }
  std::fflush(stdout);
}
} // namespace

/**
 * FuzzTetrahedralization SURFACES [SEED]: resolves SURFACES surfaces from families of hard
 * surfaces, random soups and changed surfaces of the corpus. It tetrahedralizes them and checks the
 * laws of meshes. It prints losses and errors, and a sum at the end. The exit status is 1 if a law
 * is broken or on any error.
 */
int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  long left = argc > 1 ? std::atol(argv[1]) : 500;
  unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 0;
  Tally tally;
  const auto run = [&](const std::vector<testmeshes::SurfaceFamily>& families, const char* suffix)
  {
    for (const testmeshes::SurfaceFamily& family : families)
    {
      for (std::size_t i = 0; i < family.Members.size() && left > 0; ++i, --left)
      {
        TetrahedralizeOne(family.Name + "-" + suffix, family.Members[i], tally);
      }
    }
  };
  run(testmeshes::SurfaceFamilies(3), "fixed");
  for (; left > 0; ++seed)
  {
    run(testmeshes::TetrahedralizationFamilies(seed), std::to_string(seed).c_str());
    run({ testmeshes::ChangedCorpus(seed) }, std::to_string(seed).c_str());
  }
  std::printf("%d surfaces, %ld facets, %ld lost on %d surfaces, %ld Steiner points on %ld points, "
              "%d went wrong\n",
    tally.Surfaces, tally.Facets, tally.Lost, tally.Incomplete, tally.SteinerPoints, tally.Points,
    tally.Broken);
  return tally.Broken > 0 ? 1 : 0;
}
