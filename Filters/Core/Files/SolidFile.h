// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <string>
#include <vector>

namespace insideout
{
/** A face of a cell, as TetrahedronFaces has it. */
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

  /** The points between each cell's corners, on TetrahedronEdges. Empty where cells are linear. */
  std::vector<std::array<Id, 6>> Midpoints;

  std::vector<Id> RegionOfCell; ///< which of Regions

  /** Faces of the boundary, and between regions, each once: it faces out of its cell. */
  std::vector<CellFace> Faces;
  std::vector<Id> TagOfFace; ///< which of Tags

  std::vector<SolidGroup> Regions;
  std::vector<SolidGroup> Tags;
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
 *   surfaces by element face of tags, and sets of all, `Eall` and `Nall`.
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
} // namespace insideout
