// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Monitor.h"
#include "Types.h"

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

/** What a surface file holds. Polygon p has the corners Corners[Offsets[p]] to Corners[Offsets[p +
 * 1]]. */
struct PolygonSurface
{
  std::vector<Point> Points;
  std::vector<Id> Offsets = { 0 };
  std::vector<Id> Corners;
  std::vector<Attribute> PointAttributes;
  std::vector<Attribute> PolygonAttributes;
  std::vector<std::string> Warnings; ///< what was in the file and was passed over, one line each
};

/**
 * Read a surface from an OBJ, OFF, PLY or STL file, ascii or binary, by its content where the
 * format has a mark and else by the name's ending. Coordinates are kept to the last bit. Every
 * count and id is checked before it is used: an id out of range, a truncated or malformed file is
 * an error that names the line or the element. Coordinates may be infinite or NaN here: validation
 * names the point.
 *
 * Points keep the file's order. Where an OBJ file gives one point several texture coordinates or
 * normals, a copy of the point per combination follows behind the last. STL points are the corners
 * of the facets, three each.
 *
 * PolygonAttributes and PointAttributes: `Normals` (3 floats or doubles), `TCoords` (2), `Colors`
 * (3 or 4 unsigned char), `GroupIds` and `MaterialIds` (int, in the order of first appearance) and
 * every other property of a PLY file under its own name.
 *
 * @throws Error FileUnreadable, FileMalformed, TooLarge, Stopped
 */
PolygonSurface ReadSurface(const std::string& path, Monitor& monitor);

/**
 * Write a surface as PLY (binary, doubles), OBJ (17 digits) or STL (binary, floats: the format has
 * no doubles), by the name's ending. Attributes that the format knows are written: colours, normals
 * and texture coordinates in PLY and OBJ, any numbers in PLY.
 *
 * @throws Error FileUnwritable, InvalidParameter for another ending
 */
void WriteSurface(const std::string& path, const PolygonSurface& surface);
} // namespace insideout
