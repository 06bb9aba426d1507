// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/SolverFitness.h"

#include "Common/FaceTable.h"
#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "Quality/CellQuality.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The Jacobians are those of CalculiX: Dhondt, CalculiX CrunchiX User's Manual, and its shape4tet,
// shape10tet and shape6w. Sums are taken in its order, so that rounding gives the same result for a
// flat cell.

namespace insideout
{
namespace
{
/** Time per cell. */
constexpr double NanosecondsPerCell = 100;

/** In degrees, and its sine. */
constexpr double PoorAngle = 1;
constexpr double SineOfPoorAngle = 0.017452406437283512;

/** In degrees. */
constexpr double FlatAngle = FlatSine / SineOfPoorAngle;

enum class Fitness : std::uint8_t
{
  Good,
  Poor,
  NearlyFlat,
  Refused,
  TooSmall
};

/** Derivatives of the shape functions along the three axes of the reference cell. */
template <std::size_t Nodes>
using ShapeDerivatives = std::array<std::array<double, Nodes>, 3>;

constexpr ShapeDerivatives<4> LinearDerivatives = { { { { -1, 1, 0, 0 } }, { { -1, 0, 1, 0 } },
  { { -1, 0, 0, 1 } } } };

/** The same of a quadratic cell, whose nodes are in VTK's order. */
ShapeDerivatives<10> QuadraticDerivatives(double xi, double eta, double zeta)
{
  const double a = 1 - xi - eta - zeta;
  return {
    { { { 1 - 4 * a, 4 * xi - 1, 0, 0, 4 * (a - xi), 4 * eta, -4 * eta, -4 * zeta, 4 * zeta, 0 } },
      { { 1 - 4 * a, 0, 4 * eta - 1, 0, -4 * xi, 4 * xi, 4 * (a - eta), -4 * zeta, 0, 4 * zeta } },
      { { 1 - 4 * a, 0, 0, 4 * zeta - 1, -4 * xi, 0, -4 * eta, 4 * (a - zeta), 4 * xi, 4 * eta } } }
  };
}

/** The four integration points of a quadratic cell. */
std::array<ShapeDerivatives<10>, 4> QuadraticDerivativesAtPoints()
{
  constexpr double near = 0.138196601125011;
  constexpr double far = 0.585410196624968;
  return { { QuadraticDerivatives(near, near, near), QuadraticDerivatives(far, near, near),
    QuadraticDerivatives(near, far, near), QuadraticDerivatives(near, near, far) } };
}

/** The two integration points of C3D6, and the derivatives there. */
std::array<ShapeDerivatives<6>, 2> PrismDerivativesAtPoints()
{
  constexpr double third = 0.333333333333333;
  constexpr double height = 0.577350269189626;
  const auto at = [](double xi, double eta, double zeta)
  {
    const double a = 1 - xi - eta;
    const double below = 0.5 * (1 - zeta);
    const double above = 0.5 * (1 + zeta);
    return ShapeDerivatives<6>{ { { { -below, below, 0, -above, above, 0 } },
      { { -below, 0, below, -above, 0, above } },
      { { -0.5 * a, -0.5 * xi, -0.5 * eta, 0.5 * a, 0.5 * xi, 0.5 * eta } } } };
  };
  return { { at(third, third, -height), at(third, third, height) } };
}

template <std::size_t Nodes>
double Jacobian(const std::array<Point, Nodes>& nodes, const ShapeDerivatives<Nodes>& shapes)
{
  std::array<std::array<double, 3>, 3> m = {}; // by coordinates and axes of the reference cell
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (std::size_t k = 0; k < Nodes; ++k)
      {
        m[i][j] += nodes[k][i] * shapes[j][k];
      }
    }
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/** The least Jacobian of a cell at its integration points; NaN where it has none. */
double LeastJacobian(
  const std::array<Point, 4>& corners, const std::vector<Point>& points, const Id* midpoints)
{
  if (!midpoints)
  {
    return Jacobian(corners, LinearDerivatives);
  }
  static const std::array<ShapeDerivatives<10>, 4> shapes = QuadraticDerivativesAtPoints();
  std::array<Point, 10> nodes;
  std::copy(corners.begin(), corners.end(), nodes.begin());
  std::transform(
    midpoints, midpoints + 6, nodes.begin() + 4, [&points](Id p) { return points[p]; });
  double least = std::numeric_limits<double>::infinity();
  for (const ShapeDerivatives<10>& shape : shapes)
  {
    const double jacobian = Jacobian(nodes, shape);
    least = jacobian >= least ? least : jacobian; // NaN, too
  }
  return least;
}

/** The longest edge of the tetrahedron, or the largest distance between two of several corners. */
template <std::size_t Corners>
double LongestEdge(const std::array<Point, Corners>& corners)
{
  double longest = 0;
  for (std::size_t i = 0; i < Corners; ++i)
  {
    for (std::size_t j = i + 1; j < Corners; ++j)
    {
      longest = std::max(longest, Distance(corners[i], corners[j]));
    }
  }
  return longest;
}

/** Whether a solver accepts a cell with this least Jacobian. */
Fitness FitnessOfJacobian(double jacobian, bool isFlat)
{
  return jacobian >= SmallestJacobian ? Fitness::Good
    : jacobian > 0 && !isFlat         ? Fitness::TooSmall
                                      : Fitness::Refused;
}

/** The fitness of a cell of layers. */
template <class Cell>
Fitness FitnessOf(const std::vector<Point>& points, const Cell& cell)
{
  static const std::array<ShapeDerivatives<6>, 2> shapes = PrismDerivativesAtPoints();
  const Prism ids = NodesOfC3D6(cell);
  std::array<Point, 6> nodes;
  std::transform(ids.begin(), ids.end(), nodes.begin(), [&points](Id p) { return points[p]; });
  const double below = Jacobian(nodes, shapes[0]);
  const double above = Jacobian(nodes, shapes[1]);
  const double least = below <= above ? below : above;
  const double longest = LongestEdge(nodes);
  return FitnessOfJacobian(least, least < FlatSine * longest * longest * longest);
}

Fitness FitnessOf(
  const std::array<Point, 4>& corners, const std::vector<Point>& points, const Id* midpoints)
{
  const double jacobian = LeastJacobian(corners, points, midpoints);
  const double longest = LongestEdge(corners);
  const double cube = longest * longest * longest;
  const bool isRefused = !(jacobian >= SmallestJacobian);
  // The sine of each dihedral angle is at least six volumes over the longest edge cubed.
  const double volume = midpoints ? Jacobian(corners, LinearDerivatives) : jacobian;
  if (!isRefused && volume >= 2 * SineOfPoorAngle * cube)
  {
    return Fitness::Good;
  }
  const double angle = QualityOfCell(corners).MinDihedralAngle();
  if (isRefused)
  {
    return FitnessOfJacobian(jacobian, angle < FlatAngle);
  }
  return angle < FlatAngle ? Fitness::NearlyFlat
    : angle < PoorAngle    ? Fitness::Poor
                           : Fitness::Good;
}

/** Whether a triangle is so thin that any cell on it is poor. */
bool IsNeedle(const std::array<Point, 3>& corners)
{
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    longest = std::max(longest, Distance(corners[k], corners[(k + 1) % 3]));
  }
  const double area = Length(NormalOf(corners[0], corners[1], corners[2]));
  return !(area >= SineOfPoorAngle * longest * longest);
}

/** Whether cells have a needle that has to stay: on the boundary or between regions. */
class NeedleFinder
{
public:
  NeedleFinder(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
    const std::vector<Id>& regions)
    : Points(points)
    , Cells(cells)
    , Regions(regions)
    , Faces(points.size(), cells)
  {
  }

  bool HasNeedle(Id cell) const
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle face = FaceOf(this->Cells[cell], k);
      if (this->IsOnSurface(face) && IsNeedle(CornersOf(this->Points, face)))
      {
        return true;
      }
    }
    return false;
  }

private:
  bool IsOnSurface(const Triangle& face) const
  {
    const FaceTable::Range sharing = this->Faces.Find(SortedTriangle(face));
    return sharing.Size() == 1 ||
      (!this->Regions.empty() &&
        this->Regions[sharing.First[0].Cell] != this->Regions[sharing.First[1].Cell]);
  }

  const std::vector<Point>& Points;
  const std::vector<Tetrahedron>& Cells;
  const std::vector<Id>& Regions;
  const FaceTable Faces;
};

std::string CountOf(Id count, Id all)
{
  return std::to_string(count) + " of " + std::to_string(all) + " cells";
}

std::string SomeOf(Id count, Id all)
{
  return count == all ? std::string("they") : std::to_string(count) + " of them";
}

/** Advice; empty if all of it was followed. */
std::string AdviceFor(const SolverFitness& fitness, CellTreatment done, bool mayRemesh)
{
  std::string advice;
  const auto add = [&advice](const std::string& words)
  { advice += (advice.empty() ? "" : "; ") + words; };
  const Id all = fitness.RefusedCells + fitness.PoorCells;
  if (fitness.TooSmallCells > 0)
  {
    add(SomeOf(fitness.TooSmallCells, all) +
      " would pass in a smaller unit (by scale); MergeTolerance joins points that nearly meet");
  }
  if (all == fitness.TooSmallCells)
  {
    return advice;
  }
  if (done == CellTreatment::None)
  {
    add("refining makes better ones (Refine)");
  }
  const bool isOnNeedles = fitness.CellsOnNeedles > 0;
  if (isOnNeedles && !mayRemesh)
  {
    add(SomeOf(fitness.CellsOnNeedles, all) +
      " lie on needles of the surface, which other options keep: MergeTolerance joins points that "
      "nearly meet");
  }
  else if (isOnNeedles && done != CellTreatment::Remeshed)
  {
    add(SomeOf(fitness.CellsOnNeedles, all) +
      " lie on needles of the surface, which SurfaceTreatment remeshed replaces");
  }
  else if (done == CellTreatment::Refined && mayRemesh)
  {
    add("SurfaceTreatment remeshed replaces triangles that force such cells");
  }
  else if (done != CellTreatment::None && fitness.TooSmallCells == 0)
  {
    add("MergeTolerance joins points that nearly meet");
  }
  return advice;
}
} // namespace

bool IsRefused(const std::array<Point, 4>& corners)
{
  return !(Jacobian(corners, LinearDerivatives) >= SmallestJacobian);
}

SolverFitness FitnessForSolver(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<std::array<Id, 6>>& midpoints,
  const LayerCells& layers, const std::vector<Id>& regions, Monitor& monitor,
  const ProgressRange& progress)
{
  const std::size_t pyramids = cells.size() + layers.Pyramids.size();
  std::vector<Fitness> found(pyramids + layers.Prisms.size());
  ParallelLoop(found.size(), NanosecondsPerCell, monitor, progress,
    [&](std::size_t c)
    {
      if (c >= cells.size())
      {
        found[c] = c < pyramids ? FitnessOf(points, layers.Pyramids[c - cells.size()])
                                : FitnessOf(points, layers.Prisms[c - pyramids]);
        return;
      }
      const bool isLinear = midpoints.empty() || midpoints[c][0] == None;
      found[c] =
        FitnessOf(CornersOf(points, cells[c]), points, isLinear ? nullptr : midpoints[c].data());
    });
  const auto count = [&found](Fitness kind)
  { return static_cast<Id>(std::count(found.begin(), found.end(), kind)); };
  SolverFitness fitness;
  fitness.Cells = static_cast<Id>(found.size());
  fitness.TooSmallCells = count(Fitness::TooSmall);
  fitness.RefusedCells = count(Fitness::Refused) + fitness.TooSmallCells;
  fitness.NearlyFlatCells = count(Fitness::NearlyFlat);
  fitness.PoorCells = count(Fitness::Poor) + fitness.NearlyFlatCells;
  if (!fitness.IsGood())
  {
    const NeedleFinder needles(points, cells, regions);
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      if (found[c] != Fitness::Good && needles.HasNeedle(static_cast<Id>(c)))
      {
        fitness.CellsOnNeedles += found[c] != Fitness::TooSmall ? 1 : 0;
        fitness.RefusedOnNeedles +=
          found[c] == Fitness::Refused || found[c] == Fitness::TooSmall ? 1 : 0;
      }
    }
  }
  return fitness;
}

std::string WordsOfFitness(const SolverFitness& fitness, CellTreatment done, bool mayRemesh)
{
  if (fitness.IsGood())
  {
    return {};
  }
  const std::string poor = ", whose dihedral angles are below 1 degree";
  std::string words = "a solver suffers from " + CountOf(fitness.PoorCells, fitness.Cells) + poor;
  if (fitness.RefusedCells > 0)
  {
    words = "a solver refuses " + CountOf(fitness.RefusedCells, fitness.Cells) +
      ", whose Jacobian determinants are below its limit of 1e-20";
    words += fitness.PoorCells > 0
      ? ", and suffers from " + std::to_string(fitness.PoorCells) + " more" + poor
      : "";
  }
  words += fitness.NearlyFlatCells > 0 ? ", and loses half its digits at " +
      std::to_string(fitness.NearlyFlatCells) + " nearly flat ones"
                                       : "";
  return words + ": " + AdviceFor(fitness, done, mayRemesh);
}

void AppendFitness(const SolverFitness& fitness, Statistics& statistics, const std::string& prefix)
{
  statistics.emplace_back(prefix + "RefusedCells", fitness.RefusedCells);
  statistics.emplace_back(prefix + "PoorCells", fitness.PoorCells);
}
} // namespace insideout
