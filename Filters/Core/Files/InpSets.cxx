// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/InpSets.h"

#include "Common/SortUniquely.h"
#include "Files/NameNumbers.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>
#include <numeric>

namespace insideout
{
namespace
{
/** Indices in TetrahedronFaces of S1, S2, S3 and S4. */
constexpr std::array<int, 4> FacesOfNumbers = { 3, 0, 1, 2 };

/** A text without surrounding blanks and quotes. */
std::string Trimmed(std::string text)
{
  for (const char* around : { " \t\r\n", "\"" })
  {
    const std::size_t begin = text.find_first_not_of(around);
    const std::size_t end = text.find_last_not_of(around);
    text = begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
  }
  return text;
}

/** The items between commas, without an empty one at the end of a line. */
std::vector<std::string> Fields(const std::string& line)
{
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin < line.size();)
  {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(Trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

/** Whether all of a text is an integer. */
bool IsInteger(const std::string& text, std::int64_t& value)
{
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

bool IsBefore(const FileElement& element, std::int64_t number)
{
  return element.Number < number;
}

/** A face of a cell, and the number of its surface. */
struct SideOfCell
{
  std::size_t Cell;
  int Face;
  std::int64_t Group;
};

/** A face belongs to the first surface that contains it. */
void KeepFirstOfEach(std::vector<SideOfCell>& sides)
{
  const auto keyOf = [&sides](std::size_t s)
  { return std::make_pair(sides[s].Cell, sides[s].Face); };
  std::vector<std::size_t> order(sides.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keyOf(a) < keyOf(b); });
  const auto end = std::unique(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keyOf(a) == keyOf(b); });
  std::sort(order.begin(), end); // as in the file
  std::vector<SideOfCell> kept;
  std::transform(
    order.begin(), end, std::back_inserter(kept), [&](std::size_t s) { return sides[s]; });
  sides = std::move(kept);
}
} // namespace

InpKeyword::InpKeyword(const std::string& line)
{
  const std::vector<std::string> fields = Fields(line.substr(1));
  this->Name = fields.empty() ? "" : Upper(fields[0]);
  this->ReadParameters(fields, 1);
  this->IsContinued = line.back() == ',';
}

void InpKeyword::Continue(const std::string& line)
{
  this->ReadParameters(Fields(line), 0);
  this->IsContinued = line.back() == ',';
}

void InpKeyword::ReadParameters(const std::vector<std::string>& fields, std::size_t first)
{
  for (std::size_t f = first; f < fields.size(); ++f)
  {
    const std::size_t equals = std::min(fields[f].find('='), fields[f].size());
    const std::string value = fields[f].substr(std::min(equals + 1, fields[f].size()));
    this->Parameters[Upper(Trimmed(fields[f].substr(0, equals)))] = ToUtf8(Trimmed(value));
  }
}

std::string InpKeyword::Get(const std::string& parameter) const
{
  const auto found = this->Parameters.find(parameter);
  return found == this->Parameters.end() ? "" : found->second;
}

bool InpKeyword::Is(const std::string& parameter, const std::string& value) const
{
  return !this->Has(parameter) || Upper(this->Get(parameter)) == value;
}

std::string InpKeyword::Upper(std::string text)
{
  for (char& c : text)
  {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return text;
}

InpSets::InpSets(const FileContent& file)
  : File(file)
{
}

void InpSets::ReadComment(const std::string& line)
{
  this->IsOurs = this->IsOurs || line.find("InsideOut") != std::string::npos;
  for (Known* known : { &this->Regions, &this->Tags })
  {
    const std::string kind = known == &this->Regions ? ": region " : ": tag ";
    const std::size_t colon = line.find(kind);
    const std::size_t comma = line.find(", ", std::min(colon, line.size()));
    if (!this->IsOurs || comma == std::string::npos)
    {
      continue;
    }
    const std::size_t digits = colon + kind.size();
    std::int64_t number = 0;
    if (digits < comma && IsInteger(line.substr(digits, comma - digits), number) && number > 0)
    {
      const std::string name = InpKeyword::Upper(Trimmed(line.substr(2, colon - 2)));
      (*known)[name] = { number, line.substr(comma + 2) };
    }
  }
}

std::int64_t InpSets::NumberOf(const std::string& name)
{
  if (name.empty())
  {
    return 0;
  }
  const auto next = static_cast<std::int64_t>(this->Sets.size()) + 1;
  const auto [found, isNew] = this->Numbers.emplace(InpKeyword::Upper(name), next);
  if (isNew)
  {
    this->Sets.push_back({ name });
  }
  return found->second;
}

void InpSets::BeginSet(const InpKeyword& keyword)
{
  this->IsRow = keyword.Has("GENERATE");
  this->Current = static_cast<std::size_t>(this->NumberOf(keyword.Get("ELSET")));
  if (this->Current > 0)
  {
    this->Sets[this->Current - 1].IsInternal = keyword.Has("INTERNAL");
  }
}

void InpSets::AddToSet(const std::string& line)
{
  if (this->Current == 0)
  {
    return;
  }
  std::vector<Row>& elements = this->Sets[this->Current - 1].Elements;
  Row row = { { 0, 0, 1 } };
  std::size_t place = 0;
  for (const std::string& field : Fields(line))
  {
    std::int64_t number = 0;
    if (!IsInteger(field, number))
    {
      continue; // the name of a set, whose elements are included
    }
    if (!this->IsRow)
    {
      elements.push_back({ { number, number, 1 } });
    }
    else if (place < row.size())
    {
      row[place++] = number;
    }
  }
  if (place >= 2)
  {
    row[2] = std::max<std::int64_t>(row[2], 1);
    elements.push_back(row);
  }
}

void InpSets::BeginSurface(const InpKeyword& keyword)
{
  this->Surfaces.push_back({ keyword.Get("NAME") });
}

void InpSets::AddToSurface(const std::string& line)
{
  const std::vector<std::string> fields = Fields(line);
  const std::string face = fields.size() < 2 ? "" : InpKeyword::Upper(fields[1]);
  if (face.size() == 2 && face[0] == 'S' && face[1] >= '1' && face[1] <= '4')
  {
    this->Surfaces.back().Sides.push_back(
      { fields[0], FacesOfNumbers[static_cast<std::size_t>(face[1] - '1')] });
  }
}

void InpSets::PutInto(SolidBuilder& builder)
{
  for (FileElements* elements : { &builder.Tetrahedra, &builder.Triangles })
  {
    SortByNumber(this->File, elements->Name, elements->All);
  }
  this->AddSides(builder);
  this->Group(builder.Tetrahedra, this->Regions);
  this->Group(builder.Triangles, this->Tags);
}

template <typename Visit>
void InpSets::VisitElements(
  const Row& row, const std::vector<FileElement>& elements, const Visit& visit)
{
  auto element = std::lower_bound(elements.begin(), elements.end(), row[0], IsBefore);
  for (; element != elements.end() && element->Number <= row[1]; ++element)
  {
    // Computed without overflow for any two numbers.
    const auto distance =
      static_cast<std::uint64_t>(element->Number) - static_cast<std::uint64_t>(row[0]);
    if (distance % static_cast<std::uint64_t>(row[2]) == 0)
    {
      visit(static_cast<std::size_t>(element - elements.begin()));
    }
  }
}

void InpSets::AddSides(SolidBuilder& builder)
{
  const std::vector<FileElement>& cells = builder.Tetrahedra.All;
  std::vector<SideOfCell> sides;
  for (const Surface& surface : this->Surfaces)
  {
    const std::int64_t group = this->NumberOf(surface.Name);
    for (const Side& side : surface.Sides)
    {
      const auto add = [&, face = side.Face](std::size_t cell) {
        sides.push_back({ cell, face, group });
      };
      std::int64_t number = 0;
      if (IsInteger(side.Elements, number))
      {
        VisitElements({ { number, number, 1 } }, cells, add);
        continue;
      }
      const std::int64_t set = this->NumberOf(side.Elements);
      for (std::size_t c = 0; c < cells.size() && set > 0; ++c)
      {
        if (cells[c].Group == set)
        {
          add(c);
        }
      }
      for (std::size_t r = 0; set > 0 && r < this->Sets[set - 1].Elements.size(); ++r)
      {
        VisitElements(this->Sets[set - 1].Elements[r], cells, add);
      }
    }
  }
  KeepFirstOfEach(sides);
  std::int64_t number = builder.Triangles.All.empty() ? 0 : builder.Triangles.All.back().Number;
  for (const SideOfCell& side : sides)
  {
    if (number == std::numeric_limits<std::int64_t>::max())
    {
      throw Malformed(this->File, "triangles have the largest numbers that there are");
    }
    const FileElement& element = cells[side.Cell];
    std::vector<std::int64_t> nodes;
    for (const int corner : TetrahedronFaces[side.Face])
    {
      nodes.push_back(builder.Tetrahedra.Nodes[element.Begin + static_cast<std::size_t>(corner)]);
    }
    SolidBuilder::AddElement(builder.Triangles, { ++number, element.Line, side.Group }, nodes);
  }
}

std::vector<std::int64_t> InpSets::FromLists(
  const std::vector<FileElement>& elements, bool& isPartition) const
{
  std::vector<std::int64_t> first(elements.size(), 0);
  std::size_t total = 0;
  for (std::size_t s = 0; s < this->Sets.size(); ++s)
  {
    for (std::size_t r = 0; !this->Sets[s].IsInternal && r < this->Sets[s].Elements.size(); ++r)
    {
      VisitElements(this->Sets[s].Elements[r], elements,
        [&](std::size_t e)
        {
          first[e] = first[e] == 0 ? static_cast<std::int64_t>(s) + 1 : first[e];
          ++total;
        });
    }
  }
  isPartition = total == elements.size() && std::count(first.begin(), first.end(), 0) == 0;
  return first;
}

void InpSets::Group(FileElements& elements, const Known& known)
{
  bool isPartition = false;
  const std::vector<std::int64_t> lists = this->FromLists(elements.All, isPartition);
  const bool hasOthers = std::any_of(
    elements.All.begin(), elements.All.end(), [](const FileElement& e) { return e.Group != 0; });
  std::vector<std::int64_t> used;
  for (std::size_t e = 0; e < elements.All.size(); ++e)
  {
    std::int64_t& group = elements.All[e].Group;
    group = isPartition || !hasOthers ? lists[e] : group;
    if (used.empty() || used.back() != group)
    {
      used.push_back(group);
    }
  }
  SortUniquely(used);
  std::int64_t next = 0;
  for (const auto& [name, group] : known)
  {
    next = std::max(next, group.first);
  }
  std::map<std::int64_t, std::int64_t> numbers;
  for (const std::int64_t set : used)
  {
    if (set == 0)
    {
      continue;
    }
    const std::string& name = this->Sets[set - 1].Name;
    const auto found = known.find(InpKeyword::Upper(name));
    numbers[set] = found != known.end() ? found->second.first : ++next;
    elements.NamesOfGroups[numbers[set]] = found != known.end() ? found->second.second : name;
  }
  for (FileElement& element : elements.All)
  {
    element.Group = element.Group == 0 ? 0 : numbers[element.Group];
  }
}
} // namespace insideout
