// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SolidFaces.h"
#include "Files/SolidWriters.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <set>

namespace insideout
{
namespace
{
[[noreturn]] void Refuse(const std::string& what)
{
  throw Error(ErrorCode::InvalidParameter, what);
}

void CheckGroups(
  const std::vector<Id>& groupOf, const std::vector<SolidGroup>& groups, const char* element)
{
  std::vector<bool> isUsed(groups.size());
  for (std::size_t e = 0; e < groupOf.size(); ++e)
  {
    if (groupOf[e] < 0 || static_cast<std::size_t>(groupOf[e]) >= groups.size())
    {
      Refuse(std::string(element) + " " + std::to_string(e) + " is of group " +
        std::to_string(groupOf[e]) + " of " + std::to_string(groups.size()));
    }
    isUsed[static_cast<std::size_t>(groupOf[e])] = true;
  }
  std::set<Id> numbers;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    const std::string name = "group " + Quoted(groups[g].Name);
    if (!isUsed[g])
    {
      Refuse(name + " has no " + element);
    }
    if (groups[g].Number <= 0 || !numbers.insert(groups[g].Number).second)
    {
      Refuse(name +
        " has a number that is not above 0, or another's: " + std::to_string(groups[g].Number));
    }
  }
}

/** Writers rely on these checks. */
void CheckSolid(const SolidMesh& solid)
{
  CheckCells(solid);
  const std::size_t cells = solid.NumberOfCells();
  if (solid.RegionOfCell.size() != cells || solid.TagOfFace.size() != solid.Faces.size() ||
    (IsQuadratic(solid) && (solid.Midpoints.size() != cells || solid.HasLayers())))
  {
    Refuse(
      "the numbers of cells and of their midpoints or regions differ, or those of faces and tags");
  }
  CheckGroups(solid.RegionOfCell, solid.Regions, "cell");
  CheckGroups(solid.TagOfFace, solid.Tags, "face");
  for (const CellFace& face : solid.Faces)
  {
    if (face.Cell < 0 || static_cast<std::size_t>(face.Cell) >= cells || face.Face < 0 ||
      face.Face >=
        (static_cast<std::size_t>(face.Cell) < solid.Cells.size() ? 4 : FacesOfLayerCell))
    {
      Refuse("there is no face " + std::to_string(face.Face) + " of cell " +
        std::to_string(face.Cell) + " of " + std::to_string(cells));
    }
  }
}

bool HasEnding(const std::string& path, const char* ending)
{
  return EqualsIgnoringCase(std::filesystem::path(path).extension().string(), ending);
}

/** The edge between two corners of a tetrahedron. */
int EdgeBetweenCorners(int a, int b)
{
  int edge = 0;
  while (TetrahedronEdges[edge] != std::array<int, 2>{ { a, b } } &&
    TetrahedronEdges[edge] != std::array<int, 2>{ { b, a } })
  {
    ++edge;
  }
  return edge;
}
} // namespace

SolidNodes NodesOf(const SolidMesh& solid, std::size_t cell)
{
  SolidNodes nodes = {};
  const auto take = [&nodes](const auto& corners)
  {
    std::copy(corners.begin(), corners.end(), nodes.Ids.begin());
    nodes.Count = static_cast<int>(corners.size());
    return nodes;
  };
  const CellShape shape = ShapeOfCell(solid, cell);
  if (shape != CellShape::Tetrahedron)
  {
    const std::size_t other = cell - solid.Cells.size();
    return shape == CellShape::Pyramid ? take(solid.Pyramids[other])
                                       : take(solid.Prisms[other - solid.Pyramids.size()]);
  }
  std::copy(solid.Cells[cell].begin(), solid.Cells[cell].end(), nodes.Ids.begin());
  nodes.Count = 4;
  if (IsQuadratic(solid))
  {
    const std::array<Id, 6>& midpoints = solid.Midpoints[cell];
    std::copy(midpoints.begin(), midpoints.end(), nodes.Ids.begin() + nodes.Count);
    nodes.Count += 6;
  }
  return nodes;
}

SolidNodes NodesOf(const SolidMesh& solid, const CellFace& face)
{
  SolidNodes nodes = {};
  const auto cell = static_cast<std::size_t>(face.Cell);
  if (ShapeOfCell(solid, cell) != CellShape::Tetrahedron)
  {
    const std::array<Id, 4> corners = FaceOfLayer(solid, face);
    std::copy(corners.begin(), corners.end(), nodes.Ids.begin());
    nodes.Count = corners[3] == None ? 3 : 4;
    return nodes;
  }
  const std::array<int, 3>& corners = TetrahedronFaces[face.Face];
  for (int k = 0; k < 3; ++k)
  {
    nodes.Ids[k] = solid.Cells[cell][corners[k]];
  }
  nodes.Count = 3;
  for (int k = 0; k < 3 && IsQuadratic(solid); ++k)
  {
    const int edge = EdgeBetweenCorners(corners[k], corners[(k + 1) % 3]);
    nodes.Ids[nodes.Count++] = solid.Midpoints[cell][edge];
  }
  return nodes;
}

void WriteSolid(
  const std::string& path, const SolidMesh& solid, MshVersion version, Monitor& monitor)
{
  CheckSolid(solid);
  const bool isMsh = HasEnding(path, ".msh");
  const bool isInp = HasEnding(path, ".inp");
  if (!isMsh && !isInp && !HasEnding(path, ".mesh"))
  {
    Refuse(path + ": the ending is none of .msh, .inp and .mesh, which can be written");
  }
  try
  {
    OutputFile file(path, monitor);
    if (isInp)
    {
      WriteInp(file, solid);
    }
    else
    {
      isMsh ? WriteMsh(file, solid, version) : WriteMedit(file, solid);
    }
    file.Close();
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::TooLarge, path + ": not enough memory to write it");
  }
}

std::vector<Point> PointsInFile(const std::string& path, std::vector<Point> points)
{
  if (HasEnding(path, ".inp"))
  {
    std::transform(points.begin(), points.end(), points.begin(), PointInInp);
  }
  return points;
}
} // namespace insideout
