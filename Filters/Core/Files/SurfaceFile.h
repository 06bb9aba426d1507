// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <string>
#include <variant>
#include <vector>

namespace insideout
{
/** A named array of points or polygons, with as many components each. */
struct Attribute
{
  std::string Name;
  int Components = 1;
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>,
    std::vector<unsigned char>>
    Values;
};

/** The names of what an attribute of polygons numbers: Values[i] is that of i. In UTF-8. */
struct AttributeNames
{
  std::string Name;
  std::vector<std::string> Values;
};

/** What a surface file holds. Polygon p has the corners Corners[Offsets[p]] to Corners[Offsets[p +
 * 1]]. */
struct PolygonSurface
{
  std::vector<Point> Points;
  std::vector<Id> Offsets = { 0 };
  std::vector<Id> Corners;
  std::vector<Attribute> PointAttributes;
  std::vector<Attribute> PolygonAttributes;
  std::vector<AttributeNames> Names;
  std::vector<Id> LineOffsets = { 0 }; ///< of polylines, where there are no polygons
  std::vector<Id> LineCorners;
  std::vector<std::string> Warnings; ///< what was in the file and was passed over, one line each
};

/**
 * Read a surface from an OBJ, OFF, PLY or STL file, ascii or binary, by the mark of a format, or
 * else by the name's ending, upper or lower case. (OFF is read as ascii only, OBJ has no other.)
 * Each may be compressed with gzip, and its name then end in `.gz`. Where the name says something
 * else than the content there is a warning. Coordinates are kept to the last bit; what is written
 * in decimal becomes the nearest double, whatever its declared type and the locale. Every count and
 * id is checked before it is used: an id out of range, a truncated or malformed file is an error
 * whose message names the file, then the line or the element. Coordinates may be infinite or NaN
 * here: validation names the point.
 *
 * Points keep the file's order. Where an OBJ file gives one point several texture coordinates or
 * normals, a copy of the point per combination follows behind the last. STL points are the corners
 * of the facets, three each. Polygons keep the file's order too; those with fewer than 3 corners
 * are passed over with a warning. So are points, unknown statements, elements of other names, and
 * lines, but for those of an OBJ file without faces, whose PolygonAttributes are then theirs. PLY's
 * strips of triangles (`tristrips`) are taken apart where there are no faces.
 *
 * PointAttributes and PolygonAttributes:
 * - `Normals` (3 floats or doubles) and `TCoords` (2) of points, and PLY's `Normals` of polygons;
 *   those of OBJ only where every corner has them, 0 at points that no polygon uses. An OBJ face
 *   that refers to texture coordinates or normals that do not exist costs them all, with a warning.
 *   The normals of STL facets follow from the corners and are not kept.
 * - `Colors` (3 or 4 unsigned char) of points and polygons, where all (in OBJ: all points in use)
 *   have one; in binary STL the two spare bytes may hold it. Numbers that are not bytes count from
 * 0 to 1 if none is larger, else from 0 to 255.
 * - `GroupIds` (int) of polygons: pairs of `o` and `g` in OBJ, solids in STL where there are
 *   several. `MaterialIds` (int): `usemtl` in OBJ. Both number what polygons use, in the order of
 *   first use, and solids even where they have one name. Names has `GroupNames` and
 *   `MaterialNames`: of solids as they stand in the file, which may be empty or the same for
 *   several; of OBJ see NamesOfGroups and NamesOrDefault. Text that is not UTF-8 is read as
 *   Latin-1.
 * - Every other number of a PLY vertex or face under its own name: unsigned char for uchar, int for
 *   integers that fit, float for float, else double. Lists are passed over with a warning.
 *
 * `monitor` is told of Stages::Reading.
 *
 * @throws Error FileUnreadable (missing, a folder, not to be opened), FileMalformed, TooLarge (Id
 * cannot count it, or memory not hold it), Stopped
 */
PolygonSurface ReadSurface(const std::string& path, Monitor& monitor);

/**
 * Write a surface as PLY, OBJ or OFF (text, with as many digits as keep every bit) or STL (binary,
 * floats: the format has no doubles), by the name's ending. Attributes that the format
 * knows are written: `Colors`, `Normals` and `TCoords` of points in PLY and OBJ, and any other
 * attribute in PLY, one property per component: NAME_0, NAME_1, ... OBJ gets groups by the names of
 * `BoundaryTag` or else `GroupIds`, and materials by those of `MaterialIds`, where Names has them;
 * what has no name is called by its number.
 *
 * The file is there whole or not at all, and an earlier one stays as it was until then
 * (OutputFile). `monitor` is told of Stages::Writing.
 *
 * @throws Error FileUnwritable; InvalidParameter for another ending, for attributes or offsets of
 * the wrong length, and in STL for polygons that are no triangles and points that no float holds;
 * PointOutOfRange for a corner that is no point; TooLarge (memory does not hold what is to be
 * written); Stopped. In error the file is as it was.
 */
void WriteSurface(const std::string& path, const PolygonSurface& surface, Monitor& monitor);

/** Whether a file of this name has coordinates in floats. */
bool HasFloats(const std::string& path);
} // namespace insideout
