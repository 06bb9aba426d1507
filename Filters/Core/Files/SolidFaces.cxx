// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SolidFaces.h"

#include "Common/Error.h"
#include "Common/FaceTable.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace insideout
{
namespace
{
[[noreturn]] void Refuse(ErrorCode code, std::size_t triangle, const std::string& what)
{
  throw Error(code, "triangle " + std::to_string(triangle) + " of the boundary " + what);
}

void CheckTriangles(Id points, const std::vector<Triangle>& triangles)
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const Id point : triangles[t])
    {
      if (point < 0 || point >= points)
      {
        Refuse(ErrorCode::PointOutOfRange, t,
          "refers to point " + std::to_string(point) + " of " + std::to_string(points));
      }
    }
  }
}

template <std::size_t Size>
void CheckIds(Id points, const std::vector<std::array<Id, Size>>& cells)
{
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (const Id point : cells[c])
    {
      if (point < 0 || point >= points)
      {
        throw Error(ErrorCode::PointOutOfRange,
          "cell " + std::to_string(c) + " refers to point " + std::to_string(point) + " of " +
            std::to_string(points));
      }
    }
  }
}

/** The two faces on a triangle, indexed by SortedTriangle::Turned. Cell is None for no face. */
using FacesByCorners = std::unordered_map<Triangle, std::array<CellFace, 2>, HashOfTriangle>;

constexpr std::array<CellFace, 2> NoFaces = { { { None, 0 }, { None, 0 } } };

/** The triangles of pyramids and prisms, and the halves of their quads, cut both ways.
 * @param[in] names ids of their points in the table */
FacesByCorners FacesOfLayers(const SolidMesh& solid, const std::vector<Id>& names)
{
  FacesByCorners faces;
  const auto add = [&](const CellFace& from, const Triangle& corners)
  {
    const SortedTriangle sorted(
      Triangle{ { names[corners[0]], names[corners[1]], names[corners[2]] } });
    CellFace& face = faces.emplace(sorted.Points, NoFaces).first->second[sorted.Turned ? 1 : 0];
    face = face.Cell == None ? from : face;
  };
  for (auto c = static_cast<Id>(solid.Cells.size()); c < static_cast<Id>(solid.NumberOfCells());
       ++c)
  {
    for (int k = 0; k < FacesOfLayerCell; ++k)
    {
      const std::array<Id, 4> f = FaceOfLayer(solid, { c, k });
      add({ c, k }, { { f[0], f[1], f[2] } });
      if (f[3] != None)
      {
        add({ c, k }, { { f[0], f[2], f[3] } });
        add({ c, k }, { { f[0], f[1], f[3] } });
        add({ c, k }, { { f[1], f[2], f[3] } });
      }
    }
  }
  return faces;
}

/** Points sorted by place, then by id. */
std::vector<Id> OrderByPlace(const std::vector<Point>& points)
{
  std::vector<Id> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Id p, Id q) { return points[p] < points[q]; });
  return order;
}

/** For each point the lowest at its place. */
std::vector<Id> LowestInPlaces(const std::vector<Point>& points, const std::vector<Id>& order)
{
  std::vector<Id> lowest(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
    lowest[order[i]] = same ? lowest[order[i - 1]] : order[i];
  }
  return lowest;
}

template <std::size_t Size>
std::vector<std::array<Id, Size>> Renamed(
  std::vector<std::array<Id, Size>> cells, const std::vector<Id>& names)
{
  for (auto& cell : cells)
  {
    for (Id& point : cell)
    {
      point = names[point];
    }
  }
  return cells;
}

using OuterSides = std::vector<std::array<unsigned char, 4>>;

/** The sides of cells that no other cell has. */
OuterSides FindOuterSides(const SolidMesh& solid)
{
  OuterSides isOuter(solid.Cells.size());
  FaceTable(solid.Points.size(), solid.Cells)
    .ForEach(
      [&isOuter](const FaceTable::Range& entries, Id)
      {
        const FaceEntry& entry = *entries.begin();
        isOuter[entry.Cell][entry.Face] = entries.Size() == 1;
      });
  return isOuter;
}

/** The entry of a face whose cell the triangle faces away from, else the first one. With
 * overlapping cells there are more than two: those that no other cell shares come first. */
const FaceEntry& EntryBehind(
  const FaceTable::Range& entries, bool turned, const OuterSides& isOuter)
{
  const auto rank = [&](const FaceEntry& entry)
  {
    return (isOuter.empty() || isOuter[entry.Cell][entry.Face] ? 0 : 2) +
      (entry.Turned == turned ? 0 : 1);
  };
  return *std::min_element(entries.begin(), entries.end(),
    [&](const FaceEntry& a, const FaceEntry& b) { return rank(a) < rank(b); });
}

/** The face of the cell from which a triangle faces away; tetrahedra come before layer cells. If
 * there is none, that of a cell on its other side; Cell is None without one. */
CellFace FaceBehind(const FaceTable::Range& entries, const std::array<CellFace, 2>& ofLayers,
  bool turned, const OuterSides& isOuter)
{
  CellFace best = { None, 0 };
  if (entries.Size() > 0)
  {
    const FaceEntry& entry = EntryBehind(entries, turned, isOuter);
    best = { entry.Cell, entry.Face };
    if (entry.Turned == turned)
    {
      return best;
    }
  }
  const CellFace& same = ofLayers[turned ? 1 : 0];
  const CellFace& other = ofLayers[turned ? 0 : 1];
  return same.Cell != None ? same : best.Cell != None ? best : other;
}
} // namespace

std::array<Id, 4> FaceOfLayer(const SolidMesh& solid, const CellFace& face)
{
  const int k = face.Face;
  const std::size_t other = static_cast<std::size_t>(face.Cell) - solid.Cells.size();
  if (other < solid.Pyramids.size())
  {
    const Pyramid& p = solid.Pyramids[other];
    return k == 4 ? std::array<Id, 4>{ { p[3], p[2], p[1], p[0] } }
                  : std::array<Id, 4>{ { p[k], p[(k + 1) % 4], p[4], None } };
  }
  const Prism& p = solid.Prisms[other - solid.Pyramids.size()];
  if (k < 2)
  {
    return k == 0 ? std::array<Id, 4>{ { p[0], p[1], p[2], None } }
                  : std::array<Id, 4>{ { p[3], p[5], p[4], None } };
  }
  const int first = k - 2;
  const int second = (k - 1) % 3;
  return { { p[first], p[first + 3], p[second + 3], p[second] } };
}

bool IsQuad(const SolidMesh& solid, const CellFace& face)
{
  return static_cast<std::size_t>(face.Cell) >= solid.Cells.size() &&
    FaceOfLayer(solid, face)[3] != None;
}

void CheckCells(const SolidMesh& solid)
{
  if (solid.NumberOfCells() == 0)
  {
    throw Error(ErrorCode::InvalidParameter, "the grid has no cells");
  }
  const auto bad = std::find_if_not(solid.Points.begin(), solid.Points.end(), IsFinite);
  if (bad != solid.Points.end())
  {
    throw Error(ErrorCode::PointNotFinite,
      "point " + std::to_string(bad - solid.Points.begin()) +
        " has a coordinate that is infinite "
        "or no number");
  }
  const auto points = static_cast<Id>(solid.Points.size());
  CheckIds(points, solid.Cells);
  CheckIds(points, solid.Midpoints);
  CheckIds(points, solid.Pyramids);
  CheckIds(points, solid.Prisms);
}

std::vector<CellFace> OuterFaces(const SolidMesh& solid)
{
  CheckCells(solid);
  if (solid.HasLayers())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the solid has pyramids or prisms: its boundary has to be given, too");
  }
  const OuterSides isOuter = FindOuterSides(solid);
  std::vector<CellFace> faces;
  for (std::size_t c = 0; c < isOuter.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (isOuter[c][k])
      {
        faces.push_back({ static_cast<Id>(c), k });
      }
    }
  }
  return faces;
}

std::vector<CellFace> FacesOfTriangles(
  const SolidMesh& solid, const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  CheckCells(solid);
  CheckTriangles(static_cast<Id>(points.size()), triangles);
  const std::vector<Id> order = OrderByPlace(solid.Points);
  const std::vector<Id> lowest = LowestInPlaces(solid.Points, order);
  const FaceTable table(solid.Points.size(), Renamed(solid.Cells, lowest));
  bool hasCopies = false;
  for (std::size_t p = 0; p < lowest.size(); ++p)
  {
    hasCopies = hasCopies || lowest[p] != static_cast<Id>(p);
  }
  const OuterSides isOuter = hasCopies ? FindOuterSides(solid) : OuterSides();

  std::vector<Id> pointThere(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const auto found = std::lower_bound(order.begin(), order.end(), points[p],
      [&solid](Id q, const Point& wanted) { return solid.Points[q] < wanted; });
    const bool isThere = found != order.end() && solid.Points[*found] == points[p];
    pointThere[p] = isThere ? *found : None;
  }
  const std::vector<Triangle> renamed = Renamed(triangles, pointThere);

  const FacesByCorners ofLayers = FacesOfLayers(solid, lowest);
  std::vector<CellFace> faces;
  faces.reserve(renamed.size());
  for (std::size_t t = 0; t < renamed.size(); ++t)
  {
    const SortedTriangle sorted(renamed[t]);
    const FaceTable::Range entries = table.Find(sorted);
    const auto ofLayer = ofLayers.find(sorted.Points);
    faces.push_back(FaceBehind(
      entries, ofLayer == ofLayers.end() ? NoFaces : ofLayer->second, sorted.Turned, isOuter));
    if (faces.back().Cell == None)
    {
      Refuse(ErrorCode::InvalidParameter, t, "is not a face of the solid's cells");
    }
  }
  return faces;
}
} // namespace insideout
