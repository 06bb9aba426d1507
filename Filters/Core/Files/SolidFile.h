// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <string>
#include <vector>

namespace insideout
{
/** A triangle of a cell: of a tetrahedron as TetrahedronFaces has it; of a pyramid the one at
 * corners Face and Face + 1 of its base; of a prism its first or second one. */
struct CellFace
{
  Id Cell;
  int Face;
};

/** Cells or faces that a solver is to know by a name. */
struct SolidGroup
{
  std::string Name;
  Id Number; ///< what stands for it in formats without names: above 0, and no other's of its kind
};

/** What a file for a solver holds: cells by regions, and those of their faces that have a tag. */
struct SolidMesh
{
  std::vector<Point> Points;
  std::vector<Tetrahedron> Cells; ///< their corners

  /** Cells of boundary layers, corners in VTK's order: the base of a pyramid is counter-clockwise
   * seen from its last corner, the first triangle of a prism seen from outside. */
  std::vector<std::array<Id, 5>> Pyramids;
  std::vector<std::array<Id, 6>> Prisms;

  /** The points between each cell's corners, on TetrahedronEdges. Empty where cells are linear. */
  std::vector<std::array<Id, 6>> Midpoints;

  std::vector<Id>
    RegionOfCell; ///< which of Regions: of tetrahedra, pyramids and prisms, in this order

  /** Faces of the boundary, and between regions, each once: it faces out of its cell. */
  std::vector<CellFace> Faces;
  std::vector<Id> TagOfFace; ///< which of Tags

  std::vector<SolidGroup> Regions;
  std::vector<SolidGroup> Tags;

  bool HasLayers() const { return !this->Pyramids.empty() || !this->Prisms.empty(); }
  std::size_t NumberOfCells() const
  {
    return this->Cells.size() + this->Pyramids.size() + this->Prisms.size();
  }
};

/** Which of gmsh's formats. */
enum class MshVersion
{
  Msh41,
  Msh22
};

/**
 * Write a solid for a solver, by the name's ending:
 *
 * - `.msh`: gmsh's format, ascii, with a physical group for each region and each tag. Ascii,
 *   because more programs read it so than binary, and decimals keep every bit as well.
 * - `.inp`: the format of Abaqus and CalculiX: element and node sets of regions, node sets and
 *   surfaces by element face of tags, and sets of all, `Eall` and `Nall`. Prisms are C3D6, and so
 *   are pyramids, for which CalculiX has no element: they have their last corner twice.
 * - `.mesh`: Medit's format, ascii, in which regions and tags are numbers; comments name them.
 *
 * Point p has number p + 1 in all of them. Names that a format does not take are changed, as little
 * as can be, so that each is valid there and another than all others (ValidNames). Coordinates are
 * read back to the last bit, but for .inp, whose numbers may have 20 characters: the nearest of
 * these is the same from 0.01 to 1e17, and differs by less than 1e-12 of it elsewhere.
 *
 * The file is there whole or not at all, and an earlier one stays as it was until then
 * (OutputFile). `monitor` is told of Stages::Writing.
 *
 * @throws Error FileUnwritable; InvalidParameter for another ending, and for a solid that has no
 * cells, or whose parts do not fit together; PointOutOfRange, PointNotFinite; TooLarge (memory does
 * not hold what is needed to write); Stopped. In error the file is as it was.
 */
void WriteSolid(
  const std::string& path, const SolidMesh& solid, MshVersion version, Monitor& monitor);

/** The points as a program reads them in the file of this name that WriteSolid writes. */
std::vector<Point> PointsInFile(const std::string& path, std::vector<Point> points);

/** Cells of one shape that were read, and the groups that they are in. */
template <std::size_t Corners, std::size_t Edges>
struct SolidElements
{
  std::vector<std::array<Id, Corners>> Cells;

  /** The points in the middle of edges, in VTK's order. Empty where cells are linear. */
  std::vector<std::array<Id, Edges>> Midpoints;

  std::vector<Id> GroupOf;
  std::vector<SolidGroup> Groups; ///< by ascending number; what has no name has an empty one
};

/** The content of a solver's file: tetrahedra, and triangles of their boundary and between
 * regions; or triangles alone, which are cells of their own. */
struct SolidContent
{
  std::vector<Point> Points;
  SolidElements<4, 6> Tetrahedra;
  SolidElements<3, 3> Triangles;     ///< without midpoints where there are tetrahedra
  std::vector<std::string> Warnings; ///< what was in the file and was passed over, one line each
};

/**
 * Read a solid from a file of the formats that WriteSolid writes, by the name's ending. Points,
 * cells, names and numbers of groups are those that it wrote; names as the format takes them.
 *
 * - `.msh`: gmsh's format, 4.1 and 2.x, ascii. Groups are the physical ones; where no cell is in
 *   one, the entities that cells lie on. The first of several groups of an entity counts.
 * - `.inp`: the format of Abaqus and CalculiX, of one part. Regions are the ELSET of elements; but
 *   lists of element numbers where each cell is in one list, or where there is nothing else.
 *   Triangles are shells, membranes and plane elements, and the faces of tetrahedra in surfaces.
 *   Other files (*INCLUDE) are not read, with a warning.
 * - `.mesh`: Medit's format, ascii. Groups are the references; their names, WriteSolid's comments.
 *
 * Points and cells are in the order of their numbers; points that no cell has stay. Cells are all
 * quadratic or all linear: where both are in a file midpoints are dropped, with a warning. Other
 * volumes and faces are counted in a warning; points, lines and what is no mesh are passed over.
 * Groups keep the numbers of the file if all of these are from 0 to 65535, else they are numbered
 * in their order. Cells and faces of no group get the number behind the last. Nothing in the file
 * is trusted: a number of no point, a number given twice, a coordinate that is not finite, and a
 * truncated or malformed file are errors that name file, line and element.
 *
 * `monitor` is told of Stages::Reading.
 *
 * @throws Error FileUnreadable (missing, a folder, another ending), FileMalformed, TooLarge (Id
 * cannot count it, or memory not hold it), Stopped
 */
SolidContent ReadSolid(const std::string& path, Monitor& monitor);
} // namespace insideout
