// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

/**
 * The header of a PLY file: Turk, The PLY Polygon File Format (1994), with the type names that came
 * later.
 */
namespace insideout
{
/** The number types of the format. */
enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

/** The names, length in bytes and range of a type. */
struct PlyTypeFacts
{
  const char* Name;
  const char* OtherName;
  std::uint64_t Length;
  double Lowest;
  double Highest;
  bool IsInteger;
};

/** The properties of type T, which the format calls by either name. */
template <typename T>
constexpr PlyTypeFacts MakePlyTypeFacts(const char* name, const char* otherName)
{
  using Limits = std::numeric_limits<T>;
  return { name, otherName, sizeof(T), double(Limits::lowest()), double(Limits::max()),
    std::is_integral_v<T> };
}

/** In the order of PlyType. */
inline constexpr std::array<PlyTypeFacts, 8> PlyTypes = {
  MakePlyTypeFacts<std::int8_t>("char", "int8"), MakePlyTypeFacts<std::uint8_t>("uchar", "uint8"),
  MakePlyTypeFacts<std::int16_t>("short", "int16"),
  MakePlyTypeFacts<std::uint16_t>("ushort", "uint16"),
  MakePlyTypeFacts<std::int32_t>("int", "int32"), MakePlyTypeFacts<std::uint32_t>("uint", "uint32"),
  MakePlyTypeFacts<float>("float", "float32"), MakePlyTypeFacts<double>("double", "float64")
};

/** The properties of a type. */
constexpr const PlyTypeFacts& FactsOf(PlyType type)
{
  return PlyTypes[static_cast<std::size_t>(type)];
}

/** A number, or a list of numbers, that each element of a kind has. */
struct PlyProperty
{
  std::string Name;
  PlyType Type = PlyType::Float64; ///< type of the number, or of each in the list
  bool IsList = false;
  PlyType CountType = PlyType::UInt8; ///< type of the length of a list
  std::vector<double> Values;         ///< see ReadPlyBody. Doubles hold every type.
};

/** A kind of elements, such as the vertices. */
struct PlyElement
{
  std::string Name;
  std::uint64_t Count = 0;
  std::vector<PlyProperty> Properties; ///< in the order of the body

  /** Whether a PolygonSurface can hold it. Strips of triangles become faces. */
  bool IsKept() const { return this->Name == "vertex" || this->Name == "face"; }

  /** The property of this name, null if there is none. */
  const PlyProperty* Find(std::string_view name) const;

  /** Remove the property of this name, which must exist. */
  void Remove(std::string_view name);
};

/** The encoding of the body. */
enum class PlyFormat
{
  Unknown,
  Ascii,
  LittleEndian,
  BigEndian
};

/** The whole header: the elements in the body, and the start of the body. */
struct PlyHeader
{
  PlyFormat Format = PlyFormat::Unknown;
  std::vector<PlyElement> Elements; ///< in the order of the body
  const char* Body = nullptr;       ///< the first byte after the header
  std::int64_t BodyLine = 0;        ///< the line of that byte, counted from 1
  std::int64_t UnknownStatements = 0;
  std::string FirstUnknown; ///< its line and first word, for messages

  /** The element of this name, null if there is none. */
  PlyElement* Find(std::string_view name);

  /** Whether it declares at least one face. */
  bool HasFaces() const;

  /**
   * The list of points of the element that polygons come from, `vertex_indices` or `vertex_index`:
   * of the faces, or of strips of triangles (`tristrips`) if there are no faces. Else null.
   */
  const PlyProperty* PointIdsOf(const PlyElement& element) const;
};

/**
 * Read the header. The result has a format and an element vertex with the numbers x, y and z;
 * faces, if there are any, have their list of points; the names of elements, and of the properties
 * of each, differ and are not empty. Values are still empty. Unknown statements are counted and
 * skipped.
 * @throws Error FileMalformed if this is violated, Stopped
 */
PlyHeader ReadPlyHeader(const FileContent& file, Monitor& monitor);
} // namespace insideout
