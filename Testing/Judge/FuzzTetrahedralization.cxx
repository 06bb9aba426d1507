// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Statistics.h"
#include "Exact/ExactTetrahedralization.h"
#include "Resolve/ResolveSelfIntersections.h"
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
#include <ctime>

using namespace insideout;

namespace
{
/** What came of all surfaces so far. */
struct Tally
{
  int Surfaces = 0;
  int Incomplete = 0; ///< surfaces with lost facets
  int Broken = 0;     ///< laws broken, errors, or not done in time
  long Facets = 0;
  long Lost = 0;
  long Points = 0;
  long SteinerPoints = 0;
};

double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** Stops a surface that takes longer than any should, however busy the machine is. */
class Deadline : public Monitor
{
public:
  bool Continue(const char*, double) override { return ProcessorSeconds() - this->Start < 60; }

private:
  const double Start = ProcessorSeconds();
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
    Deadline deadline;
    const ExactTetrahedralization exact = TetrahedralizeExactly(surface.Points, facets, deadline);
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
 * FuzzTetrahedralization SECONDS [SEED]: resolves random soups and the families of hard surfaces,
 * tetrahedralizes them and proves the laws of meshes, until the time is over. Prints what is lost
 * or goes wrong, and a sum at the end. Exit status 1 where a law is broken or anything goes wrong.
 */
int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60;
  unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 0;
  Stopwatch watch;
  double elapsed = 0;
  Tally tally;
  const auto isTime = [&]() { return (elapsed += watch.Lap()) < seconds; };
  for (const testmeshes::SurfaceFamily& family : testmeshes::SurfaceFamilies(3))
  {
    for (std::size_t i = 0; i < family.Members.size() && isTime(); ++i)
    {
      TetrahedralizeOne(family.Name + "-" + std::to_string(i), family.Members[i], tally);
    }
  }
  for (; isTime(); ++seed)
  {
    const std::string name = std::to_string(seed);
    for (const testmeshes::SurfaceFamily& family : testmeshes::TetrahedralizationFamilies(seed))
    {
      for (std::size_t i = 0; i < family.Members.size() && isTime(); ++i)
      {
        TetrahedralizeOne(family.Name + "-" + name, family.Members[i], tally);
      }
    }
  }
  std::printf("%d surfaces, %ld facets, %ld lost on %d surfaces, %ld Steiner points on %ld points, "
              "%d went wrong\n",
    tally.Surfaces, tally.Facets, tally.Lost, tally.Incomplete, tally.SteinerPoints, tally.Points,
    tally.Broken);
  return tally.Broken > 0 ? 1 : 0;
}
