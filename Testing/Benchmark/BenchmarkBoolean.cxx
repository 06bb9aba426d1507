// SPDX-License-Identifier: GPL-3.0-or-later
#include "BooleanByUs.h"
#include "BumpySphere.h"
#include "Measure.h"
#include "UnionByCgal.h"

#include <cstdlib>

#include <omp.h>

using namespace insideout;
using namespace benchmark;

namespace
{
constexpr Limit Target = AtMost(1.0);         ///< our union over CGAL's, of the same clean pair
constexpr Limit ThreadsTarget = AtLeast(1.6); ///< one thread's time over that of two
constexpr int Runs = 5;

/** Two spheres that cross, with this number of triangles together. */
struct Pair
{
  explicit Pair(int triangles)
    : A(BumpySphere(triangles / 2, 0, 0))
    , B(BumpySphere(triangles / 2, 0.7, 0.6))
    , Size(A.Triangles.size() + B.Triangles.size())
  {
  }

  TriangleSoup A;
  TriangleSoup B;
  std::size_t Size;
};

/** The union of a pair, by ours and by CGAL. */
void Measure(int triangles)
{
  const auto [a, b, size] = Pair(triangles);
  const std::string name = "boolean/" + std::to_string(triangles);
  const auto byCgal = UnionByCgal(a, b);
  const Made ours = BooleanByUs(a, b, SetOperation::Union);
  const Made theirs = byCgal();
  std::printf("%s: %zu facets of ours, %zu of CGAL's\n", name.c_str(), ours.Facets, theirs.Facets);
  std::array<std::vector<double>, 2> seconds;
  for (int run = 0; run < Runs; ++run)
  {
    seconds[0].push_back(BooleanByUs(a, b, SetOperation::Union).Seconds);
    seconds[1].push_back(byCgal().Seconds);
  }
  const std::array<double, 2> medians = { Median(seconds[0]), Median(seconds[1]) };
  PrintSeconds(name, size, "union", "corefine_and_compute_union", medians);
  PrintRatio(name, medians[0] / medians[1], Target);
}

/** The union of a pair, on one thread and on two. */
void MeasureThreads(int triangles)
{
  const auto [a, b, size] = Pair(triangles);
  std::array<std::vector<double>, 2> seconds;
  for (int run = 0; run < 2 * Runs; ++run)
  {
    omp_set_num_threads(1 + run % 2);
    seconds[run % 2].push_back(BooleanByUs(a, b, SetOperation::Union).Seconds);
  }
  const std::array<double, 2> medians = { Median(seconds[0]), Median(seconds[1]) };
  PrintSeconds("threads/boolean", size, "one thread", "two threads", medians);
  PrintRatio("threads/boolean", medians[0] / medians[1], ThreadsTarget);
}
} // namespace

/** BenchmarkBoolean [TRIANGLES...]: the union of two clean surfaces, with TRIANGLES triangles
 * together, against CGAL's; without any also of a million on one thread and on two. Lines as in
 * Measure.h. */
int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    Measure(std::atoi(argv[i]));
  }
  if (argc == 1)
  {
    Measure(64618);
    Measure(1000000);
    MeasureThreads(1000000);
  }
  return 0;
}
