// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Support/TestMeshes.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>

/** Contents of small surface files, of every format. */
namespace surfacefilesamples
{
using namespace insideout;

/** `value` as the bytes of a T, the lowest first or last. */
template <typename T>
inline std::string Binary(T value, bool big = false)
{
  std::string bytes(sizeof(T), '\0');
  std::memcpy(&bytes[0], &value, sizeof(T));
  if (big)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

template <typename T>
inline void Append(std::string& text, T value, bool big, bool ascii)
{
  text += ascii ? std::to_string(value) + " " : Binary(value, big);
}

inline void AppendReal(std::string& text, double value, bool big, bool ascii)
{
  char digits[40];
  std::snprintf(digits, sizeof(digits), "%.17g ", value);
  text += ascii ? std::string(digits) : Binary(value, big);
}

inline constexpr const char* Formats[3] = { "ascii", "binary_little_endian", "binary_big_endian" };

/** A PLY file of one triangle with something of every type. */
inline std::string PlyOfEveryType(int format)
{
  const bool ascii = format == 0;
  const bool big = format == 2;
  std::string text = std::string("ply\nformat ") + Formats[format] +
    " 1.0\ncomment element vertex 9\nobj_info x\n"
    "element material 2\nproperty uchar level\nproperty list uint8 float32 spectrum\n"
    "element face 1\nproperty short s16\nproperty list ushort uint vertex_indices\n"
    "property uint8 red\nproperty uint8 green\nproperty uint8 blue\n"
    "element vertex 3\nproperty char i8\nproperty double x\nproperty double y\n"
    "property double z\nproperty ushort u16\nproperty uint u32\nproperty int32 i32\n"
    "property float quality\nproperty uint huge\nend_header\n";
  for (int material = 0; material < 2; ++material)
  {
    Append<std::uint8_t>(text, 7, big, ascii);
    Append<std::uint8_t>(text, static_cast<std::uint8_t>(material), big, ascii);
    for (int i = 0; i < material; ++i)
    {
      Append<float>(text, 0.5f, big, ascii);
    }
    text += ascii ? "\n" : "";
  }
  Append<std::int16_t>(text, -300, big, ascii);
  Append<std::uint16_t>(text, 3, big, ascii);
  for (const std::uint32_t id : { 2u, 0u, 1u })
  {
    Append(text, id, big, ascii);
  }
  for (const std::uint8_t color : { 255, 128, 0 })
  {
    Append(text, color, big, ascii);
  }
  text += ascii ? "\n" : "";
  for (int p = 0; p < 3; ++p)
  {
    Append<std::int8_t>(text, static_cast<std::int8_t>(-p), big, ascii);
    AppendReal(text, 0.1 + p, big, ascii);
    AppendReal(text, p * 1e-310, big, ascii);
    AppendReal(text, -1.0 / 3.0 * p, big, ascii);
    Append<std::uint16_t>(text, 65535, big, ascii);
    Append<std::uint32_t>(text, 5, big, ascii);
    Append<std::int32_t>(text, -2147483647 - 1, big, ascii);
    Append<float>(text, 0.25f, big, ascii);
    Append<std::uint32_t>(text, 4000000000u, big, ascii);
    text += ascii ? "\n" : "";
  }
  return text;
}

/** A binary STL file of the box. */
inline std::string BinaryStl(const std::string& title)
{
  const TriangleSoup box = testmeshes::Box({ 0, 0, 0 }, { 1, 2, 0.1f });
  std::string text = title;
  text.resize(80, ' ');
  text += Binary(static_cast<std::uint32_t>(box.Triangles.size()));
  for (const Triangle& triangle : box.Triangles)
  {
    text += Binary(0.0f) + Binary(0.0f) + Binary(std::numeric_limits<float>::quiet_NaN());
    for (const Id p : triangle)
    {
      for (const double x : box.Points[p])
      {
        text += Binary(static_cast<float>(x));
      }
    }
    text += "\x7f\x01";
  }
  return text;
}

inline constexpr const char* AsciiStl =
  "solid a name of facet\n"
  "  facet normal nan -nan(ind) 1.#QNAN\n outer  loop\n"
  "vertex 0 0 0\n\tvertex 1E0 0.0 0\r\nVERTEX 0 +1.5e-1 -.5\n"
  "endloop endfacet\nendsolid a name\n\n"
  "SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\n"
  "VERTEX 1 0 0\nVERTEX 0 1 0.1\nENDLOOP\nENDFACET\nENDSOLID\n";

inline constexpr const char* TetrahedronOff = "OFF\n# a tetrahedron\n4 4 6\n\n"
                                              "0 0 0\n1 0 0 # right\n0 1 0\n0 0 1\n"
                                              "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

inline constexpr const char* SquareObj =
  "mtllib a.mtl\no Thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\n"
  "v 1 1 0 0 0 1\nv 0 1 0 1 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
  "vn 0 0 1\ng top\nusemtl red\nf 1/1/1 2/2/1 3/3/1\n"
  "usemtl blue\nf -4/-4/-1 -2/-2/-1 -1/-1/-1\n";
} // namespace surfacefilesamples
