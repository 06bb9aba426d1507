// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/TagsOfBodies.h"

#include "Common/Error.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "In/Tags.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <map>

namespace vtkInsideOut
{
using insideout::Error;

namespace
{
/** Bodies, and one of their arrays. */
struct ArrayOfBodies
{
  std::string Name;
  const std::vector<std::string>& BodyNames;
  const std::vector<vtkSmartPointer<vtkPolyData>>& Bodies;

  vtkAbstractArray* Of(std::size_t body) const
  {
    return this->Bodies[body]->GetCellData()->GetAbstractArray(this->Name.c_str());
  }
  vtkStringArray* NamesOf(std::size_t body) const
  {
    return vtkStringArray::SafeDownCast(
      this->Bodies[body]->GetFieldData()->GetAbstractArray(NameOfNames(this->Name).c_str()));
  }
};

/** The tags of a body without the array: for BoundaryTag by its other arrays, else its name. */
Tags ReadOtherwise(const ArrayOfBodies& array, std::size_t body)
{
  vtkPolyData* surface = array.Bodies[body];
  Tags tags = array.Name == BoundaryTag
    ? ReadTags(surface, {}, {})
    : Tags{ std::vector<int>(surface->GetNumberOfCells(), 0), { NoTag } };
  if (tags.Names == std::vector<std::string>{ NoTag })
  {
    tags.Names = { array.BodyNames[body] };
  }
  return tags;
}

Tags ReadBody(const ArrayOfBodies& array, std::size_t body, std::vector<std::string>& warnings)
{
  if (array.Of(body))
  {
    try
    {
      Tags tags = ReadTags(array.Bodies[body], array.Name, {});
      if (array.Name != BoundaryTag)
      {
        return tags;
      }
    }
    catch (const Error& error)
    {
      const std::string renamed = Attributes::RenameArray(
        array.Bodies[body]->GetCellData(), array.Name, array.BodyNames[body] + "/" + array.Name);
      warnings.push_back("body " + array.BodyNames[body] + ": the array " + array.Name +
        " is passed on as " + renamed + ", because it tags another body, and not this one (" +
        error.what() + ")");
    }
  }
  return ReadOtherwise(array, body);
}

/** The tags of each body; a body without polygons has none. */
std::vector<Tags> ReadAll(const ArrayOfBodies& array, std::vector<std::string>& warnings)
{
  std::vector<Tags> tags;
  for (std::size_t b = 0; b < array.Bodies.size(); ++b)
  {
    vtkPolyData* body = array.Bodies[b];
    const bool isEmpty = body->GetNumberOfPolys() + body->GetNumberOfStrips() == 0;
    if (isEmpty)
    {
      body->GetCellData()->RemoveArray(array.Name.c_str());
    }
    tags.push_back(isEmpty ? Tags() : ReadBody(array, b, warnings));
  }
  return tags;
}

/** Whether all bodies have the array, and its values distinguish bodies as required. */
bool MayStay(const ArrayOfBodies& array, const std::vector<Tags>& tags)
{
  std::vector<std::string> values;
  int bodies = 0;
  bool areBare = true;
  for (std::size_t b = 0; b < tags.size(); ++b)
  {
    if (tags[b].Names.empty())
    {
      continue;
    }
    if (!array.Of(b))
    {
      return false;
    }
    ++bodies;
    areBare = areBare && vtkDataArray::SafeDownCast(array.Of(b)) && !array.NamesOf(b);
    values.insert(values.end(), tags[b].Names.begin(), tags[b].Names.end());
  }
  std::sort(values.begin(), values.end());
  const bool areApart = std::adjacent_find(values.begin(), values.end()) == values.end();
  return bodies == 1 || (areBare && areApart);
}

/** Give each tag of each body a unique name. */
void NameApart(const std::vector<std::string>& bodyNames, std::vector<Tags>& tags)
{
  std::map<std::string, int> uses;
  for (const Tags& ofBody : tags)
  {
    for (const std::string& name : ofBody.Names)
    {
      ++uses[name];
    }
  }
  std::vector<std::string> taken;
  for (const auto& [name, count] : uses)
  {
    if (count == 1)
    {
      taken.push_back(name);
    }
  }
  for (std::size_t b = 0; b < tags.size(); ++b)
  {
    for (std::string& name : tags[b].Names)
    {
      if (uses[name] > 1)
      {
        name = NewName(name == bodyNames[b] ? name : bodyNames[b] + "/" + name, taken);
        taken.push_back(name);
      }
    }
  }
}

/** Whether all values are strings. */
bool AreStrings(const ArrayOfBodies& array)
{
  bool areStrings = false;
  for (std::size_t b = 0; b < array.Bodies.size(); ++b)
  {
    vtkAbstractArray* ofBody = array.Of(b);
    if (ofBody && !vtkStringArray::SafeDownCast(ofBody))
    {
      return false;
    }
    areStrings = areStrings || ofBody;
  }
  return areStrings;
}

/** Store the tags on the bodies, numbered body by body. */
SharedTags Write(const ArrayOfBodies& array, const std::vector<Tags>& tags)
{
  const char* name = array.Name.c_str();
  const bool areStrings = AreStrings(array);
  std::vector<std::string> all;
  for (std::size_t b = 0; b < tags.size(); ++b)
  {
    if (tags[b].Names.empty())
    {
      continue;
    }
    const int first = static_cast<int>(all.size());
    all.insert(all.end(), tags[b].Names.begin(), tags[b].Names.end());
    std::vector<int> numbers;
    std::vector<std::string> strings;
    for (const int tag : tags[b].OfCell)
    {
      numbers.push_back(tag < 0 ? -1 : first + tag);
      if (areStrings)
      {
        strings.push_back(tag < 0 ? std::string() : tags[b].Names[tag]);
      }
    }
    array.Bodies[b]->GetCellData()->AddArray(areStrings
        ? vtkSmartPointer<vtkAbstractArray>(MakeStrings(name, strings))
        : vtkSmartPointer<vtkAbstractArray>(MakeArray<vtkIntArray>(name, numbers)));
  }
  return { array.Name, areStrings ? nullptr : MakeStrings(NameOfNames(array.Name).c_str(), all) };
}

/** The names of an unchanged array: those of the first body that has it. */
vtkSmartPointer<vtkStringArray> FirstNames(const ArrayOfBodies& array)
{
  for (std::size_t b = 0; b < array.Bodies.size(); ++b)
  {
    if (array.Of(b))
    {
      return array.NamesOf(b);
    }
  }
  return nullptr;
}
} // namespace

std::vector<SharedTags> ShareTags(const std::vector<std::string>& names,
  const std::vector<vtkSmartPointer<vtkPolyData>>& bodies, std::vector<std::string>& warnings)
{
  // first, because it depends on the unchanged others
  std::vector<std::string> arrays = { BoundaryTag };
  for (vtkPolyData* body : bodies)
  {
    for (const std::string& array : FindTagArrays(body))
    {
      if (std::find(arrays.begin(), arrays.end(), array) == arrays.end())
      {
        arrays.push_back(array);
      }
    }
  }
  std::vector<SharedTags> shared;
  for (const std::string& name : arrays)
  {
    const ArrayOfBodies array = { name, names, bodies };
    std::vector<Tags> tags = ReadAll(array, warnings);
    if (MayStay(array, tags))
    {
      shared.push_back({ name, FirstNames(array) });
      continue;
    }
    NameApart(names, tags);
    shared.push_back(Write(array, tags));
  }
  return shared;
}

void TagHoles(const std::vector<SharedTags>& shared, vtkPolyData* boundary)
{
  vtkDataArray* cells = boundary->GetCellData()->GetArray("vtkOriginalCellIds");
  std::vector<vtkIdType> holes;
  for (vtkIdType triangle = 0; triangle < boundary->GetNumberOfCells(); ++triangle)
  {
    if (cells->GetComponent(triangle, 0) < 0)
    {
      holes.push_back(triangle);
    }
  }
  if (holes.empty())
  {
    return;
  }
  for (const SharedTags& tags : shared)
  {
    const char* name = tags.Array.c_str();
    Tags known = ReadTags(boundary, name, {});
    const std::string hole = NewName("hole", known.Names);
    auto* strings = vtkStringArray::SafeDownCast(boundary->GetCellData()->GetAbstractArray(name));
    for (const vtkIdType triangle : holes)
    {
      known.OfCell[triangle] = static_cast<int>(known.Names.size());
      if (strings)
      {
        strings->SetValue(triangle, hole);
      }
    }
    if (!strings)
    {
      known.Names.push_back(hole);
      boundary->GetCellData()->AddArray(MakeArray<vtkIntArray>(name, known.OfCell));
      boundary->GetFieldData()->AddArray(MakeStrings(NameOfNames(name).c_str(), known.Names));
    }
  }
}
} // namespace vtkInsideOut
