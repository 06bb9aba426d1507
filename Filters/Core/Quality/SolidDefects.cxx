// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/SolidDefects.h"

#include "Common/DisjointSets.h"
#include "Common/FaceTable.h"
#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"
#include "Common/Stages.h"
#include "Resolve/FindIntersections.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** The time for a cell's orientation. */
constexpr double NanosecondsPerCell = 50;

/** Faces by the number of their cells, and by the positions of these. */
struct Faces
{
  std::vector<std::array<Id, 2>> Joints; ///< cells on both sides
  std::vector<Triangle> Boundary;
  Id Crowded = 0;
  Id Overlapping = 0;
  Id Cut = 0; ///< halves of quads that are also a triangle of another cell
};

/** The cells, with layer cells cut into tetrahedra. */
class Parts
{
public:
  Parts(const std::vector<Tetrahedron>& cells, const LayerCells& layers)
    : Corners(cells)
    , Tetrahedra(cells.size())
  {
    Id cell = static_cast<Id>(cells.size());
    this->Append(layers.Pyramids, cell);
    this->Append(layers.Prisms, cell);
  }

  std::vector<Tetrahedron> Corners;

  Id CellOf(Id part) const
  {
    const auto other = static_cast<std::size_t>(part) - this->Tetrahedra;
    return static_cast<std::size_t>(part) < this->Tetrahedra ? part : this->Cells[other];
  }

  bool IsHalf(const FaceEntry& entry) const
  {
    const auto other = static_cast<std::size_t>(entry.Cell) - this->Tetrahedra;
    return static_cast<std::size_t>(entry.Cell) >= this->Tetrahedra &&
      this->Halves[other][entry.Face];
  }

private:
  template <class Cell>
  void Append(const std::vector<Cell>& cells, Id& number)
  {
    std::vector<CellPart> parts;
    for (const Cell& cell : cells)
    {
      parts.clear();
      AppendParts(cell, parts);
      for (const CellPart& part : parts)
      {
        this->Corners.push_back(part.Corners);
        this->Halves.push_back(part.IsHalf);
        this->Cells.push_back(number);
      }
      ++number;
    }
  }

  const std::size_t Tetrahedra;
  std::vector<Id> Cells; ///< cells of the parts that follow the tetrahedra
  std::vector<std::array<bool, 4>> Halves;
};

Faces FindFaces(
  const Parts& parts, std::size_t numberOfPoints, const std::vector<std::int8_t>& orientations)
{
  Faces faces;
  const FaceTable table(numberOfPoints, parts.Corners);
  /**
   * The side of the face, by the order of its sorted points, on which the cell lies; 0 for a flat
   * cell.
   */
  const auto sideOf = [&](const FaceEntry& entry)
  { return (entry.Turned ? -1 : 1) * orientations[parts.CellOf(entry.Cell)]; };
  for (std::size_t c = 0; c < parts.Corners.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle corners = FaceOf(parts.Corners[c], k);
      const FaceTable::Range sharing = table.Find(SortedTriangle(corners));
      if (sharing.First[0].Cell != static_cast<Id>(c))
      {
        continue; // seen already
      }
      if (sharing.Size() == 1)
      {
        faces.Boundary.push_back(corners);
      }
      for (std::size_t other = 1; other < sharing.Size(); ++other)
      {
        faces.Joints.push_back(
          { parts.CellOf(static_cast<Id>(c)), parts.CellOf(sharing.First[other].Cell) });
      }
      faces.Crowded += sharing.Size() > 2;
      faces.Overlapping +=
        sharing.Size() == 2 && sideOf(sharing.First[0]) * sideOf(sharing.First[1]) > 0;
      faces.Cut +=
        sharing.Size() == 2 && parts.IsHalf(sharing.First[0]) != parts.IsHalf(sharing.First[1]);
    }
  }
  return faces;
}

/** Number the connected components of cells, by their first cells. */
void FindRegions(const std::vector<std::array<Id, 2>>& joints, SolidDefects& defects)
{
  const std::size_t cells = defects.Orientations.size();
  DisjointSets parts(cells);
  for (const std::array<Id, 2>& joint : joints)
  {
    parts.Join(joint[0], joint[1]);
  }
  defects.Regions.resize(cells);
  for (Id c = 0; c < static_cast<Id>(cells); ++c)
  {
    const Id first = parts.Find(c);
    defects.Regions[c] = first == c ? defects.NumberOfRegions++ : defects.Regions[first];
  }
}

/** The triangles with an area. */
std::vector<Triangle> WithArea(const std::vector<Point>& points, std::vector<Triangle> triangles)
{
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const Triangle& t) { return IsDegenerate(points, t); }),
    triangles.end());
  return triangles;
}
} // namespace

SolidDefects FindSolidDefects(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const LayerCells& layers, Monitor& monitor)
{
  SolidDefects defects;
  const std::size_t pyramids = cells.size() + layers.Pyramids.size();
  defects.Orientations.resize(pyramids + layers.Prisms.size());
  ParallelLoop(defects.Orientations.size(), NanosecondsPerCell, monitor,
    { Stages::Validating, 0, 0.3 },
    [&](std::size_t c)
    {
      defects.Orientations[c] =
        static_cast<std::int8_t>(c < cells.size() ? Orient3D(points, cells[c])
            : c < pyramids ? Orient(points, layers.Pyramids[c - cells.size()])
                           : Orient(points, layers.Prisms[c - pyramids]));
    });
  const auto count = [&](int sign)
  {
    return static_cast<Id>(
      std::count(defects.Orientations.begin(), defects.Orientations.end(), sign));
  };
  defects.NegativeCells = count(-1);
  defects.FlatCells = count(0);
  Parts parts(cells, layers);
  Faces faces = FindFaces(parts, points.size(), defects.Orientations);
  monitor.Check(Stages::Validating, 0.8);
  FindRegions(faces.Joints, defects);
  defects.CrowdedFaces = faces.Crowded;
  defects.OverlappingFaces = faces.Overlapping;
  defects.Boundary = std::move(faces.Boundary);
  defects.Parts = std::move(parts.Corners);
  monitor.Check(Stages::Validating, 1);
  defects.ContactPairs = faces.Cut +
    static_cast<Id>(FindIntersections(points, WithArea(points, defects.Boundary), monitor).size());
  return defects;
}

void AppendSolidDefects(const SolidDefects& defects, Statistics& statistics)
{
  statistics.emplace_back("Cells", defects.Orientations.size());
  statistics.emplace_back("Regions", defects.NumberOfRegions);
  statistics.emplace_back("NegativeCells", defects.NegativeCells);
  statistics.emplace_back("FlatCells", defects.FlatCells);
  statistics.emplace_back("CrowdedFaces", defects.CrowdedFaces);
  statistics.emplace_back("OverlappingFaces", defects.OverlappingFaces);
  statistics.emplace_back("BoundaryFaces", defects.Boundary.size());
  statistics.emplace_back("ContactPairs", defects.ContactPairs);
  statistics.emplace_back("Conforms", defects.Conforms());
}
} // namespace insideout
