// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <map>
#include <string>

using namespace insideout;
using namespace testmeshes;

namespace
{
/** Counts how often each stage asks whether to stop. */
class Census : public Monitor
{
public:
  bool Continue(const char* stage, double) override
  {
    ++this->Reports[stage];
    return true;
  }

  std::map<std::string, int> Reports;
};
} // namespace

/** Work between two reports must not grow with the surface, or Ctrl-C would be heard late. */
TEST(Reports, GrowWithTheSurface)
{
  const auto count = [](int rings)
  {
    TriangleSoup soup = RingedSphere(1, rings);
    TriangleSoup other = RingedSphere(2, rings);
    for (Point& p : other.Points)
    {
      p = { p[0] + 0.5, p[1] + 0.25, p[2] + 0.125 };
    }
    Census census;
    HullMeshParameters parameters;
    parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
    const HullMesh hull = MeshHull(Join(soup, other), parameters, census);
    SegmentMesh(hull.Mesh, hull.W, {}, {}, {}, census);
    return census.Reports;
  };
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1); // others work without asking
  const std::map<std::string, int> few = count(20);
  const std::map<std::string, int> many = count(80);
  omp_set_num_threads(threads);
  for (const char* stage :
    { "finding self-intersections", "resolving self-intersections", "tetrahedralizing" })
  {
    EXPECT_GE(many.at(stage), 2 * few.at(stage)) << stage;
  }
}
