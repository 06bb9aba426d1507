// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/PlyAttributes.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace insideout
{
namespace
{
using Names = std::vector<std::string>;
using Columns = std::vector<const PlyProperty*>;
using AttributeValues = decltype(Attribute::Values);

bool HaveType(const Columns& columns, PlyType type)
{
  return std::all_of(columns.begin(), columns.end(),
    [type](const PlyProperty* column) { return column->Type == type; });
}

/** Whether the numbers are signed 32-bit integers. */
bool AreIntegers(const Columns& columns)
{
  return std::all_of(columns.begin(), columns.end(),
    [](const PlyProperty* column)
    {
      return FactsOf(column->Type).IsInteger &&
        std::all_of(column->Values.begin(), column->Values.end(),
          [](double value) { return value <= FactsOf(PlyType::Int32).Highest; });
    });
}

/** The numbers, interleaved: those of one point or polygon together. */
template <typename T>
std::vector<T> SideBySide(const Columns& columns)
{
  const std::size_t count = columns.front()->Values.size();
  std::vector<T> values(count * columns.size());
  for (std::size_t component = 0; component < columns.size(); ++component)
  {
    const std::vector<double>& column = columns[component]->Values;
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i * columns.size() + component] = static_cast<T>(column[i]);
    }
  }
  return values;
}

/** The same, in the smallest suitable type of an attribute. */
AttributeValues ToAttributeValues(const Columns& columns)
{
  if (HaveType(columns, PlyType::UInt8))
  {
    return SideBySide<unsigned char>(columns);
  }
  if (AreIntegers(columns))
  {
    return SideBySide<std::int32_t>(columns);
  }
  if (HaveType(columns, PlyType::Float32))
  {
    return SideBySide<float>(columns);
  }
  return SideBySide<double>(columns);
}

/** Bytes are kept, all other numbers are converted by ToColorBytes: a float's 1 may stand next to a
 * byte's 255. */
std::optional<std::vector<unsigned char>> ColorBytesOf(const Columns& columns)
{
  Columns others;
  std::copy_if(columns.begin(), columns.end(), std::back_inserter(others),
    [](const PlyProperty* column) { return column->Type != PlyType::UInt8; });
  if (others.empty())
  {
    return SideBySide<unsigned char>(columns);
  }
  const auto converted = ToColorBytes(SideBySide<double>(others));
  if (!converted)
  {
    return {};
  }
  std::vector<unsigned char> bytes = SideBySide<unsigned char>(columns);
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    const auto component = static_cast<std::size_t>(
      std::find(columns.begin(), columns.end(), others[i]) - columns.begin());
    for (std::size_t of = 0; of * columns.size() < bytes.size(); ++of)
    {
      bytes[of * columns.size() + component] = (*converted)[of * others.size() + i];
    }
  }
  return bytes;
}

class AttributeMaker
{
public:
  explicit AttributeMaker(PlyElement& element)
    : Element(element)
  {
  }

  std::vector<Attribute> MakeAll()
  {
    this->RemoveLists();
    this->MakeVector("Normals", { "nx", "ny", "nz" });
    for (const Names& names : { Names{ "s", "t" }, { "u", "v" }, { "texture_u", "texture_v" } })
    {
      if (this->MakeVector("TCoords", names))
      {
        break;
      }
    }
    if (!this->MakeColors({ "red", "green", "blue", "alpha" }))
    {
      this->MakeColors({ "red", "green", "blue" });
    }
    while (!this->Element.Properties.empty())
    {
      const PlyProperty& property = this->Element.Properties.front();
      this->Make(
        this->FreeName(property.Name), { property.Name }, ToAttributeValues({ &property }));
    }
    return std::move(this->Attributes);
  }

private:
  void RemoveLists()
  {
    std::vector<PlyProperty>& properties = this->Element.Properties;
    properties.erase(std::remove_if(properties.begin(), properties.end(),
                       [](const PlyProperty& property) { return property.IsList; }),
      properties.end());
  }

  /** The properties of these names, or none if one is missing. */
  Columns Find(const Names& names) const
  {
    Columns columns;
    for (const std::string& name : names)
    {
      columns.push_back(this->Element.Find(name));
    }
    const bool complete = std::find(columns.begin(), columns.end(), nullptr) == columns.end();
    return complete ? columns : Columns();
  }

  /** False if these are not numbers of a vector. */
  bool MakeVector(const char* attribute, const Names& names)
  {
    const Columns columns = this->Find(names);
    if (columns.empty() || AreIntegers(columns))
    {
      return false;
    }
    this->Make(attribute, names, ToAttributeValues(columns));
    return true;
  }

  /** False if one of the names is missing. Numbers that are not colors stay. */
  bool MakeColors(const Names& names)
  {
    const Columns columns = this->Find(names);
    if (columns.empty())
    {
      return false;
    }
    if (auto bytes = ColorBytesOf(columns))
    {
      this->Make("Colors", names, std::move(*bytes));
    }
    return true;
  }

  void Make(const std::string& attribute, const Names& names, AttributeValues values)
  {
    this->Attributes.push_back({ attribute, static_cast<int>(names.size()), std::move(values) });
    for (const std::string& name : names)
    {
      this->Element.Remove(name);
    }
  }

  std::string FreeName(std::string name) const
  {
    const auto hasName = [&name](const Attribute& attribute) { return attribute.Name == name; };
    while (std::any_of(this->Attributes.begin(), this->Attributes.end(), hasName))
    {
      name += '_';
    }
    return name;
  }

  PlyElement& Element;
  std::vector<Attribute> Attributes;
};
} // namespace

std::vector<Point> TakePlyPoints(PlyElement& vertices)
{
  const std::array<const char*, 3> axes = { "x", "y", "z" };
  std::vector<Point> points(vertices.Count);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& column = vertices.Find(axes[axis])->Values;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i][axis] = column[i];
    }
    vertices.Remove(axes[axis]);
  }
  return points;
}

std::vector<Attribute> TakePlyAttributes(PlyElement& element)
{
  return AttributeMaker(element).MakeAll();
}
} // namespace insideout
