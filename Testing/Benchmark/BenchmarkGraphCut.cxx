// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Measure.h"
#include "Support/ReadTriangles.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"

using namespace insideout;
using namespace benchmark;

namespace
{
constexpr Limit Target = { Limit::Side::AtMost, 0.2 }; // of the CDT stage's seconds

MeshSegmentation Segment(
  const HullMesh& hull, const std::vector<FacetPiece>& pieces, bool facets, bool manifold)
{
  Monitor monitor;
  SegmentMeshParameters parameters;
  parameters.ConstrainFacets = facets;
  parameters.FillNonManifold = manifold;
  return SegmentMesh(hull.Mesh, hull.W, pieces, {}, parameters, monitor);
}

double StatisticOf(const MeshSegmentation& result, const std::string& name)
{
  for (const auto& [key, value] : result.Statistics)
  {
    if (key == name)
    {
      return value;
    }
  }
  return 0;
}

/** What the constraints change, and what they cost. */
void PrintConstraints(
  const std::string& name, const HullMesh& hull, const std::vector<FacetPiece>& pieces)
{
  const std::pair<bool, bool> choices[] = { { true, false }, { false, true }, { true, true } };
  for (const auto& [facets, manifold] : choices)
  {
    Stopwatch watch;
    const MeshSegmentation result = Segment(hull, pieces, facets, manifold);
    std::printf("%-28s %9.0f cells flipped for%s%s   %8.4f s   energy %.6g\n", name.c_str(),
      StatisticOf(result, "ChangedCells"), facets ? " facets" : "", manifold ? " manifold" : "",
      watch.Lap(), StatisticOf(result, "Energy"));
  }
}

void Measure(const std::string& path)
{
  const std::string name = "cut/" + StemOf(path);
  Monitor monitor;
  const HullMesh hull = MeshHull(testmeshes::ReadTriangles(path), {}, monitor);
  const std::vector<FacetPiece> pieces = PiecesOfFacets(hull.Mesh);
  const double before = ResetHighWaterMark();
  const MeshSegmentation result = Segment(hull, pieces, false, false);
  const double memory = HighWaterMark() - before;
  const auto seconds = MedianSeconds([&] { Segment(hull, pieces, false, false); },
    [&] { ConstrainedDelaunay(hull.Surface, {}, monitor); });
  PrintSeconds(name, hull.Surface.Facets.size(), "cut", "CDT", seconds);
  std::printf("%-28s %9zu cells    %.1f MiB   energy %.6g\n", name.c_str(), hull.W.size(), memory,
    StatisticOf(result, "Energy"));
  PrintConstraints(name, hull, pieces);
  PrintRatio(name, seconds[0] / seconds[1], Target);
}
} // namespace

/**
 * BenchmarkGraphCut SURFACE...: times the cut against stage CDT, by turns, and says what its
 * constraints change. Lines as in Measure.h; a surface that cannot be meshed is named and passed
 * over.
 */
int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    try
    {
      Measure(argv[i]);
    }
    catch (const Error& error)
    {
      std::printf("%s: %s\n", argv[i], error.what());
    }
  }
  return 0;
}
