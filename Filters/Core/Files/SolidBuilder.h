// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidFile.h"
#include "Files/SurfaceReaders.h"
#include "Files/TextScanner.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace insideout
{
/** An element as in a file. */
struct FileElement
{
  std::int64_t Number; ///< its number in the file
  std::int64_t Line;
  std::int64_t Group = 0;  ///< 0 for none
  std::int64_t Entity = 0; ///< the geometric entity that it lies on, for files without groups
  std::size_t Begin = 0;   ///< numbers of its nodes, corners first and midpoints in VTK's order
  bool IsQuadratic = false;
};

/** Elements of one shape. */
struct FileElements
{
  const char* Name; ///< nodes per element
  std::size_t Corners;
  std::vector<FileElement> All = {};
  std::vector<std::int64_t> Nodes = {}; ///< the numbers of points, of all elements
  std::map<std::int64_t, std::string> NamesOfGroups = {};
};

/**
 * Makes a solid of a file's numbered points and elements. Numbers may be in any order and have
 * gaps; an element may come before its points.
 */
class SolidBuilder
{
public:
  explicit SolidBuilder(const FileContent& file);

  /** @throws Error FileMalformed for coordinates that are not finite */
  void AddPoint(const TextScanner& scanner, std::int64_t number, const Point& point);

  /** The number of an element's nodes determines whether it has midpoints. */
  static void AddElement(
    FileElements& elements, const FileElement& element, const std::vector<std::int64_t>& nodes);

  /** Count elements of another shape, with their plural name for messages. */
  void AddOthers(const std::string& shape, std::int64_t count)
  {
    this->Others[shape] += static_cast<std::uint64_t>(count);
  }

  /** Warn of skipped elements. */
  void Warn(const std::string& what);

  /** @throws Error FileMalformed: an element refers to no point, a number is there twice, there
   * are neither tetrahedra nor triangles; TooLarge */
  SolidContent Finish();

  FileElements Tetrahedra = { "tetrahedron", 4 };
  FileElements Triangles = { "triangle", 3 };

private:
  void SortPoints();
  void WarnOfOthers();
  Id IdOf(const FileElements& elements, const FileElement& element, std::size_t node) const;
  template <std::size_t Corners, std::size_t Edges>
  void Fill(FileElements& elements, bool keepsMidpoints, SolidElements<Corners, Edges>& filled);
  template <std::size_t Corners, std::size_t Edges>
  void NumberGroups(FileElements& elements, SolidElements<Corners, Edges>& filled);

  const FileContent& File;
  std::vector<std::int64_t> Numbers; ///< of the points
  std::map<std::string, std::uint64_t> Others;
  SolidContent Solid;
};

/** @throws Error FileMalformed: the file's name, the line, then `what` */
[[noreturn]] void FailAtLine(const FileContent& file, std::int64_t line, const std::string& what);

/** Order elements by their numbers.
 * @throws Error FileMalformed for one that is there twice */
void SortByNumber(const FileContent& file, const char* name, std::vector<FileElement>& elements);

/**
 * @throws Error FileMalformed unless `left` bytes can hold `count` things of at least `shortest`
 * bytes
 */
void CheckAnnounced(
  const TextScanner& scanner, std::int64_t count, std::uint64_t shortest, const char* things);
} // namespace insideout
