// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ContractOnSurface.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>

namespace insideout
{
namespace
{
template <class Corners>
bool Has(const Corners& corners, Id point)
{
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}
} // namespace

void SurfaceContraction::Look(Id point, Around& around) const
{
  around.Cells.clear();
  around.Points.clear();
  around.Edges.clear();
  around.FacetPoints.clear();
  around.FacetEdges.clear();
  this->Mesh.Star(point, around.Cells);
  for (const Id c : around.Cells)
  {
    const RefinableCell& cell = this->Mesh.Cell(c);
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] == point)
      {
        continue;
      }
      around.Points.push_back(cell.Corners[k]);
      const Triangle face = FaceAcross(cell.Corners, k);
      const int at = face[0] == point ? 0 : face[1] == point ? 1 : 2;
      const Edge across = EdgeBetween(face[(at + 1) % 3], face[(at + 2) % 3]);
      around.Edges.push_back(across);
      if (cell.Facets[k] != None)
      {
        around.FacetEdges.push_back(across);
        around.FacetPoints.insert(around.FacetPoints.end(), across.begin(), across.end());
      }
    }
  }
  SortUniquely(around.Points);
  SortUniquely(around.Edges);
  SortUniquely(around.FacetPoints);
  SortUniquely(around.FacetEdges);
}

/** Requires the surroundings of both points. */
bool SurfaceContraction::KeepsTopology(Id point, Id target)
{
  std::vector<Id> linkPoints;
  std::vector<Edge> linkEdges;
  std::vector<Id> linkOfFacets;
  for (const Id c : this->OfPoint.Cells)
  {
    const RefinableCell& cell = this->Mesh.Cell(c);
    if (!Has(cell.Corners, target))
    {
      continue;
    }
    std::array<int, 2> others;
    std::size_t found = 0;
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] != point && cell.Corners[k] != target)
      {
        others[found++] = k;
        linkPoints.push_back(cell.Corners[k]);
      }
    }
    for (int i = 0; i < 2; ++i)
    {
      // which contains both ends, and one that contains only the other
      if (cell.Facets[others[i]] != None)
      {
        linkOfFacets.push_back(cell.Corners[others[1 - i]]);
      }
    }
    linkEdges.push_back(EdgeBetween(cell.Corners[others[0]], cell.Corners[others[1]]));
  }
  SortUniquely(linkPoints);
  SortUniquely(linkEdges);
  SortUniquely(linkOfFacets);
  return InBoth(this->OfPoint.Points, this->OfTarget.Points) == linkPoints &&
    InBoth(this->OfPoint.Edges, this->OfTarget.Edges) == linkEdges &&
    InBoth(this->OfPoint.FacetPoints, this->OfTarget.FacetPoints) == linkOfFacets &&
    InBoth(this->OfPoint.FacetEdges, this->OfTarget.FacetEdges).empty();
}

bool SurfaceContraction::KeepsLengths(Id target, double longest) const
{
  const std::vector<double>& sizes = this->Mesh.Sizes;
  return std::all_of(this->OfPoint.FacetPoints.begin(), this->OfPoint.FacetPoints.end(),
    [&](Id other)
    {
      return Distance(this->Mesh.Points[other], this->Mesh.Points[target]) <=
        longest * 0.5 * (sizes[other] + sizes[target]);
    });
}

bool SurfaceContraction::MakeCells(Id point, Id target, double wanted)
{
  this->Exchange.Clear();
  this->Exchange.Old = this->OfPoint.Cells;
  for (const Id c : this->OfPoint.Cells)
  {
    Tetrahedron fresh = this->Mesh.Cell(c).Corners;
    if (!Has(fresh, target))
    {
      std::replace(fresh.begin(), fresh.end(), point, target);
      if (!(ShapeOf(this->Mesh.Points, fresh) > wanted) || Orient3D(this->Mesh.Points, fresh) <= 0)
      {
        return false;
      }
      this->Exchange.Add(fresh, c);
    }
  }
  return true;
}

/** The pieces that are removed and created. */
void SurfaceContraction::MakePieces(Id point, Id target)
{
  this->Gone.clear();
  this->Fresh.clear();
  this->Moved.clear();
  for (const Id c : this->OfPoint.Cells)
  {
    const RefinableCell& cell = this->Mesh.Cell(c);
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] == point || !this->Mesh.HasPiece(c, k))
      {
        continue;
      }
      this->Gone.push_back(PieceAt(this->Mesh, c, k));
      Triangle face = this->Gone.back().Corners;
      if (!Has(face, target))
      {
        this->Moved.push_back(this->Gone.back());
        std::replace(face.begin(), face.end(), point, target);
        this->Fresh.push_back({ face, CornersOf(this->Mesh.Points, face), cell.Facets[k] });
      }
    }
  }
}

/** Make the new cells, and check both ends. The cheapest checks come first: most contractions are
 * refused. */
bool SurfaceContraction::Approach(Id point, Id target, double wanted)
{
  this->OfPoint.Cells.clear();
  this->Mesh.Star(point, this->OfPoint.Cells);
  if (!this->MakeCells(point, target, wanted))
  {
    return false;
  }
  this->Look(point, this->OfPoint);
  this->Look(target, this->OfTarget);
  return std::binary_search(
    this->OfPoint.FacetPoints.begin(), this->OfPoint.FacetPoints.end(), target);
}

void SurfaceContraction::Replace()
{
  ExchangePieces(this->Gone, this->Fresh, this->Exchange);
  this->Bound.Replace();
  this->Mesh.Replace(this->Exchange);
}

bool SurfaceContraction::Contract(Id point, Id target, double wanted, double longest)
{
  if (!this->Surface.MayContract(point, target))
  {
    return false;
  }
  const bool isRidge = this->Surface.IsRidge(point, target);
  if (!this->Approach(point, target, wanted) || !this->KeepsLengths(target, longest) ||
    !this->KeepsTopology(point, target))
  {
    return false;
  }
  this->MakePieces(point, target);
  if (!(isRidge ? this->Bound.AllowsEach(this->Moved, this->Gone, this->Fresh)
                : this->Bound.Allows(this->Gone, this->Fresh)))
  {
    return false;
  }
  this->Surface.Contract(point, target);
  this->Replace();
  return true;
}

bool SurfaceContraction::ContractStep(Id point, Id target, double wanted)
{
  if (!this->Surface.MayLeave(point) || this->Surface.IsPinched(target) ||
    !this->Approach(point, target, wanted) || !this->KeepsTopology(point, target))
  {
    return false;
  }
  this->MakePieces(point, target);
  if (!this->KeepsLabels(this->Gone, this->Moved) ||
    !this->Bound.AllowsEach(this->Moved, this->Gone, this->Fresh))
  {
    return false;
  }
  this->Surface.Contract(point, target);
  this->Mesh.Kinds[target] = PointKind::Fixed;
  this->Replace();
  return true;
}

bool SurfaceContraction::Remove(Id point, double wanted, double longest)
{
  this->Look(point, this->OfPoint);
  const std::vector<Id> targets = this->OfPoint.FacetPoints;
  return std::any_of(targets.begin(), targets.end(),
    [&](Id target) { return this->Contract(point, target, wanted, longest); });
}
} // namespace insideout
