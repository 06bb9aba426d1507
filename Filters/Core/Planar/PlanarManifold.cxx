// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarManifold.h"

#include "Common/LoopProgress.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"

#include <algorithm>

namespace insideout
{
PlanarManifold::PlanarManifold(std::size_t points, const PlanarMesh& mesh)
  : Mesh(mesh)
  , CellsOfPoints(points,
      [&](auto visit)
      {
        for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
        {
          for (const Id point : mesh.Cells[c])
          {
            visit(static_cast<std::size_t>(point), static_cast<Id>(c));
          }
        }
      })
  , IsWaiting(points, 0)
{
}

/** Whether the point is manifold if the label of cell `flipped` is flipped. */
int PlanarManifold::BoundaryEdges(const GreedyLabels& labels, Id point, Id flipped) const
{
  const auto isInside = [&](Id cell)
  { return cell != None && labels.IsInside(cell) != (cell == flipped); };
  int edges = 0;
  for (const Id cell : this->CellsOfPoints[point])
  {
    for (int k = 0; isInside(cell) && k < 3; ++k)
    {
      const Segment edge = EdgeOf(this->Mesh.Cells[cell], k);
      edges += (edge[0] == point || edge[1] == point) && !isInside(this->Mesh.Neighbors[cell][k]);
    }
  }
  return edges;
}

bool PlanarManifold::Allows(const GreedyLabels& labels, Id cell)
{
  const Triangle& corners = this->Mesh.Cells[cell];
  return std::all_of(corners.begin(), corners.end(),
    [&](Id point)
    { return this->BoundaryEdges(labels, point, cell) <= 2 || !this->IsManifold(labels, point); });
}

void PlanarManifold::Changed(Id cell)
{
  for (const Id point : this->Mesh.Cells[cell])
  {
    if (!this->IsWaiting[point])
    {
      this->IsWaiting[point] = 1;
      this->Waiting.push_back(point);
    }
  }
}

/** Release forced cells, the last first, that the point does not need. */
void PlanarManifold::TakeBack(GreedyLabels& labels, std::vector<Id>& forced, Id point) const
{
  for (std::size_t k = forced.size(); k-- > 0;)
  {
    labels.TakeBack(forced[k]);
    if (this->IsManifold(labels, point))
    {
      forced.erase(forced.begin() + static_cast<std::ptrdiff_t>(k));
    }
    else
    {
      labels.Force(forced[k]);
    }
  }
}

/** Repair a point. @return whether it is manifold now */
bool PlanarManifold::Fill(GreedyLabels& labels, Id point) const
{
  std::vector<Id> outside;
  for (const Id cell : this->CellsOfPoints[point])
  {
    if (!labels.IsInside(cell) && labels.MayBeInside(cell))
    {
      outside.push_back(cell);
    }
  }
  std::stable_sort(
    outside.begin(), outside.end(), [&](Id a, Id b) { return labels.W(a) > labels.W(b); });
  std::vector<Id> forced;
  bool isManifold = false;
  for (std::size_t k = 0; k < outside.size() && !isManifold; ++k)
  {
    labels.Force(outside[k]);
    forced.push_back(outside[k]);
    isManifold = this->IsManifold(labels, point);
  }
  if (isManifold)
  {
    this->TakeBack(labels, forced, point);
  }
  if (!forced.empty())
  {
    labels.Keep(forced.front());
    labels.ImproveAround(forced);
  }
  return isManifold;
}

ManifoldConstraint::Outcome PlanarManifold::Satisfy(
  GreedyLabels& labels, Monitor& monitor, double begin, double end)
{
  const Id points = static_cast<Id>(this->CellsOfPoints.Size());
  const LoopProgress progress(
    monitor, { Stages::Segmenting, begin, end }, static_cast<std::size_t>(points));
  for (Id point = points; point-- > 0;)
  {
    this->IsWaiting[point] = 1;
    this->Waiting.push_back(point);
  }
  labels.Add(*this);
  ManifoldConstraint::Outcome outcome;
  std::vector<Id> failed;
  for (std::size_t visits = 0; !this->Waiting.empty(); ++visits)
  {
    progress.Check(visits);
    const Id point = this->Waiting.back();
    this->Waiting.pop_back();
    this->IsWaiting[point] = 0;
    if (!this->IsManifold(labels, point))
    {
      ++outcome.Points;
      if (!this->Fill(labels, point))
      {
        failed.push_back(point);
      }
    }
  }
  labels.ReleaseAndImprove();
  SortUniquely(failed);
  outcome.LeftPoints = static_cast<Id>(std::count_if(
    failed.begin(), failed.end(), [&](Id point) { return !this->IsManifold(labels, point); }));
  return outcome;
}
} // namespace insideout
