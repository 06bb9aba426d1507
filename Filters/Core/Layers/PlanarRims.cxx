// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/PlanarRims.h"

#include "Common/Buckets.h"
#include "Common/Vectors.h"

#include <algorithm>

namespace insideout
{
namespace
{
class RimFinder
{
public:
  RimFinder(const std::vector<Point>& flat, const PlanarMesh& mesh, const std::vector<Id>& wall)
    : Flat(flat)
    , All(ConstraintsOf(mesh, wall))
    , At(flat.size(),
        [this](auto visit)
        {
          for (std::size_t c = 0; c < this->All.size(); ++c)
          {
            visit(static_cast<std::size_t>(this->All[c].Ends[0]), static_cast<Id>(c));
            visit(static_cast<std::size_t>(this->All[c].Ends[1]), static_cast<Id>(c));
          }
        })
    , IsOfRun(this->All.size(), 0)
  {
    this->Rims.AtPoints.resize(flat.size());
  }

  PlanarRims Find()
  {
    std::vector<Id> begins;
    std::vector<Id> ends;
    for (std::size_t p = 0; p < this->At.Size(); ++p)
    {
      const auto around = this->At[p];
      const bool isOfWall =
        std::any_of(around.begin(), around.end(), [this](Id c) { return this->All[c].IsWall; });
      if (!isOfWall)
      {
        continue;
      }
      const Id point = static_cast<Id>(p);
      const bool isPlain = this->IsPlain(point);
      this->Rims.AtPoints[p].IsHeld = !isPlain;
      for (const Id c : around)
      {
        if (isPlain && !this->All[c].IsWall)
        {
          (this->All[c].Ends[0] == point ? begins : ends).push_back(point);
        }
      }
    }
    for (const Id point : begins)
    {
      this->AddRun(point, 1);
    }
    for (const Id point : ends)
    {
      this->AddRun(point, 0);
    }
    for (std::size_t c = 0; c < this->All.size(); ++c)
    {
      if (this->IsOfRun[c] == 0)
      {
        this->Rims.Constraints.push_back(this->All[c]);
      }
    }
    return std::move(this->Rims);
  }

private:
  static std::vector<PlanarConstraint> ConstraintsOf(
    const PlanarMesh& mesh, const std::vector<Id>& wall)
  {
    std::vector<PlanarConstraint> constraints;
    for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Id beyond = mesh.Neighbors[cell][k];
        if (mesh.Segments[cell][k] != None && (beyond == None || cell < beyond))
        {
          const Id edge = 3 * cell + k;
          constraints.push_back({ EdgeOf(mesh.Cells[cell], k), edge, mesh.Segments[cell][k],
            beyond == None, std::binary_search(wall.begin(), wall.end(), edge) });
        }
      }
    }
    return constraints;
  }

  /** Whether two edges of the boundary meet at a point, and nothing else. */
  bool IsPlain(Id point) const
  {
    const auto around = this->At[point];
    return around.Size() == 2 && this->All[around.begin()[0]].IsOuter &&
      this->All[around.begin()[1]].IsOuter;
  }

  /** The constraint at a plain point that begins (end 0) or ends (1) there. */
  Id ConstraintAt(Id point, int end) const
  {
    const auto around = this->At[point];
    const Id first = around.begin()[0];
    return this->All[first].Ends[end] == point ? first : around.begin()[1];
  }

  Point Way(Id from, Id to) const { return Difference(this->Flat[to], this->Flat[from]); }

  bool IsStraight(Id start, Id middle, Id next) const
  {
    const Point way = this->Way(start, middle);
    const Point on = this->Way(middle, next);
    return Dot(way, on) > 0 && Length(Cross(way, on)) <= SineInPlane * Length(way) * Length(on);
  }

  /** Add the run from a plain point of the wall, forward (1) or backward (0) along the boundary. */
  void AddRun(Id start, int forward)
  {
    PlanarRun run{ { start }, {}, true, false };
    std::vector<Id> chain;
    while (this->IsPlain(run.Points.back()))
    {
      const Id last = run.Points.back();
      const Id c = this->ConstraintAt(last, 1 - forward);
      const Id next = this->All[c].Ends[forward];
      const bool goesOn = chain.empty() ||
        (this->All[c].Label == this->All[chain.front()].Label &&
          this->IsStraight(start, last, next));
      run.EndsAtWall = this->All[c].IsWall;
      if (this->All[c].IsWall || this->IsOfRun[c] != 0 || !goesOn)
      {
        break;
      }
      chain.push_back(c);
      run.Points.push_back(next);
    }
    if (chain.empty())
    {
      return; // the run from the other end is this one
    }
    this->SetRim(start, run.Points.back());
    if (run.EndsAtWall)
    {
      this->SetRim(run.Points.back(), start);
    }
    for (const Id c : chain)
    {
      this->IsOfRun[c] = 1;
      run.Edges.push_back(this->All[c].Edge);
    }
    if (forward == 0)
    {
      std::reverse(run.Points.begin(), run.Points.end());
      std::reverse(run.Edges.begin(), run.Edges.end());
      std::swap(run.BeginsAtWall, run.EndsAtWall);
    }
    this->Rims.Runs.push_back(run);
  }

  /** A point of the wall moves along the way to another point, unless that leads outward. */
  void SetRim(Id point, Id other)
  {
    const Point way = this->Way(point, other);
    const double length = Length(way);
    for (const Id c : this->At[point])
    {
      if (this->All[c].IsWall)
      {
        const Point edge = this->Way(this->All[c].Ends[0], this->All[c].Ends[1]);
        this->Rims.AtPoints[point].IsHeld = !(edge[0] * way[1] - edge[1] * way[0] > 0);
      }
    }
    this->Rims.AtPoints[point].Normals = { { { -way[1] / length, way[0] / length, 0 } } };
  }

  const std::vector<Point>& Flat;
  const std::vector<PlanarConstraint> All;
  const Buckets<Id> At;
  std::vector<char> IsOfRun;
  PlanarRims Rims;
};
} // namespace

PlanarRims FindPlanarRims(
  const std::vector<Point>& flat, const PlanarMesh& mesh, const std::vector<Id>& wall)
{
  return RimFinder(flat, mesh, wall).Find();
}
} // namespace insideout
