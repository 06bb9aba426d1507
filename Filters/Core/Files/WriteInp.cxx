// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/SortUniquely.h"
#include "Files/GroupNames.h"
#include "Files/SolidWriters.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <system_error>

// The format: Abaqus Keywords Reference Guide; Dhondt, CalculiX CrunchiX User's Manual.

namespace insideout
{
namespace
{
/** Both programs read this many characters of a number; CalculiX ignores the rest. */
constexpr std::size_t LongestNumber = 20;

/**
 * Both CalculiX and Abaqus limit names of sets to 80 characters. Some are left for a user's
 * suffixes.
 */
constexpr NameRules NamesOfInp = { 64, true, false };

constexpr const char* AllPoints = "Nall";
constexpr const char* AllCells = "Eall";

/** Items per line, limited by CalculiX's lines of 132 characters. */
constexpr std::size_t NumbersInLine = 10;

/** The numbers of TetrahedronFaces: S1 is that of corners 1, 2 and 3, S2 of 1, 2 and 4, S3 of 2, 3
 * and 4, S4 of 1, 3 and 4. */
constexpr std::array<int, 4> NumbersOfFaces = { 2, 3, 4, 1 };

/** The numbers in C3D6 of the faces of prisms and pyramids. */
constexpr std::array<int, 5> NumbersOfPrismFaces = { 2, 1, 3, 4, 5 };
constexpr std::array<int, 5> NumbersOfPyramidFaces = { 2, 5, 1, 3, 4 };

/** The number of a face at a cell. */
int NumberOfFace(const SolidMesh& solid, const CellFace& face)
{
  const CellShape shape = ShapeOfCell(solid, static_cast<std::size_t>(face.Cell));
  return shape == CellShape::Prism ? NumbersOfPrismFaces[face.Face]
    : shape == CellShape::Pyramid  ? NumbersOfPyramidFaces[face.Face]
                                   : NumbersOfFaces[face.Face];
}

/** The points of a cell in the order of C3D4, C3D10 and C3D6. */
SolidNodes InpNodesOf(const SolidMesh& solid, std::size_t cell)
{
  SolidNodes nodes = NodesOf(solid, cell);
  const std::array<Id, 10>& n = nodes.Ids;
  const CellShape shape = ShapeOfCell(solid, cell);
  if (shape == CellShape::Tetrahedron)
  {
    return nodes;
  }
  const Prism other = shape == CellShape::Prism
    ? NodesOfC3D6(Prism{ { n[0], n[1], n[2], n[3], n[4], n[5] } })
    : NodesOfC3D6(Pyramid{ { n[0], n[1], n[2], n[3], n[4] } });
  nodes.Count = 6;
  std::copy(other.begin(), other.end(), nodes.Ids.begin());
  return nodes;
}

/** A number by to_chars, without zeros that readers do not need. */
template <typename... Format>
std::string Text(double value, Format... format)
{
  std::array<char, 400> text; // digits of the smallest double, including leading zeros
  const std::to_chars_result result =
    std::to_chars(text.data(), text.data() + text.size(), value, format...);
  std::string number(text.data(), result.ptr);
  const std::size_t exponent = number.find('e');
  if (exponent != std::string::npos)
  {
    // e-05 is e-5, and e+17 is e17.
    const bool negative = number[exponent + 1] == '-';
    number = number.substr(0, exponent + 1) + (negative ? "-" : "") +
      std::to_string(std::abs(std::stoi(number.substr(exponent + 1))));
  }
  const std::size_t zero = number[0] == '-' ? 1 : 0;
  if (number.size() > LongestNumber && number.compare(zero, 2, "0.") == 0)
  {
    number.erase(zero, 1);
  }
  return number;
}

/** The shortest text that reads back as the number; if that is too long, the nearest one that fits.
 */
std::string ShortNumber(double value)
{
  std::string text = Text(value);
  if (text.size() > LongestNumber)
  {
    text = Text(value, std::chars_format::fixed);
  }
  constexpr int mostDigits = 17; // enough to distinguish all doubles
  for (int digits = mostDigits; text.size() > LongestNumber; --digits)
  {
    const std::string scientific = Text(value, std::chars_format::scientific, digits - 1);
    const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
    text = Text(value, std::chars_format::fixed, std::max(0, digits - 1 - exponent));
    text = text.size() > LongestNumber ? scientific : text;
  }
  return text;
}

/** The number that a reader makes of a text. */
double ReadBack(const std::string& text)
{
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/** Comments with the meaning of names. */
void WriteNames(OutputFile& file, const char* what, const std::vector<SolidGroup>& groups,
  const std::vector<std::string>& names)
{
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    file.Text(std::string("** ") + names[g] + ": " + what + " " + std::to_string(groups[g].Number) +
      ", " + PrintableText(groups[g].Name) + "\n");
  }
}

void WriteNodes(OutputFile& file, const SolidMesh& solid)
{
  file.Text(std::string("*NODE, NSET=") + AllPoints + "\n");
  for (std::size_t p = 0; p < solid.Points.size(); ++p)
  {
    file.Decimal(p + 1);
    for (const double x : solid.Points[p])
    {
      file.Text(", ");
      file.Text(ShortNumber(x));
    }
    file.Text("\n");
  }
}

/** Points as a set, without repetition. */
void WriteSet(OutputFile& file, const std::string& name, std::vector<Id> points)
{
  file.Text("*NSET, NSET=" + name + "\n");
  SortUniquely(points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    file.Decimal(std::int64_t(points[i]) + 1);
    file.Text((i + 1) % NumbersInLine == 0 || i + 1 == points.size() ? "\n" : ", ");
  }
}

/** The cells and points of each region as sets, and all cells as another. */
void WriteRegions(OutputFile& file, const SolidMesh& solid, const std::vector<std::string>& names)
{
  const auto isOfLayer = [&](Id cell)
  { return ShapeOfCell(solid, static_cast<std::size_t>(cell)) != CellShape::Tetrahedron; };
  const auto typeOf = [&](Id cell)
  {
    return isOfLayer(cell) ? "C3D6"
      : IsQuadratic(solid) ? "C3D10" // midpoints in VTK's order
                           : "C3D4";
  };
  const Buckets<Id> cells = ByGroup(names.size(), solid.RegionOfCell);
  for (std::size_t r = 0; r < names.size(); ++r)
  {
    Id last = None;
    for (const Id cell : cells[r])
    {
      if (last == None || isOfLayer(cell) != isOfLayer(last))
      {
        file.Text(std::string("*ELEMENT, TYPE=") + typeOf(cell) + ", ELSET=" + names[r] + "\n");
      }
      last = cell;
      file.Decimal(std::int64_t(cell) + 1);
      for (const Id point : InpNodesOf(solid, static_cast<std::size_t>(cell)))
      {
        file.Text(", ");
        file.Decimal(std::int64_t(point) + 1);
      }
      file.Text("\n");
    }
  }
  file.Text(std::string("*ELSET, ELSET=") + AllCells + "\n");
  for (const std::string& name : names)
  {
    file.Text(name + "\n");
  }
  for (std::size_t r = 0; r < names.size(); ++r)
  {
    std::vector<Id> points;
    for (const Id cell : cells[r])
    {
      const SolidNodes nodes = NodesOf(solid, static_cast<std::size_t>(cell));
      points.insert(points.end(), nodes.begin(), nodes.end());
    }
    WriteSet(file, names[r], std::move(points));
  }
}

/** The points and faces of each tag. */
void WriteTags(OutputFile& file, const SolidMesh& solid, const std::vector<std::string>& names)
{
  const Buckets<Id> faces = ByGroup(names.size(), solid.TagOfFace);
  for (std::size_t t = 0; t < names.size(); ++t)
  {
    std::vector<Id> points;
    for (const Id face : faces[t])
    {
      const SolidNodes nodes = NodesOf(solid, solid.Faces[face]);
      points.insert(points.end(), nodes.begin(), nodes.end());
    }
    WriteSet(file, names[t], std::move(points));
    file.Text("*SURFACE, NAME=" + names[t] + ", TYPE=ELEMENT\n");
    for (const Id face : faces[t])
    {
      file.Decimal(std::int64_t(solid.Faces[face].Cell) + 1);
      file.Text(", S");
      file.Decimal(NumberOfFace(solid, solid.Faces[face]));
      file.Text("\n");
    }
  }
}
} // namespace

void WriteInp(OutputFile& file, const SolidMesh& solid)
{
  const GroupNames names = ValidNames(solid, NamesOfInp, { AllPoints, AllCells });
  file.Text(
    "** Written by InsideOut: sets of elements and nodes of regions, of nodes and surfaces of "
    "tags\n");
  WriteNames(file, "region", solid.Regions, names.Regions);
  WriteNames(file, "tag", solid.Tags, names.Tags);
  WriteNodes(file, solid);
  WriteRegions(file, solid, names.Regions);
  WriteTags(file, solid, names.Tags);
}

Point PointInInp(Point point)
{
  std::transform(
    point.begin(), point.end(), point.begin(), [](double x) { return ReadBack(ShortNumber(x)); });
  return point;
}
} // namespace insideout
