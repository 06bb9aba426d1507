// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/RefineGrid.h"

#include "Common/Error.h"
#include "Common/ScaledPoints.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Data/FieldNames.h"
#include "In/ReadGrid.h"
#include "Out/MixInCells.h"
#include "Out/NameSizes.h"
#include "Out/RefineBoundary.h"
#include "Quality/QualityOfMesh.h"
#include "Quality/SolverFitness.h"
#include "Refine/MakeRefinable.h"
#include "Refine/QuadraticCells.h"
#include "Refine/RefineTetrahedra.h"
#include "Refine/TriangleTree.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** Input errors that would break a stage: VTK does not check them. */
void CheckGrid(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfCells() == 0)
  {
    throw Error(ErrorCode::EmptySurface, "the grid has no cells");
  }
  if (const vtkIdType other = FindOtherCell(grid); other >= 0)
  {
    throw Error(ErrorCode::InvalidParameter,
      "cell " + std::to_string(other) + " is a " + CellName(grid->GetCellType(other)) +
        "; only tetrahedra (vtkTetra) can be refined. Triangles in a plane become better ones "
        "where "
        "vtkRobustTetrahedralize makes them, by its Refine");
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCellPoints(c, corners);
    for (const vtkIdType p : *corners)
    {
      if (p < 0 || p >= grid->GetNumberOfPoints())
      {
        throw Error(ErrorCode::InvalidParameter,
          "cell " + std::to_string(c) + " has the point " + std::to_string(p) +
            ", which is not there");
      }
      Point place;
      grid->GetPoint(p, place.data());
      if (!IsFinite(place))
      {
        throw Error(ErrorCode::InvalidParameter, "point " + std::to_string(p) + " is not finite");
      }
    }
  }
}

/** The cells' RegionId, renumbered; empty without one. */
std::vector<Id> ReadRegions(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetCellData()->GetArray("RegionId");
  if (!array)
  {
    return {};
  }
  if (!HasIntegers(array, grid) || array->GetNumberOfComponents() != 1)
  {
    throw Error(ErrorCode::InvalidParameter, "the cell array RegionId is not one integer per cell");
  }
  std::vector<double> values(grid->GetNumberOfCells());
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    values[c] = array->GetComponent(static_cast<vtkIdType>(c), 0);
  }
  return NumberedAnew(values);
}

/** Regions subdivided by bodies, by InBody of vtkRobustTetrahedralize: bodies within a region stay
 * separate. Other arrays of that name are ignored. */
std::vector<Id> SplitByBodies(std::vector<Id> regions, vtkUnstructuredGrid* grid)
{
  vtkDataArray* bodies = grid->GetCellData()->GetArray("InBody");
  const bool isOfBodies = bodies && HasIntegers(bodies, grid);
  for (int body = 0; isOfBodies && body < bodies->GetNumberOfComponents(); ++body)
  {
    std::vector<double> values(grid->GetNumberOfCells());
    for (std::size_t c = 0; c < values.size(); ++c)
    {
      const double region = regions.empty() ? 0 : regions[c];
      values[c] = 2 * region + (bodies->GetComponent(static_cast<vtkIdType>(c), body) != 0 ? 1 : 0);
    }
    regions = NumberedAnew(values);
  }
  return regions;
}

/** The face of a cell of the grid for face k of the mesh's cell: inverted cells were turned. */
int FaceInGrid(vtkUnstructuredGrid* grid, const TetrahedralMesh& mesh, Id cell, int k)
{
  vtkNew<vtkIdList> given;
  grid->GetCellPoints(cell, given);
  const bool turned = !std::equal(given->begin(), given->end(), mesh.Cells[cell].begin());
  // ConnectCells says which faces of turned cells change places.
  return turned && (k == 0 || k == 3) ? 3 - k : k;
}

/**
 * Arrays of four values per cell, one per face: those of facets are kept, others are `otherwise`.
 */
void CarryFaces(const TetrahedralMesh& mesh, const RefinedMesh& refined, const char* name,
  double otherwise, vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  vtkDataArray* source = input->GetCellData()->GetArray(name);
  vtkDataArray* array = output->GetCellData()->GetArray(name);
  if (!array || !source || source->GetNumberOfComponents() != 4)
  {
    return;
  }
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id face = refined.OriginalFaces[c][k];
      array->SetComponent(static_cast<vtkIdType>(c), k,
        face == None ? otherwise
                     : source->GetComponent(face / 4, FaceInGrid(input, mesh, face / 4, face % 4)));
    }
  }
}

/**
 * On the boundary and between regions, points are interpolated between a face's corners, not a
 * cell's: one of these may be a point in the volume, without data.
 */
void MixOnFaces(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const RefinedMesh& refined, std::vector<Attributes::Mixture>& mixtures)
{
  const PowerOfTwo scale(-LargestExponent(mesh.Points));
  const auto scaled = [&scale](const std::array<Point, 3>& t) {
    return std::array<Point, 3>{ { scale.Times(t[0]), scale.Times(t[1]), scale.Times(t[2]) } };
  };
  const std::vector<FacetOfInput> facets = FacetsOf(mesh, regions, {});
  std::vector<LabelledTriangle> triangles;
  triangles.reserve(facets.size());
  for (const FacetOfInput& facet : facets)
  {
    triangles.push_back({ scaled(facet.Corners), 0 });
  }
  const TriangleTree tree(std::move(triangles));
  std::vector<char> isDone(mixtures.size(), 0);
  Id nearest = None;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (refined.OriginalFaces[c][k] == None)
      {
        continue;
      }
      for (const Id p : FaceOf(refined.Cells[c], k))
      {
        if (mixtures[p].IsNew && std::exchange(isDone[p], 1) == 0)
        {
          const Point place = scale.Times(refined.Points[p]);
          nearest = tree.NearestTo(place, 0, nearest).Triangle;
          const Id face = facets[nearest].Faces[0];
          const Triangle corners = FaceOf(mesh.Cells[face / 4], face % 4);
          mixtures[p].Points = { { corners[0], corners[1], corners[2], corners[0] } };
          mixtures[p].Weights = WeightsIn(scaled(CornersOf(mesh.Points, corners)), place);
        }
      }
    }
  }
}

std::vector<Attributes::Mixture> MixturesOf(
  const TetrahedralMesh& mesh, const std::vector<Id>& regions, const RefinedMesh& refined)
{
  std::vector<Attributes::Mixture> mixtures =
    MixInCells(mesh, refined.Points, refined.OriginalPoints, refined.CellsOfPoints);
  MixOnFaces(mesh, regions, refined, mixtures);
  return mixtures;
}

/** Points and cells of a result, with mid-edge nodes if wanted. */
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
  const RefinedMesh& refined, const QuadraticCells* quadratic)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (!quadratic)
  {
    grid->SetPoints(MakePoints(refined.Points));
    grid->SetCells(VTK_TETRA, MakeCells(refined.Cells));
    return grid;
  }
  std::vector<Point> points = refined.Points;
  points.reserve(points.size() + quadratic->Edges.size());
  for (const Edge& edge : quadratic->Edges)
  {
    points.push_back(Midpoint(refined.Points[edge[0]], refined.Points[edge[1]]));
  }
  grid->SetPoints(MakePoints(points));
  grid->SetCells(VTK_QUADRATIC_TETRA, MakeCells(quadratic->Cells));
  return grid;
}

std::string TooLargeCells(double count, std::size_t cells, double maximumVolume)
{
  std::ostringstream words;
  words << static_cast<Id>(count) << " of " << cells << " cells are larger than MaximumVolume, "
        << maximumVolume << ": faces that stay as they are may allow no smaller ones";
  return words.str();
}
/**
 * Measures a solid whose surface changed.
 *
 * @param[in] ownRegions whether RegionId is this library's, from 0, so that each region is measured
 */
void MeasureMasses(
  const RefinedMesh& refined, vtkUnstructuredGrid* grid, bool ownRegions, Refinement& result)
{
  vtkDataArray* regions = grid->GetCellData()->GetArray("RegionId");
  TetrahedralMesh mesh;
  mesh.Points = refined.Points;
  mesh.Cells = refined.Cells;
  SolidRegions after;
  for (std::size_t i = 0; ownRegions && i < refined.OriginalCells.size(); ++i)
  {
    const Id cell = refined.OriginalCells[i];
    after.OfCell.push_back(regions ? static_cast<Id>(regions->GetComponent(cell, 0)) : 0);
    after.Count = std::max(after.Count, after.OfCell.back() + 1);
  }
  if (ownRegions)
  {
    result.Masses = MeasureRegions(mesh, after);
  }
  result.Mass = MeasureMass(mesh, std::vector<unsigned char>(mesh.Cells.size(), 1));
}

double StatisticOf(const Statistics& statistics, const std::string& wanted)
{
  for (const auto& [name, value] : statistics)
  {
    if (name == wanted)
    {
      return value;
    }
  }
  return 0;
}

/** Call visit(p, q) for the edges of the boundary and between regions, once for each face of a cell
 * there. */
template <class Visitor>
void VisitSurfaceEdges(const RefinedMesh& refined, const Visitor& visit)
{
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (refined.OriginalFaces[c][k] != None)
      {
        const Triangle corners = FaceOf(refined.Cells[c], k);
        for (int corner = 0; corner < 3; ++corner)
        {
          visit(corners[corner], corners[(corner + 1) % 3]);
        }
      }
    }
  }
}

/** Their lengths. */
std::vector<double> SurfaceEdges(const RefinedMesh& refined)
{
  std::vector<double> lengths;
  VisitSurfaceEdges(refined,
    [&](Id a, Id b) { lengths.push_back(Distance(refined.Points[a], refined.Points[b])); });
  return lengths;
}

/** The lengths of these edges in those that rules ask for at their ends. */
std::vector<double> SurfaceEdgesInLengths(const RefinedMesh& refined)
{
  std::vector<double> ratios;
  VisitSurfaceEdges(refined,
    [&](Id a, Id b)
    {
      const double asked = (refined.LengthsByRules[a] + refined.LengthsByRules[b]) / 2;
      ratios.push_back(Distance(refined.Points[a], refined.Points[b]) / asked);
    });
  return ratios;
}

double MedianOf(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** A message on how the surface's edges differ from what rules ask for; empty if they do not. */
std::string OtherEdgesThanRules(const RefinedMesh& refined, const RefinementParameters& parameters)
{
  constexpr double MostTimes = 2;
  if (refined.LengthsByRules.empty())
  {
    return {};
  }
  std::vector<double> ratios = SurfaceEdgesInLengths(refined);
  std::ostringstream words;
  words << std::setprecision(3);
  const bool asksForCurvature =
    std::any_of(parameters.Sizes.Rules.begin(), parameters.Sizes.Rules.end(),
      [](const SizeRule& rule) { return rule.What == SizeRule::Kind::Curvature; });
  const double most = *std::max_element(ratios.begin(), ratios.end());
  if (parameters.Surface == SurfaceTreatment::Kept && most > MostTimes)
  {
    words << "edges of the surface, which is kept, are up to " << most
          << " times as long as SizeRules asks for"
          << (parameters.CouldBeTreated ? ": SurfaceTreatment split or remeshed makes them as short"
                                        : "");
  }
  else if (const double middle = MedianOf(ratios); asksForCurvature &&
           parameters.Surface == SurfaceTreatment::Remeshed && middle < 1 / MostTimes)
  {
    words << "half of the edges of the surface are shorter than " << middle
          << " times what SizeRules asks for, because it stays within SurfaceTolerance, "
          << StatisticOf(refined.Statistics, "SurfaceTolerance")
          << ", and keeps edges above FeatureAngle: larger ones make it coarser";
  }
  return words.str();
}

/** A message on how the surface's edges differ from the wanted lengths; empty if they do not. */
std::string OtherEdgesThanAsked(const RefinedMesh& refined, const RefinementParameters& parameters)
{
  // Edges of a suitable surface may be slightly longer; most are at least half as long.
  constexpr double MostTimes = 2;
  const double asked = parameters.Sizes.EdgeLength;
  std::vector<double> lengths = asked > 0 ? SurfaceEdges(refined) : std::vector<double>();
  std::ostringstream words;
  if (lengths.empty())
  {
    return {};
  }
  if (parameters.Surface == SurfaceTreatment::Kept)
  {
    const double longest = *std::max_element(lengths.begin(), lengths.end());
    words << "EdgeLength is " << asked << ", and edges of the surface, which is kept, are up to "
          << std::setprecision(3) << longest << " long"
          << (parameters.CouldBeTreated ? ": SurfaceTreatment split or remeshed makes them as short"
                                        : "");
    return longest > MostTimes * asked ? words.str() : std::string();
  }
  const bool isByLengthAlone = parameters.Sizes.Lengths.empty() && !parameters.Sizes.LengthAt &&
    parameters.Sizes.Rules.empty() && parameters.Sizes.MaximumVolume == 0;
  if (parameters.Surface != SurfaceTreatment::Remeshed || !isByLengthAlone)
  {
    return {};
  }
  const double middle = MedianOf(lengths);
  words << "EdgeLength is " << asked << ", and half of the edges of the surface are shorter than "
        << std::setprecision(3) << middle << ", because it stays within SurfaceTolerance, "
        << StatisticOf(refined.Statistics, "SurfaceTolerance")
        << ", and keeps edges above FeatureAngle: larger ones make it coarser";
  return middle < asked / MostTimes ? words.str() : std::string();
}

void WarnAbout(const RefinedMesh& refined, const RefinementParameters& parameters,
  std::vector<std::string>& warnings)
{
  for (const std::string& words :
    { OtherEdgesThanAsked(refined, parameters), OtherEdgesThanRules(refined, parameters) })
  {
    if (!words.empty())
    {
      warnings.push_back(words);
    }
  }
  if (const double large = StatisticOf(refined.Statistics, "CellsAboveMaximumVolume"); large > 0)
  {
    warnings.push_back(TooLargeCells(large, refined.Cells.size(), parameters.Sizes.MaximumVolume));
  }
  if (const double kept = StatisticOf(refined.Statistics, "KeptFacets"); kept > 0)
  {
    warnings.push_back(std::to_string(static_cast<Id>(kept)) +
      " triangles of the surface stay as they are, since they cross others");
  }
  const double distance = StatisticOf(refined.Statistics, "InputDistance");
  if (const double tolerance = StatisticOf(refined.Statistics, "SurfaceTolerance");
      distance > tolerance)
  {
    std::ostringstream words;
    words << "a part of the surface is " << distance << " away from the remeshed one, farther than "
          << tolerance;
    warnings.push_back(words.str());
  }
}

/** A grid to be refined, and how. */
struct GridToRefine
{
  /** @throws Error that names a cell which cannot be refined */
  GridToRefine(vtkUnstructuredGrid* grid, vtkPolyData* boundary, const RefinementParameters& given)
    : Grid(grid)
    , Boundary(boundary)
    , Parameters(given)
  {
    CheckGrid(grid);
    const bool isKept = given.Surface == SurfaceTreatment::Kept;
    this->OwnRegions = ReadRegions(grid);
    this->Regions = isKept ? SplitByBodies(this->OwnRegions, grid) : this->OwnRegions;
    this->Mesh = ReadTetrahedra(grid);
    NameSizes(grid, boundary, this->Parameters.Sizes);
    const bool needsTags = given.Surface == SurfaceTreatment::Remeshed || given.TreatsNeedles ||
      SizesNameTags(this->Parameters.Sizes.Rules);
    if (boundary && needsTags)
    {
      this->Parameters.Labels = LabelsOf(this->Mesh, this->OwnRegions, boundary);
      this->Parameters.LabelOfHoles = LabelOfHoles(boundary);
    }
    if (boundary && given.Surface == SurfaceTreatment::Split)
    {
      this->Parameters.Attributes = AttributesOf(this->Mesh, this->OwnRegions, boundary);
    }
  }

  vtkUnstructuredGrid* Grid;
  vtkPolyData* Boundary; ///< null: none
  RefinementParameters Parameters;
  std::vector<Id> OwnRegions;
  std::vector<Id> Regions; ///< subdivided where the surface is kept
  TetrahedralMesh Mesh;
};

/** The grid's result, with its data.
 * @param[in] stopwatch started when refinement began */
Refinement ResultOf(const GridToRefine& given, const RefinedMesh& refined, bool changesSurface,
  bool quadratic, Stopwatch stopwatch, Monitor& monitor)
{
  vtkUnstructuredGrid* grid = given.Grid;
  const TetrahedralMesh& mesh = given.Mesh;
  const std::vector<Id>& regions = given.Regions;
  QuadraticCells secondOrder;
  if (quadratic)
  {
    secondOrder = MakeQuadraticCells(static_cast<Id>(refined.Points.size()), refined.Cells);
  }

  Refinement result;
  result.Grid = MakeGrid(refined, quadratic ? &secondOrder : nullptr);
  Attributes::MixPointData(grid, MixturesOf(mesh, regions, refined), secondOrder.Edges,
    result.Grid->GetPointData(), result.Warnings);
  Attributes::CopyCellData(
    grid, refined.OriginalCells, result.Grid->GetCellData(), result.Warnings);
  CarryFaces(mesh, refined, "FacetIds", -1, grid, result.Grid);
  CarryFaces(mesh, refined, "FacetMultiplicity", 0, grid, result.Grid);
  result.Grid->GetFieldData()->ShallowCopy(grid->GetFieldData());
  result.Boundary = given.Boundary;
  if (given.Boundary && changesSurface)
  {
    result.Boundary =
      RefineBoundary(mesh, given.OwnRegions, refined, given.Boundary, result.Warnings);
  }

  result.ChangesMasses = changesSurface && given.Parameters.Surface != SurfaceTreatment::Split;
  if (result.ChangesMasses)
  {
    MeasureMasses(refined, grid, given.Boundary != nullptr, result);
  }
  result.Statistics = refined.Statistics;
  const ProgressRange end = { Stages::Refining, 1, 1 };
  AppendQuality(QualityOfMesh(mesh.Points, mesh.Cells, monitor, end), result.Statistics, "Before");
  AppendFitness(FitnessForSolver(mesh.Points, mesh.Cells, {}, {}, {}, monitor, end),
    result.Statistics, "Before");
  AppendQuality(QualityOfMesh(refined.Points, refined.Cells, monitor, end), result.Statistics);
  const GridTetrahedra made = ReadTetrahedraOfAnyOrder(result.Grid);
  std::vector<Id> regionsNow;
  for (std::size_t c = 0; c < refined.OriginalCells.size() && !regions.empty(); ++c)
  {
    regionsNow.push_back(regions[refined.OriginalCells[c]]);
  }
  result.Fitness =
    FitnessForSolver(made.Points, made.Cells, made.Midpoints, {}, regionsNow, monitor, end);
  AppendFitness(result.Fitness, result.Statistics);
  result.Statistics.emplace_back("RefinedCells", refined.Cells.size());
  WarnAbout(refined, given.Parameters, result.Warnings);
  result.Statistics.emplace_back("SecondsRefine", stopwatch.Lap());
  return result;
}

/** Limit of cells of a kept surface for remeshing it unasked: it may take minutes, and be in vain.
 */
constexpr Id MostCellsOfTrial = 100000;

/** Whether a solver handles cells better than others. If some of them are merely too small, which
 * only another unit mends, it mends those of the others, too: these do not count. */
bool IsFitter(const SolverFitness& cells, const SolverFitness& others)
{
  const auto count = [&cells](const SolverFitness& fitness)
  { return fitness.UnfitCells() - (cells.TooSmallCells > 0 ? fitness.TooSmallCells : 0); };
  return count(cells) < count(others);
}

/** A message that another treatment was chosen than to keep the surface, and why. */
std::string WordsOfTreatment(
  const Refinement& kept, const std::string& treatment, const Refinement& treated)
{
  const std::string flat = kept.Fitness.NearlyFlatCells > 0
    ? ", or lose half its digits at " + std::to_string(kept.Fitness.NearlyFlatCells) + ","
    : "";
  return "a solver would refuse " + std::to_string(kept.Fitness.RefusedCells) + flat + " of " +
    std::to_string(kept.Fitness.Cells) + " cells where the surface is kept" + treatment + " " +
    std::to_string(treated.Fitness.UnfitCells()) +
    " are left; set SurfaceTreatment to Kept to leave it";
}

std::string WordsOfMending(const Refinement& mended)
{
  std::ostringstream words;
  words << ": after " << static_cast<Id>(StatisticOf(mended.Statistics, "MendedNeedles"))
        << " changes to its needles and flat cells, which move it by at most "
        << std::setprecision(3) << StatisticOf(mended.Statistics, "SurfaceTolerance") << ",";
  return words.str();
}

/** Whether areas and volumes are to stay: there are several tags of triangles that close no hole,
 * several named regions, or two that touch. */
bool HasSeveralNames(vtkUnstructuredGrid* grid, vtkPolyData* boundary)
{
  std::vector<Id> tags = boundary ? TagsOf(boundary) : std::vector<Id>();
  SortUniquely(tags);
  const std::ptrdiff_t holes =
    boundary ? std::count(tags.begin(), tags.end(), LabelOfHoles(boundary)) : 0;
  const std::vector<Id> regions = ReadRegions(grid);
  const TetrahedralMesh mesh = ReadTetrahedra(grid);
  bool doTouch = false;
  for (std::size_t c = 0; c < regions.size(); ++c)
  {
    for (const Id neighbor : mesh.Neighbors[c])
    {
      doTouch |= neighbor != None && regions[neighbor] != regions[c];
    }
  }
  return static_cast<std::ptrdiff_t>(tags.size()) - holes > 1 || doTouch ||
    NamesByNumber(grid->GetFieldData(), "RegionNames").size() > 1;
}
} // namespace

Refinement RefineGrid(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  const RefinementParameters& given, bool quadratic, Monitor& monitor)
{
  const Stopwatch stopwatch;
  const GridToRefine input(grid, boundary, given);
  const auto resultOf = [&](const RefinedMesh& refined, bool changesSurface)
  { return ResultOf(input, refined, changesSurface, quadratic, stopwatch, monitor); };
  if (!given.TreatsNeedles)
  {
    return resultOf(RefineTetrahedra(input.Mesh, input.Regions, input.Parameters, monitor),
      given.Surface != SurfaceTreatment::Kept);
  }
  std::optional<Refinement> kept;
  Refinement best;
  const auto look = [&](const RefinedMesh& refined)
  {
    if (!kept)
    {
      kept = best = resultOf(refined, false);
    }
    else if (const Id needles = static_cast<Id>(StatisticOf(refined.Statistics, "MendedNeedles"));
             needles > 0)
    {
      Refinement mended = resultOf(refined, true);
      if (IsFitter(mended.Fitness, best.Fitness))
      {
        best = mended;
        best.Warnings.push_back(WordsOfTreatment(*kept, WordsOfMending(mended), best));
      }
    }
    return best.Fitness.UnfitCells() > 0;
  };
  RefinementParameters parameters = input.Parameters;
  parameters.MendsSurface = look;
  const RefinedMesh last = RefineTetrahedra(input.Mesh, input.Regions, parameters, monitor);
  if (best.Fitness.UnfitCells() > 0)
  {
    look(last);
  }
  if (best.Fitness.UnfitCells() > 0 && kept->Fitness.Cells <= MostCellsOfTrial &&
    !HasSeveralNames(grid, boundary))
  {
    RefinementParameters other = given;
    other.TreatsNeedles = false;
    other.Surface = SurfaceTreatment::Remeshed; // split needles are needles still
    Refinement remeshed = RefineGrid(grid, boundary, other, quadratic, monitor);
    if (IsFitter(remeshed.Fitness, best.Fitness))
    {
      best = remeshed;
      std::ostringstream words;
      words << ": it is remeshed, within " << std::setprecision(3)
            << StatisticOf(remeshed.Statistics, "SurfaceTolerance") << ", and";
      best.Warnings.push_back(WordsOfTreatment(*kept, words.str(), best));
    }
  }
  return best;
}
} // namespace vtkInsideOut
