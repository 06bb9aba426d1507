// SPDX-License-Identifier: GPL-3.0-or-later
#include "Data/Attributes.h"

#include "Data/Arrays.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>

namespace vtkInsideOut
{
namespace
{
using Warnings = std::vector<std::string>;

void WarnOnce(const std::string& warning, Warnings& warnings)
{
  if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
  {
    warnings.push_back(warning);
  }
}

/**
 * A shallow copy of the input's data, with only the arrays that have `size` tuples and none of the
 * names that the output adds: see RenameArrays.
 */
template <typename Data>
vtkSmartPointer<Data> UsableArrays(Data* input, vtkIdType size, bool areMadeHere,
  std::initializer_list<const char*> added, Warnings& warnings)
{
  auto copy = vtkSmartPointer<Data>::New();
  copy->ShallowCopy(input);
  for (int i = copy->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = copy->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != size)
    {
      WarnOnce(std::string("the input's array ") +
          (array->GetName() ? array->GetName() : "(unnamed)") + " has " +
          std::to_string(array->GetNumberOfTuples()) + " tuples where " + std::to_string(size) +
          " are needed: it is left out",
        warnings);
      copy->RemoveArray(i);
    }
  }
  Attributes::RenameArrays(copy, areMadeHere, added, warnings);
  return copy;
}

bool IsReal(vtkDataArray* array)
{
  return array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
}

/** Set tuple `id` of every integer array to 0: ids are not interpolated. */
void SetIntegersToZero(vtkDataSetAttributes* data, vtkIdType id)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    for (int k = 0; array && !IsReal(array) && k < array->GetNumberOfComponents(); ++k)
    {
      array->SetComponent(id, k, 0);
    }
  }
}

/** Set tuple `id` of every array to NaN, or 0 where the type has none. */
void SetNoValue(vtkDataSetAttributes* data, vtkIdType id)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      const double value = IsReal(array) ? std::numeric_limits<double>::quiet_NaN() : 0.0;
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        array->SetComponent(id, k, value);
      }
    }
  }
}

/** Give an interpolated normal unit length again. */
void NormalizeNormal(vtkDataSetAttributes* data, vtkIdType id)
{
  vtkDataArray* normals = data->GetNormals();
  if (!normals || !IsReal(normals))
  {
    return;
  }
  double normal[3];
  normals->GetTuple(id, normal);
  if (vtkMath::Normalize(normal) > 0)
  {
    normals->SetTuple(id, normal);
  }
}

/** Make room for `size` tuples in every array, so that all have values. */
void SetNumberOfTuples(vtkDataSetAttributes* data, vtkIdType size)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    data->GetAbstractArray(i)->SetNumberOfTuples(size);
  }
}

/** Call before `size` tuples of every array are made. */
void RequireTuples(vtkDataSetAttributes* data, vtkIdType size)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    RequireMemory(size * array->GetNumberOfComponents() * array->GetDataTypeSize());
  }
}
} // namespace

bool Attributes::AreMadeHere(vtkDataSet* data)
{
  return data->GetFieldData()->HasArray("StatisticsNames") != 0;
}

std::string Attributes::RenameArray(
  vtkFieldData* data, const std::string& from, const std::string& to)
{
  std::string renamed = to;
  for (int k = 2; data->HasArray(renamed.c_str()); ++k)
  {
    renamed = to + "_" + std::to_string(k);
  }
  vtkAbstractArray* array = data->GetAbstractArray(from.c_str());
  vtkSmartPointer<vtkAbstractArray> clone;
  clone.TakeReference(array->NewInstance());
  RequireMemory(static_cast<vtkIdType>(array->GetActualMemorySize()) << 10);
  clone->DeepCopy(array);
  clone->SetName(renamed.c_str());
  data->RemoveArray(from.c_str());
  data->AddArray(clone);
  return renamed;
}

void Attributes::RenameArrays(vtkFieldData* data, bool areMadeHere,
  std::initializer_list<const char*> names, Warnings& warnings)
{
  for (const char* name : names)
  {
    const bool areIds = std::string(name).rfind("vtkOriginal", 0) == 0;
    if (areMadeHere && !areIds)
    {
      data->RemoveArray(name);
    }
    if (data->HasArray(name))
    {
      std::string renamed = std::string("Input_") + name;
      while (data->HasArray(renamed.c_str()))
      {
        renamed = "Input_" + renamed;
      }
      Attributes::RenameArray(data, name, renamed);
      if (!areMadeHere)
      {
        WarnOnce(std::string("the input's array ") + name + " is passed on as " + renamed +
            ", because the output has its own",
          warnings);
      }
    }
  }
}

void Attributes::PassPointData(vtkDataSet* input,
  const std::vector<insideout::PointOrigin>& origins, vtkPointData* output, Warnings& warnings)
{
  const vtkIdType size = static_cast<vtkIdType>(origins.size());
  const vtkSmartPointer<vtkPointData> source = UsableArrays(input->GetPointData(),
    input->GetNumberOfPoints(), AreMadeHere(input), { "vtkOriginalPointIds" }, warnings);
  RequireTuples(source, size);
  output->InterpolateAllocate(source, size);
  SetNumberOfTuples(output, size);

  std::vector<vtkIdType> inputPoints(size, -1);
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  for (vtkIdType p = 0; p < size; ++p)
  {
    insideout::PointOrigin origin = origins[p];
    if (origin.IsInput())
    {
      inputPoints[p] = origin.Points[0];
      output->CopyData(source, origin.Points[0], p);
    }
    else if (origin.Points[0] == insideout::None)
    {
      SetNoValue(output, p);
    }
    else
    {
      for (int k = 0; k < 3; ++k)
      {
        corners->SetId(k, origin.Points[k]);
      }
      output->InterpolatePoint(source, p, corners, origin.Weights.data());
      NormalizeNormal(output, p);
    }
  }
  output->AddArray(MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", inputPoints));
}

void Attributes::PassCellData(vtkDataSet* input, const std::vector<vtkIdType>& cells,
  std::initializer_list<const char*> added, vtkCellData* output, Warnings& warnings)
{
  const vtkIdType size = static_cast<vtkIdType>(cells.size());
  const vtkSmartPointer<vtkCellData> source =
    UsableArrays(input->GetCellData(), input->GetNumberOfCells(), AreMadeHere(input),
      { "vtkOriginalCellIds", "FacetMultiplicity" }, warnings);
  RenameArrays(source, AreMadeHere(input), added, warnings);
  RequireTuples(source, size);
  output->CopyAllocate(source, size);
  SetNumberOfTuples(output, size);
  for (vtkIdType c = 0; c < size; ++c)
  {
    if (cells[c] >= 0)
    {
      output->CopyData(source, cells[c], c);
    }
    else
    {
      SetNoValue(output, c);
    }
  }
  output->AddArray(MakeArray<vtkIdTypeArray>("vtkOriginalCellIds", cells));
}

void Attributes::CopyCellData(vtkDataSet* input, const std::vector<insideout::Id>& cells,
  vtkCellData* output, Warnings& warnings)
{
  const vtkIdType size = static_cast<vtkIdType>(cells.size());
  const vtkSmartPointer<vtkCellData> source =
    UsableArrays(input->GetCellData(), input->GetNumberOfCells(), false, {}, warnings);
  RequireTuples(source, size);
  output->CopyAllocate(source, size);
  SetNumberOfTuples(output, size);
  for (vtkIdType c = 0; c < size; ++c)
  {
    output->CopyData(source, cells[c], c);
  }
}

void Attributes::MixPointData(vtkDataSet* input, const std::vector<Mixture>& mixtures,
  const std::vector<insideout::Edge>& edges, vtkPointData* output, Warnings& warnings)
{
  const vtkIdType corners = static_cast<vtkIdType>(mixtures.size());
  const vtkIdType size = corners + static_cast<vtkIdType>(edges.size());
  const vtkSmartPointer<vtkPointData> source =
    UsableArrays(input->GetPointData(), input->GetNumberOfPoints(), false, {}, warnings);
  vtkDataArray* given = source->GetArray("vtkOriginalPointIds");
  const vtkSmartPointer<vtkDataArray> earlierPoints =
    given && given->GetNumberOfComponents() == 1 ? given : nullptr;
  source->RemoveArray("vtkOriginalPointIds");
  RequireTuples(source, size);
  output->InterpolateAllocate(source, size);
  SetNumberOfTuples(output, size);

  std::vector<vtkIdType> inputPoints(size, -1);
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(4);
  for (vtkIdType p = 0; p < corners; ++p)
  {
    Mixture mixture = mixtures[p];
    if (!mixture.IsNew)
    {
      const vtkIdType original = mixture.Points[0];
      inputPoints[p] =
        earlierPoints ? static_cast<vtkIdType>(earlierPoints->GetComponent(original, 0)) : original;
      output->CopyData(source, original, p);
      continue;
    }
    for (int k = 0; k < 4; ++k)
    {
      ids->SetId(k, mixture.Points[k]);
    }
    output->InterpolatePoint(source, p, ids, mixture.Weights.data());
    NormalizeNormal(output, p);
    SetIntegersToZero(output, p);
  }
  for (vtkIdType p = corners; p < size; ++p)
  {
    const insideout::Edge& edge = edges[p - corners];
    for (int i = 0; i < output->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = output->GetAbstractArray(i);
      array->InterpolateTuple(p, edge[0], array, edge[1], array, 0.5);
    }
    NormalizeNormal(output, p);
    SetIntegersToZero(output, p);
  }
  output->AddArray(MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", inputPoints));
}

void Attributes::PassAll(vtkDataSet* input, std::initializer_list<const char*> added,
  vtkDataSet* output, Warnings& warnings)
{
  output->GetPointData()->ShallowCopy(
    UsableArrays(input->GetPointData(), input->GetNumberOfPoints(), false, {}, warnings));
  output->GetCellData()->ShallowCopy(UsableArrays(
    input->GetCellData(), input->GetNumberOfCells(), AreMadeHere(input), added, warnings));
}

std::vector<insideout::Id> Attributes::AlikePoints(
  vtkDataSet* input, const std::vector<insideout::Id>& mergedInto)
{
  vtkPointData* data = input->GetPointData();
  std::vector<insideout::Id> alike = mergedInto;
  std::vector<vtkDataArray*> arrays;
  for (vtkDataArray* array : { data->GetTCoords(), data->GetNormals() })
  {
    if (array && array->GetNumberOfTuples() == input->GetNumberOfPoints())
    {
      arrays.push_back(array);
    }
  }
  if (arrays.empty())
  {
    return alike;
  }
  const auto values = [&](insideout::Id p)
  {
    std::vector<std::uint64_t> bits; // bytewise, so that NaNs compare equal
    for (vtkDataArray* array : arrays)
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        const double value = array->GetComponent(p, k) + 0.0; // -0 becomes 0
        bits.emplace_back();
        std::memcpy(&bits.back(), &value, sizeof(value));
      }
    }
    return bits;
  };
  std::map<std::pair<insideout::Id, std::vector<std::uint64_t>>, insideout::Id> lowest;
  std::vector<char> isShared(alike.size(), 0);
  for (const insideout::Id p : mergedInto)
  {
    isShared[p] += isShared[p] < 2;
  }
  for (insideout::Id p = 0; p < static_cast<insideout::Id>(alike.size()); ++p)
  {
    if (isShared[mergedInto[p]] > 1)
    {
      alike[p] = lowest.insert({ { mergedInto[p], values(p) }, p }).first->second;
    }
  }
  return alike;
}

namespace
{
/** An array of the common type of both, with room for `size` uninitialized tuples. */
vtkSmartPointer<vtkAbstractArray> MakeAlike(
  const std::vector<vtkAbstractArray*>& arrays, vtkIdType size)
{
  vtkSmartPointer<vtkAbstractArray> result;
  result.TakeReference(arrays.front()->NewInstance());
  for (vtkAbstractArray* array : arrays)
  {
    if (array->GetDataType() != result->GetDataType())
    {
      result = vtkSmartPointer<vtkDoubleArray>::New();
    }
  }
  vtkAbstractArray* first = arrays.front();
  RequireMemory(size * first->GetNumberOfComponents() * result->GetDataTypeSize());
  result->SetName(first->GetName());
  result->SetNumberOfComponents(first->GetNumberOfComponents());
  for (int k = 0; k < first->GetNumberOfComponents(); ++k)
  {
    if (const char* component = first->GetComponentName(k))
    {
      result->SetComponentName(k, component);
    }
  }
  result->SetNumberOfTuples(size);
  if (auto* numbers = vtkDataArray::SafeDownCast(result))
  {
    const double none = IsReal(numbers) ? std::numeric_limits<double>::quiet_NaN() : 0;
    for (int k = 0; k < numbers->GetNumberOfComponents(); ++k)
    {
      numbers->FillComponent(k, none);
    }
  }
  return result;
}

/** Whether two arrays of one name can be joined. */
bool FitTogether(vtkAbstractArray* a, vtkAbstractArray* b)
{
  const bool areNumbers = vtkDataArray::SafeDownCast(a) && vtkDataArray::SafeDownCast(b);
  return a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    (areNumbers || a->GetDataType() == b->GetDataType());
}

using DataOfInputs = std::vector<vtkSmartPointer<vtkDataSetAttributes>>;

/** The names of arrays of several inputs, each once. */
std::vector<std::string> NamesOfArrays(const DataOfInputs& inputs)
{
  std::vector<std::string> names;
  for (vtkDataSetAttributes* input : inputs)
  {
    for (int k = 0; k < input->GetNumberOfArrays(); ++k)
    {
      const char* name = input->GetAbstractArray(k)->GetName();
      if (name && std::find(names.begin(), names.end(), name) == names.end())
      {
        names.emplace_back(name);
      }
    }
  }
  return names;
}

/** Rename an array; if it is active it stays so. */
std::string RenameActive(vtkDataSetAttributes* data, const std::string& from, const std::string& to)
{
  std::vector<int> activeAs;
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    if (data->GetAbstractAttribute(type) == data->GetAbstractArray(from.c_str()))
    {
      activeAs.push_back(type);
    }
  }
  const std::string renamed = Attributes::RenameArray(data, from, to);
  for (const int type : activeAs)
  {
    data->SetActiveAttribute(renamed.c_str(), type);
  }
  return renamed;
}

/** Rename arrays of one name that cannot be joined: prefix the names of their inputs. */
void KeepApart(
  const DataOfInputs& inputs, const std::vector<std::string>& inputNames, Warnings& warnings)
{
  for (const std::string& name : NamesOfArrays(inputs))
  {
    vtkAbstractArray* first = nullptr;
    bool areOne = true;
    for (vtkDataSetAttributes* input : inputs)
    {
      vtkAbstractArray* array = input->GetAbstractArray(name.c_str());
      first = first ? first : array;
      areOne = areOne && (!array || FitTogether(first, array));
    }
    for (std::size_t i = 0; i < inputs.size(); ++i)
    {
      if (!areOne && inputs[i]->HasArray(name.c_str()))
      {
        const std::string renamed = RenameActive(inputs[i], name, inputNames[i] + "/" + name);
        WarnOnce("body " + inputNames[i] + ": the array " + name + " is passed on as " + renamed +
            ", because another body's has another type or number of components",
          warnings);
      }
    }
  }
}

/**
 * The first input with tuples that is not among the owners, which are ascending; if there is none,
 * their number.
 */
std::size_t FirstWithout(
  const std::vector<std::size_t>& owners, const std::vector<vtkIdType>& first)
{
  const std::size_t numberOfInputs = first.size() - 1;
  std::size_t input = 0;
  while (input < numberOfInputs &&
    (first[input] == first[input + 1] || std::binary_search(owners.begin(), owners.end(), input)))
  {
    ++input;
  }
  return input;
}
} // namespace

void Attributes::Append(const std::vector<vtkDataSetAttributes*>& inputs,
  const std::vector<std::string>& names, const std::vector<vtkIdType>& first,
  vtkDataSetAttributes* output, Warnings& warnings)
{
  std::vector<vtkSmartPointer<vtkDataSetAttributes>> usable;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    usable.push_back(UsableArrays(inputs[i], first[i + 1] - first[i], false, {}, warnings));
  }
  KeepApart(usable, names, warnings);
  for (const std::string& name : NamesOfArrays(usable))
  {
    std::vector<vtkAbstractArray*> arrays;
    std::vector<std::size_t> owners;
    for (std::size_t i = 0; i < usable.size(); ++i)
    {
      vtkAbstractArray* array = usable[i]->GetAbstractArray(name.c_str());
      if (array)
      {
        arrays.push_back(array);
        owners.push_back(i);
      }
    }
    const std::size_t without = FirstWithout(owners, first);
    if (without < usable.size() && usable[owners.front()]->GetNormals() == arrays.front())
    {
      WarnOnce(
        "the normals are left out, because input " + std::to_string(without + 1) + " has none",
        warnings);
      continue;
    }
    const vtkSmartPointer<vtkAbstractArray> all = MakeAlike(arrays, first.back());
    for (std::size_t k = 0; k < arrays.size(); ++k)
    {
      all->InsertTuples(first[owners[k]], arrays[k]->GetNumberOfTuples(), 0, arrays[k]);
    }
    const int index = output->AddArray(all);
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      vtkAbstractArray* active = usable[owners.front()]->GetAbstractAttribute(type);
      if (active == arrays.front() && !output->GetAbstractAttribute(type))
      {
        output->SetActiveAttribute(index, type);
      }
    }
  }
}
} // namespace vtkInsideOut
