// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LayerCells.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

#include <string>
#include <vector>

namespace insideout
{
/** A face of a cell: of a tetrahedron in the order of TetrahedronFaces; of a pyramid the triangle
 * at corners Face and Face + 1 of its base, then the base; of a prism its first or second triangle,
 * then the quads at its edges 0 to 1, 1 to 2 and 2 to 0. */
struct CellFace
{
  Id Cell;
  int Face;
};

/** Cells or faces that a solver knows by a name. */
struct SolidGroup
{
  std::string Name;
  Id Number; ///< its number in formats without names: positive, and unique in its kind
};

/** The content of a solver's file: cells by regions, and their tagged faces. */
struct SolidMesh : LayerCells
{
  std::vector<Point> Points;
  std::vector<Tetrahedron> Cells; ///< their corners

  /**
   * The mid-edge nodes of each cell, in the order of TetrahedronEdges. Empty if cells are linear.
   */
  std::vector<std::array<Id, 6>> Midpoints;

  std::vector<Id>
    RegionOfCell; ///< indices in Regions: of tetrahedra, pyramids and prisms, in this order

  /** Faces of the boundary, and between regions, each once: it faces out of its cell. */
  std::vector<CellFace> Faces;
  std::vector<Id> TagOfFace; ///< indices in Tags

  std::vector<SolidGroup> Regions;
  std::vector<SolidGroup> Tags;

  std::size_t NumberOfCells() const
  {
    return this->Cells.size() + this->Pyramids.size() + this->Prisms.size();
  }
};

/** Gmsh's format version. */
enum class MshVersion
{
  Msh41,
  Msh22
};

/**
 * Write a solid for a solver, by the name's ending:
 *
 * - `.msh`: gmsh's format, ascii, with a physical group for each region and each tag. More programs
 *   read ascii than binary, and decimals keep every bit as well.
 * - `.inp`: the format of Abaqus and CalculiX: element and node sets of regions, node sets and
 *   surfaces by element face of tags, and sets of all, `Eall` and `Nall`. Prisms are C3D6, and so
 *   are pyramids, for which CalculiX has no element: their last corner is repeated.
 * - `.mesh`: Medit's format, ascii, in which regions and tags are numbers; comments name them.
 *
 * Point p has number p + 1 in all of them. Names that a format does not allow are changed
 * minimally, so that they are valid and unique (ValidNames). Coordinates read back to the last bit,
 * except in .inp, whose numbers have at most 20 characters: the nearest such number is exact from
 * 0.01 to 1e17, with a relative error below 1e-12 elsewhere.
 *
 * The file is written atomically (OutputFile). `monitor` gets Stages::Writing.
 *
 * @throws Error FileUnwritable; InvalidParameter for another ending, and for a solid that has no
 * cells, or whose parts do not fit together; PointOutOfRange, PointNotFinite; TooLarge (out of
 * memory); Stopped. On error the file is unchanged.
 */
void WriteSolid(
  const std::string& path, const SolidMesh& solid, MshVersion version, Monitor& monitor);

/** The points as read back from the file of this name that WriteSolid writes. */
std::vector<Point> PointsInFile(const std::string& path, std::vector<Point> points);

/** Cells of one shape, with their groups. */
template <std::size_t Corners, std::size_t Edges>
struct SolidElements
{
  std::vector<std::array<Id, Corners>> Cells;

  /** The mid-edge nodes, in VTK's order. Empty if cells are linear. */
  std::vector<std::array<Id, Edges>> Midpoints;

  std::vector<Id> GroupOf;
  std::vector<SolidGroup> Groups; ///< by ascending number; unnamed groups have an empty name
};

/** The content of a solver's file: tetrahedra, and triangles of their boundary and between regions;
 * or triangles alone, as cells. */
struct SolidContent
{
  std::vector<Point> Points;
  SolidElements<4, 6> Tetrahedra;
  SolidElements<3, 3> Triangles;     ///< without midpoints if there are tetrahedra
  std::vector<std::string> Warnings; ///< warnings of skipped content, one line each
};

/**
 * Read a solid from a file of the formats that WriteSolid writes, by the name's ending. Points,
 * cells, groups and their numbers are those written; names are those changed for the format.
 *
 * - `.msh`: gmsh's format, 4.1 and 2.x, ascii. Groups are the physical ones; if no cell is in one,
 *   the entities that cells lie on. An entity belongs to its first group.
 * - `.inp`: the format of Abaqus and CalculiX, of one part. Regions are the ELSET of elements; but
 *   lists of element numbers where each cell is in one list, or where there is nothing else.
 *   Triangles are shells, membranes and plane elements, and the faces of tetrahedra in surfaces.
 *   Other files (*INCLUDE) are not read, with a warning.
 * - `.mesh`: Medit's format, ascii. References become groups, whose names are read from
 *   WriteSolid's comments.
 *
 * Points and cells are in the order of their numbers; points in no cell are kept. Cells are all
 * quadratic or all linear: if a file has both, midpoints are dropped, with a warning. Other volumes
 * and faces are counted in a warning; points, lines and all else are skipped. Groups keep the
 * file's numbers if all are from 0 to 65535, else they are numbered in their order. Cells and faces
 * of no group get the next number. The file is validated: unknown points, repeated numbers,
 * coordinates that are not finite, and truncated or malformed files are errors that name file, line
 * and element.
 *
 * `monitor` gets Stages::Reading.
 *
 * @throws Error FileUnreadable (missing, a folder, another ending), FileMalformed, TooLarge (Id
 * cannot count it, or memory not hold it), Stopped
 */
SolidContent ReadSolid(const std::string& path, Monitor& monitor);
} // namespace insideout
