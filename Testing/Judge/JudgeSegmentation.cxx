// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChangedSurfaces.h"
#include "GraphCut/GraphCutSegmentation.h"
#include "GraphCut/InteriorFaces.h"
#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Support/CutReference.h"
#include "Support/ReadTriangles.h"
#include "WindingNumber/SurfaceWindingNumber.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>

using namespace insideout;

namespace
{
/** Pieces without an inside cell on either side. */
int CountUnsatisfied(
  const std::vector<FacetPiece>& pieces, const std::vector<unsigned char>& inside)
{
  int count = 0;
  for (const FacetPiece& piece : pieces)
  {
    count += !inside[piece.First] && (piece.Second == None || !inside[piece.Second]);
  }
  return count;
}

/** One line per combination of constraints. @return whether all holds */
bool JudgeConstraints(const std::string& path)
{
  Monitor monitor;
  const HullMesh hull = MeshHull(testmeshes::ReadTriangles(path), {}, monitor);
  const std::vector<FacetPiece> pieces = PiecesOfFacets(hull.Mesh);
  const CellGraph graph = { hull.W, InteriorFaces(hull.Mesh), {}, {} };
  const double least = testcut::LeastEnergy(graph, {});
  bool holds = true;
  for (int options = 0; options < 4; ++options)
  {
    SegmentMeshParameters parameters;
    parameters.ConstrainFacets = (options & 1) != 0;
    parameters.FillNonManifold = (options & 2) != 0;
    const MeshSegmentation result = SegmentMesh(hull.Mesh, hull.W, pieces, {}, parameters, monitor);
    const double energy = testcut::EnergyOf(graph, {}, result.Inside);
    const int unsatisfied = CountUnsatisfied(pieces, result.Inside);
    const testcut::NotManifold bad = testcut::CountNotManifold(hull.Mesh.Cells, result.Inside);
    const bool good = (options != 0 || std::abs(energy - least) <= 1e-9 * (1 + least)) &&
      (!parameters.ConstrainFacets || unsatisfied == 0) &&
      (!parameters.FillNonManifold || bad.Edges + bad.Points == 0);
    holds = holds && good;
    std::printf(
      "%-44s %9zu %s %s energy %14.6g least %14.6g unsatisfied %6d not manifold %6d %6d %s\n",
      path.substr(path.find_last_of('/') + 1).c_str(), hull.W.size(),
      parameters.ConstrainFacets ? "facets" : "      ",
      parameters.FillNonManifold ? "manifold" : "        ", energy, least, unsatisfied, bad.Edges,
      bad.Points, good ? "holds" : "FAILS");
    std::fflush(stdout);
  }
  return holds;
}

/** The surface less every triangle for which this is true, or with it turned over. */
template <typename Choose>
TriangleSoup Changed(const TriangleSoup& soup, bool turn, Choose choose)
{
  TriangleSoup changed = { soup.Points, {} };
  for (Triangle t : soup.Triangles)
  {
    const bool chosen = choose();
    if (chosen && turn)
    {
      std::swap(t[1], t[2]);
    }
    if (!chosen || turn)
    {
      changed.Triangles.push_back(t);
    }
  }
  return changed;
}

std::vector<std::pair<const char*, TriangleSoup>> Damaged(const TriangleSoup& soup)
{
  const std::size_t size = soup.Triangles.size();
  std::mt19937 random(1);
  return { { "small holes",
             benchmark::WithHoles(soup, std::max<int>(3, static_cast<int>(size / 800)), 30) },
    { "large holes",
      benchmark::WithHoles(
        soup, 4, std::max<std::size_t>(20, static_cast<std::size_t>(std::sqrt(size)))) },
    { "facets away", Changed(soup, false, [&] { return random() % 100 < 20; }) },
    { "turned over", Changed(soup, true, [&] { return random() % 100 < 8; }) } };
}

/** The volume that is labelled otherwise than the whole surface has it, in percent of the solid's.
 */
double PercentWrong(const HullMesh& hull, const std::vector<double>& volumes,
  const std::vector<double>& truth, const GraphCutParameters& parameters)
{
  Monitor monitor;
  const std::vector<unsigned char> inside =
    GraphCutSegmentation({ hull.W, InteriorFaces(hull.Mesh), volumes, {} }, parameters, monitor)
      .Inside;
  double wrong = 0;
  double solid = 0;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const bool isInside = truth[i] > 0.5;
    solid += isInside ? volumes[i] : 0;
    wrong += isInside != (inside[i] != 0) ? volumes[i] : 0;
  }
  return 100 * wrong / solid;
}

std::vector<double> TruthAt(const SurfaceWindingNumber& whole, const TetrahedralMesh& mesh)
{
  std::vector<Point> centres;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    Point centre = { 0, 0, 0 };
    for (const Id p : cell)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] += mesh.Points[p][axis] / 4;
      }
    }
    centres.push_back(centre);
  }
  Monitor monitor;
  return whole.At(centres, monitor);
}

/** One line per damage and choice of parameters. */
void JudgeParameters(const std::string& path)
{
  Monitor monitor;
  const TriangleSoup soup = testmeshes::ReadTriangles(path);
  const FacetComplex surface = CountFacets(soup, {}, monitor).Surface;
  if (!IsClosed(surface))
  {
    std::printf("%s is open: nobody knows what is inside\n", path.c_str());
    return;
  }
  const SurfaceWindingNumber whole(surface, {}, monitor);
  HullMeshParameters asGiven;
  asGiven.Orientation = Orientation::AsGiven;
  for (const auto& [damage, damaged] : Damaged({ surface.Points, surface.Facets }))
  {
    const HullMesh hull = MeshHull(damaged, asGiven, monitor);
    const std::vector<double> volumes = CellVolumes(hull.Mesh);
    const std::vector<double> truth = TruthAt(whole, hull.Mesh);
    const std::pair<double, double> choices[] = { { 0, 0.1 }, { 1, 0.1 }, { 2, 0.15 }, { 5, 0.2 },
      { 10, 0.3 } };
    for (const auto& [gamma, sigma] : choices)
    {
      std::printf("%-30s %-12s gamma %4g sigma %4g   uniform %8.4f %%   weighted %8.4f %%\n",
        path.substr(path.find_last_of('/') + 1).c_str(), damage, gamma, sigma,
        PercentWrong(hull, volumes, truth, { gamma, sigma, DataTerm::Uniform }),
        PercentWrong(hull, volumes, truth, { gamma, sigma, DataTerm::VolumeWeighted }));
      std::fflush(stdout);
    }
  }
}
} // namespace

/**
 * JudgeSegmentation SURFACE...: whether the cut is as good as Boost's maximum flow and each
 * constraint keeps what it promises. JudgeSegmentation --parameters SURFACE...: what the parameters
 * make of closed surfaces that are damaged. Exit status 1 when something does not hold.
 */
int main(int argc, char** argv)
{
  const bool parameters = argc > 1 && std::strcmp(argv[1], "--parameters") == 0;
  bool holds = true;
  for (int i = parameters ? 2 : 1; i < argc; ++i)
  {
    try
    {
      if (parameters)
      {
        JudgeParameters(argv[i]);
      }
      else
      {
        holds = JudgeConstraints(argv[i]) && holds;
      }
    }
    catch (const Error& error)
    {
      std::printf("%s: %s\n", argv[i], error.what());
    }
  }
  return holds ? 0 : 1;
}
