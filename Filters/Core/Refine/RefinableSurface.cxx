// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefinableSurface.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
/** A facet at an edge of the given mesh. */
struct RefinableSurface::EdgeUse
{
  Edge Ends;
  Id Facet;
  std::array<Id, 2> Regions; ///< regions on both sides, the second None outside
  Point Normal;              ///< equal for facets of the same regions on the same side

  bool operator<(const EdgeUse& other) const
  {
    return this->Ends != other.Ends ? this->Ends < other.Ends : this->Facet < other.Facet;
  }
};

namespace
{
constexpr double DegreesOfHalfTurn = 180;

/** Ridges of this many feature angles stay even if they end freely. */
constexpr double SharpAngles = 2;

double CosineOf(double degrees)
{
  return std::cos(degrees * std::acos(-1.0) / DegreesOfHalfTurn);
}

/** Whether the angle between two directions exceeds that of this cosine. */
bool DifferByMore(const Point& a, const Point& b, double cosine)
{
  return !(Dot(a, b) >= cosine * Length(a) * Length(b));
}
} // namespace

RefinableSurface::RefinableSurface(RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
  const std::vector<char>& locked, SurfaceTreatment treatment, double featureAngle)
  : Mesh(mesh)
  , Facets(facets)
  , Locked(locked)
  , How(treatment)
{
  this->FindPinched();
  this->FindRidges(featureAngle);
  this->SetKinds(featureAngle);
}

void RefinableSurface::FindPinched()
{
  // Elsewhere all cells around a point are reachable from each other.
  std::vector<char> isOnBoundary(this->Mesh.Points.size(), 0);
  const auto forEachCorner = [this](const auto& visit)
  {
    for (Id c = 0; c < this->Mesh.NumberOfCells(); ++c)
    {
      for (int k = 0; k < 4 && !this->Mesh.IsDead(c); ++k)
      {
        visit(this->Mesh.Cell(c), k);
      }
    }
  };
  forEachCorner(
    [&](const RefinableCell& cell, int k)
    {
      for (int i = 0; i < 3 && cell.Neighbors[k] == None; ++i)
      {
        isOnBoundary[FaceAcross(cell.Corners, k)[i]] = 1;
      }
    });
  std::vector<Id> around(isOnBoundary.size(), 0);
  forEachCorner([&](const RefinableCell& cell, int k)
    { around[cell.Corners[k]] += isOnBoundary[cell.Corners[k]]; });
  this->Pinched.assign(around.size(), 0);
  std::vector<Id> star;
  for (std::size_t p = 0; p < around.size(); ++p)
  {
    if (around[p] > 0)
    {
      star.clear();
      this->Mesh.Star(static_cast<Id>(p), star);
      this->Pinched[p] = star.size() < static_cast<std::size_t>(around[p]) ? 1 : 0;
    }
  }
}

bool RefinableSurface::MustBeRidge(const EdgeUse* first, const EdgeUse* last, double cosine) const
{
  if (this->How != SurfaceTreatment::Remeshed)
  {
    return last - first != 2 || first[0].Facet != first[1].Facet;
  }
  return last - first != 2 ||
    this->Facets[first[0].Facet].Label != this->Facets[first[1].Facet].Label ||
    first[0].Regions != first[1].Regions || DifferByMore(first[0].Normal, first[1].Normal, cosine);
}

void RefinableSurface::FindRidges(double featureAngle)
{
  std::vector<EdgeUse> uses;
  this->Mesh.VisitFacets(
    [&](Id c, int k)
    {
      const RefinableCell& cell = this->Mesh.Cell(c);
      const Id neighbor = cell.Neighbors[k];
      const Id beyond = neighbor == None ? None : this->Mesh.Cell(neighbor).Region;
      if (this->Mesh.HasPiece(c, k))
      {
        const Triangle f = FaceAcross(cell.Corners, k);
        const auto [a, b, d] = CornersOf(this->Mesh.Points, f);
        for (int i = 0; i < 3; ++i)
        {
          uses.push_back({ EdgeBetween(f[i], f[(i + 1) % 3]), cell.Facets[k],
            { { cell.Region, beyond } }, NormalOf(a, b, d) });
        }
      }
    });
  std::sort(uses.begin(), uses.end());
  const double cosine = CosineOf(featureAngle);
  const double sharp = CosineOf(std::min(SharpAngles * featureAngle, DegreesOfHalfTurn));
  std::unordered_set<Edge, HashOfEdge> blunt;
  for (auto first = uses.begin(); first != uses.end();)
  {
    const auto last =
      std::find_if(first, uses.end(), [&](const EdgeUse& use) { return use.Ends != first->Ends; });
    const auto ofBoundary =
      std::count_if(first, last, [](const EdgeUse& use) { return use.Regions[1] == None; });
    const bool isKept = ofBoundary > 2 ||
      std::any_of(first, last, [&](const EdgeUse& use) { return this->IsLocked(use.Facet); });
    if (isKept || this->MustBeRidge(&*first, &*first + (last - first), cosine))
    {
      this->AddRidge(first->Ends[0], first->Ends[1], isKept);
      if (!isKept && !this->MustBeRidge(&*first, &*first + (last - first), sharp))
      {
        blunt.insert(first->Ends);
      }
    }
    first = last;
  }
  if (this->How == SurfaceTreatment::Remeshed)
  {
    this->DropLooseEnds(blunt);
  }
}

/** Remove lines of blunt ridges from their loose ends on. */
void RefinableSurface::DropLooseEnds(const std::unordered_set<Edge, HashOfEdge>& blunt)
{
  std::vector<Id> points;
  for (const auto& [point, ends] : this->RidgeEnds)
  {
    points.push_back(point);
  }
  for (Id point : points)
  {
    for (const std::vector<Id>* ends = &this->RidgeEnds[point];
         ends->size() == 1 && blunt.count(EdgeBetween(point, ends->front())) > 0;
         ends = &this->RidgeEnds[point])
    {
      const Id next = ends->front();
      this->RemoveRidge(point, next);
      point = next;
    }
  }
}

void RefinableSurface::SetKinds(double featureAngle)
{
  this->Mesh.Kinds.assign(this->Mesh.Points.size(), PointKind::Free);
  this->Mesh.VisitFacets(
    [&](Id c, int k)
    {
      const RefinableCell& cell = this->Mesh.Cell(c);
      const bool isFixed =
        this->How != SurfaceTreatment::Remeshed || this->IsLocked(cell.Facets[k]);
      for (const Id corner : FaceAcross(cell.Corners, k))
      {
        PointKind& kind = this->Mesh.Kinds[corner];
        kind = isFixed || this->IsPinched(corner) ? PointKind::Fixed
          : kind == PointKind::Free               ? PointKind::InFacet
                                                  : kind;
      }
    });
  // A ridge continues where two of its edges meet at a blunt angle.
  std::vector<std::array<Id, 2>> ends(this->Mesh.Points.size(), { { None, None } });
  for (const auto& [edge, isKept] : this->Ridges)
  {
    for (int i = 0; i < 2; ++i)
    {
      PointKind& kind = this->Mesh.Kinds[edge[i]];
      std::array<Id, 2>& others = ends[edge[i]];
      kind = kind == PointKind::Fixed || isKept || others[1] != None ? PointKind::Fixed
                                                                     : PointKind::OnRidge;
      others[others[0] == None ? 0 : 1] = edge[1 - i];
    }
  }
  const double cosine = CosineOf(featureAngle);
  const std::vector<Point>& points = this->Mesh.Points;
  for (std::size_t p = 0; p < ends.size(); ++p)
  {
    if (this->Mesh.Kinds[p] == PointKind::OnRidge &&
      (ends[p][1] == None ||
        DifferByMore(Difference(points[p], points[ends[p][0]]),
          Difference(points[ends[p][1]], points[p]), cosine)))
    {
      this->Mesh.Kinds[p] = PointKind::Fixed;
    }
  }
}

void RefinableSurface::AddRidge(Id u, Id v, bool isLocked)
{
  if (this->Ridges.emplace(EdgeBetween(u, v), isLocked).second)
  {
    this->RidgeEnds[u].push_back(v);
    this->RidgeEnds[v].push_back(u);
  }
}

void RefinableSurface::RemoveRidge(Id u, Id v)
{
  this->Ridges.erase(EdgeBetween(u, v));
  for (const auto& [from, to] : { std::pair(u, v), std::pair(v, u) })
  {
    std::vector<Id>& ends = this->RidgeEnds[from];
    ends.erase(std::find(ends.begin(), ends.end(), to));
  }
}

bool RefinableSurface::IsLocked(Id u, Id v) const
{
  if (this->How == SurfaceTreatment::Kept)
  {
    return true;
  }
  const auto found = this->Ridges.find(EdgeBetween(u, v));
  return found != this->Ridges.end() && found->second;
}

void RefinableSurface::Split(Id u, Id v, Id middle)
{
  if (this->IsRidge(u, v))
  {
    this->RemoveRidge(u, v);
    this->AddRidge(u, middle, false);
    this->AddRidge(middle, v, false);
  }
}

/** The other ends of the ridges at a point, in the order of their ids. */
std::vector<Id> RefinableSurface::RidgesFrom(Id point) const
{
  const auto found = this->RidgeEnds.find(point);
  std::vector<Id> ends = found == this->RidgeEnds.end() ? std::vector<Id>() : found->second;
  std::sort(ends.begin(), ends.end());
  return ends;
}

bool RefinableSurface::MayContract(Id point, Id target) const
{
  const PointKind kind = this->Mesh.Kinds[point];
  const bool isRidge = this->IsRidge(point, target);
  if ((kind != PointKind::InFacet && !(kind == PointKind::OnRidge && isRidge)) ||
    this->IsPinched(target) || this->IsLocked(point, target))
  {
    return false;
  }
  const std::vector<Id> ends = this->RidgesFrom(point);
  return std::none_of(
    ends.begin(), ends.end(), [&](Id end) { return end != target && this->IsRidge(target, end); });
}

bool RefinableSurface::MayLeave(Id point) const
{
  const std::vector<Id> ends = this->RidgesFrom(point);
  return !this->IsPinched(point) &&
    std::none_of(ends.begin(), ends.end(), [&](Id end) { return this->IsLocked(point, end); });
}

void RefinableSurface::Contract(Id point, Id target)
{
  for (const Id end : this->RidgesFrom(point))
  {
    this->RemoveRidge(point, end);
    if (end != target)
    {
      this->AddRidge(target, end, false);
    }
  }
}
} // namespace insideout
