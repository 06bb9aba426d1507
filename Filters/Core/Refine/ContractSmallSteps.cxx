// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ContractSmallSteps.h"

#include "Common/LoopProgress.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractEdge.h"
#include "Refine/ContractOnSurface.h"
#include "Refine/ReconnectCells.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace insideout
{
namespace
{
/**
 * Relative to the longest edge of a triangle: an edge longer than this does not make it a needle.
 */
constexpr double LargestShare = 0.1;

/** Limit of rounds: one contraction may make room for another. */
constexpr int MostRounds = 10;

/** Required shape of new cells, relative to the worst cell at the removed point. */
constexpr double LeastShare = 0.5;

/** Cells with an angle below this, in degrees, may obstruct contractions. */
constexpr double FlatAngle = 3;

/** An edge of the surface that may be contracted. */
struct Step
{
  double Length;
  Edge Ends;

  bool operator<(const Step& other) const
  {
    return std::tie(this->Length, this->Ends) < std::tie(other.Length, other.Ends);
  }
  bool operator==(const Step& other) const { return this->Ends == other.Ends; }
};

/** Shortest first. */
std::vector<Step> FindSteps(const RefinableMesh& mesh, double tolerance)
{
  std::vector<Step> steps;
  mesh.VisitFacets(
    [&](Id c, int k)
    {
      const Triangle f = FaceAcross(mesh.Cell(c).Corners, k);
      std::array<double, 3> lengths;
      for (int i = 0; i < 3; ++i)
      {
        lengths[i] = Distance(mesh.Points[f[i]], mesh.Points[f[(i + 1) % 3]]);
      }
      const double longest = *std::max_element(lengths.begin(), lengths.end());
      for (int i = 0; i < 3; ++i)
      {
        const Edge ends = EdgeBetween(f[i], f[(i + 1) % 3]);
        if (lengths[i] <= std::min(tolerance, LargestShare * longest))
        {
          steps.push_back({ lengths[i], ends });
        }
      }
    });
  SortUniquely(steps);
  return steps;
}

class StepContraction : public SurfaceOperator
{
public:
  using SurfaceOperator::SurfaceOperator;

  /** Contract an edge, if both ends still exist and it is possible. */
  bool Contract(Id point, Id target)
  {
    if (this->Mesh.CellAt(point) == None || this->Mesh.CellAt(target) == None)
    {
      return false;
    }
    const double wanted = std::max(this->InSolid.WorstAround(point), 0.0) * LeastShare;
    return this->OnSurface.ContractStep(point, target, wanted);
  }

  /** Cells between nearly coplanar points obstruct any move: replace them. */
  bool MakeRoom(Id point)
  {
    if (this->Mesh.CellAt(point) == None)
    {
      return false;
    }
    std::vector<Id> cells;
    this->Mesh.Star(point, cells);
    bool isChanged = false;
    for (const Id cell : cells)
    {
      isChanged |= !this->Mesh.IsDead(cell) &&
        ShapeOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners) < this->Flat &&
        this->Reconnect.ImproveCell(cell);
    }
    return isChanged;
  }

private:
  const double Flat = ShapeOfAngle(FlatAngle);
  SurfaceContraction OnSurface{ this->Mesh, this->Surface, this->Bound };
  Contraction InSolid{ this->Mesh };
  Reconnection Reconnect{ this->Mesh, this->Surface, this->Bound };
};
} // namespace

Id ContractSmallSteps(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  double tolerance, Monitor& monitor, const ProgressRange& progress)
{
  StepContraction contraction(mesh, surface, bound);
  Id count = 0;
  for (int round = 0; round < MostRounds; ++round)
  {
    const std::vector<Step> steps = FindSteps(mesh, tolerance);
    const LoopProgress looked(monitor, progress, steps.size());
    bool isChanged = false;
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      looked.Check(i);
      const auto [u, v] = steps[i].Ends;
      const bool isContracted = contraction.Contract(u, v) || contraction.Contract(v, u);
      count += isContracted ? 1 : 0;
      isChanged |= isContracted || contraction.MakeRoom(u) || contraction.MakeRoom(v);
    }
    if (!isChanged)
    {
      break;
    }
  }
  return count;
}
} // namespace insideout
