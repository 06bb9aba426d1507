// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceFile.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/** Shared by the readers of the surface formats; call them through ReadSurface. */
namespace insideout
{
/** A file in memory. */
struct FileContent
{
  std::string Name; ///< without its folder, for messages
  std::unique_ptr<char[]> Bytes;
  std::size_t Size = 0;

  const char* Begin() const { return this->Bytes.get(); }
  const char* End() const { return this->Bytes.get() + this->Size; }

  /** The beginning of a text, after the byte order mark that some editors insert. */
  const char* TextBegin() const;

  /** Report progress: the file is parsed up to `at`. */
  void ReportPosition(const char* at, Monitor& monitor) const;
};

/** A file as on the disk, not empty. @throws Error FileUnreadable, FileMalformed, Stopped */
FileContent LoadFile(const std::string& path, Monitor& monitor);

/** Whether the first line is that of a PLY file. */
bool IsPly(const FileContent& file);

/** Whether the first word is that of an OFF file. */
bool IsOff(const FileContent& file, Monitor& monitor);

/** Whether it begins like an ascii STL file, or has the length of a binary one. */
bool IsStl(const FileContent& file, Monitor& monitor);

/**
 * Whether a vertex of three numbers comes first, except for statements allowed before it in OBJ.
 */
bool IsObj(const FileContent& file, Monitor& monitor);

/** The readers, with ReadSurface's errors. Each file has at least one byte. @{ */
PolygonSurface ReadObj(const FileContent& file, Monitor& monitor);
PolygonSurface ReadOff(const FileContent& file, Monitor& monitor);
PolygonSurface ReadPly(const FileContent& file, Monitor& monitor);
PolygonSurface ReadStl(const FileContent& file, Monitor& monitor);
/** @} */

/** An Error FileMalformed: the file's name, then `what`. */
Error Malformed(const FileContent& file, const std::string& what);

/** @throws Error TooLarge if Id cannot count `count` of `things` */
void CheckCount(const FileContent& file, std::uint64_t count, const char* things);

/**
 * Make the corners after the last polygon a polygon, or drop them if they are fewer than three.
 * @return whether it is a polygon
 * @throws Error TooLarge
 */
bool ClosePolygon(const FileContent& file, PolygonSurface& surface);

/** Warn of the number of polygons that ClosePolygon dropped, if any. */
void WarnOfDropped(const FileContent& file, std::uint64_t dropped, PolygonSurface& surface);

/** Colors given as numbers of points or polygons, for all of them or not at all. */
class ColorColumn
{
public:
  /** Add the color of the next point or polygon: 3 or 4 numbers; anything else is no color. */
  void Add(const std::vector<double>& color);

  /** Whether any point or polygon had a color, even an invalid one. */
  bool Any() const { return this->SomeNumbers; }

  /**
   * The attribute `Colors`. Numbers are 0 to 1 if the largest in the file is at most 1, else 0 to
   * 255. Nothing if a color is missing, has another number of components or is beyond 255.
   */
  std::optional<Attribute> ToAttribute() const;

private:
  bool SomeNumbers = false;
  bool Complete = true;
  std::size_t Components = 0;
  std::vector<double> Values;
};

/**
 * Convert numbers from 0 to 1, or from 0 to 255 if one is larger than 1, to bytes. Nothing if one
 * is outside or NaN.
 */
std::optional<std::vector<unsigned char>> ToColorBytes(const std::vector<double>& numbers);
} // namespace insideout
