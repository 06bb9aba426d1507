// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The tags of the cells of a surface, for the boundary of the solid that is made of it.
 */
#pragma once

#include "In/Blocks.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace vtkInsideOut
{
/** The array of tags that this house makes. */
constexpr const char* BoundaryTag = "BoundaryTag";

/** The tag of a surface that says nothing. */
constexpr const char* NoTag = "surface";

/** Tags are numbers from 0, which have names. */
struct Tags
{
  std::vector<int> OfCell; ///< one per cell of the surface, -1 where it does not count
  std::vector<std::string> Names;
};

/**
 * The tags that a cell array of integers or strings gives to the polygons of a surface, or to its
 * lines where it has no polygons. Integers are numbered in their order. Their names are those of
 * the field array of strings that goes with the array (GroupNames with GroupIds, BoundaryTagNames
 * with BoundaryTag), else themselves; strings are numbered in the order of their first cells. Cells
 * with one name have one tag. A point array will do if it is constant in each cell.
 *
 * Where no array is named it is the first that tells cells apart: the tags of a boundary made here
 * (BoundaryTag), groups (GroupIds), materials (MaterialIds), solids of VTK's STL reader
 * (STLSolidLabeling); the blocks of a composite data set, of which this surface is one. If none
 * does all cells have one tag: the one name that the first of these gives, or else surface.
 *
 * @throws insideout::Error when the surface has no such array, or it holds something else
 */
Tags ReadTags(vtkPolyData* surface, const std::string& name, const Blocks& blocks);

/**
 * The tags that a cell array of two integers gives to both sides of each polygon: two for each
 * cell, behind it and before it, where its normal points. 0 is the background, and has the tag -1.
 * Nothing where the surface has no such array.
 *
 * @throws insideout::Error as ReadTags does
 */
std::optional<Tags> ReadSides(vtkPolyData* surface, const std::string& name);

/** The cell arrays that tag cells: those of ReadTags, integers with names, and strings. */
std::vector<std::string> FindTagArrays(vtkPolyData* surface);

/** The name of the field array that names an array's integers. */
std::string NameOfNames(const std::string& array);

/** A name that no other has: itself, or with a number from 2 on behind it. */
std::string NewName(const std::string& name, const std::vector<std::string>& others);

/** Tag the triangles of a boundary by its vtkOriginalCellIds: the cell array BoundaryTag, and the
 * field array BoundaryTagNames. Those that lie on no cell close a hole, and have a tag of their
 * own, the last. */
void AddTags(const Tags& tags, vtkPolyData* boundary);

/**
 * Give the pieces of one surface the same names for what their cell arrays of integers number.
 * Where the field arrays of names differ, all get one that has all names, and the cell arrays are
 * renumbered. A number without a name is called as it is written.
 */
void ShareNames(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces);
} // namespace vtkInsideOut
