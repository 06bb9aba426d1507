// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/MakeLayeredMesh.h"

#include "Common/Stages.h"
#include "Layers/LayerColumns.h"
#include "Refine/LocateCells.h"

#include <utility>

namespace insideout
{
namespace
{
class LayeredMeshMaker
{
public:
  explicit LayeredMeshMaker(const PushedSolid& solid)
    : Solid(solid)
    , Layers(static_cast<Id>(solid.Fractions.size()) - 1)
    , Outer(solid.Mesh.Points.size(), None)
    , FirstBorder(solid.Mesh.Points.size(), None)
  {
  }

  LayeredMesh Make(Monitor& monitor)
  {
    this->AddPoints();
    this->AddCellsBehind();
    for (std::size_t t = 0; t < this->Solid.Wall.Triangles.size(); ++t)
    {
      this->AddColumn(this->Solid.Wall.Triangles[t], this->Solid.WallFaces[t] / 4);
    }
    this->JoinCells();
    for (const RimEdge& edge : this->Solid.Rim)
    {
      this->AddSides(edge);
    }
    this->Locate(monitor);
    return std::move(this->Result);
  }

private:
  bool IsLifted(Id point) const { return this->FirstBorder[point] != None; }

  /** The id of a point of the wall on a border between layers, 0 for the wall. */
  Id OnBorder(Id point, Id border) const
  {
    return border == 0 || !this->IsLifted(point) ? this->Outer[point]
                                                 : this->FirstBorder[point] + border - 1;
  }

  void AddPoint(const Point& place, Id original, Id cell)
  {
    this->Result.Points.push_back(place);
    this->Result.OriginalPoints.push_back(original);
    this->Result.CellsOfPoints.push_back(cell);
  }

  void AddPoints()
  {
    const RefinableMesh& mesh = this->Solid.Mesh;
    const auto given = static_cast<Id>(this->Solid.Input.Points.size());
    for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); ++p)
    {
      if (mesh.CellAt(p) != None)
      {
        const bool isOfWall = (p < given) && (this->Solid.Pushed.Height(p) > 0);
        const Point& place = isOfWall ? this->Solid.Pushed.Outer(p) : mesh.Points[p];
        this->Outer[p] = static_cast<Id>(this->Result.Points.size());
        this->AddPoint(place, p < given && place == this->Solid.Input.Points[p] ? p : None,
          mesh.Cell(mesh.CellAt(p)).Parent);
      }
    }
    for (const Id p : this->Solid.Wall.Points)
    {
      if (this->Solid.Pushed.Height(p) > 0)
      {
        this->FirstBorder[p] = static_cast<Id>(this->Result.Points.size());
        for (Id border = 1; border <= this->Layers; ++border)
        {
          this->AddPoint(PlaceOnBorder(this->Solid.Pushed.Outer(p), mesh.Points[p],
                           this->Solid.Fractions[border]),
            None, this->Result.CellsOfPoints[this->Outer[p]]);
        }
      }
    }
    for (Id p = 0; p < given; ++p)
    {
      this->Result.PointsBeside.push_back(this->OnBorder(p, this->Layers));
    }
  }

  void AddCellsBehind()
  {
    const RefinableMesh& mesh = this->Solid.Mesh;
    for (Id c = 0; c < mesh.NumberOfCells(); ++c)
    {
      if (!mesh.IsDead(c))
      {
        Tetrahedron cell;
        for (int k = 0; k < 4; ++k)
        {
          cell[k] = this->OnBorder(mesh.Cell(c).Corners[k], this->Layers);
        }
        this->Result.Tetrahedra.push_back(cell);
        this->Result.OriginalCells.push_back(mesh.Cell(c).Parent);
        this->Result.Layers.push_back(0);
      }
    }
    this->Result.NumberOfCellsBehind = this->Result.Tetrahedra.size();
  }

  void AddColumn(const Triangle& triangle, Id cell)
  {
    int lifted = 0;
    int first = 0; // index of the only lifted corner, or of the only one that is not
    for (int k = 0; k < 3; ++k)
    {
      lifted += this->IsLifted(triangle[k]) ? 1 : 0;
    }
    for (int k = 0; k < 3; ++k)
    {
      first = this->IsLifted(triangle[k]) == (lifted == 1) ? k : first;
    }
    const Id a = triangle[first];
    const Id b = triangle[(first + 1) % 3];
    const Id c = triangle[(first + 2) % 3];
    for (Id layer = 1; layer <= this->Layers && lifted > 0; ++layer)
    {
      const auto below = [&](Id point) { return this->OnBorder(point, layer - 1); };
      const auto above = [&](Id point) { return this->OnBorder(point, layer); };
      if (lifted == 3)
      {
        this->Result.Prisms.push_back(
          { { below(a), below(b), below(c), above(a), above(b), above(c) } });
        this->OfPrisms.push_back({ cell, layer });
      }
      else if (lifted == 2)
      {
        this->Result.Pyramids.push_back({ { below(b), below(c), above(c), above(b), below(a) } });
        this->OfPyramids.push_back({ cell, layer });
      }
      else
      {
        this->Result.Tetrahedra.push_back({ { below(c), below(b), below(a), above(a) } });
        this->Result.OriginalCells.push_back(cell);
        this->Result.Layers.push_back(layer);
      }
    }
  }

  /** Add the quads along another facet; triangles where one end of the edge is not lifted. */
  void AddSides(const RimEdge& edge)
  {
    for (Id layer = 1; layer <= this->Layers; ++layer)
    {
      const Id from = this->OnBorder(edge.From, layer - 1);
      const Id to = this->OnBorder(edge.To, layer - 1);
      const Id fromAbove = this->OnBorder(edge.From, layer);
      const Id toAbove = this->OnBorder(edge.To, layer);
      if (from != fromAbove && to != toAbove)
      {
        this->Result.Sides.push_back({ { { from, fromAbove, toAbove, to } }, edge.Face });
      }
      else if (from != fromAbove || to != toAbove)
      {
        const Id above = from != fromAbove ? fromAbove : toAbove;
        this->Result.Sides.push_back({ { { from, above, to, None } }, edge.Face });
      }
    }
  }

  void JoinCells()
  {
    for (const auto* cells : { &this->OfPyramids, &this->OfPrisms })
    {
      for (const CellOfLayer& cell : *cells)
      {
        this->Result.OriginalCells.push_back(cell.Original);
        this->Result.Layers.push_back(cell.Layer);
      }
    }
  }

  template <std::size_t Size>
  void AppendMiddles(const std::vector<std::array<Id, Size>>& cells, std::vector<Point>& middles)
  {
    for (const auto& cell : cells)
    {
      Point middle = { { 0, 0, 0 } };
      for (const Id corner : cell)
      {
        for (int k = 0; k < 3; ++k)
        {
          middle[k] += this->Result.Points[corner][k] / static_cast<double>(Size);
        }
      }
      middles.push_back(middle);
    }
  }

  /** Find the input cells that contain points and cells. */
  void Locate(Monitor& monitor)
  {
    std::vector<Point> middles;
    this->AppendMiddles(this->Result.Tetrahedra, middles);
    this->AppendMiddles(this->Result.Pyramids, middles);
    this->AppendMiddles(this->Result.Prisms, middles);
    const std::vector<Id>& regions = this->Solid.Regions;
    std::vector<Id>& cells = this->Result.OriginalCells;
    const std::vector<Id> near = cells;
    LocateCells(this->Solid.Input, middles, cells, monitor, { Stages::Layering, 0.9, 0.97 });
    for (std::size_t c = 0; c < near.size() && !regions.empty(); ++c)
    {
      cells[c] = regions[cells[c]] == regions[near[c]] ? cells[c] : near[c]; // by rounding
    }
    LocateCells(this->Solid.Input, this->Result.Points, this->Result.CellsOfPoints, monitor,
      { Stages::Layering, 0.97, 1 });
  }

  struct CellOfLayer
  {
    Id Original;
    Id Layer;
  };

  const PushedSolid& Solid;
  const Id Layers;
  std::vector<Id> Outer;       ///< per point of the mesh, its point at the wall
  std::vector<Id> FirstBorder; ///< the same on the inner border of the first layer; None without
  std::vector<CellOfLayer> OfPyramids;
  std::vector<CellOfLayer> OfPrisms;
  LayeredMesh Result;
};
} // namespace

LayeredMesh MakeLayeredMesh(const PushedSolid& solid, Monitor& monitor)
{
  return LayeredMeshMaker(solid).Make(monitor);
}
} // namespace insideout
