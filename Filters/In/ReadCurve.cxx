// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadCurve.h"

#include "Data/Arrays.h"
#include "In/ReadSurface.h"

#include "Common/Error.h"
#include "Common/Vectors.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;
using insideout::Id;
using insideout::PlanarPoint;
using insideout::Plane;
using insideout::Point;

namespace
{
bool HasPolygons(vtkPolyData* input)
{
  return input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0;
}

/** Visit each cell of an array as (number of points, points). */
template <typename Visit>
void VisitCells(vtkCellArray* cells, const Visit& visit)
{
  vtkIdType size;
  const vtkIdType* points;
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    iterator->GetCurrentCell(size, points);
    visit(size, points);
  }
}

/** Visit the outlines of polygons and of triangles of strips, or the lines if there are neither, as
 * (cell, points). */
template <typename Visit>
void VisitOutlines(vtkPolyData* input, const Visit& visit)
{
  vtkIdType cell = input->GetNumberOfVerts();
  std::vector<Id> ids;
  const auto visitAs = [&](vtkIdType size, const vtkIdType* points)
  {
    ids.assign(points, points + size);
    visit(cell, ids);
  };
  if (!HasPolygons(input))
  {
    VisitCells(input->GetLines(),
      [&](vtkIdType size, const vtkIdType* points)
      {
        visitAs(size, points);
        ++cell;
      });
    return;
  }
  cell += input->GetNumberOfLines();
  VisitCells(input->GetPolys(),
    [&](vtkIdType size, const vtkIdType* points)
    {
      visitAs(size, points);
      ++cell;
    });
  VisitCells(input->GetStrips(),
    [&](vtkIdType size, const vtkIdType* points)
    {
      for (vtkIdType k = 0; k + 2 < size; ++k)
      {
        const vtkIdType odd = k % 2; // every other triangle of a strip runs the other way
        const vtkIdType triangle[3] = { points[k], points[k + 1 + odd], points[k + 2 - odd] };
        visitAs(3, triangle);
      }
      ++cell;
    });
}

/** The points used by outlines. @throws Error PointOutOfRange, PointNotFinite */
std::vector<Point> PointsInUse(vtkPolyData* input, const std::vector<Point>& points)
{
  std::vector<char> isUsed(points.size(), 0);
  VisitOutlines(input,
    [&](vtkIdType cell, const std::vector<Id>& ids)
    {
      for (const Id p : ids)
      {
        if (p < 0 || p >= static_cast<Id>(points.size()))
        {
          throw Error(ErrorCode::PointOutOfRange,
            "cell " + std::to_string(cell) + " refers to point " + std::to_string(p) + " of " +
              std::to_string(points.size()));
        }
        if (!insideout::IsFinite(points[p]))
        {
          throw Error(ErrorCode::PointNotFinite, "point " + std::to_string(p) + " is not finite");
        }
        isUsed[p] = 1;
      }
    });
  std::vector<Point> used;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (isUsed[p])
    {
      used.push_back(points[p]);
    }
  }
  return used;
}

/** Points of a few polygons, evenly spread. */
std::vector<Point> SomePoints(vtkPolyData* input)
{
  constexpr vtkIdType few = 64;
  vtkCellArray* polygons = input->GetPolys();
  const vtkIdType count = polygons->GetNumberOfCells();
  std::vector<Point> points;
  for (vtkIdType cell = 0; cell < count; cell += std::max<vtkIdType>(count / few, 1))
  {
    vtkIdType size;
    const vtkIdType* ids;
    polygons->GetCellAtId(cell, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      Point p = { { 0, 0, 0 } };
      if (ids[k] >= 0 && ids[k] < input->GetNumberOfPoints())
      {
        input->GetPoint(ids[k], p.data());
        points.push_back(p);
      }
    }
  }
  return points;
}

/**
 * Whether points are farther from any plane than rounding explains; for most surfaces a few
 * suffice.
 */
bool AreSurelyNotFlat(const std::vector<Point>& points)
{
  // tolerance, because the plane of a few points is not exactly that of all
  constexpr double surely = 16;
  if (!std::all_of(points.begin(), points.end(), insideout::IsFinite))
  {
    return true;
  }
  try
  {
    return insideout::FindPlane(points).Distance > surely * insideout::RoundingOfDoubles;
  }
  catch (const Error&)
  {
    return false; // collinear
  }
}

/** Twice the signed area of an outline, negative if clockwise. */
double TwiceAreaOf(const std::vector<Point>& points, const std::vector<Id>& ids, const Plane& plane)
{
  double area = 0;
  const PlanarPoint first = plane.Project(points[ids[0]]);
  for (std::size_t k = 1; k + 1 < ids.size(); ++k)
  {
    area += 2 *
      insideout::AreaOf(
        first, plane.Project(points[ids[k]]), plane.Project(points[ids[k + 1]]), plane.Metric);
  }
  return area;
}

void AddSegment(Curve& curve, vtkIdType cell, Id from, Id to)
{
  curve.Soup.Segments.push_back({ { from, to } });
  curve.CellOfSegment.push_back(cell);
}

void ReadLines(Curve& curve)
{
  VisitOutlines(curve.Input,
    [&](vtkIdType cell, const std::vector<Id>& ids)
    {
      for (std::size_t k = 0; k + 1 < ids.size(); ++k)
      {
        AddSegment(curve, cell, ids[k], ids[k + 1]);
      }
    });
}

/** The count of each line, for resolved lines of vtkRobustTriangulate. */
void ReadMultiplicity(Curve& curve)
{
  vtkDataArray* multiplicity = FindCellArray(curve.Input, "FacetMultiplicity");
  if (multiplicity && multiplicity->GetDataType() == VTK_SHORT)
  {
    for (const vtkIdType cell : curve.CellOfSegment)
    {
      curve.Soup.Multiplicity.push_back(
        static_cast<std::int16_t>(multiplicity->GetComponent(cell, 0)));
    }
  }
}

/** The edges of polygons, each counted, with polygons oriented as the orientation requires. */
void ReadPolygons(Curve& curve, insideout::Orientation orientation)
{
  const std::vector<Point>& points = curve.Soup.Points;
  double total = 0;
  bool areDegenerate = true;
  vtkIdType tooSmall = 0;
  VisitOutlines(curve.Input,
    [&](vtkIdType, const std::vector<Id>& ids)
    {
      const double area = ids.size() < 3 ? 0 : TwiceAreaOf(points, ids, curve.Plane);
      total += area;
      areDegenerate = areDegenerate && area == 0;
    });
  if (areDegenerate)
  {
    throw Error(ErrorCode::AllDegenerate, "all polygons are degenerate (without area)");
  }
  curve.Plane = total < 0 ? curve.Plane.Turned() : curve.Plane;
  const bool makeAgree = orientation == insideout::Orientation::Automatic ||
    orientation == insideout::Orientation::Outward;
  VisitOutlines(curve.Input,
    [&](vtkIdType cell, const std::vector<Id>& ids)
    {
      if (ids.size() < 3)
      {
        ++tooSmall;
        return;
      }
      const bool isTurned = makeAgree ? TwiceAreaOf(points, ids, curve.Plane) < 0
                                      : orientation == insideout::Orientation::Reverse;
      if (isTurned && (curve.TurnedCells.empty() || curve.TurnedCells.back() != cell))
      {
        curve.TurnedCells.push_back(cell);
      }
      for (std::size_t k = 0; k < ids.size(); ++k)
      {
        AddSegment(curve, cell, ids[k], ids[(k + 1) % ids.size()]);
        curve.Soup.Multiplicity.push_back(isTurned ? -1 : 1);
      }
    });
  if (tooSmall > 0)
  {
    curve.Warnings.push_back(
      std::to_string(tooSmall) + " polygons of fewer than three points are left out");
  }
  if (makeAgree && !curve.TurnedCells.empty())
  {
    curve.Warnings.push_back(std::to_string(curve.TurnedCells.size()) +
      " polygons face the other way than most and are turned over");
  }
}

void ReadParticipation(const std::string& name, Curve& curve)
{
  if (name.empty())
  {
    return;
  }
  vtkDataArray* array = FindCellArray(curve.Input, name.c_str());
  if (!array)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the surface has no cell array " + name + " of one number per cell");
  }
  for (const vtkIdType cell : curve.CellOfSegment)
  {
    curve.Soup.NonParticipating.push_back(array->GetComponent(cell, 0) != 0);
  }
}

/** A message with the distance of points from a plane. */
std::string NotFlat(const Plane& plane)
{
  char distance[32];
  std::snprintf(distance, sizeof(distance), "%.2g", plane.Distance);
  return std::string("the input does not lie in a plane: points are off by up to ") + distance +
    " of the largest coordinate";
}
} // namespace

bool AreLines(vtkPolyData* input)
{
  return input->GetNumberOfLines() > 0 && !HasPolygons(input);
}

bool IsInAPlane(vtkPolyData* input)
{
  if (!HasPolygons(input) || AreSurelyNotFlat(SomePoints(input)))
  {
    return AreLines(input);
  }
  try
  {
    const std::vector<Point> points = PointsInUse(input, ReadPoints(input, "the surface"));
    return insideout::FindPlane(points).Distance <= insideout::RoundingOfDoubles;
  }
  catch (const Error&)
  {
    return false; // it is then refused with a message of its own
  }
}

void RefuseLines(vtkPolyData* input)
{
  if (AreLines(input))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the input is lines, which bound no volume: vtkRobustTriangulate makes triangles of lines in "
      "a plane");
  }
}

void RefusePlane(vtkPolyData* input, bool thickens)
{
  RefuseLines(input);
  if (!thickens && IsInAPlane(input))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the polygons lie in one plane and bound no volume: vtkRobustTriangulate makes triangles of "
      "them");
  }
}

Curve ReadCurve(
  vtkPolyData* input, insideout::Orientation orientation, const std::string& nonParticipating)
{
  Curve curve;
  curve.Input = input;
  curve.Soup.Points = ReadPoints(input, "the surface");
  curve.ArePolygons = HasPolygons(input);
  if (!curve.ArePolygons && input->GetNumberOfLines() == 0)
  {
    throw Error(ErrorCode::EmptySurface, "the surface is empty: it has neither polygons nor lines");
  }
  curve.Plane = insideout::FindPlane(PointsInUse(input, curve.Soup.Points));
  if (curve.Plane.Distance > insideout::RoundingOfSingles)
  {
    throw Error(ErrorCode::InvalidParameter, NotFlat(curve.Plane));
  }
  if (curve.ArePolygons)
  {
    ReadPolygons(curve, orientation);
  }
  else
  {
    ReadLines(curve);
    ReadMultiplicity(curve);
  }
  const vtkIdType ignored =
    input->GetNumberOfVerts() + (curve.ArePolygons ? input->GetNumberOfLines() : 0);
  if (ignored > 0)
  {
    curve.Warnings.push_back(std::to_string(ignored) +
      (curve.ArePolygons ? " vertices and lines are ignored: only polygons and strips count"
                         : " vertices are ignored: only lines count"));
  }
  ReadParticipation(nonParticipating, curve);
  return curve;
}
} // namespace vtkInsideOut
