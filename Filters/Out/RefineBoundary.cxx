// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/RefineBoundary.h"

#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Refine/TriangleTree.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVariant.h>

#include <algorithm>
#include <map>
#include <string>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/**
 * A face of a cell, 4 * cell + face, and the same face of the other cell: None if that is outside.
 */
using BothSides = std::array<Id, 2>;

/** The faces on the boundary, then those between regions from the lower one's side: in the order of
 * a boundary. */
std::vector<BothSides> FacesOnBoundary(const TetrahedralMesh& mesh, const std::vector<Id>& regions)
{
  std::vector<BothSides> faces;
  std::vector<BothSides> interfaces;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id behind = mesh.Neighbors[c][k];
      if (behind == None)
      {
        faces.push_back({ { 4 * c + k, None } });
      }
      else if (!regions.empty() && regions[c] < regions[behind])
      {
        const auto& back = mesh.Neighbors[behind];
        const auto side = std::find(back.begin(), back.end(), c) - back.begin();
        interfaces.push_back({ { 4 * c + k, 4 * behind + static_cast<Id>(side) } });
      }
    }
  }
  faces.insert(faces.end(), interfaces.begin(), interfaces.end());
  return faces;
}

std::array<Id, 3> CornersOfCell(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  surface->GetCellPoints(cell, corners);
  return { { static_cast<Id>(corners->GetId(0)), static_cast<Id>(corners->GetId(1)),
    static_cast<Id>(corners->GetId(2)) } };
}

/** Interpolates point data of a surface's triangles at places on it or near it, all scaled. */
class SurfaceMixer
{
public:
  SurfaceMixer(vtkPolyData* surface, const PowerOfTwo& scale)
    : Surface(surface)
    , Scale(scale)
    , Tree(this->Triangles())
  {
  }

  /** @param[in] hint a triangle near the place */
  Attributes::Mixture At(const Point& given, Id hint) const
  {
    const Point place = this->Scale.Times(given);
    const Id triangle = this->Tree.NearestTo(place, 0, hint).Triangle;
    const Triangle ids = CornersOfCell(this->Surface, triangle);
    const std::array<Point, 3> corners = this->PlacesOf(triangle);
    const auto at = std::find(corners.begin(), corners.end(), place) - corners.begin();
    return at < 3
      ? Attributes::Mixture{ { { ids[at], 0, 0, 0 } }, { { 1, 0, 0, 0 } }, false }
      : Attributes::Mixture{ { { ids[0], ids[1], ids[2], 0 } }, WeightsIn(corners, place), true };
  }

private:
  std::array<Point, 3> PlacesOf(Id triangle) const
  {
    std::array<Point, 3> places;
    const Triangle ids = CornersOfCell(this->Surface, triangle);
    for (int i = 0; i < 3; ++i)
    {
      this->Surface->GetPoint(ids[i], places[i].data());
      places[i] = this->Scale.Times(places[i]);
    }
    return places;
  }

  std::vector<LabelledTriangle> Triangles() const
  {
    std::vector<LabelledTriangle> triangles;
    for (Id t = 0; t < static_cast<Id>(this->Surface->GetNumberOfCells()); ++t)
    {
      triangles.push_back({ this->PlacesOf(t), 0 });
    }
    return triangles;
  }

  vtkPolyData* Surface;
  PowerOfTwo Scale;
  TriangleTree Tree;
};
} // namespace

std::array<double, 4> WeightsIn(const std::array<Point, 3>& t, const Point& place)
{
  std::array<double, 4> weights = { { 0, 0, 0, 0 } };
  const Point normal = NormalOf(t[0], t[1], t[2]);
  double sum = 0;
  for (int k = 0; k < 3; ++k)
  {
    weights[k] = std::max(0.0, Dot(NormalOf(place, t[(k + 1) % 3], t[(k + 2) % 3]), normal));
    sum += weights[k];
  }
  for (int k = 0; k < 3; ++k)
  {
    weights[k] = sum > 0 ? weights[k] / sum : 1.0 / 3;
  }
  return weights;
}

namespace
{
/** The numbers of triangles of the boundary on the faces of cells; 0 on others. */
std::vector<std::array<Id, 4>> OnFaces(
  const TetrahedralMesh& mesh, const std::vector<Id>& regions, const std::vector<Id>& numbers)
{
  std::vector<std::array<Id, 4>> labels(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  const std::vector<BothSides> faces = FacesOnBoundary(mesh, regions);
  const std::size_t there = std::min(faces.size(), numbers.size());
  for (std::size_t i = 0; i < there; ++i)
  {
    for (const Id face : faces[i])
    {
      if (face != None)
      {
        labels[face / 4][face % 4] = numbers[i];
      }
    }
  }
  return labels;
}

/** The bytes of an array's values at a triangle. */
std::string BytesAt(vtkAbstractArray* array, vtkIdType triangle)
{
  std::string bytes;
  const int components = array->GetNumberOfComponents();
  for (int k = 0; k < components; ++k)
  {
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      const double value = numbers->GetComponent(triangle, k);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    else
    {
      bytes += array->GetVariantValue(components * triangle + k).ToString() + '\0';
    }
  }
  return bytes;
}
} // namespace

std::vector<Id> TagsOf(vtkPolyData* boundary)
{
  vtkDataArray* tags = boundary->GetCellData()->GetArray("BoundaryTag");
  std::vector<Id> numbers;
  for (vtkIdType t = 0; tags && t < boundary->GetNumberOfCells(); ++t)
  {
    numbers.push_back(static_cast<Id>(tags->GetComponent(t, 0)));
  }
  return numbers;
}

std::vector<std::array<Id, 4>> LabelsOf(
  const TetrahedralMesh& mesh, const std::vector<Id>& regions, vtkPolyData* boundary)
{
  return OnFaces(mesh, regions, TagsOf(boundary));
}

Id LabelOfHoles(vtkPolyData* boundary)
{
  vtkDataArray* tags = boundary->GetCellData()->GetArray("BoundaryTag");
  vtkDataArray* origins = boundary->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType t = 0; tags && origins && t < boundary->GetNumberOfCells(); ++t)
  {
    if (origins->GetComponent(t, 0) < 0)
    {
      return static_cast<Id>(tags->GetComponent(t, 0));
    }
  }
  return None;
}

std::vector<std::array<Id, 4>> AttributesOf(
  const TetrahedralMesh& mesh, const std::vector<Id>& regions, vtkPolyData* boundary)
{
  std::map<std::string, Id> known;
  std::vector<Id> numbers;
  for (vtkIdType t = 0; t < boundary->GetNumberOfCells(); ++t)
  {
    std::string bytes;
    for (int a = 0; a < boundary->GetCellData()->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = boundary->GetCellData()->GetAbstractArray(a);
      const std::string name = array->GetName() ? array->GetName() : "";
      bytes += name == "vtkOriginalCellIds" ? std::string() : BytesAt(array, t);
    }
    numbers.push_back(known.emplace(bytes, static_cast<Id>(known.size())).first->second);
  }
  return OnFaces(mesh, regions, numbers);
}

vtkSmartPointer<vtkPolyData> RefineBoundary(const TetrahedralMesh& mesh,
  const std::vector<Id>& regions, const RefinedMesh& refined, vtkPolyData* before,
  std::vector<std::string>& warnings)
{
  std::vector<std::array<Id, 2>> triangleOfFace; // (face, triangle), from one side of each
  for (const BothSides& face : FacesOnBoundary(mesh, regions))
  {
    triangleOfFace.push_back({ { face[0], static_cast<Id>(triangleOfFace.size()) } });
  }
  std::sort(triangleOfFace.begin(), triangleOfFace.end());
  const SurfaceMixer mixer(before, PowerOfTwo(-LargestExponent(mesh.Points)));
  std::vector<Id> numbers(refined.Points.size(), None);
  std::vector<Point> points;
  std::vector<Attributes::Mixture> mixtures;
  std::vector<Triangle> triangles;
  std::vector<Id> sources;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id face = refined.OriginalFaces[c][k];
      const auto found = std::lower_bound(
        triangleOfFace.begin(), triangleOfFace.end(), std::array<Id, 2>{ { face, 0 } });
      if (face == None || found == triangleOfFace.end() || (*found)[0] != face)
      {
        continue; // within, or seen from behind
      }
      sources.push_back((*found)[1]);
      triangles.push_back(FaceOf(refined.Cells[c], k));
      for (Id& corner : triangles.back())
      {
        if (numbers[corner] == None)
        {
          numbers[corner] = static_cast<Id>(points.size());
          points.push_back(refined.Points[corner]);
          mixtures.push_back(mixer.At(points.back(), sources.back()));
        }
        corner = numbers[corner];
      }
    }
  }
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  boundary->SetPoints(MakePoints(points));
  boundary->SetPolys(MakeCells(triangles));
  Attributes::MixPointData(before, mixtures, {}, boundary->GetPointData(), warnings);
  Attributes::CopyCellData(before, sources, boundary->GetCellData(), warnings);
  boundary->GetFieldData()->ShallowCopy(before->GetFieldData());
  return boundary;
}
} // namespace vtkInsideOut
