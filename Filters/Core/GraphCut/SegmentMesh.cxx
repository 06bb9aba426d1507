// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"

#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "GraphCut/InteriorFaces.h"

#include <algorithm>
#include <cmath>

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

/** Labels, and what the constraints did. */
struct Labelling
{
  std::vector<unsigned char> Cut; ///< before the constraints
  std::vector<unsigned char> Inside;
  double EnergyOfCut = 0;
  double Energy = 0;
  FacetConstraint::Outcome Kept;
  ManifoldConstraint::Outcome Filled;
  ControlledTopology Topology;
  Id ForcedCells = 0;
};

/** Whether the minimum is known without a cut (IsCutByWholeNumbers), and nothing constrains it. */
bool NeedsNoCut(const CellGraph& graph, const SegmentMeshParameters& parameters)
{
  return graph.Demands.empty() && !parameters.ConstrainFacets && !parameters.FillNonManifold &&
    parameters.Topology.ChangeNothing() && IsCutByWholeNumbers(parameters.Cut) &&
    std::all_of(graph.W.begin(), graph.W.end(), [](double w) { return w == std::floor(w); });
}

Labelling LabelsOfWholeNumbers(const RealEnergy& energy)
{
  const std::vector<double>& w = energy.Cells().W;
  Labelling result;
  result.Inside.resize(w.size());
  std::transform(w.begin(), w.end(), result.Inside.begin(), [](double of) { return of >= 1; });
  result.Cut = result.Inside;
  result.Energy = result.EnergyOfCut = result.Topology.EnergyBefore = energy.Of(result.Inside);
  return result;
}

Labelling CutAndConstrain(const CutEnergy& energy, const std::vector<FacetPiece>& pieces,
  const SegmentMeshParameters& parameters, const MeshToSegment& mesh, Monitor& monitor)
{
  Labelling result;
  result.Cut = MinimumCut(energy);
  result.EnergyOfCut = energy.Of(result.Cut);
  const auto energyOf = [&](const std::vector<unsigned char>& inside)
  { return inside == result.Cut ? result.EnergyOfCut : energy.Of(inside); };
  monitor.Check(Stages::Segmenting, BeforeFacets);

  GreedyLabels labels(energy, result.Cut);
  FacetConstraint facets(pieces, energy.NumberOfCells());
  if (parameters.ConstrainFacets)
  {
    result.Kept = facets.Satisfy(labels, monitor, BeforeFacets, BeforeManifold);
  }
  if (parameters.FillNonManifold)
  {
    result.Filled = mesh.MakeManifold(labels, monitor, BeforeManifold, BeforeTopology);
  }
  result.Inside = labels.Labels();
  if (parameters.Topology.ChangeNothing())
  {
    result.Topology.EnergyBefore = energyOf(result.Inside);
  }
  else
  {
    result.Topology = ControlTopology(mesh.ListCells(), energy,
      { &energy.Demands(), parameters.ConstrainFacets ? &pieces : nullptr,
        parameters.FillNonManifold ? mesh.MakeManifold : MakeManifold() },
      parameters.Topology, result.Inside, monitor, { Stages::Segmenting, BeforeTopology, 1 });
    result.Filled.LeftPoints = std::max(result.Filled.LeftPoints, result.Topology.LeftPoints);
  }
  result.ForcedCells = labels.NumberOfForced() + result.Topology.ForcedCells;
  result.Energy = energyOf(result.Inside);
  return result;
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
  RealEnergy energy(graph, parameters.Cut);
  monitor.Check(Stages::Segmenting, BeforeCut);
  Labelling labelling = NeedsNoCut(graph, parameters)
    ? LabelsOfWholeNumbers(energy)
    : CutAndConstrain(CutEnergy(std::move(energy)), pieces, parameters, mesh, monitor);
  result.Inside = std::move(labelling.Inside);

  const Id unsatisfied = static_cast<Id>(labelling.Kept.Unsatisfied.size());
  if (unsatisfied > 0)
  {
    const Id seed = SeedBeside(pieces[labelling.Kept.Unsatisfied.front()], seeded);
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
  const Id leftPoints = labelling.Filled.LeftPoints;
  if (leftPoints > 0)
  {
    result.Warnings.push_back(std::to_string(leftPoints) +
      " points of the boundary could not be made manifold: " +
      (!hasSeeds ? "the hull is not manifold there" : "seeds that are to be outside forbid it"));
  }
  const Id changed = CountDifferent(result.Inside, labelling.Cut);
  result.Statistics = { { "Energy", labelling.Energy }, { "EnergyOfCut", labelling.EnergyOfCut },
    { "ForcedFacets", labelling.Kept.Forced }, { "ForcedCells", labelling.ForcedCells },
    { "ChangedCells", changed }, { "UnsatisfiedFacets", unsatisfied + dropped },
    { "NonManifoldPoints", leftPoints },
    { "SeedConflicts", seeded.Conflicts + unsatisfied + leftPoints + lostSeeds } };
  Tell(labelling.Topology, result);
  monitor.Check(Stages::Segmenting, 1);
  return result;
}
} // namespace insideout
