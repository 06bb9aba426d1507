// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/DelaunayOfPoints.h"

#include "Common/Stages.h"
#include "Delaunay/DelaunayTetrahedra.h"
#include "Mesh/MeshCell.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Memory per cell, with its share of the points, and of the result. */
constexpr double BytesPerCell = 100;

/** The Delaunay tetrahedra, if the memory budget holds them. */
DelaunayTetrahedra DelaunayWithin(
  const std::vector<Point>& points, double mebibytes, Monitor& monitor)
{
  const double most = mebibytes * 1024 * 1024 / BytesPerCell;
  try
  {
    return DelaunayTetrahedra(points,
      static_cast<std::size_t>(std::clamp(most, 0.0, static_cast<double>(MostNumberedCells))),
      monitor, { Stages::Tetrahedralizing, 0, 1 });
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::TooLarge)
    {
      throw;
    }
    throw Error(ErrorCode::TetrahedralizerFailed,
      "the memory budget does not suffice for the points alone: " + std::string(error.what()));
  }
}
} // namespace

RawTetrahedra DelaunayOfPoints(const std::vector<Point>& points, double mebibytes, Monitor& monitor)
{
  const DelaunayTetrahedra delaunay = DelaunayWithin(points, mebibytes, monitor);
  RawTetrahedra raw;
  raw.Points = points;
  for (Id cell = 0; cell < delaunay.NumberOfCells(); ++cell)
  {
    Tetrahedron corners = delaunay.At(cell).Corners;
    if (corners[3] != static_cast<Id>(points.size()))
    {
      std::sort(corners.begin(), corners.end());
      raw.Cells.push_back(corners);
    }
  }
  std::sort(raw.Cells.begin(), raw.Cells.end());
  return raw;
}
} // namespace insideout
