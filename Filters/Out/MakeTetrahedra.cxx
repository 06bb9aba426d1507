// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeTetrahedra.h"

#include "Boolean/SingleBodies.h"
#include "Boolean/WindingNumbersOfBodies.h"
#include "Common/Stages.h"
#include "Data/StatisticsArrays.h"
#include "In/ReadGrid.h"
#include "NothingInside.h"
#include "Out/RefineGrid.h"
#include "Output/MassProperties.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** The solid, with copies of cells where it overlaps itself, and of points where it touches itself.
 */
Parting Part(const HullMesh& hull, const std::vector<unsigned char>& inside, bool separateOverlaps,
  bool splitPoints, Monitor& monitor)
{
  Parting parting;
  parting.Solid = UnpartedSolid(hull.Mesh, inside);
  if (separateOverlaps)
  {
    SeparateOverlaps(hull, parting, monitor, { Stages::Extracting, 0, 0 });
  }
  if (splitPoints)
  {
    SplitPoints(parting, monitor, { Stages::Extracting, 0, 0 });
  }
  return parting;
}

/** The volume of the solid with w above 3/2, where it overlaps itself. */
double OverlapOf(const HullMesh& hull, const std::vector<unsigned char>& inside)
{
  std::vector<unsigned char> overlaps(inside.size(), 0);
  std::transform(hull.W.begin(), hull.W.end(), inside.begin(), overlaps.begin(),
    [](double w, unsigned char label) -> unsigned char { return label != 0 && w > 1.5; });
  return MeasureMass(hull.Mesh, overlaps).Volume;
}

/** Label the cells of a grid. */
void AddLabels(
  const std::vector<unsigned char>& inside, const SolidRegions& regions, vtkUnstructuredGrid* grid)
{
  AddInside(inside, grid);
  AddRegions(regions, grid);
}

/** All cells with their labels, and the extent of bodies. */
vtkSmartPointer<vtkUnstructuredGrid> LabelHull(const KeptHull& kept, const SegmentedHull& segmented)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->ShallowCopy(kept.Grid);
  if (kept.Bodies.AreNamed())
  {
    AddBodies(kept.Bodies, segmented.InBodies, segmented.Regions, kept.Hull.Mesh, grid);
  }
  AddLabels(segmented.All.Inside, segmented.Regions.Regions, grid);
  return grid;
}

/** The solid's cells with their regions, and mass properties of the solid and each region. */
struct Solid
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::vector<MassProperties> Masses; ///< of the regions
  MassProperties Mass;
  Statistics Counts;
};

Solid MakeSolid(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  const SolidRegions& regions, vtkUnstructuredGrid* labelled, Monitor& monitor)
{
  Solid solid;
  solid.Grid = ExtractInside(labelled, monitor, { Stages::Extracting, 0.45, 1 });
  const auto insideCells = std::count(inside.begin(), inside.end(), 1);
  if (insideCells > 0)
  {
    solid.Masses = MeasureRegions(mesh, regions);
  }
  solid.Counts.emplace_back("InsideCells", insideCells);
  solid.Counts.emplace_back("Regions", regions.Count);
  solid.Mass = solid.Masses.size() == 1 ? solid.Masses.front() : MeasureMass(mesh, inside);
  return solid;
}

Solid MakePartedSolid(const KeptHull& kept, const Parting& parted, Monitor& monitor)
{
  const TetrahedralMesh& mesh = parted.Solid.Mesh;
  const SolidRegions regions =
    FindRegions(mesh, parted.Solid.Inside, monitor, { Stages::Extracting, 0.4, 0.45 });
  const auto grid = MakePartedGrid(kept.Grid, parted);
  AddLabels(parted.Solid.Inside, regions, grid);
  return MakeSolid(mesh, parted.Solid.Inside, regions, grid, monitor);
}

/** Refine the solid, and its boundary with it. */
Refinement RefineSolid(const RefinementParameters& parameters, bool quadratic, Solid& solid,
  SolidSurfaces& surfaces, Monitor& monitor)
{
  Refinement refinement = RefineGrid(solid.Grid, surfaces.Boundary, parameters, quadratic, monitor);
  solid.Grid = refinement.Grid;
  surfaces.Boundary = refinement.Boundary;
  if (refinement.ChangesMasses)
  {
    refinement.Masses.resize(solid.Masses.size()); // the last regions may have no cell
    solid.Masses = refinement.Masses;
    solid.Mass = refinement.Mass;
  }
  return refinement;
}

/**
 * Evaluate w of open bodies in refined cells: it varies within the hull's cells, whose values these
 * have.
 */
void SetWOfRefined(
  const HullMesh& hull, int quadratureOrder, vtkUnstructuredGrid* refined, Monitor& monitor)
{
  if (AreClosed(hull, SortedFacetEdges(hull.Surface.Facets)))
  {
    return;
  }
  const GridTetrahedra grid = ReadTetrahedraOfAnyOrder(refined);
  const std::vector<std::vector<double>> found = WindingNumbersOfOpenBodies(
    hull, hull.Mesh, grid.Points, grid.Cells, quadratureOrder, monitor, { Stages::Refining, 1, 1 });
  vtkDataArray* ofBodies = refined->GetCellData()->GetArray("BodyW");
  vtkDataArray* sums = refined->GetCellData()->GetArray("w");
  sums->Fill(0);
  for (int b = 0; b < hull.NumberOfBodies(); ++b)
  {
    for (vtkIdType c = 0; c < refined->GetNumberOfCells(); ++c)
    {
      const double w = found[b].empty() ? ofBodies->GetComponent(c, b) : found[b][c];
      sums->SetComponent(c, 0, sums->GetComponent(c, 0) + w);
      if (ofBodies)
      {
        ofBodies->SetComponent(c, b, w);
      }
    }
  }
}

bool TakesTetrahedra(const KeptHull& kept, bool hasSeeds, const SolidOptions& options)
{
  const SegmentMeshParameters& segment = options.Segment.Parameters;
  return kept.Bodies.AreNamed() || hasSeeds || options.GenerateHull || options.Refine ||
    options.SeparateOverlaps || options.SplitPoints || options.Segment.MembranesSeparateRegions ||
    segment.ConstrainFacets || segment.FillNonManifold || !segment.Topology.ChangeNothing() ||
    !IsCutByWholeNumbers(segment.Cut);
}

template <typename List>
void Append(const List& more, List& list)
{
  list.insert(list.end(), more.begin(), more.end());
}
} // namespace

std::optional<Tetrahedra> MakeSurfaceOnly(const KeptHull& kept, bool hasSeeds, const Tags& tags,
  const SolidOptions& options, Monitor& monitor)
{
  if (TakesTetrahedra(kept, hasSeeds, options))
  {
    return std::nullopt;
  }
  Stopwatch stopwatch;
  const std::optional<ExpressionSurface> repaired =
    SurfaceOfExpression(kept.Hull, { SetOperation::Union, kept.Hull.NumberOfBodies() }, monitor);
  if (!repaired || repaired->Boundary.empty())
  {
    return std::nullopt;
  }
  const double seconds = stopwatch.Lap();
  MakeOutputs outputs = kept.Outputs;
  const SolidSurfaces surfaces =
    MakeRepairedSurfaces(kept, *repaired, options.Boundary, tags, outputs, monitor);

  Statistics statistics = kept.Hull.Statistics;
  statistics.emplace_back("Closed", 1);
  statistics.emplace_back("MinimumW", repaired->MinimumW);
  statistics.emplace_back("MaximumW", repaired->MaximumW);
  statistics.emplace_back("SecondsW", seconds);
  statistics.emplace_back("BoundaryFaces", surfaces.Boundary->GetNumberOfCells());
  Append(surfaces.Counts, statistics);
  statistics.emplace_back("PeakMemory", PeakMemory());
  Tetrahedra made{ vtkSmartPointer<vtkUnstructuredGrid>::New(), surfaces.Boundary,
    surfaces.Outliers, nullptr, kept.Hull.Warnings };
  AddStatistics(statistics, made.Grid);
  outputs.AddTurnedCells(kept.Hull, made.Grid);
  outputs.AddLeftOutCells(kept.Hull.Surface, made.Grid);
  Append(outputs.Warnings, made.Warnings);
  Append(WarningsAbout(surfaces.Lost), made.Warnings);
  return made;
}

Tetrahedra MakeTetrahedra(const KeptHull& kept, const std::vector<Seed>& seeds, vtkPointSet* points,
  const Tags& tags, const SolidOptions& options, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  MakeOutputs outputs = kept.Outputs;
  Stopwatch stopwatch;
  const SegmentedHull segmented = SegmentHull(kept, seeds, points, options.Segment, monitor);
  const MeshSegmentation& segmentation = segmented.All;
  const double cutSeconds = stopwatch.Lap();
  Parting parting;
  const Parting* parted = nullptr;
  if (options.SeparateOverlaps || options.SplitPoints)
  {
    parting =
      Part(hull, segmentation.Inside, options.SeparateOverlaps, options.SplitPoints, monitor);
    parted = &parting;
  }
  SolidSurfaces surfaces =
    MakeSolidSurfaces(kept, segmented, parted, options.Boundary, tags, outputs, monitor);
  const auto labelled = LabelHull(kept, segmented);
  const SolidRegions& regions = segmented.Regions.Regions;
  Solid solid = parted ? MakePartedSolid(kept, *parted, monitor)
                       : MakeSolid(hull.Mesh, segmentation.Inside, regions, labelled, monitor);
  const std::vector<MassProperties> massesOfHull =
    parted && options.GenerateHull ? MeasureRegions(hull.Mesh, regions) : solid.Masses;
  Refinement refinement;
  if (options.Refine && !solid.Masses.empty())
  {
    refinement = RefineSolid(options.Refinement, options.QuadraticCells, solid, surfaces, monitor);
    SetWOfRefined(hull, options.QuadratureOrder, solid.Grid, monitor);
  }

  Statistics statistics = hull.Statistics;
  statistics.emplace_back("SecondsCut", cutSeconds);
  Append(segmentation.Statistics, statistics);
  Append(parting.Statistics, statistics);
  Append(solid.Counts, statistics);
  AppendMass(solid.Mass, statistics);
  statistics.emplace_back("OverlapVolume", OverlapOf(hull, segmentation.Inside));
  statistics.emplace_back("BoundaryFaces", surfaces.Boundary->GetNumberOfCells());
  Append(surfaces.Counts, statistics);
  Append(refinement.Statistics, statistics);
  if (!options.Refinement.CouldBeTreated)
  {
    statistics.emplace_back("KeptByOptions", 1);
  }
  statistics.emplace_back("PeakMemory", PeakMemory());
  Tetrahedra made{ solid.Grid, surfaces.Boundary, surfaces.Outliers, nullptr, {} };
  const auto finish = [&](const std::vector<MassProperties>& masses, vtkUnstructuredGrid* grid)
  {
    AddStatistics(statistics, grid);
    outputs.AddLeftOutCells(hull.Surface, grid);
    AddMasses(masses, grid);
  };
  finish(solid.Masses, solid.Grid);
  if (options.GenerateHull)
  {
    finish(massesOfHull, labelled);
    made.Hull = labelled;
  }
  for (const auto& warnings : { hull.Warnings, segmentation.Warnings, parting.Warnings,
         outputs.Warnings, refinement.Warnings })
  {
    Append(warnings, made.Warnings);
  }
  // The segmentation already warns of dropped regions: do not name their shells again.
  if (DropsRegions(segmentation.Statistics))
  {
    surfaces.Lost.Shells.clear();
  }
  if (!solid.Masses.empty())
  {
    Append(WarningsAbout(surfaces.Lost), made.Warnings);
  }
  else if (!DropsRegions(segmentation.Statistics))
  {
    made.Warnings.push_back(NothingInside(hull));
  }
  return made;
}
} // namespace vtkInsideOut
