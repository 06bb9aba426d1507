// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"

#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "GraphCut/InteriorFaces.h"

#include <algorithm>

namespace insideout
{
namespace
{
// Fractions of the progress at which the cut, the facets, the manifold and the topology begin.
constexpr double BeforeCut = 0.2;
constexpr double BeforeFacets = 0.5;
constexpr double BeforeManifold = 0.7;
constexpr double BeforeTopology = 0.8;

/** The seed in a cell next to the piece. */
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

Id CountUnsatisfied(const std::vector<FacetPiece>& pieces, const std::vector<unsigned char>& inside)
{
  return static_cast<Id>(std::count_if(pieces.begin(), pieces.end(),
    [&](const FacetPiece& piece)
    { return !inside[piece.First] && (piece.Second == None || !inside[piece.Second]); }));
}

/** Cells with a seed inside that are outside, because their regions were dropped. */
std::vector<Id> DroppedSeeds(
  const std::vector<std::int8_t>& demands, const std::vector<unsigned char>& inside)
{
  std::vector<Id> cells;
  for (std::size_t cell = 0; cell < demands.size(); ++cell)
  {
    if (demands[cell] > 0 && !inside[cell])
    {
      cells.push_back(static_cast<Id>(cell));
    }
  }
  return cells;
}

ScaledSizes VolumesOf(const TetrahedralMesh& mesh)
{
  return { CellVolumes(mesh), 3 * LargestExponent(mesh.Points) };
}

void Tell(const ControlledTopology& topology, MeshSegmentation& result)
{
  const std::vector<std::string>& warnings = topology.Warnings;
  result.Warnings.insert(result.Warnings.end(), warnings.begin(), warnings.end());
  const RegionChanges& regions = topology.Regions;
  const Statistics figures = { { "EnergyBeforeTopology", topology.EnergyBefore },
    { "DroppedRegions", regions.DroppedRegions }, { "DroppedVolume", regions.DroppedVolume },
    { "FilledCavities", regions.FilledCavities }, { "FilledVolume", regions.FilledVolume },
    { "JoinedRegions", topology.Joined } };
  result.Statistics.insert(result.Statistics.end(), figures.begin(), figures.end());
}
} // namespace

bool DropsRegions(const Statistics& statistics)
{
  return std::any_of(statistics.begin(), statistics.end(),
    [](const auto& figure) { return figure.first == "DroppedRegions" && figure.second > 0; });
}

MeshSegmentation SegmentMesh(const TetrahedralMesh& mesh, const std::vector<double>& w,
  const std::vector<FacetPiece>& pieces, const std::vector<Seed>& seeds,
  const SegmentMeshParameters& parameters, Monitor& monitor)
{
  monitor.Check(Stages::Segmenting, 0);
  SeededCells seeded = FindSeededCells(mesh.Points, mesh.Cells, seeds);
  CellGraph graph = { w, InteriorFaces(mesh),
    parameters.Cut.DataTerm == DataTerm::VolumeWeighted ? CellVolumes(mesh)
                                                        : std::vector<double>() };
  return SegmentCells(std::move(graph), std::move(seeded), pieces, parameters,
    { [&](GreedyLabels& labels, Monitor& watch, double begin, double end)
      {
        ManifoldConstraint manifold(mesh.Points.size(), mesh.Cells, mesh.Neighbors);
        return manifold.Satisfy(labels, watch, begin, end);
      },
      [&]()
      {
        return SimplicialCells(mesh.Points.size(), mesh.Cells, mesh.Neighbors, CornerAcrossFrom,
          [&]() { return VolumesOf(mesh); });
      } },
    monitor);
}

MeshSegmentation SegmentCells(CellGraph graph, SeededCells seeded,
  const std::vector<FacetPiece>& pieces, const SegmentMeshParameters& parameters,
  const MeshToSegment& mesh, Monitor& monitor)
{
  MeshSegmentation result;
  result.Warnings = std::move(seeded.Warnings);
  graph.Demands = std::move(seeded.Demands);
  const bool hasSeeds = !graph.Demands.empty();
  const CutEnergy energy(graph, parameters.Cut);
  monitor.Check(Stages::Segmenting, BeforeCut);
  const std::vector<unsigned char> cut = MinimumCut(energy);
  const double energyOfCut = energy.Of(cut);
  const auto energyOf = [&](const std::vector<unsigned char>& inside)
  { return inside == cut ? energyOfCut : energy.Of(inside); };
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
    filled = mesh.MakeManifold(labels, monitor, BeforeManifold, BeforeTopology);
  }
  result.Inside = labels.Labels();
  ControlledTopology topology;
  if (parameters.Topology.ChangeNothing())
  {
    topology.EnergyBefore = energyOf(result.Inside);
  }
  else
  {
    topology = ControlTopology(mesh.ListCells(), energy,
      { &graph.Demands, parameters.ConstrainFacets ? &pieces : nullptr,
        parameters.FillNonManifold ? mesh.MakeManifold : MakeManifold() },
      parameters.Topology, result.Inside, monitor, { Stages::Segmenting, BeforeTopology, 1 });
    filled.LeftPoints = std::max(filled.LeftPoints, topology.LeftPoints);
  }

  const Id unsatisfied = static_cast<Id>(kept.Unsatisfied.size());
  if (unsatisfied > 0)
  {
    const Id seed = SeedBeside(pieces[kept.Unsatisfied.front()], seeded);
    result.Warnings.push_back(std::to_string(unsatisfied) +
      " pieces of facets are not kept, because seeds are to be outside on both sides of them: "
      "seed " +
      std::to_string(seed) + " beside the first");
  }
  const Id dropped =
    parameters.ConstrainFacets ? CountUnsatisfied(pieces, result.Inside) - unsatisfied : 0;
  if (dropped > 0)
  {
    result.Warnings.push_back(std::to_string(dropped) +
      " pieces of facets are not kept, because their regions were dropped");
  }
  const std::vector<Id> droppedSeeds = DroppedSeeds(graph.Demands, result.Inside);
  const Id lostSeeds = static_cast<Id>(droppedSeeds.size());
  if (lostSeeds > 0)
  {
    result.Warnings.push_back(std::to_string(lostSeeds) +
      " seeds that are to be inside are outside, because their regions were dropped: seed " +
      std::to_string(seeded.Seeds[droppedSeeds.front()]) + " is one");
  }
  if (filled.LeftPoints > 0)
  {
    result.Warnings.push_back(std::to_string(filled.LeftPoints) +
      " points of the boundary could not be made manifold: " +
      (!hasSeeds ? "the hull is not manifold there" : "seeds that are to be outside forbid it"));
  }
  const Id changed = CountDifferent(result.Inside, cut);
  result.Statistics = { { "Energy", energyOf(result.Inside) }, { "EnergyOfCut", energyOfCut },
    { "ForcedFacets", kept.Forced },
    { "ForcedCells", labels.NumberOfForced() + topology.ForcedCells }, { "ChangedCells", changed },
    { "UnsatisfiedFacets", unsatisfied + dropped }, { "NonManifoldPoints", filled.LeftPoints },
    { "SeedConflicts", seeded.Conflicts + unsatisfied + filled.LeftPoints + lostSeeds } };
  Tell(topology, result);
  monitor.Check(Stages::Segmenting, 1);
  return result;
}
} // namespace insideout
