// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefinableMesh.h"

namespace insideout
{
void CellExchange::Clear()
{
  this->Old.clear();
  this->Fresh.clear();
  this->Models.clear();
  this->Gone.clear();
  this->Facets.clear();
}

void CellExchange::Add(const Tetrahedron& fresh, Id model)
{
  this->Fresh.push_back(fresh);
  this->Models.push_back(model);
}

Id RefinableMesh::AddPoint(const Point& place, PointKind kind, double size)
{
  this->Points.push_back(place);
  this->Kinds.push_back(kind);
  this->Sizes.push_back(size);
  this->AppendVertex(this->Own.Changes);
  return static_cast<Id>(this->Points.size() - 1);
}

void RefinableMesh::StarWithWalls(
  Id point, std::vector<Id>& cells, std::vector<Triangle>& walls) const
{
  cells.clear();
  walls.clear();
  this->Star(point, cells);
  for (const Id cell : cells)
  {
    walls.push_back(this->FaceCorners(cell, this->CornerIndex(cell, point)));
  }
}

void RefinableMesh::Move(Id point, const Point& place, const std::vector<Triangle>& walls)
{
  ++this->Own.Changes;
  this->Points[point] = place;
  this->ChangeAround[point] = this->Own.Changes;
  for (const Triangle& wall : walls)
  {
    for (const Id corner : wall)
    {
      this->ChangeAround[corner] = this->Own.Changes;
    }
  }
}

void RefinableMesh::Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh)
{
  this->Replace({ old, fresh, {}, {} }, [&](std::size_t) { return old.front(); });
}

void RefinableMesh::Replace(const CellExchange& exchange)
{
  this->Replace({ exchange.Old, exchange.Fresh, exchange.Gone, exchange.Facets },
    [&](std::size_t i) { return exchange.Models[i]; });
}

template <class ModelOf>
void RefinableMesh::Replace(const Replacement& replacement, const ModelOf& modelOf)
{
  const auto contentOf = [&](std::size_t i, Id id)
  {
    const RefinableCell& model = this->Cells[modelOf(i)];
    const bool isNew = id >= this->NumberOfCells();
    const Id version = isNew ? 0 : this->Cells[id].Version + (this->IsDead(id) ? 0 : 1);
    return SolidPolicy::Content{ model.Region, model.Parent, version };
  };
  Mesh::Replace(replacement, contentOf, this->Own);
  for (const Id cell : replacement.Old)
  {
    this->Cells[cell].Version += this->IsDead(cell) ? 1 : 0;
  }
}
} // namespace insideout
