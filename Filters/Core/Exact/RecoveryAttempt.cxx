// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoveryAttempt.h"

#include "Exact/FlipTwins.h"
#include "Exact/RecoverConstraints.h"
#include "Exact/RecoverLostFacets.h"

#include <numeric>

namespace insideout
{
RecoveryAttempt::RecoveryAttempt(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, std::int64_t workPerElement, Monitor& monitor)
  : Points(points)
  , Progress(monitor)
  , Work(workPerElement * static_cast<std::int64_t>(points.size() + facets.size()))
  , Constrained(points, facets, this->Work, monitor)
{
}

bool RecoveryAttempt::Run(SegmentRecovery::From from)
{
  std::vector<Id> all(this->Constrained.Facets.size());
  std::iota(all.begin(), all.end(), 0);
  ConstraintRecovery recovery(this->Constrained, this->Random, this->Progress);
  if (!recovery.RecoverAndRound(all, from, false, -1, this->GivenUp))
  {
    return false;
  }
  LostFacetRecovery(this->Constrained, this->Random, this->Progress).Recover(this->Points, from);
  FlipTwinsAway(this->Constrained);
  this->Constrained.FindLost(this->Progress); // marks facets that flips made faces by chance
  return true;
}

namespace
{
/** The faces that facets lie on, each from the one of its two cells that comes first. */
void CollectFaces(const FlippableMesh& mesh, const std::vector<Id>& renamed, RawTetrahedra& result)
{
  for (Id id = 0; id < mesh.NumberOfCells(); ++id)
  {
    const FlippableCell& cell = mesh.Cell(id);
    for (int k = 0; !mesh.IsDead(id) && k < 4; ++k)
    {
      if (cell.Facets[k] == None || cell.Neighbors[k] < id)
      {
        continue;
      }
      result.Faces.push_back(mesh.FaceCorners(id, k));
      for (Id& corner : result.Faces.back())
      {
        corner = renamed[corner];
      }
      result.FacetOfFaces.push_back(cell.Facets[k]);
    }
  }
}
} // namespace

RawTetrahedra RecoveryAttempt::Result() const
{
  const FlippableMesh& mesh = this->Constrained.Mesh;
  RawTetrahedra result;
  result.Points = this->Points;
  std::vector<Id> renamed(static_cast<std::size_t>(mesh.Vertices().Size()), None);
  std::iota(renamed.begin(), renamed.begin() + mesh.Infinite(), 0);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (mesh.IsDead(cell) || mesh.IsInfinite(cell))
    {
      continue;
    }
    result.Cells.push_back(mesh.Cell(cell).Corners);
    for (Id& corner : result.Cells.back())
    {
      if (renamed[corner] == None)
      {
        renamed[corner] = static_cast<Id>(result.Points.size());
        result.Points.push_back(mesh.Vertices().Nearest(corner));
      }
      corner = renamed[corner];
    }
  }
  CollectFaces(mesh, renamed, result);
  return result;
}
} // namespace insideout
