// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/FaceTable.h"
#include "Files/GroupNames.h"
#include "Files/SolidFaces.h"
#include "Files/SolidWriters.h"

#include <algorithm>
#include <cmath>
#include <map>

// The formats: Geuzaine and Remacle, Gmsh Reference Manual, "MSH file format" and "Legacy formats".

namespace insideout
{
namespace
{
/** Gmsh's dimensions of entities, and types of elements. */
constexpr int SurfaceDimension = 2;
constexpr int VolumeDimension = 3;
constexpr int TypeOfTriangle = 2;
constexpr int TypeOfQuad = 3;
constexpr int TypeOfTetrahedron = 4;
constexpr int TypeOfPrism = 6;
constexpr int TypeOfPyramid = 7;
constexpr int TypeOfQuadraticTriangle = 9;
constexpr int TypeOfQuadraticTetrahedron = 11;

/** Gmsh reads lines of 127 bytes; a blank and quotes surround the name. */
constexpr NameRules NamesOfMsh = { 100, false, true };

int TypeOfFace(const SolidMesh& solid, std::size_t face)
{
  return IsQuad(solid, solid.Faces[face]) ? TypeOfQuad
    : IsQuadratic(solid)                  ? TypeOfQuadraticTriangle
                                          : TypeOfTriangle;
}

int TypeOfCell(const SolidMesh& solid, std::size_t cell)
{
  const CellShape shape = ShapeOfCell(solid, cell);
  if (shape != CellShape::Tetrahedron)
  {
    return shape == CellShape::Pyramid ? TypeOfPyramid : TypeOfPrism;
  }
  return IsQuadratic(solid) ? TypeOfQuadraticTetrahedron : TypeOfTetrahedron;
}

/** The points of a cell in gmsh's order: a tetrahedron's edge 2 3 comes before 1 3, and the first
 * triangle of a prism is counter-clockwise seen from within. */
SolidNodes MshNodesOf(const SolidMesh& solid, std::size_t cell)
{
  SolidNodes nodes = NodesOf(solid, cell);
  std::swap(nodes.Ids[8], nodes.Ids[9]);
  if (ShapeOfCell(solid, cell) == CellShape::Prism)
  {
    std::rotate(nodes.Ids.begin(), nodes.Ids.begin() + 3, nodes.Ids.begin() + 6);
  }
  return nodes;
}

template <typename... Numbers>
void WriteLine(OutputFile& file, const Numbers... numbers)
{
  const char* blank = "";
  (
    [&](const auto number)
    {
      file.Text(blank);
      file.Decimal(number);
      blank = " ";
    }(numbers),
    ...);
  file.Text("\n");
}

void WriteHead(OutputFile& file, const SolidMesh& solid, const char* version)
{
  file.Text(std::string("$MeshFormat\n") + version + " 0 8\n$EndMeshFormat\n$PhysicalNames\n");
  const GroupNames names = ValidNames(solid, NamesOfMsh);
  WriteLine(file, names.Tags.size() + names.Regions.size());
  const auto writeNames = [&file](int dimension, const std::vector<SolidGroup>& groups,
                            const std::vector<std::string>& namesOfGroups)
  {
    for (std::size_t g = 0; g < groups.size(); ++g)
    {
      file.Text(std::to_string(dimension) + " " + std::to_string(groups[g].Number) + " \"" +
        namesOfGroups[g] + "\"\n");
    }
  };
  writeNames(SurfaceDimension, solid.Tags, names.Tags);
  writeNames(VolumeDimension, solid.Regions, names.Regions);
  file.Text("$EndPhysicalNames\n");
}

/** The bounding box of added points. */
struct Bounds
{
  Point Low = { { HUGE_VAL, HUGE_VAL, HUGE_VAL } };
  Point High = { { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

  void Add(const Point& point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], point[axis]);
      this->High[axis] = std::max(this->High[axis], point[axis]);
    }
  }
};

void WriteEntity(OutputFile& file, const SolidGroup& group, const Bounds& box)
{
  file.Decimal(group.Number);
  file.Text(" ");
  WriteCoordinates(file, box.Low);
  file.Text(" ");
  WriteCoordinates(file, box.High);
  file.Text(" 1 "); // of physical groups
  file.Decimal(group.Number);
}

/** For each region the tags that bound it: 1 if faces with the tag face out of it, else -1. */
std::vector<std::map<Id, int>> TagsAroundRegions(const SolidMesh& solid)
{
  std::vector<std::map<Id, int>> around(solid.Regions.size());
  for (std::size_t f = 0; f < solid.Faces.size(); ++f)
  {
    around[solid.RegionOfCell[solid.Faces[f].Cell]][solid.TagOfFace[f]] = 1;
  }
  if (solid.Regions.size() > 1)
  {
    const FaceTable table(solid.Points.size(), solid.Cells);
    for (std::size_t f = 0; f < solid.Faces.size(); ++f)
    {
      const SolidNodes nodes = NodesOf(solid, solid.Faces[f]);
      for (const FaceEntry& entry :
        table.Find(SortedTriangle(Triangle{ { nodes.Ids[0], nodes.Ids[1], nodes.Ids[2] } })))
      {
        around[solid.RegionOfCell[entry.Cell]].emplace(solid.TagOfFace[f], -1);
      }
    }
  }
  return around;
}

void WriteSurfaceEntities(OutputFile& file, const SolidMesh& solid)
{
  std::vector<Bounds> boxes(solid.Tags.size());
  for (std::size_t f = 0; f < solid.Faces.size(); ++f)
  {
    for (const Id point : NodesOf(solid, solid.Faces[f]))
    {
      boxes[solid.TagOfFace[f]].Add(solid.Points[point]);
    }
  }
  for (std::size_t t = 0; t < solid.Tags.size(); ++t)
  {
    WriteEntity(file, solid.Tags[t], boxes[t]);
    file.Text(" 0\n"); // curves that bound it
  }
}

void WriteVolumeEntities(OutputFile& file, const SolidMesh& solid)
{
  std::vector<Bounds> boxes(solid.Regions.size());
  for (std::size_t c = 0; c < solid.NumberOfCells(); ++c)
  {
    for (const Id point : NodesOf(solid, c))
    {
      boxes[solid.RegionOfCell[c]].Add(solid.Points[point]);
    }
  }
  const std::vector<std::map<Id, int>> around = TagsAroundRegions(solid);
  for (std::size_t r = 0; r < solid.Regions.size(); ++r)
  {
    WriteEntity(file, solid.Regions[r], boxes[r]);
    file.Text(" " + std::to_string(around[r].size()));
    for (const auto& [tag, sign] : around[r])
    {
      file.Text(" " + std::to_string(sign * std::int64_t(solid.Tags[tag].Number)));
    }
    file.Text("\n");
  }
}

/** For each point its entity: tags from 0 on, followed by the regions. */
std::vector<Id> EntitiesOfPoints(const SolidMesh& solid)
{
  const auto tags = static_cast<Id>(solid.Tags.size());
  const auto all = tags + static_cast<Id>(solid.Regions.size());
  std::vector<Id> entities(solid.Points.size(), all);
  for (std::size_t f = 0; f < solid.Faces.size(); ++f)
  {
    for (const Id point : NodesOf(solid, solid.Faces[f]))
    {
      entities[point] = std::min(entities[point], solid.TagOfFace[f]);
    }
  }
  for (std::size_t c = 0; c < solid.NumberOfCells(); ++c)
  {
    for (const Id point : NodesOf(solid, c))
    {
      entities[point] = std::min(entities[point], tags + solid.RegionOfCell[c]);
    }
  }
  // A point in no cell needs an entity, too.
  std::replace(entities.begin(), entities.end(), all, tags);
  return entities;
}

/**
 * Gmsh requires the points by the entities that they lie on. Points of several belong to the first.
 */
void WritePointsByEntity(OutputFile& file, const SolidMesh& solid)
{
  const std::size_t tags = solid.Tags.size();
  const Buckets<Id> points = ByGroup(tags + solid.Regions.size(), EntitiesOfPoints(solid));
  std::size_t blocks = 0;
  for (std::size_t e = 0; e < points.Size(); ++e)
  {
    blocks += points[e].Size() > 0;
  }
  file.Text("$Nodes\n");
  WriteLine(file, blocks, solid.Points.size(), 1, solid.Points.size());
  for (std::size_t e = 0; e < points.Size(); ++e)
  {
    const bool isSurface = e < tags;
    if (points[e].Size() == 0)
    {
      continue;
    }
    WriteLine(file, isSurface ? SurfaceDimension : VolumeDimension,
      isSurface ? solid.Tags[e].Number : solid.Regions[e - tags].Number, 0, points[e].Size());
    for (const Id point : points[e])
    {
      WriteLine(file, std::int64_t(point) + 1);
    }
    for (const Id point : points[e])
    {
      WriteCoordinates(file, solid.Points[point]);
      file.Text("\n");
    }
  }
  file.Text("$EndNodes\n");
}

/** Visit the runs of elements of one group and type, which is a block there. */
template <typename TypeOf, typename Visit>
void ForEachBlock(const Buckets<Id>& groups, const TypeOf& typeOf, const Visit& visit)
{
  for (std::size_t group = 0; group < groups.Size(); ++group)
  {
    const auto elements = groups[group];
    for (const Id* first = elements.begin(); first != elements.end();)
    {
      const int type = typeOf(static_cast<std::size_t>(*first));
      const Id* const last = std::find_if(first, elements.end(),
        [&](Id element) { return typeOf(static_cast<std::size_t>(element)) != type; });
      visit(group, type, first, last);
      first = last;
    }
  }
}

void WriteElementsByEntity(OutputFile& file, const SolidMesh& solid)
{
  const Buckets<Id> faces = ByGroup(solid.Tags.size(), solid.TagOfFace);
  const Buckets<Id> cells = ByGroup(solid.Regions.size(), solid.RegionOfCell);
  const auto typeOfFace = [&](std::size_t face) { return TypeOfFace(solid, face); };
  const auto typeOfCell = [&](std::size_t cell) { return TypeOfCell(solid, cell); };
  const std::size_t elements = solid.Faces.size() + solid.NumberOfCells();
  file.Text("$Elements\n");
  std::size_t blocks = 0;
  const auto count = [&](std::size_t, int, const Id*, const Id*) { ++blocks; };
  ForEachBlock(faces, typeOfFace, count);
  ForEachBlock(cells, typeOfCell, count);
  WriteLine(file, blocks, elements, 1, elements);
  ForEachBlock(faces, typeOfFace,
    [&](std::size_t tag, int type, const Id* first, const Id* last)
    {
      WriteLine(file, SurfaceDimension, solid.Tags[tag].Number, type, last - first);
      for (; first != last; ++first)
      {
        file.Decimal(std::int64_t(*first) + 1);
        WriteNumbers(file, NodesOf(solid, solid.Faces[*first]));
        file.Text("\n");
      }
    });
  ForEachBlock(cells, typeOfCell,
    [&](std::size_t region, int type, const Id* first, const Id* last)
    {
      WriteLine(file, VolumeDimension, solid.Regions[region].Number, type, last - first);
      for (; first != last; ++first)
      {
        file.Decimal(solid.Faces.size() + static_cast<std::size_t>(*first) + 1);
        WriteNumbers(file, MshNodesOf(solid, static_cast<std::size_t>(*first)));
        file.Text("\n");
      }
    });
  file.Text("$EndElements\n");
}

void WriteMsh41(OutputFile& file, const SolidMesh& solid)
{
  WriteHead(file, solid, "4.1");
  file.Text("$Entities\n");
  WriteLine(file, 0, 0, solid.Tags.size(), solid.Regions.size());
  WriteSurfaceEntities(file, solid);
  WriteVolumeEntities(file, solid);
  file.Text("$EndEntities\n");
  WritePointsByEntity(file, solid);
  WriteElementsByEntity(file, solid);
}

/** Number, type, and the two tags of an element: its physical and its elementary group. */
void BeginElement(OutputFile& file, std::size_t number, int type, const SolidGroup& group)
{
  file.Decimal(number);
  file.Text(" ");
  file.Decimal(type);
  file.Text(" 2 ");
  file.Decimal(group.Number);
  file.Text(" ");
  file.Decimal(group.Number);
}

void WriteMsh22(OutputFile& file, const SolidMesh& solid)
{
  WriteHead(file, solid, "2.2");
  file.Text("$Nodes\n");
  WriteLine(file, solid.Points.size());
  for (std::size_t p = 0; p < solid.Points.size(); ++p)
  {
    file.Decimal(p + 1);
    file.Text(" ");
    WriteCoordinates(file, solid.Points[p]);
    file.Text("\n");
  }
  file.Text("$EndNodes\n$Elements\n");
  WriteLine(file, solid.Faces.size() + solid.NumberOfCells());
  for (std::size_t f = 0; f < solid.Faces.size(); ++f)
  {
    BeginElement(file, f + 1, TypeOfFace(solid, f), solid.Tags[solid.TagOfFace[f]]);
    WriteNumbers(file, NodesOf(solid, solid.Faces[f]));
    file.Text("\n");
  }
  for (std::size_t c = 0; c < solid.NumberOfCells(); ++c)
  {
    BeginElement(
      file, solid.Faces.size() + c + 1, TypeOfCell(solid, c), solid.Regions[solid.RegionOfCell[c]]);
    WriteNumbers(file, MshNodesOf(solid, c));
    file.Text("\n");
  }
  file.Text("$EndElements\n");
}
} // namespace

void WriteMsh(OutputFile& file, const SolidMesh& solid, MshVersion version)
{
  version == MshVersion::Msh22 ? WriteMsh22(file, solid) : WriteMsh41(file, solid);
  // At the end, for programs that do not support comments.
  file.Text("$Comments\nWritten by InsideOut\n$EndComments\n");
}
} // namespace insideout
