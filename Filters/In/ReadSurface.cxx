// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadSurface.h"

#include "Data/Arrays.h"
#include "Data/FileAttributes.h"

#include "Validate/TriangulatePolygon.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;
using insideout::Id;
using insideout::Point;

namespace
{
/**
 * Visit each polygon of at least three points, then each triangle of the strips, as (cell, number
 * of corners, corners).
 *
 * @param[in] checkPoint called for each corner that is a point of the input
 * @return the number of polygons with fewer points
 * @throws Error PointOutOfRange
 */
template <typename CheckPoint, typename Visit>
vtkIdType VisitPolygons(vtkPolyData* input, const CheckPoint& checkPoint, const Visit& visit)
{
  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  vtkIdType tooSmall = 0;
  vtkIdType size;
  const vtkIdType* corners;
  const auto check = [&]()
  {
    for (vtkIdType k = 0; k < size; ++k)
    {
      if (corners[k] < 0 || corners[k] >= input->GetNumberOfPoints())
      {
        throw Error(ErrorCode::PointOutOfRange,
          "cell " + std::to_string(cell) + " refers to point " + std::to_string(corners[k]) +
            " of " + std::to_string(input->GetNumberOfPoints()));
      }
      checkPoint(corners[k]);
    }
  };
  const auto polygons = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    polygons->GetCurrentCell(size, corners);
    check();
    if (size >= 3)
    {
      visit(cell, size, corners);
    }
    tooSmall += size < 3;
    ++cell;
  }
  const auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    strips->GetCurrentCell(size, corners);
    check();
    for (vtkIdType k = 0; k + 2 < size; ++k)
    {
      const int odd = k % 2; // every other triangle of a strip runs the other way
      const vtkIdType triangle[3] = { corners[k], corners[k + 1 + odd], corners[k + 2 - odd] };
      visit(cell, 3, triangle);
    }
    ++cell;
  }
  return tooSmall;
}

void CheckThatIsFinite(const Point& x, vtkIdType id)
{
  if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
  {
    throw Error(ErrorCode::PointNotFinite, "point " + std::to_string(id) + " is not finite");
  }
}

void ReadTriangles(Surface& surface)
{
  const auto checkPoint = [&](vtkIdType id) { CheckThatIsFinite(surface.Soup.Points[id], id); };
  vtkIdType crossed = 0;
  vtkIdType firstCrossed = 0;
  std::vector<Id> ids;
  const vtkIdType tooSmall = VisitPolygons(surface.Input, checkPoint,
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
    {
      ids.assign(corners, corners + size);
      if (!insideout::TriangulatePolygon(surface.Soup.Points, ids, surface.Soup.Triangles))
      {
        firstCrossed = crossed == 0 ? cell : firstCrossed;
        ++crossed;
      }
      surface.CellOfTriangle.resize(surface.Soup.Triangles.size(), cell);
    });
  if (crossed > 0)
  {
    surface.Warnings.push_back(std::to_string(crossed) + " polygons, cell " +
      std::to_string(firstCrossed) +
      " the first, cross themselves: their triangles keep the outline, but overlap");
  }
  if (tooSmall > 0)
  {
    surface.Warnings.push_back(
      std::to_string(tooSmall) + " polygons of fewer than three points are left out");
  }
}

void ReadMultiplicity(Surface& surface)
{
  vtkDataArray* multiplicity = FindCellArray(surface.Input, "FacetMultiplicity");
  if (!multiplicity || multiplicity->GetDataType() == VTK_DOUBLE ||
    multiplicity->GetDataType() == VTK_FLOAT)
  {
    return; // of another type than vtkResolveSelfIntersections makes
  }
  for (const vtkIdType cell : surface.CellOfTriangle)
  {
    const double count = multiplicity->GetComponent(cell, 0);
    if (std::abs(count) > std::numeric_limits<std::int16_t>::max())
    {
      throw Error(ErrorCode::TooLarge,
        "cell " + std::to_string(cell) + " has a FacetMultiplicity that 16 bits do not hold");
    }
    surface.Soup.Multiplicity.push_back(static_cast<std::int16_t>(count));
  }
}

void ReadParticipation(const std::string& name, Surface& surface)
{
  if (name.empty())
  {
    return;
  }
  vtkDataArray* array = FindCellArray(surface.Input, name.c_str());
  if (!array)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the surface has no cell array " + name + " of one number per cell");
  }
  for (const vtkIdType cell : surface.CellOfTriangle)
  {
    surface.Soup.NonParticipating.push_back(array->GetComponent(cell, 0) != 0);
  }
}
} // namespace

vtkDataArray* FindCellArray(vtkPolyData* input, const char* name)
{
  vtkDataArray* array = input->GetCellData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == input->GetNumberOfCells();
  return fits ? array : nullptr;
}

vtkIdType Surface::CellOfFacet(const insideout::FacetComplex& surface, Id facet, int side) const
{
  return this->CellOfTriangle[SourceOfFacet(surface, facet, side)]; // triangles are in cell order
}

Surface ReadSurface(vtkPolyData* input, const std::string& nonParticipating)
{
  Surface surface;
  surface.Input = input;
  surface.Soup.Points = ReadPoints(input, "the surface");
  if (input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    throw Error(ErrorCode::EmptySurface,
      input->GetNumberOfCells() == 0 ? "the surface is empty: it has no polygons"
                                     : "the surface has no polygons, only lines or vertices");
  }
  if (const vtkIdType ignored = input->GetNumberOfVerts() + input->GetNumberOfLines())
  {
    surface.Warnings.push_back(
      std::to_string(ignored) + " vertices and lines are ignored: only polygons and strips count");
  }
  ReadTriangles(surface);
  ReadMultiplicity(surface);
  ReadParticipation(nonParticipating, surface);
  return surface;
}

void CheckPolygons(vtkPolyData* input, const std::string& label)
{
  const auto checkPoint = [&](vtkIdType id)
  {
    Point x;
    input->GetPoint(id, x.data());
    CheckThatIsFinite(x, id);
  };
  try
  {
    VisitPolygons(input, checkPoint, [](vtkIdType, vtkIdType, const vtkIdType*) {});
  }
  catch (const Error& error)
  {
    throw Error(error.Code, label + error.what());
  }
}

std::vector<unsigned char> ReadChosenFacets(
  const Surface& surface, const std::string& name, const insideout::FacetComplex& facets)
{
  std::vector<unsigned char> chosen;
  if (name.empty())
  {
    return chosen;
  }
  vtkDataArray* array = FindCellArray(surface.Input, name.c_str());
  if (!array)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the surface has no cell array " + name +
        " of one value per cell, which is to choose facets");
  }
  chosen.assign(facets.Facets.size(), 0);
  for (Id facet = 0; facet < facets.NumberOfFacets(); ++facet)
  {
    for (Id s = facets.SourceOffsets[facet]; s < facets.SourceOffsets[facet + 1]; ++s)
    {
      const vtkIdType cell = surface.CellOfTriangle[facets.Sources[s].Triangle];
      chosen[facet] = chosen[facet] || array->GetComponent(cell, 0) != 0;
    }
  }
  return chosen;
}

insideout::PolygonSurface ReadPolygons(vtkPolyData* input)
{
  insideout::PolygonSurface surface;
  std::vector<vtkIdType> cells;
  surface.Points = ReadPoints(input, "the surface");
  if (input->GetPolys()->GetNumberOfConnectivityIds() +
      3 * input->GetStrips()->GetNumberOfConnectivityIds() >
    std::numeric_limits<Id>::max())
  {
    throw Error(ErrorCode::TooLarge,
      "the surface has more than " + std::to_string(std::numeric_limits<Id>::max()) + " corners");
  }
  VisitPolygons(
    input, [](vtkIdType) {},
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
    {
      for (vtkIdType k = 0; k < size; ++k)
      {
        surface.Corners.push_back(static_cast<Id>(corners[k]));
      }
      surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
      cells.push_back(cell);
    });
  std::vector<vtkIdType> points(input->GetNumberOfPoints());
  std::iota(points.begin(), points.end(), 0);
  surface.PointAttributes = ReadAttributes(input->GetPointData(), points);
  surface.PolygonAttributes = ReadAttributes(input->GetCellData(), cells);
  surface.Names = ReadNames(input->GetFieldData());
  return surface;
}
} // namespace vtkInsideOut
