// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/CellsOfExpression.h"

#include "Boolean/BodyRegions.h"
#include "Boolean/FillGaps.h"
#include "Boolean/SegmentBodies.h"
#include "Boolean/WindingNumbersOfBodies.h"
#include "Common/PointPredicates.h"
#include "Common/Stages.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Where each body is. */
BodySegmentation Segment(const ResolvedBodies& bodies, const std::vector<std::string>& names,
  const TetrahedralMesh& mesh, Monitor& monitor)
{
  std::vector<std::vector<double>> w = WindingNumbersOfBodies(bodies, mesh, 1, monitor);
  std::vector<BodyToSegment> toSegment;
  for (std::size_t body = 0; body < w.size(); ++body)
  {
    toSegment.push_back({ names[body], std::move(w[body]), {}, {} });
  }
  return SegmentBodies(mesh, toSegment, {}, monitor);
}

/** Whether all facets lie in one plane, so that no body has a volume. */
bool ArePlanar(const FacetComplex& surface)
{
  const std::vector<Point>& points = surface.Points;
  const Triangle& first = surface.Facets.front();
  return std::all_of(points.begin(), points.end(),
    [&](const Point& p)
    { return Orient3D(points[first[0]], points[first[1]], points[first[2]], p) == 0; });
}
} // namespace

CellsOfExpression FindCellsOfExpression(const ResolvedBodies& bodies,
  const std::vector<std::string>& names, const SetExpression& expression, double mergeTolerance,
  Monitor& monitor)
{
  CellsOfExpression cells;
  if (ArePlanar(bodies.Surface))
  {
    cells.Warnings.push_back("all facets lie in one plane: nothing is inside");
    return cells;
  }
  Tetrahedralization result = ConstrainedDelaunay(bodies.Surface, {}, monitor);
  AddMeshCounts(result, cells.Statistics);
  AddWarnings(result, cells.Warnings);
  cells.Mesh = std::move(result.Mesh);
  BodySegmentation segmentation = Segment(bodies, names, cells.Mesh, monitor);
  cells.Warnings.insert(
    cells.Warnings.end(), segmentation.Warnings.begin(), segmentation.Warnings.end());
  if (mergeTolerance > 0)
  {
    AddFilledGaps(
      FillGaps(cells.Mesh, mergeTolerance, PriorityOf(names, {}), segmentation.Inside, monitor),
      cells.Statistics, cells.Warnings);
  }

  std::vector<char> isIn(bodies.Bodies.size());
  for (Id cell = 0; cell < cells.Mesh.NumberOfCells(); ++cell)
  {
    for (std::size_t body = 0; body < isIn.size(); ++body)
    {
      isIn[body] = static_cast<char>(segmentation.Inside[body][cell]);
    }
    cells.Inside.push_back(expression.Holds(isIn));
  }
  const std::vector<BoundaryFace> faces =
    BoundaryFaces(cells.Mesh, cells.Inside, monitor, { Stages::Extracting, 0, 0.5 });
  cells.Boundary =
    BoundaryTriangles(bodies.Surface, cells.Mesh, faces, monitor, { Stages::Extracting, 0.5, 1 });
  return cells;
}
} // namespace insideout
