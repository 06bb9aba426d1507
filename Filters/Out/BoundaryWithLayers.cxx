// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/BoundaryWithLayers.h"

#include "Data/Arrays.h"
#include "Out/TransferLayers.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <unordered_map>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
class BoundaryMover
{
public:
  BoundaryMover(vtkPolyData* boundary, const LayeredSolid& solid)
    : Boundary(boundary)
    , Solid(solid)
    , Points(ReadPoints(boundary, "the boundary"))
    , Origins(this->Points.size())
    , StaysAt(this->Points.size(), 0)
    , NumberOf(solid.After.Points.size(), None)
  {
    for (std::size_t q = 0; q < this->Origins.size(); ++q)
    {
      this->Origins[q] = static_cast<vtkIdType>(q);
    }
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    for (std::size_t t = 0; t < this->Solid.Faces.size(); ++t)
    {
      this->AddCorners(t);
    }
    for (std::size_t t = 0; t < this->Solid.Faces.size(); ++t)
    {
      this->AddTriangle(t);
    }
    for (const LayerSide& side : this->Solid.After.Sides)
    {
      this->AddSide(side);
    }
    return this->Collect();
  }

private:
  /** The corners of a triangle of the boundary as points of the mesh before. */
  Triangle CornersBefore(std::size_t triangle)
  {
    const Id face = this->Solid.Faces[triangle];
    const Triangle given = FaceOf(this->Solid.Before.Cells[face / 4], face % 4);
    this->Boundary->GetPolys()->GetCellAtId(static_cast<vtkIdType>(triangle), this->Ids);
    Triangle corners = given;
    for (int k = 0; k < 3; ++k)
    {
      for (const Id p : given)
      {
        const Point& place = this->Points[this->Ids->GetId(k)];
        corners[k] = this->Solid.Before.Points[p] == place ? p : corners[k];
      }
    }
    return corners;
  }

  /** The points of the wall are the ones that stay. */
  void AddCorners(std::size_t triangle)
  {
    const Triangle corners = this->CornersBefore(triangle);
    this->Corners.push_back(corners);
    for (int k = 0; k < 3 && this->Solid.IsLayered[triangle] != 0; ++k)
    {
      this->StaysAt[this->Ids->GetId(k)] = 1;
      this->PointOf.emplace(corners[k], this->Ids->GetId(k));
    }
  }

  /** A point of the boundary at a point of the solid, which may be new. */
  vtkIdType PointAt(Id point, vtkIdType origin)
  {
    if (this->NumberOf[point] == None)
    {
      this->NumberOf[point] = static_cast<vtkIdType>(this->Places.size() + this->Points.size());
      this->Places.push_back(this->Solid.After.Points[point]);
      this->Origins.push_back(origin);
    }
    return this->NumberOf[point];
  }

  void AddTriangle(std::size_t triangle)
  {
    this->FirstOf.emplace(this->Solid.Faces[triangle], static_cast<vtkIdType>(triangle));
    this->Boundary->GetPolys()->GetCellAtId(static_cast<vtkIdType>(triangle), this->Ids);
    for (int k = 0; k < 3 && this->Solid.IsLayered[triangle] == 0; ++k)
    {
      const vtkIdType q = this->Ids->GetId(k);
      const Id now = this->Solid.After.PointsBeside[this->Corners[triangle][k]];
      const Point& place = this->Solid.After.Points[now];
      if (this->StaysAt[q] == 0)
      {
        this->Moved.emplace_back(q, place);
      }
      else if (place != this->Points[q])
      {
        this->Ids->SetId(k, this->PointAt(now, q));
      }
    }
    this->AddCell(triangle);
  }

  void AddCell(std::size_t origin)
  {
    this->Polys->InsertNextCell(this->Ids);
    this->CellOrigins.push_back(static_cast<vtkIdType>(origin));
  }

  void AddSide(const LayerSide& side)
  {
    const auto found = this->FirstOf.find(side.Face);
    if (found == this->FirstOf.end())
    {
      return; // the facet is not of this boundary
    }
    std::array<vtkIdType, 4> ids = {};
    const int count = side.Corners[3] == None ? 3 : 4;
    for (int k = 0; k < count; ++k)
    {
      const Id before = this->Solid.After.OriginalPoints[side.Corners[k]];
      const auto there = before == None ? this->PointOf.end() : this->PointOf.find(before);
      const vtkIdType origin = k > 0 ? this->Origins[ids[0]] : 0; // the first is there already
      ids[k] =
        there != this->PointOf.end() ? there->second : this->PointAt(side.Corners[k], origin);
    }
    for (int k = 2; k < count; ++k)
    {
      this->Ids->SetId(0, ids[0]);
      this->Ids->SetId(1, ids[k - 1]);
      this->Ids->SetId(2, ids[k]);
      this->AddCell(static_cast<std::size_t>(found->second));
    }
  }

  vtkSmartPointer<vtkPolyData> Collect()
  {
    for (const auto& [q, place] : this->Moved)
    {
      this->Points[q] = place;
    }
    this->Points.insert(this->Points.end(), this->Places.begin(), this->Places.end());
    auto output = vtkSmartPointer<vtkPolyData>::New();
    output->SetPoints(MakePoints(this->Points));
    output->SetPolys(this->Polys);
    CopyChosen(this->Boundary->GetPointData(), this->Origins, output->GetPointData());
    CopyChosen(this->Boundary->GetCellData(), this->CellOrigins, output->GetCellData());
    output->GetFieldData()->ShallowCopy(this->Boundary->GetFieldData());
    return output;
  }

  vtkPolyData* Boundary;
  const LayeredSolid& Solid;
  std::vector<Point> Points;
  std::vector<vtkIdType> Origins;  ///< per point, one of the boundary before
  std::vector<char> StaysAt;       ///< whether a point is of the wall
  std::vector<vtkIdType> NumberOf; ///< per point of the solid after, that of the new boundary
  std::vector<Triangle> Corners;   ///< per triangle
  std::unordered_map<Id, vtkIdType> PointOf; ///< for points of the wall before
  std::unordered_map<Id, vtkIdType> FirstOf; ///< triangle per face
  std::vector<std::pair<vtkIdType, Point>> Moved;
  std::vector<Point> Places; ///< of new points
  std::vector<vtkIdType> CellOrigins;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkCellArray> Polys;
};
} // namespace

vtkSmartPointer<vtkPolyData> BoundaryWithLayers(vtkPolyData* boundary, const LayeredSolid& solid)
{
  return BoundaryMover(boundary, solid).Make();
}
} // namespace vtkInsideOut
