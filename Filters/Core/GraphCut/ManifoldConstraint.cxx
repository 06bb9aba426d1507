// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/ManifoldConstraint.h"

#include "Common/Error.h"
#include "Common/LoopProgress.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Stages.h"

#include <algorithm>

namespace insideout
{
namespace
{
using LinkEdge = std::pair<Id, Id>;

/**
 * The first point of the link, from `above` on, at which several of its edges begin; None if there
 * is none.
 */
Id FindBranch(const std::vector<LinkEdge>& link, Id above)
{
  auto edge = std::lower_bound(link.begin(), link.end(), LinkEdge(above, None));
  for (; edge != link.end() && edge + 1 != link.end(); ++edge)
  {
    if (edge->first == (edge + 1)->first)
    {
      return edge->first;
    }
  }
  return None;
}

/** Whether the link, which has no branches, is one circle or empty. */
bool IsOneCircle(const std::vector<LinkEdge>& link)
{
  std::size_t length = 0;
  for (Id at = link.empty() ? None : link.front().first; at != None;)
  {
    ++length;
    at = std::lower_bound(link.begin(), link.end(), LinkEdge(at, None))->second;
    at = at == link.front().first ? None : at;
  }
  return length == link.size();
}

bool IsManifold(const std::vector<LinkEdge>& link)
{
  return FindBranch(link, 0) == None && IsOneCircle(link);
}

/**
 * Tells the two sides of a face apart: whether sorting its corners reverses it as seen from the
 * cell.
 */
bool IsTurned(const Tetrahedron& cell, int face)
{
  return SortedTriangle(FaceOf(cell, face)).Turned;
}

bool Has(const Tetrahedron& cell, Id point)
{
  return std::find(cell.begin(), cell.end(), point) != cell.end();
}
} // namespace

ManifoldConstraint::Queue::Queue(std::size_t points)
  : IsWaiting(points, 0)
{
}

void ManifoldConstraint::Queue::Push(Id point)
{
  if (!this->IsWaiting[point])
  {
    this->IsWaiting[point] = 1;
    this->Points.push_back(point);
  }
}

Id ManifoldConstraint::Queue::Pop()
{
  const Id point = this->Points.front();
  this->Points.pop_front();
  this->IsWaiting[point] = 0;
  return point;
}

ManifoldConstraint::ManifoldConstraint(std::size_t points, const std::vector<Tetrahedron>& cells,
  const std::vector<std::array<Id, 4>>& neighbors)
  : Cells(cells)
  , Neighbors(neighbors)
  , CellsOfPoints(points,
      [&](auto visit)
      {
        for (std::size_t c = 0; c < cells.size(); ++c)
        {
          for (const Id point : cells[c])
          {
            visit(static_cast<std::size_t>(point), static_cast<Id>(c));
          }
        }
      })
  , WithEdges(points)
  , Alone(points)
{
  this->CheckThatCellsAreApart();
}

void ManifoldConstraint::CheckThatCellsAreApart() const
{
  for (Id cell = 0; cell < static_cast<Id>(this->Cells.size()); ++cell)
  {
    for (int face = 0; face < 4; ++face)
    {
      const Id next = this->Neighbors[cell][face];
      if (next < cell) // each face once, none on the hull
      {
        continue;
      }
      const auto back = std::find(this->Neighbors[next].begin(), this->Neighbors[next].end(), cell);
      const int faceOfNext = static_cast<int>(back - this->Neighbors[next].begin());
      if (IsTurned(this->Cells[cell], face) == IsTurned(this->Cells[next], faceOfNext))
      {
        throw Error(ErrorCode::InvalidParameter,
          "cells " + std::to_string(cell) + " and " + std::to_string(next) +
            " are on one side of the face that they share: nothing tells their boundary");
      }
    }
  }
}

/** The link, sorted, as it is when the label of cell `flipped` is flipped. */
std::vector<LinkEdge> ManifoldConstraint::LinkOf(
  const GreedyLabels& labels, Id point, Id flipped) const
{
  const auto isInside = [&](Id cell)
  { return cell != None && labels.IsInside(cell) != (cell == flipped); };
  std::vector<LinkEdge> link;
  for (const Id cell : this->CellsOfPoints[point])
  {
    for (int face = 0; isInside(cell) && face < 4; ++face)
    {
      if (isInside(this->Neighbors[cell][face]))
      {
        continue;
      }
      for (int corner = 0; corner < 3; ++corner)
      {
        const auto at = [&](int i)
        { return this->Cells[cell][TetrahedronFaces[face][(corner + i) % 3]]; };
        if (at(0) == point)
        {
          link.emplace_back(at(1), at(2));
        }
      }
    }
  }
  std::sort(link.begin(), link.end());
  return link;
}

bool ManifoldConstraint::IsManifold(const GreedyLabels& labels, Id point, Id other) const
{
  const std::vector<LinkEdge> link = this->LinkOf(labels, point);
  return other == None ? insideout::IsManifold(link) : FindBranch(link, other) != other;
}

/** Whether the point and its edges stay manifold, if they are, when the cell is flipped. */
bool ManifoldConstraint::Keeps(const GreedyLabels& labels, Id cell, Id point) const
{
  const std::vector<LinkEdge> after = this->LinkOf(labels, point, cell);
  if (insideout::IsManifold(after))
  {
    return true;
  }
  const std::vector<LinkEdge> before = this->LinkOf(labels, point);
  if (insideout::IsManifold(before))
  {
    return false;
  }
  for (Id branch = FindBranch(after, 0); branch != None; branch = FindBranch(after, branch + 1))
  {
    if (FindBranch(before, branch) != branch)
    {
      return false;
    }
  }
  return true;
}

bool ManifoldConstraint::Allows(const GreedyLabels& labels, Id cell)
{
  return std::all_of(this->Cells[cell].begin(), this->Cells[cell].end(),
    [&](Id point) { return this->Keeps(labels, cell, point); });
}

void ManifoldConstraint::Changed(Id cell)
{
  for (const Id point : this->Cells[cell])
  {
    this->WithEdges.Push(point);
    this->Alone.Push(point);
  }
}

/** Release forced cells, the last first, that the point (or its edge to another point) does not
 * need. */
void ManifoldConstraint::TakeBack(
  GreedyLabels& labels, std::vector<Id>& forced, Id point, Id other) const
{
  for (std::size_t k = forced.size(); k-- > 0;)
  {
    labels.TakeBack(forced[k]);
    if (this->IsManifold(labels, point, other))
    {
      forced.erase(forced.begin() + static_cast<std::ptrdiff_t>(k));
    }
    else
    {
      labels.Force(forced[k]);
    }
  }
}

/** Repair a point, or its edge to another point. @return whether it is manifold now */
bool ManifoldConstraint::Fill(GreedyLabels& labels, Id point, Id other) const
{
  std::vector<Id> outside;
  for (const Id cell : this->CellsOfPoints[point])
  {
    if (!labels.IsInside(cell) && labels.MayBeInside(cell) &&
      (other == None || Has(this->Cells[cell], other)))
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
    isManifold = this->IsManifold(labels, point, other);
  }
  if (isManifold)
  {
    this->TakeBack(labels, forced, point, other);
  }
  if (!forced.empty())
  {
    labels.Keep(forced.front());
    labels.ImproveAround(forced);
  }
  return isManifold;
}

void ManifoldConstraint::VisitEdges(GreedyLabels& labels, Id point, Outcome& outcome)
{
  Id branch = FindBranch(this->LinkOf(labels, point), 0);
  while (branch != None)
  {
    ++outcome.Edges;
    const bool filled = this->Fill(labels, point, branch);
    branch = FindBranch(this->LinkOf(labels, point), filled ? 0 : branch + 1);
  }
}

void ManifoldConstraint::VisitPoint(GreedyLabels& labels, Id point, Outcome& outcome)
{
  if (!this->IsManifold(labels, point, None))
  {
    ++outcome.Points;
    if (!this->Fill(labels, point, None))
    {
      this->Failed.push_back(point);
    }
  }
}

ManifoldConstraint::Outcome ManifoldConstraint::Satisfy(
  GreedyLabels& labels, Monitor& monitor, double begin, double end)
{
  const Id points = static_cast<Id>(this->CellsOfPoints.Size());
  const LoopProgress progress(
    monitor, { Stages::Segmenting, begin, end }, 2 * static_cast<std::size_t>(points));
  for (Id point = 0; point < points; ++point)
  {
    this->WithEdges.Push(point);
    this->Alone.Push(point);
  }
  labels.Add(*this);
  Outcome outcome;
  for (std::size_t visits = 0; !this->WithEdges.IsEmpty() || !this->Alone.IsEmpty(); ++visits)
  {
    progress.Check(visits);
    if (!this->WithEdges.IsEmpty())
    {
      this->VisitEdges(labels, this->WithEdges.Pop(), outcome);
    }
    else
    {
      this->VisitPoint(labels, this->Alone.Pop(), outcome);
    }
  }
  labels.ReleaseAndImprove();
  SortUniquely(this->Failed);
  outcome.LeftPoints = static_cast<Id>(std::count_if(this->Failed.begin(), this->Failed.end(),
    [&](Id point) { return !this->IsManifold(labels, point, None); }));
  return outcome;
}
} // namespace insideout
