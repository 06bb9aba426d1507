// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/Tags.h"

#include "Data/Arrays.h"
#include "In/CornerValues.h"

#include "Common/Error.h"
#include "Files/NameNumbers.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;

namespace
{
/** Arrays that tag cells, if the user names none. The last is that of VTK's STL reader; its OBJ
 * reader has GroupIds and MaterialIds, too. */
constexpr const char* KnownArrays[] = { BoundaryTag, "GroupIds", "MaterialIds",
  "STLSolidLabeling" };

/** Numbers names in the order of first use. They may be in any encoding: VTK's readers do not
 * convert them. */
class TagNumbers
{
public:
  int Of(const std::string& given)
  {
    const std::string name = insideout::ToUtf8(given);
    const auto [found, isNew] =
      this->Numbers.insert({ name, static_cast<int>(this->Names.size()) });
    if (isNew)
    {
      this->Names.push_back(name);
    }
    return found->second;
  }

  std::vector<std::string> Names;

private:
  std::map<std::string, int> Numbers;
};

/** A cell array with this number of values per cell; nullptr without one of this name. */
vtkAbstractArray* FindArray(vtkPolyData* input, const std::string& name, int components = 1)
{
  vtkAbstractArray* array = input->GetCellData()->GetAbstractArray(name.c_str());
  const bool fits = array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == input->GetNumberOfCells();
  return fits ? array : nullptr;
}

/** The field array with the names of an array's numbers; nullptr if there is none. */
vtkStringArray* FindNames(vtkPolyData* input, const std::string& name)
{
  return vtkStringArray::SafeDownCast(
    input->GetFieldData()->GetAbstractArray(NameOfNames(name).c_str()));
}

/** The value as an integer, also if stored as a float, as VTK's readers do. */
std::optional<long long> WholeNumber(const vtkVariant& value)
{
  constexpr double Beyond = 9223372036854775808.0; // 2^63
  if (value.IsFloat() || value.IsDouble())
  {
    const double number = value.ToDouble();
    const bool isWhole = std::abs(number) < Beyond && number == std::trunc(number);
    return isWhole ? std::optional(static_cast<long long>(number)) : std::nullopt;
  }
  const long long number = value.ToLongLong();
  const bool isTooLarge = number < 0 && value.ToDouble() > 0;
  return isTooLarge ? std::nullopt : std::optional(number);
}

std::optional<long long> NumberAt(vtkDataArray* array, vtkIdType value)
{
  const int components = array->GetNumberOfComponents();
  return WholeNumber(array->GetDataType() == VTK_BIT
      ? vtkVariant(array->GetComponent(value / components, static_cast<int>(value % components)))
      : array->GetVariantValue(value)); // vtkBitArray does not support variants
}

/** The name of a number. */
std::string NameOf(vtkStringArray* names, long long number)
{
  const bool isNamed =
    names && number >= 0 && number < names->GetNumberOfValues() && !names->GetValue(number).empty();
  return isNamed ? std::string(names->GetValue(number)) : std::to_string(number);
}

using Cells = std::vector<vtkIdType>;

/** The integer at an index among the array's values. */
long long TagNumberAt(vtkDataArray* array, vtkIdType value)
{
  const std::optional<long long> number = NumberAt(array, value);
  if (!number)
  {
    throw Error(ErrorCode::InvalidParameter,
      std::string("the cell array ") + array->GetName() + " has the value " +
        array->GetVariantValue(value).ToString() + " at cell " +
        std::to_string(value / array->GetNumberOfComponents()) + ": tags are integers or strings");
  }
  return *number;
}

Tags TagsOfNumbers(vtkDataArray* array, vtkStringArray* names, const Cells& cells)
{
  std::map<long long, int> tagOf;
  std::vector<long long> values;
  for (const vtkIdType cell : cells)
  {
    values.push_back(TagNumberAt(array, cell));
    tagOf.insert({ values.back(), 0 });
  }
  TagNumbers numbers;
  for (auto& [number, tag] : tagOf)
  {
    tag = numbers.Of(NameOf(names, number));
  }
  Tags tags{ std::vector<int>(array->GetNumberOfValues(), -1), numbers.Names };
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    tags.OfCell[cells[i]] = tagOf.at(values[i]);
  }
  return tags;
}

Tags TagsOfStrings(vtkStringArray* array, const Cells& cells)
{
  Tags tags{ std::vector<int>(array->GetNumberOfTuples(), -1), {} };
  TagNumbers numbers;
  for (const vtkIdType cell : cells)
  {
    const std::string& name = array->GetValue(cell);
    tags.OfCell[cell] = numbers.Of(name.empty() ? "default" : name);
  }
  tags.Names = numbers.Names;
  return tags;
}

Tags TagsOf(vtkPolyData* input, const std::string& name, const Cells& cells)
{
  vtkSmartPointer<vtkAbstractArray> array = FindArray(input, name);
  array = array ? array : ValuesOfCorners(input, name);
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    return TagsOfStrings(strings, cells);
  }
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    return TagsOfNumbers(numbers, FindNames(input, name), cells);
  }
  throw Error(ErrorCode::InvalidParameter,
    "the surface has no cell array " + name + " of one integer or string per cell, for its tags");
}

/** A block's tag numbered among those of all, so that the blocks can be joined. */
Tags TagsOfBlock(vtkPolyData* input, const Blocks& blocks)
{
  TagNumbers numbers;
  int current = 0;
  for (int block = 0; block < static_cast<int>(blocks.Names.size()); ++block)
  {
    const std::string& name = blocks.Names[block];
    const int tag = numbers.Of(name.empty() ? std::to_string(block) : name);
    current = block == blocks.Current ? tag : current;
  }
  return { std::vector<int>(input->GetNumberOfCells(), current), numbers.Names };
}

Tags AutomaticTags(vtkPolyData* input, const Blocks& blocks, const Cells& cells)
{
  std::optional<Tags> first;
  for (const char* name : KnownArrays)
  {
    try
    {
      Tags tags = TagsOf(input, name, cells);
      if (tags.Names.size() > 1)
      {
        return tags;
      }
      first = first ? first : std::move(tags);
    }
    catch (const Error&)
    {
      continue; // missing, or another array of that name
    }
  }
  const bool isNamed = blocks.AreThere() && !blocks.Names.front().empty();
  if (blocks.Names.size() > 1 || (isNamed && !first))
  {
    return TagsOfBlock(input, blocks);
  }
  return first ? *first : Tags{ std::vector<int>(input->GetNumberOfCells(), 0), { NoTag } };
}

/** The tagged cells: polygons and strips, or lines if there are none. */
Cells TaggedCells(vtkPolyData* surface)
{
  const bool arePolygons = surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
  const vtkIdType lines = surface->GetNumberOfVerts(); // planar input may consist of lines only
  const vtkIdType polygons = lines + surface->GetNumberOfLines();
  const vtkIdType first = arePolygons ? polygons : lines;
  Cells cells((arePolygons ? surface->GetNumberOfCells() : polygons) - first);
  std::iota(cells.begin(), cells.end(), first);
  return cells;
}
} // namespace

std::string NameOfNames(const std::string& array)
{
  const std::string ids = "Ids";
  const bool isIds = array.size() > ids.size() && array.substr(array.size() - ids.size()) == ids;
  return (isIds ? array.substr(0, array.size() - ids.size()) : array) + "Names";
}

Tags ReadTags(vtkPolyData* surface, const std::string& name, const Blocks& blocks)
{
  const Cells cells = TaggedCells(surface);
  return name.empty() ? AutomaticTags(surface, blocks, cells) : TagsOf(surface, name, cells);
}

std::optional<Tags> ReadSides(vtkPolyData* surface, const std::string& name)
{
  auto* labels = vtkDataArray::SafeDownCast(FindArray(surface, name, 2));
  if (!labels)
  {
    return std::nullopt;
  }
  Cells values;
  for (const vtkIdType cell : TaggedCells(surface))
  {
    for (const vtkIdType value : { 2 * cell, 2 * cell + 1 })
    {
      if (TagNumberAt(labels, value) != 0)
      {
        values.push_back(value);
      }
    }
  }
  return TagsOfNumbers(labels, FindNames(surface, name), values);
}

std::vector<std::string> FindTagArrays(vtkPolyData* surface)
{
  std::vector<std::string> found;
  for (int i = 0; i < surface->GetCellData()->GetNumberOfArrays(); ++i)
  {
    const char* given = surface->GetCellData()->GetArrayName(i);
    const std::string name = given ? given : "";
    const auto* known = std::find(std::begin(KnownArrays), std::end(KnownArrays), name);
    const bool isTag = known != std::end(KnownArrays) || FindNames(surface, name) ||
      vtkStringArray::SafeDownCast(FindArray(surface, name));
    try
    {
      if (isTag)
      {
        TagsOf(surface, name, TaggedCells(surface));
        found.push_back(name);
      }
    }
    catch (const Error&)
    {
      continue; // another array of that name
    }
  }
  return found;
}

std::string NewName(const std::string& name, const std::vector<std::string>& others)
{
  std::string result = name;
  for (int k = 2; std::find(others.begin(), others.end(), result) != others.end(); ++k)
  {
    result = name + "_" + std::to_string(k);
  }
  return result;
}

void AddTags(const Tags& tags, vtkPolyData* boundary)
{
  vtkDataArray* cells = boundary->GetCellData()->GetArray("vtkOriginalCellIds");
  std::vector<std::string> names = tags.Names;
  const int hole = static_cast<int>(names.size());
  std::vector<int> tagOf;
  bool hasHole = false;
  for (vtkIdType triangle = 0; triangle < boundary->GetNumberOfCells(); ++triangle)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(triangle, 0));
    hasHole = hasHole || cell < 0;
    tagOf.push_back(cell < 0 ? hole : tags.OfCell[cell]);
  }
  if (hasHole)
  {
    names.push_back(NewName("hole", names));
  }
  boundary->GetCellData()->AddArray(MakeArray<vtkIntArray>(BoundaryTag, tagOf));
  boundary->GetFieldData()->AddArray(MakeStrings("BoundaryTagNames", names));
}

namespace
{
bool AreEqual(vtkStringArray* a, vtkStringArray* b)
{
  bool areEqual = a && b && a->GetNumberOfValues() == b->GetNumberOfValues();
  for (vtkIdType i = 0; areEqual && i < a->GetNumberOfValues(); ++i)
  {
    areEqual = a->GetValue(i) == b->GetValue(i);
  }
  return areEqual;
}

/** The cell arrays of numbers with names in a block. */
std::vector<std::string> NamedArrays(vtkPolyData* piece)
{
  std::vector<std::string> named;
  for (int i = 0; i < piece->GetCellData()->GetNumberOfArrays(); ++i)
  {
    const char* name = piece->GetCellData()->GetArrayName(i);
    if (name && vtkDataArray::SafeDownCast(FindArray(piece, name)) && FindNames(piece, name))
    {
      named.emplace_back(name);
    }
  }
  return named;
}

/** An array as indices of names; nullptr if it is not of integers. */
vtkSmartPointer<vtkIntArray> Renumber(vtkPolyData* piece, const std::string& name, TagNumbers& all)
{
  auto* array = vtkDataArray::SafeDownCast(FindArray(piece, name));
  vtkStringArray* names = FindNames(piece, name);
  std::vector<int> numbers;
  for (vtkIdType cell = 0; array && cell < piece->GetNumberOfCells(); ++cell)
  {
    const std::optional<long long> number = NumberAt(array, cell);
    if (!number)
    {
      return nullptr;
    }
    numbers.push_back(all.Of(NameOf(names, *number)));
  }
  return array ? MakeArray<vtkIntArray>(name.c_str(), numbers) : nullptr;
}

/** Renumber one array in all blocks by common names. */
void ShareNames(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, const std::string& name)
{
  std::string nameOfNames;
  TagNumbers all;
  std::vector<vtkSmartPointer<vtkIntArray>> renumbered;
  for (vtkPolyData* piece : pieces)
  {
    vtkStringArray* names = FindNames(piece, name);
    nameOfNames = names ? names->GetName() : nameOfNames;
    for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    {
      all.Of(NameOf(names, i));
    }
    renumbered.push_back(Renumber(piece, name, all));
  }
  if (std::find(renumbered.begin(), renumbered.end(), nullptr) != renumbered.end())
  {
    return; // not an array of all blocks
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    vtkNew<vtkFieldData> fields; // the block's array may be shared
    fields->ShallowCopy(pieces[i]->GetFieldData());
    fields->AddArray(MakeStrings(nameOfNames.c_str(), all.Names));
    pieces[i]->SetFieldData(fields);
    pieces[i]->GetCellData()->AddArray(renumbered[i]);
  }
}
} // namespace

void ShareNames(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces)
{
  for (vtkPolyData* piece : pieces)
  {
    for (const std::string& name : NamedArrays(piece))
    {
      const auto differs = [&](vtkPolyData* other)
      { return !AreEqual(FindNames(piece, name), FindNames(other, name)); };
      if (std::any_of(pieces.begin(), pieces.end(), differs))
      {
        ShareNames(pieces, name);
      }
    }
  }
}
} // namespace vtkInsideOut
