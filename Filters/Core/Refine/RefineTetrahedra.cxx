// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefineTetrahedra.h"

#include "Common/Box.h"
#include "Common/PointPredicates.h"
#include "Common/ScaledPoints.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractSmallSteps.h"
#include "Refine/FillBetweenPieces.h"
#include "Refine/FillWithPoints.h"
#include "Refine/ImproveCells.h"
#include "Refine/JoinCoplanar.h"
#include "Refine/JoinThinHoles.h"
#include "Refine/LocateCells.h"
#include "Refine/MakeRefinable.h"
#include "Refine/MendNeedles.h"
#include "Refine/MendRefusedCells.h"
#include "Refine/RefinedSurface.h"
#include "Refine/RemeshPieces.h"
#include "Refine/RemeshSurface.h"
#include "Refine/SizesByRules.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace insideout
{
namespace
{
/** Cells during refinement relative to those of the result. */
constexpr double MostCells = std::numeric_limits<Id>::max() / 16.0;

/** Memory per cell, measured on nine surfaces. */
constexpr double GibibytesOfCell = 4e-7;

/** In any unit: cells with shorter edges are refused by a solver, or nearly so (IsRefused). */
constexpr double EdgeOfSmallestCell = 4e-7;

/** The largest share of that edge in the size of a solid of which most cells may be accepted. */
constexpr double LargestSmallestCell = 1e-2;

/** Points of a refined mesh per needle that is mended in it. Refinement makes small cells beside
 * needles: where these are frequent, it is better and hardly slower to refine anew without them. */
constexpr Id LeastPointsPerNeedle = 1000;

/** Beyond 2 to this power products of lengths might over- or underflow: sizes are then scaled. */
constexpr int LargestOrdinaryExponent = 60;

void CheckInput(const TetrahedralMesh& mesh, const SizingParameters& parameters)
{
  CheckCells(mesh);
  for (std::size_t p = 0; p < parameters.Lengths.size(); ++p)
  {
    if (!(parameters.Lengths[p] > 0))
    {
      throw Error(ErrorCode::InvalidParameter,
        "the edge length at point " + std::to_string(p) + " is not positive");
    }
  }
}

/**
 * The face of the input that a piece of a facet belongs to, on the side of the cells of a region.
 */
Id FaceOnSide(const FacetOfInput& facet, const std::vector<Id>& regions, Id region)
{
  const bool isSecond = !regions.empty() && regions[facet.Faces[0] / 4] != region;
  return facet.Faces[isSecond ? 1 : 0];
}

RefinedMesh Compress(const RefinableMesh& mesh, const TetrahedralMesh& input,
  const std::vector<Id>& regions, const std::vector<FacetOfInput>& facets)
{
  RefinedMesh result;
  std::vector<Id> numbers(mesh.Points.size(), None);
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (!mesh.IsDead(c))
    {
      const RefinableCell& cell = mesh.Cell(c);
      result.Cells.push_back(cell.Corners);
      result.OriginalCells.push_back(cell.Parent);
      std::array<Id, 4> faces;
      for (int k = 0; k < 4; ++k)
      {
        const Id facet = cell.Facets[CornerAcrossFrom[k]];
        faces[k] = facet == None ? None : FaceOnSide(facets[facet], regions, cell.Region);
      }
      result.OriginalFaces.push_back(faces);
    }
  }
  for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); ++p)
  {
    if (mesh.CellAt(p) != None)
    {
      numbers[p] = static_cast<Id>(result.Points.size());
      result.Points.push_back(mesh.Points[p]);
      const bool isOriginal =
        p < static_cast<Id>(input.Points.size()) && mesh.Points[p] == input.Points[p];
      result.OriginalPoints.push_back(isOriginal ? p : None);
      result.CellsOfPoints.push_back(mesh.Cell(mesh.CellAt(p)).Parent);
    }
  }
  for (Tetrahedron& cell : result.Cells)
  {
    for (Id& corner : cell)
    {
      corner = numbers[corner];
    }
  }
  return result;
}

Id CountLargeCells(const RefinedMesh& mesh, double maximumVolume)
{
  return static_cast<Id>(std::count_if(mesh.Cells.begin(), mesh.Cells.end(),
    [&](const Tetrahedron& cell)
    {
      const std::array<Point, 4> c = CornersOf(mesh.Points, cell);
      return Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0])) >
        6 * maximumVolume;
    }));
}

void CheckEstimate(const SizingField& sizes, Id maximumCells)
{
  const double cells = sizes.EstimatedCells();
  const bool isAbove =
    maximumCells > 0 && sizes.IsAskedFor() && cells > static_cast<double>(maximumCells);
  if (cells < MostCells && !isAbove)
  {
    return;
  }
  std::ostringstream words;
  words << "edges as short as asked for would make about " << std::setprecision(2) << cells
        << " cells, more than ";
  if (cells < MostCells)
  {
    words << "MaximumCells, " << maximumCells << ": they take some " << cells * GibibytesOfCell
          << " GiB";
  }
  else
  {
    words << "can be counted";
  }
  throw Error(ErrorCode::TooLarge, words.str());
}

/** A surface during refinement. */
struct SurfaceOfRun
{
  std::vector<FacetOfInput> Facets;
  std::vector<char> Locked; ///< facets that stay as they are
  double Tolerance;
  bool MayBeFit; ///< whether a solver accepts cells much smaller than the solid

  Id NumberOfLocked() const
  {
    return static_cast<Id>(std::count(this->Locked.begin(), this->Locked.end(), 1));
  }
};

/** Mark the facets with pieces on the boundary that cross others. */
std::vector<char> MarkCrossing(
  const RefinableMesh& mesh, const SurfaceOfRun& run, Monitor& monitor, double progress)
{
  std::vector<char> marks(run.Facets.size(), 0);
  for (const Id facet : CrossingFacets(mesh, monitor, { Stages::Refining, progress, progress }))
  {
    marks[facet] = 1;
  }
  return marks;
}

/** Whether pieces of facets that are not locked cross others: SurfaceBound allows none, and this
 * verifies it. */
bool HasNewCrossings(const RefinableMesh& mesh, const SurfaceOfRun& run, Monitor& monitor)
{
  const std::vector<char> crossing = MarkCrossing(mesh, run, monitor, 0.9);
  return !std::equal(crossing.begin(), crossing.end(), run.Locked.begin(), std::less_equal<>());
}

/** Make each piece one of its patch's facet (JoinCoplanar). */
void PutInPatches(RefinableMesh& mesh, const std::vector<FacetOfInput>& facets)
{
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (const Id facet = mesh.Cell(c).Facets[k]; facet != None)
      {
        mesh.SetFacet(c, k, facets[facet].Label);
      }
    }
  }
}

void FillToSizes(
  RefinableMesh& mesh, SizingField& sizes, const RefinementParameters& parameters, Monitor& monitor)
{
  ThinPoints(mesh);
  FillWithPoints(mesh, sizes, parameters.Sizes.MaximumVolume, parameters.Surface, monitor,
    { Stages::Refining, 0.2, 0.4 });
}

/** Refine the mesh; its surface is treated as requested, except for locked facets.
 * @param[in] regions per cell of the input
 * @param[in] mayFill whether cells may be made anew
 * @return false if that was not possible; the mesh is of no use then
 */
bool Run(RefinableMesh& refinable, const std::vector<Id>& regions, SurfaceOfRun& run,
  const RefinementParameters& parameters, bool mayFill, Monitor& monitor)
{
  std::optional<SurfaceBudget> budget;
  if (parameters.Surface == SurfaceTreatment::Split)
  {
    budget.emplace(refinable, run.Facets);
  }
  SurfaceBound bound(
    refinable, run.Facets, parameters.Surface, run.Tolerance, budget ? &*budget : nullptr);
  const auto surfaceNow = [&]
  {
    return RefinableSurface(
      refinable, run.Facets, run.Locked, parameters.Surface, parameters.FeatureAngle);
  };
  if (parameters.Surface == SurfaceTreatment::Remeshed)
  {
    RefinableSurface withSteps = surfaceNow();
    ContractSmallSteps(
      refinable, withSteps, bound, run.Tolerance, monitor, { Stages::Refining, 0, 0.05 });
  }
  RefinableSurface surface = surfaceNow();
  SizingField sizes(refinable, parameters.Sizes);
  CheckEstimate(sizes, parameters.MaximumCells);
  monitor.Check(Stages::Refining, 0.05);
  if (parameters.Surface != SurfaceTreatment::Kept)
  {
    if (parameters.Surface == SurfaceTreatment::Split)
    {
      TurnDiagonals(refinable, surface, bound, sizes, monitor, { Stages::Refining, 0.05, 0.05 });
      sizes.FollowSurface(1);
    }
    else
    {
      sizes.FollowWishes();
    }
    CheckEstimate(sizes, parameters.MaximumCells);
    if (mayFill)
    {
      const std::vector<SurfacePiece> pieces = RemeshPieces(
        refinable, surface, bound, sizes, run.Tolerance, monitor, { Stages::Refining, 0.05, 0.2 });
      if (!FillBetweenPieces(
            refinable, pieces, run.Facets, regions, sizes, monitor, { Stages::Refining, 0.2, 0.2 }))
      {
        return false;
      }
    }
    else
    {
      RemeshSurface(refinable, surface, bound, sizes, monitor, { Stages::Refining, 0.05, 0.2 });
    }
    sizes.FollowSurface();
  }
  FillToSizes(refinable, sizes, parameters, monitor);
  ImproveCells(refinable, surface, bound, sizes, monitor, { Stages::Refining, 0.4, 0.9 });
  if (run.MayBeFit)
  {
    MendRefusedCells(refinable, surface, bound, run.Tolerance,
      parameters.Surface == SurfaceTreatment::Remeshed, monitor, { Stages::Refining, 0.9, 0.9 });
  }
  return true;
}

/** Refine a mesh and mend its surface.
 * @param[in] isRefined whether the mesh is refined, with its surface kept: only what mending
 * changes is improved then
 * @return the number of changes of the surface; 0 if some made crossings, or if there are too many
 * in a refined mesh: the mesh is of no use then */
Id MendSurface(RefinableMesh& mesh, SurfaceOfRun& run, const RefinementParameters& parameters,
  bool isRefined, Monitor& monitor)
{
  SurfaceBudget budget(mesh, run.Facets);
  SurfaceBound bound(mesh, run.Facets, SurfaceTreatment::Remeshed, run.Tolerance, &budget);
  const std::int64_t since = isRefined ? mesh.NumberOfChanges() : None;
  Id count = MendNeedles(mesh, run.Facets, run.Locked, bound, run.Tolerance, monitor);
  if (isRefined && count > static_cast<Id>(mesh.Points.size()) / LeastPointsPerNeedle)
  {
    return 0;
  }
  RefinableSurface kept(
    mesh, run.Facets, run.Locked, SurfaceTreatment::Kept, parameters.FeatureAngle);
  SizingField sizes(mesh, parameters.Sizes);
  if (!isRefined)
  {
    FillToSizes(mesh, sizes, parameters, monitor);
  }
  ImproveCells(mesh, kept, bound, sizes, monitor, { Stages::Refining, 0.4, 0.9 }, since);
  if (run.MayBeFit)
  {
    RefinableSurface surface(
      mesh, run.Facets, run.Locked, SurfaceTreatment::Remeshed, parameters.FeatureAngle);
    count += MendRefusedCells(
      mesh, surface, bound, run.Tolerance, true, monitor, { Stages::Refining, 0.9, 0.9 });
  }
  return HasNewCrossings(mesh, run, monitor) ? 0 : count;
}

/** Refine a mesh without new crossings: facets that cross others stay as they are. */
RefinableMesh RunWithoutCrossings(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  SurfaceOfRun& run, const RefinementParameters& parameters, Monitor& monitor)
{
  RefinableMesh refinable = MakeRefinable(mesh, regions, run.Facets);
  const bool isKept = parameters.Surface == SurfaceTreatment::Kept;
  run.Locked =
    isKept ? std::vector<char>(run.Facets.size(), 0) : MarkCrossing(refinable, run, monitor, 0);
  if (parameters.Surface == SurfaceTreatment::Split)
  {
    JoinCoplanar(mesh, run.Locked, run.Facets);
    PutInPatches(refinable, run.Facets);
  }
  else if (parameters.Surface == SurfaceTreatment::Remeshed)
  {
    JoinThinHoles(regions, parameters, run.Tolerance, run.Facets);
  }
  // New cells have no faces that cross, and no inner points with lengths of their own.
  const bool mayFill = parameters.Surface == SurfaceTreatment::Remeshed &&
    run.NumberOfLocked() == 0 && parameters.Sizes.Lengths.empty();
  if (!Run(refinable, regions, run, parameters, mayFill, monitor))
  {
    refinable = MakeRefinable(mesh, regions, run.Facets);
    Run(refinable, regions, run, parameters, false, monitor);
  }
  if (!isKept && HasNewCrossings(refinable, run, monitor))
  {
    run.Locked.assign(run.Facets.size(), 1); // their pieces are unchanged
    refinable = MakeRefinable(mesh, regions, run.Facets);
    Run(refinable, regions, run, parameters, false, monitor);
  }
  return refinable;
}

/** The distances between the surfaces before and after. @throws Error Stopped */
void CompareSurfaces(
  const RefinableMesh& mesh, const SurfaceOfRun& run, Statistics& statistics, Monitor& monitor)
{
  const std::vector<LabelledTriangle> before = TrianglesOf(run.Facets);
  std::vector<LabelledTriangle> after;
  for (const SurfacePiece& piece : PiecesOf(mesh))
  {
    after.push_back({ piece.Places, run.Facets[piece.Facet].Label });
  }
  const double enough = run.Tolerance / 4; // smaller distances are not reported
  const ProgressRange atEnd = { Stages::Refining, 1, 1 };
  statistics.emplace_back("SurfaceTolerance", run.Tolerance);
  statistics.emplace_back(
    "SurfaceDistance", LargestDistance(after, before, enough, monitor, atEnd));
  statistics.emplace_back("InputDistance", LargestDistance(before, after, enough, monitor, atEnd));
}

Id CountSurfacePoints(const RefinableMesh& mesh, std::size_t before)
{
  Id count = 0;
  for (std::size_t p = before; p < mesh.Points.size(); ++p)
  {
    count += mesh.CellAt(static_cast<Id>(p)) != None && mesh.Kinds[p] != PointKind::Free ? 1 : 0;
  }
  return count;
}

/** Lengths wanted at the points of a result, except those given by arrays at the input's points. */
std::vector<double> LengthsByRules(
  const RefinedMesh& result, const std::vector<Id>& regions, const SizingParameters& sizes)
{
  if (sizes.Rules.empty())
  {
    return {};
  }
  std::vector<double> lengths;
  for (const Point& point : result.Points)
  {
    const double everywhere =
      sizes.EdgeLength > 0 ? sizes.EdgeLength : std::numeric_limits<double>::infinity();
    lengths.push_back(sizes.LengthAt ? std::min(everywhere, sizes.LengthAt(point)) : everywhere);
  }
  for (std::size_t c = 0; c < result.Cells.size() && !sizes.LengthOfRegion.empty(); ++c)
  {
    const std::size_t region = regions.empty() ? 0 : regions[result.OriginalCells[c]];
    for (const Id p : result.Cells[c])
    {
      lengths[p] = std::min(lengths[p], sizes.LengthOfRegion[region]);
    }
  }
  return lengths;
}

/** The result of a run.
 * @param[in] mesh, regions of the input */
RefinedMesh ResultOf(const RefinableMesh& refinable, const TetrahedralMesh& mesh,
  const std::vector<Id>& regions, const SurfaceOfRun& run, const RefinementParameters& parameters,
  Monitor& monitor)
{
  RefinedMesh result = Compress(refinable, mesh, regions, run.Facets);
  std::vector<Point> barycentres(result.Cells.size());
  for (std::size_t c = 0; c < result.Cells.size(); ++c)
  {
    barycentres[c] = Barycentre(result.Points, result.Cells[c]);
  }
  LocateCells(mesh, result.Points, result.CellsOfPoints, monitor, { Stages::Refining, 0.9, 0.93 });
  const std::vector<Id> near = result.OriginalCells;
  for (std::size_t c = 0; c < near.size(); ++c)
  {
    // A shorter way, which leaves the solid more rarely, than from a cell's predecessor.
    result.OriginalCells[c] = result.CellsOfPoints[result.Cells[c][0]];
  }
  LocateCells(mesh, barycentres, result.OriginalCells, monitor, { Stages::Refining, 0.93, 1 });
  for (std::size_t c = 0; c < near.size() && !regions.empty(); ++c)
  {
    // The rounded barycenter of a sliver may be beyond a face between regions.
    Id& found = result.OriginalCells[c];
    found = regions[found] == regions[near[c]] ? found : near[c];
  }

  result.LengthsByRules = LengthsByRules(result, regions, parameters.Sizes);

  const auto kept = static_cast<Id>(result.OriginalPoints.size() -
    std::count(result.OriginalPoints.begin(), result.OriginalPoints.end(), None));
  result.Statistics = { { "AddedPoints", static_cast<double>(result.Points.size()) - kept },
    { "RemovedPoints", static_cast<double>(mesh.Points.size()) - kept } };
  if (parameters.Sizes.MaximumVolume > 0)
  {
    result.Statistics.emplace_back(
      "CellsAboveMaximumVolume", CountLargeCells(result, parameters.Sizes.MaximumVolume));
  }
  if (parameters.Surface != SurfaceTreatment::Kept)
  {
    result.Statistics.emplace_back(
      "SurfacePoints", CountSurfacePoints(refinable, mesh.Points.size()));
    result.Statistics.emplace_back("KeptFacets", run.NumberOfLocked());
  }
  if (parameters.Surface == SurfaceTreatment::Remeshed)
  {
    CompareSurfaces(refinable, run, result.Statistics, monitor);
  }
  return result;
}

RefinedMesh RefineNearUnitSize(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const RefinementParameters& given, Monitor& caller)
{
  ForwardMonitor monitor(caller);
  const bool isSplit = given.Surface == SurfaceTreatment::Split;
  const Box box = BoundingBox(mesh.Points);
  const double size = box.Extent(box.LongestAxis());
  const double usual = RefinementParameters::DefaultTolerance * size;
  SurfaceOfRun run = { FacetsOf(mesh, regions, isSplit ? given.Attributes : given.Labels), {},
    given.SurfaceTolerance > 0 ? given.SurfaceTolerance : usual,
    EdgeOfSmallestCell <= LargestSmallestCell * size };
  monitor.Check(Stages::Refining, 0);
  RefinementParameters parameters = given;
  parameters.Sizes = SizesByRules(mesh, regions, run.Facets, given, monitor);
  RefinableMesh refinable = RunWithoutCrossings(mesh, regions, run, parameters, monitor);
  if (parameters.Surface != SurfaceTreatment::Kept)
  {
    FindNearestFacets(run.Facets, refinable, monitor, { Stages::Refining, 0.9, 0.9 });
    return ResultOf(refinable, mesh, regions, run, parameters, monitor);
  }
  RefinedMesh result = ResultOf(refinable, mesh, regions, run, parameters, monitor);
  const double least = RefinementParameters::MendingTolerance * size;
  run.Tolerance = run.MayBeFit ? std::max(least, std::min(EdgeOfSmallestCell, usual)) : least;
  for (const bool isRefined : { true, false })
  {
    if (!parameters.MendsSurface || !parameters.MendsSurface(result))
    {
      break;
    }
    if (isRefined)
    {
      run.Locked = MarkCrossing(refinable, run, monitor, 0.9);
    }
    else
    {
      refinable = MakeRefinable(mesh, regions, run.Facets);
    }
    const Id changes = MendSurface(refinable, run, parameters, isRefined, monitor);
    if (changes > 0)
    {
      FindNearestFacets(run.Facets, refinable, monitor, { Stages::Refining, 0.9, 0.9 });
      result = ResultOf(refinable, mesh, regions, run, parameters, monitor);
      result.Statistics.emplace_back("MendedNeedles", changes);
      result.Statistics.emplace_back("SurfaceTolerance", run.Tolerance);
    }
  }
  return result;
}

/** The regions renumbered from 0, in ascending order; None is the outside. */
std::vector<Id> NumberedAnew(std::vector<Id> regions)
{
  std::vector<Id> sorted = regions;
  SortUniquely(sorted);
  for (Id& region : regions)
  {
    region = IndexIn(sorted, region);
  }
  return regions;
}

/** Avoid underflow to 0, which has a special meaning. */
double ScaledSize(double size, int exponent)
{
  return size > 0 ? std::max(std::ldexp(size, exponent), std::numeric_limits<double>::min()) : 0;
}

/** The lengths for a mesh that is 2^exponent times as large. */
SizingParameters Scaled(const SizingParameters& parameters, int exponent)
{
  SizingParameters scaled = parameters;
  scaled.EdgeLength = ScaledSize(parameters.EdgeLength, exponent);
  scaled.MaximumVolume = ScaledSize(parameters.MaximumVolume, 3 * exponent);
  for (std::vector<double>* lengths : { &scaled.Lengths, &scaled.LengthOfCell })
  {
    for (double& length : *lengths)
    {
      length = ScaledSize(length, exponent);
    }
  }
  for (SizeRule& rule : scaled.Rules)
  {
    const bool isLength =
      rule.What != SizeRule::Kind::Curvature && rule.What != SizeRule::Kind::Gap;
    rule.Value = isLength ? ScaledSize(rule.Value, exponent) : rule.Value;
    rule.Radius = ScaledSize(rule.Radius, exponent);
    rule.Center = ScaledPoints({ rule.Center }, exponent).front();
  }
  if (parameters.LengthAt)
  {
    scaled.LengthAt = [&parameters, exponent](const Point& place)
    {
      const Point there = { { std::ldexp(place[0], -exponent), std::ldexp(place[1], -exponent),
        std::ldexp(place[2], -exponent) } };
      return std::ldexp(parameters.LengthAt(there), exponent);
    };
  }
  return scaled;
}

/** A result that is 2^exponent times as large.
 * @param[in] mesh the input of that size */
RefinedMesh ScaledBack(RefinedMesh result, int exponent, const TetrahedralMesh& mesh)
{
  result.Points = ScaledPoints(result.Points, exponent);
  for (double& length : result.LengthsByRules)
  {
    length = std::ldexp(length, exponent);
  }
  for (auto& [name, value] : result.Statistics)
  {
    const bool isLength =
      name == "SurfaceDistance" || name == "InputDistance" || name == "SurfaceTolerance";
    value = isLength ? std::ldexp(value, exponent) : value;
  }
  for (std::size_t p = 0; p < result.Points.size(); ++p)
  {
    if (result.OriginalPoints[p] != None)
    {
      result.Points[p] = mesh.Points[result.OriginalPoints[p]];
    }
  }
  for (const Tetrahedron& cell : result.Cells)
  {
    if (Orient3D(result.Points, cell) <= 0)
    {
      throw Error(ErrorCode::InvalidParameter,
        "the points are too large and too small at once for cells between them to be refined");
    }
  }
  return result;
}
} // namespace

RefinedMesh RefineTetrahedra(const TetrahedralMesh& mesh, const std::vector<Id>& given,
  const RefinementParameters& parameters, Monitor& monitor)
{
  CheckInput(mesh, parameters.Sizes);
  const std::vector<Id> regions = NumberedAnew(given);
  const int exponent = LargestExponent(mesh.Points);
  if (std::abs(exponent) <= LargestOrdinaryExponent)
  {
    return RefineNearUnitSize(mesh, regions, parameters, monitor);
  }
  TetrahedralMesh scaled = mesh;
  scaled.Points = ScaledPoints(mesh.Points, -exponent);
  RefinementParameters other = parameters;
  other.Sizes = Scaled(parameters.Sizes, -exponent);
  other.SurfaceTolerance = ScaledSize(parameters.SurfaceTolerance, -exponent);
  if (parameters.MendsSurface)
  {
    other.MendsSurface = [&](const RefinedMesh& kept)
    { return parameters.MendsSurface(ScaledBack(kept, exponent, mesh)); };
  }
  return ScaledBack(RefineNearUnitSize(scaled, regions, other, monitor), exponent, mesh);
}
} // namespace insideout
