// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidBuilder.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace insideout
{
/** A line that begins with one asterisk: `*ELEMENT, TYPE=C3D4, ELSET=red`. */
class InpKeyword
{
public:
  explicit InpKeyword(const std::string& line);

  /** Read the next line, too, where the last one ended with a comma. */
  void Continue(const std::string& line);

  /** The value of a parameter, without quotes; empty where there is none. */
  std::string Get(const std::string& parameter) const;

  /** Whether a parameter is there, with or without a value. */
  bool Has(const std::string& parameter) const { return this->Parameters.count(parameter) > 0; }

  /** Whether a parameter has a value, or is not there. */
  bool Is(const std::string& parameter, const std::string& value) const;

  /** In upper case, which no name depends on. */
  static std::string Upper(std::string text);

  std::string Name;
  bool IsContinued = false;

private:
  void ReadParameters(const std::vector<std::string>& fields, std::size_t first);

  std::map<std::string, std::string> Parameters;
};

/** The sets of elements and the surfaces of an .inp file, which become groups in the end. */
class InpSets
{
public:
  explicit InpSets(const FileContent& file);

  /** What vtkSolidWriter says of a name. */
  void ReadComment(const std::string& line);

  /** By which number elements of a set are known here: from 1 on, 0 for no name. */
  std::int64_t NumberOf(const std::string& name);

  /** A set by numbers, names of others, or a row of numbers. @{ */
  void BeginSet(const InpKeyword& keyword);
  void AddToSet(const std::string& line);
  /** @} */

  /** A surface by elements, or sets of them, and which of their faces. @{ */
  void BeginSurface(const InpKeyword& keyword);
  void AddToSurface(const std::string& line);
  /** @} */

  /** Give all elements their groups, and make triangles of the faces in surfaces. */
  void PutInto(SolidBuilder& builder);

private:
  /** Elements by their numbers: the first, the last, and the step between. */
  using Row = std::array<std::int64_t, 3>;

  struct Named
  {
    std::string Name;
    std::vector<Row> Elements = {}; ///< as *ELSET lists them
    bool IsInternal = false;        ///< made by a program, not named by a user
  };

  struct Side
  {
    std::string Elements; ///< a number, or a set
    int Face;             ///< as TetrahedronFaces has it
  };

  struct Surface
  {
    std::string Name;
    std::vector<Side> Sides = {};
  };

  /** What vtkSolidWriter's comments say of names: the groups' numbers and names before. */
  using Known = std::map<std::string, std::pair<std::int64_t, std::string>>;

  /** The first list that has each element, 0 for none, and whether each is in one list. */
  std::vector<std::int64_t> FromLists(
    const std::vector<FileElement>& elements, bool& isPartition) const;

  void Group(FileElements& elements, const Known& known);
  void AddSides(SolidBuilder& builder);
  template <typename Visit>
  static void VisitElements(
    const Row& row, const std::vector<FileElement>& elements, const Visit& visit);

  const FileContent& File;
  std::vector<Named> Sets;
  std::map<std::string, std::int64_t> Numbers; ///< of sets, by their names in upper case
  std::vector<Surface> Surfaces;
  std::size_t Current = 0; ///< the number of the set that is read
  bool IsOurs = false;
  bool IsRow = false;
  Known Regions;
  Known Tags;
};
} // namespace insideout
