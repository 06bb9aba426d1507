// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SolidBuilder.h"

#include "Common/SortUniquely.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
/** Limit of group numbers: names of groups are in a list as long as the largest number. */
constexpr std::int64_t LargestGroup = 1 << 16;

/** The new numbers of a file's groups: unchanged if possible, with the next number for no group;
 * else from 1 on in their order. */
std::vector<SolidGroup> GroupsOf(
  const std::vector<std::int64_t>& present, const std::map<std::int64_t, std::string>& names)
{
  const bool areKept = present.front() >= 0 && present.back() < LargestGroup;
  std::vector<SolidGroup> groups;
  for (const std::int64_t number : present)
  {
    const auto name = names.find(number);
    const std::int64_t kept = !areKept ? static_cast<std::int64_t>(groups.size()) + 1
      : number == 0                    ? present.back() + 1
                                       : number;
    groups.push_back({ name == names.end() ? "" : name->second, static_cast<Id>(kept) });
  }
  return groups;
}
} // namespace

SolidBuilder::SolidBuilder(const FileContent& file)
  : File(file)
{
}

void SolidBuilder::AddPoint(const TextScanner& scanner, std::int64_t number, const Point& point)
{
  if (!IsFinite(point))
  {
    scanner.Fail("point " + std::to_string(number) + " is not finite");
  }
  this->Numbers.push_back(number);
  this->Solid.Points.push_back(point);
}

void SolidBuilder::AddElement(
  FileElements& elements, const FileElement& element, const std::vector<std::int64_t>& nodes)
{
  elements.All.push_back(element);
  elements.All.back().Begin = elements.Nodes.size();
  elements.All.back().IsQuadratic = nodes.size() > elements.Corners;
  elements.Nodes.insert(elements.Nodes.end(), nodes.begin(), nodes.end());
}

void SolidBuilder::Warn(const std::string& what)
{
  this->Solid.Warnings.push_back(this->File.Name + what);
}

SolidContent SolidBuilder::Finish()
{
  this->WarnOfOthers();
  if (this->Tetrahedra.All.empty() && this->Triangles.All.empty())
  {
    const std::string others = this->Solid.Warnings.empty() ? "" : "; " + this->Solid.Warnings[0];
    throw Malformed(this->File, "holds no tetrahedra and no triangles" + others);
  }
  this->SortPoints();
  this->Fill(this->Tetrahedra, true, this->Solid.Tetrahedra);
  // Boundary triangles have the midpoints of their cells.
  this->Fill(this->Triangles, this->Tetrahedra.All.empty(), this->Solid.Triangles);
  return std::move(this->Solid);
}

void SolidBuilder::WarnOfOthers()
{
  std::string list;
  for (const auto& [shape, count] : this->Others)
  {
    if (count == 0)
    {
      continue;
    }
    list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + shape;
  }
  if (!list.empty())
  {
    this->Warn(": only tetrahedra and triangles are read; left out: " + list);
  }
}

void SolidBuilder::SortPoints()
{
  CheckCount(this->File, this->Numbers.size(), "points");
  if (!std::is_sorted(this->Numbers.begin(), this->Numbers.end()))
  {
    std::vector<Id> order(this->Numbers.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
      [this](Id p, Id q) { return this->Numbers[p] < this->Numbers[q]; });
    std::vector<std::int64_t> numbers;
    std::vector<Point> points;
    numbers.reserve(order.size());
    points.reserve(order.size());
    for (const Id p : order)
    {
      numbers.push_back(this->Numbers[p]);
      points.push_back(this->Solid.Points[p]);
    }
    this->Numbers = std::move(numbers);
    this->Solid.Points = std::move(points);
  }
  const auto twice = std::adjacent_find(this->Numbers.begin(), this->Numbers.end());
  if (twice != this->Numbers.end())
  {
    throw Malformed(this->File, "point " + std::to_string(*twice) + " is there twice");
  }
}

Id SolidBuilder::IdOf(
  const FileElements& elements, const FileElement& element, std::size_t node) const
{
  const std::int64_t wanted = elements.Nodes[element.Begin + node];
  const auto points = static_cast<std::int64_t>(this->Numbers.size());
  const bool isRow = points > 0 && this->Numbers.back() == points && this->Numbers.front() == 1;
  const auto found = isRow
    ? this->Numbers.begin() + (std::clamp<std::int64_t>(wanted, 1, points) - 1)
    : std::lower_bound(this->Numbers.begin(), this->Numbers.end(), wanted);
  if (found == this->Numbers.end() || *found != wanted)
  {
    FailAtLine(this->File, element.Line,
      std::string(elements.Name) + " " + std::to_string(element.Number) + " refers to point " +
        std::to_string(wanted) +
        (isRow ? " of " + std::to_string(points) : std::string(", which is not there")));
  }
  return static_cast<Id>(found - this->Numbers.begin());
}

template <std::size_t Corners, std::size_t Edges>
void SolidBuilder::Fill(
  FileElements& elements, bool keepsMidpoints, SolidElements<Corners, Edges>& filled)
{
  CheckCount(this->File, elements.All.size(), "cells");
  SortByNumber(this->File, elements.Name, elements.All);
  const std::size_t count = elements.All.size();
  const auto quadratic = static_cast<std::size_t>(std::count_if(elements.All.begin(),
    elements.All.end(), [](const FileElement& element) { return element.IsQuadratic; }));
  const bool isQuadratic = keepsMidpoints && quadratic == count;
  if (keepsMidpoints && quadratic > 0 && !isQuadratic)
  {
    this->Warn(": " + std::to_string(quadratic) + " of " + std::to_string(count) +
      " cells are quadratic, and are read as linear ones, as the others are");
  }
  filled.Cells.resize(count);
  filled.Midpoints.resize(isQuadratic ? count : 0);
  for (std::size_t e = 0; e < count; ++e)
  {
    for (std::size_t k = 0; k < Corners; ++k)
    {
      filled.Cells[e][k] = this->IdOf(elements, elements.All[e], k);
    }
    for (std::size_t k = 0; k < Edges && isQuadratic; ++k)
    {
      filled.Midpoints[e][k] = this->IdOf(elements, elements.All[e], Corners + k);
    }
  }
  this->NumberGroups(elements, filled);
}

template <std::size_t Corners, std::size_t Edges>
void SolidBuilder::NumberGroups(FileElements& elements, SolidElements<Corners, Edges>& filled)
{
  std::vector<FileElement>& all = elements.All;
  if (all.empty())
  {
    return;
  }
  if (std::all_of(all.begin(), all.end(), [](const FileElement& e) { return e.Group == 0; }))
  {
    for (FileElement& element : all)
    {
      element.Group = element.Entity;
    }
    elements.NamesOfGroups.clear();
  }
  std::vector<std::int64_t> present;
  for (const FileElement& element : all)
  {
    if (present.empty() || present.back() != element.Group)
    {
      present.push_back(element.Group);
    }
  }
  SortUniquely(present);
  filled.Groups = GroupsOf(present, elements.NamesOfGroups);
  filled.GroupOf.reserve(all.size());
  for (const FileElement& element : all)
  {
    filled.GroupOf.push_back(IndexIn(present, element.Group));
  }
}

void FailAtLine(const FileContent& file, std::int64_t line, const std::string& what)
{
  throw Error(ErrorCode::FileMalformed, file.Name + ", line " + std::to_string(line) + ": " + what);
}

void SortByNumber(const FileContent& file, const char* name, std::vector<FileElement>& elements)
{
  const auto isBefore = [](const FileElement& a, const FileElement& b)
  { return a.Number < b.Number; };
  if (!std::is_sorted(elements.begin(), elements.end(), isBefore))
  {
    std::stable_sort(elements.begin(), elements.end(), isBefore);
  }
  const auto twice = std::adjacent_find(elements.begin(), elements.end(),
    [](const FileElement& a, const FileElement& b) { return a.Number == b.Number; });
  if (twice != elements.end())
  {
    FailAtLine(file, (twice + 1)->Line,
      std::string(name) + " " + std::to_string(twice->Number) + " is there twice");
  }
}

void CheckAnnounced(
  const TextScanner& scanner, std::int64_t count, std::uint64_t shortest, const char* things)
{
  const std::uint64_t possible = (scanner.Left() + 1) / shortest;
  if (count < 0)
  {
    scanner.Fail(std::string("the number of ") + things + " is negative");
  }
  if (static_cast<std::uint64_t>(count) > possible)
  {
    scanner.Fail(std::to_string(count) + " " + things + " announced, at most " +
      std::to_string(possible) + " present: the file is truncated");
  }
}
} // namespace insideout
