// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"

#include "Common/Stages.h"
#include "GraphCut/InteriorFaces.h"

#include <algorithm>

namespace insideout
{
namespace
{
// What share of the progress is over before the cut, the facets and the manifold.
constexpr double BeforeCut = 0.2;
constexpr double BeforeFacets = 0.5;
constexpr double BeforeManifold = 0.75;

/** The seed in a cell beside the piece. */
Id SeedBeside(const FacetPiece& piece, const SeededCells& seeded)
{
  const Id seed = seeded.Seeds[piece.First];
  return seed == None ? seeded.Seeds[piece.Second] : seed;
}

Id CountDifferent(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  Id different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    different += a[i] != b[i];
  }
  return different;
}
} // namespace

MeshSegmentation SegmentMesh(const TetrahedralMesh& mesh, const std::vector<double>& w,
  const std::vector<FacetPiece>& pieces, const std::vector<Seed>& seeds,
  const SegmentMeshParameters& parameters, Monitor& monitor)
{
  monitor.Check(Stages::Segmenting, 0);
  SeededCells seeded = FindSeededCells(mesh.Points, mesh.Cells, seeds);
  CellGraph graph = { w, InteriorFaces(mesh),
    parameters.Cut.DataTerm == DataTerm::VolumeWeighted ? CellVolumes(mesh)
                                                        : std::vector<double>() };
  return SegmentCells(
    std::move(graph), std::move(seeded), pieces, parameters,
    [&](GreedyLabels& labels, Monitor& watch, double begin, double end)
    {
      ManifoldConstraint manifold(mesh.Points.size(), mesh.Cells, mesh.Neighbors);
      return manifold.Satisfy(labels, watch, begin, end);
    },
    monitor);
}

MeshSegmentation SegmentCells(CellGraph graph, SeededCells seeded,
  const std::vector<FacetPiece>& pieces, const SegmentMeshParameters& parameters,
  const MakeManifold& makeManifold, Monitor& monitor)
{
  MeshSegmentation result;
  result.Warnings = std::move(seeded.Warnings);
  graph.Demands = std::move(seeded.Demands);
  const bool hasSeeds = !graph.Demands.empty();
  const CutEnergy energy(graph, parameters.Cut);
  monitor.Check(Stages::Segmenting, BeforeCut);
  const std::vector<unsigned char> cut = MinimumCut(energy);
  monitor.Check(Stages::Segmenting, BeforeFacets);

  GreedyLabels labels(energy, cut);
  FacetConstraint facets(pieces, energy.NumberOfCells());
  FacetConstraint::Outcome kept;
  if (parameters.ConstrainFacets)
  {
    kept = facets.Satisfy(labels, monitor, BeforeFacets, BeforeManifold);
  }
  ManifoldConstraint::Outcome filled;
  if (parameters.FillNonManifold)
  {
    filled = makeManifold(labels, monitor, BeforeManifold, 1);
  }
  result.Inside = labels.Labels();

  const Id unsatisfied = static_cast<Id>(kept.Unsatisfied.size());
  if (unsatisfied > 0)
  {
    const Id seed = SeedBeside(pieces[kept.Unsatisfied.front()], seeded);
    result.Warnings.push_back(std::to_string(unsatisfied) +
      " pieces of facets are not kept, for seeds are to be outside on either side of them: seed " +
      std::to_string(seed) + " beside the first");
  }
  if (filled.LeftPoints > 0)
  {
    result.Warnings.push_back(std::to_string(filled.LeftPoints) +
      " points of the boundary could not be made manifold: " +
      (!hasSeeds ? "the hull is not manifold there" : "seeds that are to be outside forbid it"));
  }
  result.Statistics = { { "Energy", energy.Of(result.Inside) }, { "EnergyOfCut", energy.Of(cut) },
    { "ForcedFacets", kept.Forced }, { "ForcedCells", labels.NumberOfForced() },
    { "ChangedCells", CountDifferent(result.Inside, cut) }, { "UnsatisfiedFacets", unsatisfied },
    { "NonManifoldPoints", filled.LeftPoints },
    { "SeedConflicts", seeded.Conflicts + unsatisfied + filled.LeftPoints } };
  monitor.Check(Stages::Segmenting, 1);
  return result;
}
} // namespace insideout
