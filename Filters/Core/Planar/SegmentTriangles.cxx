// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/SegmentTriangles.h"

#include "Common/Stages.h"
#include "Planar/PlanarManifold.h"
#include "Planar/TriangleLocator.h"

#include <cmath>

namespace insideout
{
namespace
{
SeededCells FindSeededTriangles(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
  const Plane& plane, const std::vector<Seed>& seeds)
{
  if (seeds.empty())
  {
    return FindSeededCells(seeds, mesh.NumberOfCells(), [](const Point&) { return None; });
  }
  const TriangleLocator cells(points, mesh);
  return FindSeededCells(seeds, mesh.NumberOfCells(),
    [&](const Point& seed)
    { return cells.Find(plane.Project(plane.Foot(seed)), [](Id) { return true; }); });
}

std::vector<double> CellAreas(
  const std::vector<PlanarPoint>& points, const PlanarMesh& mesh, const PlanarMetric& metric)
{
  std::vector<double> areas;
  areas.reserve(mesh.Cells.size());
  for (const Triangle& cell : mesh.Cells)
  {
    areas.push_back(std::abs(AreaOf(points[cell[0]], points[cell[1]], points[cell[2]], metric)));
  }
  return areas;
}

/** In the units of space. */
ScaledSizes AreasInSpace(
  const std::vector<PlanarPoint>& points, const PlanarMesh& mesh, const Plane& plane)
{
  return { CellAreas(points, mesh, plane.Metric), 2 * plane.Exponent };
}

/** For each edge of a triangle the opposite corner (EdgeOf). */
constexpr std::array<int, 3> CornersOppositeEdges = { { 2, 0, 1 } };
} // namespace

std::vector<InteriorFace> InteriorEdges(
  const std::vector<PlanarPoint>& points, const PlanarMesh& mesh, const PlanarMetric& metric)
{
  std::vector<InteriorFace> edges;
  edges.reserve(mesh.Cells.size() + mesh.Cells.size() / 2);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (mesh.Neighbors[cell][k] > cell)
      {
        const Segment edge = EdgeOf(mesh.Cells[cell], k);
        edges.push_back(
          { cell, mesh.Neighbors[cell][k], metric.Distance(points[edge[0]], points[edge[1]]) });
      }
    }
  }
  return edges;
}

std::vector<FacetPiece> PiecesOfSegments(
  const PlanarMesh& mesh, const std::vector<unsigned char>& chosen)
{
  std::vector<FacetPiece> pieces;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id segment = mesh.Segments[cell][k];
      const Id beyond = mesh.Neighbors[cell][k];
      if (segment != None && (beyond == None || beyond > cell) &&
        (chosen.empty() || chosen[segment]))
      {
        pieces.push_back({ cell, beyond, segment });
      }
    }
  }
  return pieces;
}

MeshSegmentation SegmentTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const Plane& plane, const std::vector<double>& w, const std::vector<FacetPiece>& pieces,
  const std::vector<Seed>& seeds, const SegmentMeshParameters& parameters, Monitor& monitor)
{
  monitor.Check(Stages::Segmenting, 0);
  SeededCells seeded = FindSeededTriangles(curve.Points, mesh, plane, seeds);
  CellGraph graph = { w, InteriorEdges(curve.Points, mesh, plane.Metric),
    parameters.Cut.DataTerm == DataTerm::VolumeWeighted
      ? CellAreas(curve.Points, mesh, plane.Metric)
      : std::vector<double>() };
  return SegmentCells(std::move(graph), std::move(seeded), pieces, parameters,
    { [&](GreedyLabels& labels, Monitor& watch, double begin, double end)
      {
        PlanarManifold manifold(curve.Points.size(), mesh);
        return manifold.Satisfy(labels, watch, begin, end);
      },
      [&]()
      {
        return SimplicialCells(curve.Points.size(), mesh.Cells, mesh.Neighbors,
          CornersOppositeEdges, [&]() { return AreasInSpace(curve.Points, mesh, plane); });
      } },
    monitor);
}
} // namespace insideout
