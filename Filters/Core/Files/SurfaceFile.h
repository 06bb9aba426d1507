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

/** The names of an attribute's numbers: Values[i] is that of i. In UTF-8. */
struct AttributeNames
{
  std::string Name;
  std::vector<std::string> Values;
};

/** The content of a surface file. Polygon p has the corners Corners[Offsets[p]] to
 * Corners[Offsets[p + 1]]. */
struct PolygonSurface
{
  std::vector<Point> Points;
  std::vector<Id> Offsets = { 0 };
  std::vector<Id> Corners;
  std::vector<Attribute> PointAttributes;
  std::vector<Attribute> PolygonAttributes;
  std::vector<AttributeNames> Names;
  std::vector<Id> LineOffsets = { 0 }; ///< attributes of polylines if there are no polygons
  std::vector<Id> LineCorners;
  std::vector<std::string> Warnings; ///< warnings of skipped content, one line each
};

/**
 * Read a surface from an OBJ, OFF, PLY or STL file, ascii or binary, by the mark of a format, or
 * else by the name's ending, upper or lower case. (OFF is read as ascii only, OBJ has no other.)
 * Files may be compressed with gzip; names may then end in `.gz`. If name and content disagree
 * there is a warning. Coordinates are kept to the last bit; decimals become the nearest double,
 * regardless of declared type and locale. Every count and id is checked before use: an id out of
 * range, a truncated or malformed file is an error whose message names the file, then the line or
 * the element. Coordinates may be infinite or NaN: validation names the point.
 *
 * Points keep the file's order. If an OBJ file gives one point several texture coordinates or
 * normals, a copy of the point per combination is appended. STL points are the corners of the
 * facets, three each. Polygons keep the file's order too. Skipped with a warning are polygons with
 * fewer than 3 corners, points, unknown statements, elements of other names, and lines. Lines of an
 * OBJ file without faces are read, with PolygonAttributes for them. PLY's strips of triangles
 * (`tristrips`) are split into triangles if there are no faces.
 *
 * PointAttributes and PolygonAttributes:
 * - `Normals` (3 floats or doubles) and `TCoords` (2) of points, and PLY's `Normals` of polygons;
 *   those of OBJ only if every corner has them, 0 at points unused by polygons. If an OBJ face
 *   refers to texture coordinates or normals that do not exist, all are dropped, with a warning.
 *   The normals of STL facets follow from the corners and are not kept.
 * - `Colors` (3 or 4 unsigned char) of points and polygons, if all (in OBJ: all points in use) have
 *   one; in binary STL the two spare bytes may hold it. Numbers other than bytes range from 0 to 1
 *   if none is larger, else from 0 to 255.
 * - `GroupIds` (int) of polygons: pairs of `o` and `g` in OBJ, solids in STL if there are several.
 *   `MaterialIds` (int): `usemtl` in OBJ. Both are numbered in the order of first use by polygons;
 *   solids of the same name get different numbers. Names has `GroupNames` and `MaterialNames`: of
 *   solids as in the file, possibly empty or repeated; of OBJ see NamesOfGroups and NamesOrDefault.
 *   Text that is not UTF-8 is read as Latin-1.
 * - Every other number of a PLY vertex or face under its own name: unsigned char for uchar, int for
 *   integers that fit, float for float, else double. Lists are skipped with a warning.
 *
 * `monitor` gets Stages::Reading.
 *
 * @throws Error FileUnreadable (missing, a folder, not to be opened), FileMalformed, TooLarge (Id
 * cannot count it, or memory not hold it), Stopped
 */
PolygonSurface ReadSurface(const std::string& path, Monitor& monitor);

/**
 * Write a surface as PLY, OBJ or OFF (text, with as many digits as keep every bit) or STL (binary,
 * floats: the format has no doubles), by the name's ending. Attributes that the format knows are
 * written: `Colors`, `Normals` and `TCoords` of points in PLY and OBJ, and any other attribute in
 * PLY, one property per component: NAME_0, NAME_1, ... OBJ gets groups by the names of
 * `BoundaryTag` or else `GroupIds`, and materials by those of `MaterialIds`; the name of an unnamed
 * one is its number.
 *
 * The file is written atomically (OutputFile). `monitor` gets Stages::Writing.
 *
 * @throws Error FileUnwritable; InvalidParameter for another ending, for attributes or offsets of
 * the wrong length, and in STL for polygons other than triangles and points beyond the range of
 * floats; PointOutOfRange for an invalid corner; TooLarge (out of memory); Stopped. On error the
 * file is unchanged.
 */
void WriteSurface(const std::string& path, const PolygonSurface& surface, Monitor& monitor);

/** Whether a file of this name stores coordinates as floats. */
bool HasFloats(const std::string& path);
} // namespace insideout
