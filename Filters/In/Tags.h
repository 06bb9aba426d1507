// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The tags of the cells of a surface, for the boundary of the solid that is made of it.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "In/Blocks.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace vtkInsideOut
{
/** The array of tags made by this module. */
constexpr const char* BoundaryTag = "BoundaryTag";

/** The default tag of a surface. */
constexpr const char* NoTag = "surface";

/** Tags are numbers from 0, which have names. */
struct Tags
{
  std::vector<int> OfCell; ///< one per cell of the surface, -1 if it does not count
  std::vector<std::string> Names;
};

/**
 * The tags that a cell array of integers or strings gives to the polygons of a surface, or to its
 * lines where it has no polygons. Integers are numbered in their order. Their names are in the
 * associated field array of strings (GroupNames for GroupIds, BoundaryTagNames for BoundaryTag),
 * else the integers themselves; strings are numbered in the order of their first cells. Cells with
 * one name have one tag. A point array is accepted if it is constant in each cell.
 *
 * Without a name it is the first of these that distinguishes cells: the tags of a boundary made
 * here (BoundaryTag), groups (GroupIds), materials (MaterialIds), solids of VTK's STL reader
 * (STLSolidLabeling), the blocks of a composite data set with this surface. If none does, all cells
 * have one tag: the single name from the first of these, or else surface.
 *
 * @throws insideout::Error if the surface has no such array, or it has another type
 */
Tags ReadTags(vtkPolyData* surface, const std::string& name, const Blocks& blocks);

/**
 * The tags of both sides of each polygon from a cell array of two integers: behind it and in front
 * of it, where its normal points. 0 is the background, with the tag -1. Nothing without such an
 * array.
 *
 * @throws insideout::Error as ReadTags does
 */
std::optional<Tags> ReadSides(vtkPolyData* surface, const std::string& name);

/** The cell arrays that tag cells: those of ReadTags, integers with names, and strings. */
std::vector<std::string> FindTagArrays(vtkPolyData* surface);

/** The name of the field array with the names of an array's integers. */
std::string NameOfNames(const std::string& array);

/** A unique name: unchanged, or with a number from 2 on appended. */
std::string NewName(const std::string& name, const std::vector<std::string>& others);

/** Tag the triangles of a boundary by its vtkOriginalCellIds: the cell array BoundaryTag, and the
 * field array BoundaryTagNames. Triangles on no cell close a hole, and have a tag of their own, the
 * last. */
void AddTags(const Tags& tags, vtkPolyData* boundary);

/**
 * Unify the names of integers in cell arrays of one surface's blocks. If the field arrays of names
 * differ, all get one with all names, and the cell arrays are renumbered. The name of an unnamed
 * number is the number.
 */
void ShareNames(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces);
} // namespace vtkInsideOut
