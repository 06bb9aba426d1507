// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/Bodies.h"

#include "Boolean/AgreeOnSides.h"
#include "Common/Error.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "In/Partitions.h"
#include "Output/MassProperties.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

#include <algorithm>
#include <map>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
bool HasPolygons(vtkPolyData* surface)
{
  return surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
}

/** The body named by each seed: None for none. */
std::vector<Id> BodiesOfSeeds(vtkPointSet* points, const std::vector<std::string>& names)
{
  std::vector<Id> bodies(points->GetNumberOfPoints(), None);
  vtkAbstractArray* array = points->GetPointData()->GetAbstractArray("Body");
  if (array &&
    (array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != points->GetNumberOfPoints()))
  {
    throw Error(
      ErrorCode::InvalidParameter, "the seeds' point array Body has not one value per point");
  }
  for (std::size_t p = 0; array && p < bodies.size(); ++p)
  {
    const std::string name = array->GetVariantValue(static_cast<vtkIdType>(p)).ToString();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() && !name.empty())
    {
      throw Error(ErrorCode::InvalidParameter,
        "seed " + std::to_string(p) + " names " + name + ", which is not a body");
    }
    bodies[p] = name.empty() ? None : static_cast<Id>(found - names.begin());
  }
  return bodies;
}

/** Keep the triangles with different labels on their sides. @return these labels */
std::vector<Sides> KeepInterfaces(Surface& surface, const Tags& sides, const std::string& arrayName)
{
  std::vector<Sides> kept;
  TriangleSoup& soup = surface.Soup;
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    const vtkIdType cell = surface.CellOfTriangle[t];
    const Sides ofCell = { { sides.OfCell[2 * cell], sides.OfCell[2 * cell + 1] } };
    if (ofCell[0] == ofCell[1])
    {
      continue;
    }
    const std::size_t k = kept.size();
    kept.push_back(ofCell);
    soup.Triangles[k] = soup.Triangles[t];
    surface.CellOfTriangle[k] = cell;
    if (!soup.Multiplicity.empty())
    {
      soup.Multiplicity[k] = soup.Multiplicity[t];
    }
    if (!soup.NonParticipating.empty())
    {
      soup.NonParticipating[k] = soup.NonParticipating[t];
    }
  }
  if (kept.empty())
  {
    throw Error(ErrorCode::EmptySurface,
      "the cell array " + arrayName + " has no triangle with different labels on its two sides");
  }
  if (const std::size_t leftOut = soup.Triangles.size() - kept.size())
  {
    surface.Warnings.push_back(std::to_string(leftOut) + " triangles have the same label of " +
      arrayName + " on both sides, and are left out");
  }
  soup.Triangles.resize(kept.size());
  surface.CellOfTriangle.resize(kept.size());
  soup.Multiplicity.resize(soup.Multiplicity.empty() ? 0 : kept.size());
  soup.NonParticipating.resize(soup.NonParticipating.empty() ? 0 : kept.size());
  return kept;
}

/** Replace each triangle between two bodies by one per body. @return the body of each triangle */
std::vector<Id> GiveToBothSides(Surface& surface, const std::vector<Sides>& sides)
{
  const TriangleSoup given = surface.Soup;
  const std::vector<vtkIdType> cells = surface.CellOfTriangle;
  const std::vector<unsigned char> turned = AgreeOnSides(given, sides);
  surface.Soup = { given.Points, {} };
  surface.CellOfTriangle.clear();
  std::vector<Id> ofTriangle;
  for (std::size_t t = 0; t < sides.size(); ++t)
  {
    const auto [a, b, c] = given.Triangles[t];
    for (int side = 0; side < 2; ++side)
    {
      if (sides[t][side] == None)
      {
        continue;
      }
      const bool isReversed = (side == 1) != (turned[t] != 0);
      ofTriangle.push_back(sides[t][side]);
      surface.Soup.Triangles.push_back(isReversed ? Triangle{ { a, c, b } } : given.Triangles[t]);
      surface.CellOfTriangle.push_back(cells[t]);
      if (!given.Multiplicity.empty())
      {
        surface.Soup.Multiplicity.push_back(given.Multiplicity[t]);
      }
      if (!given.NonParticipating.empty())
      {
        surface.Soup.NonParticipating.push_back(given.NonParticipating[t]);
      }
    }
  }
  return ofTriangle;
}

/** An array with one component per body, named after the bodies. */
template <typename Array, typename Value>
vtkSmartPointer<Array> ArrayOfBodies(const char* name,
  const std::vector<std::vector<Value>>& values, const std::vector<std::string>& names)
{
  const auto size = static_cast<vtkIdType>(values.empty() ? 0 : values.front().size());
  auto array = MakeArray<Array>(name, size, static_cast<int>(values.size()));
  for (int b = 0; b < static_cast<int>(values.size()); ++b)
  {
    array->SetComponentName(b, names[b].c_str());
    for (vtkIdType i = 0; i < size; ++i)
    {
      array->SetTypedComponent(i, b, values[b][i]);
    }
  }
  return array;
}

/** Per body, whether regions belong to it. */
std::vector<std::vector<unsigned char>> RegionsOfBodies(
  const std::vector<std::vector<Id>>& bodiesOfRegions, std::size_t bodies)
{
  std::vector<std::vector<unsigned char>> of(
    bodies, std::vector<unsigned char>(bodiesOfRegions.size(), 0));
  for (std::size_t region = 0; region < bodiesOfRegions.size(); ++region)
  {
    for (const Id body : bodiesOfRegions[region])
    {
      of[body][region] = 1;
    }
  }
  return of;
}
} // namespace

vtkSmartPointer<vtkPolyData> JoinBlocks(vtkDataObject* blocks, std::vector<std::string>& warnings)
{
  vtkNew<vtkAppendPolyData> append;
  std::vector<std::string> names;
  VisitBlocks(blocks,
    [&](vtkDataObject* block, const std::string& path)
    {
      const std::string name = path.empty() ? std::to_string(names.size()) : path;
      const std::string label = "block " + name + ": ";
      const auto surface = JoinPartitions(block, label);
      if (!surface)
      {
        throw Error(ErrorCode::InvalidParameter,
          "block " + name + " is a " + block->GetClassName() + "; bodies are vtkPolyData");
      }
      auto copy = vtkSmartPointer<vtkPolyData>::New();
      copy->ShallowCopy(surface);
      // Check before surfaces are joined, which can hide ids out of range.
      CheckPolygons(surface, label);
      std::vector<std::string> ofBody;
      if (!HasPolygons(surface))
      {
        ofBody.emplace_back("the surface has no polygons: the body is empty");
      }
      Attributes::RenameArrays(
        copy->GetCellData(), Attributes::AreMadeHere(surface), { BodyIds }, ofBody);
      for (const std::string& warning : ofBody)
      {
        warnings.push_back(WordsOf(name, warning));
      }
      copy->GetCellData()->AddArray(MakeArray<vtkIntArray>(
        BodyIds, std::vector<int>(surface->GetNumberOfCells(), static_cast<int>(names.size()))));
      append->AddInputData(copy);
      names.push_back(name);
    });
  if (names.empty())
  {
    throw Error(ErrorCode::EmptySurface, "there are no blocks, which were to be bodies");
  }
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  vtkSmartPointer<vtkPolyData> joined = append->GetOutput();
  if (!HasPolygons(joined))
  {
    throw Error(ErrorCode::EmptySurface, "none of the blocks has polygons");
  }
  joined->GetFieldData()->AddArray(MakeStrings("BodyNames", names));
  return joined;
}

std::vector<std::string> NamesOfBodies(vtkPolyData* surface, const std::string& arrayName)
{
  if (arrayName.empty())
  {
    return {};
  }
  const std::optional<Tags> sides = ReadSides(surface, arrayName);
  return sides ? sides->Names : ReadTags(surface, arrayName, {}).Names;
}

Bodies ReadBodies(Surface& surface, const std::string& arrayName)
{
  Bodies bodies;
  if (arrayName.empty())
  {
    return bodies;
  }
  const std::optional<Tags> sides = ReadSides(surface.Input, arrayName);
  const Tags tags = sides ? *sides : ReadTags(surface.Input, arrayName, {});
  bodies.Names = tags.Names;
  if (sides)
  {
    bodies.OfTriangle = GiveToBothSides(surface, KeepInterfaces(surface, tags, arrayName));
    return bodies;
  }
  for (const vtkIdType cell : surface.CellOfTriangle)
  {
    bodies.OfTriangle.push_back(tags.OfCell[cell]);
  }
  return bodies;
}

std::vector<std::string> SplitNames(const std::string& names)
{
  std::vector<std::string> split;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (split.empty() || names[i] == ',')
    {
      split.emplace_back();
    }
    if (names[i] != ',')
    {
      i += names[i] == '\\' && i + 1 < names.size();
      split.back() += names[i];
    }
  }
  return split;
}

std::vector<std::vector<Seed>> SeedsOfBodies(
  const std::vector<Seed>& seeds, vtkPointSet* points, const std::vector<std::string>& names)
{
  std::vector<std::vector<Seed>> ofBodies(names.size());
  if (seeds.empty())
  {
    return ofBodies;
  }
  const std::vector<Id> bodies = BodiesOfSeeds(points, names);
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    if (bodies[s] == None && seeds[s].Inside)
    {
      throw Error(ErrorCode::InvalidParameter,
        "seed " + std::to_string(s) +
          " is to be inside, but its point array Body does not say which body");
    }
    for (Id b = 0; b < static_cast<Id>(names.size()); ++b)
    {
      if (bodies[s] == None || bodies[s] == b)
      {
        ofBodies[b].push_back(seeds[s]);
      }
    }
  }
  return ofBodies;
}

std::vector<std::vector<FacetPiece>> PiecesOfBodies(
  const HullMesh& hull, const Bodies& bodies, const std::vector<unsigned char>& chosen)
{
  const FacetComplex& surface = hull.Surface;
  std::vector<std::vector<unsigned char>> ofBody(
    bodies.Names.size(), std::vector<unsigned char>(surface.Facets.size(), 0));
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    for (Id s = surface.SourceOffsets[f]; s < surface.SourceOffsets[f + 1]; ++s)
    {
      ofBody[bodies.OfTriangle[surface.Sources[s].Triangle]][f] = chosen.empty() || chosen[f];
    }
  }
  std::vector<std::vector<FacetPiece>> pieces;
  for (const std::vector<unsigned char>& facets : ofBody)
  {
    pieces.push_back(PiecesOfFacets(hull.Mesh, facets));
  }
  return pieces;
}

std::function<bool(Id, Id)> IsInOwnBody(
  const HullMesh& hull, const Bodies& bodies, const std::vector<std::vector<unsigned char>>& inside)
{
  return [&](Id facet, Id cell)
  {
    const auto sources = hull.Surface.Sources.begin();
    return std::any_of(sources + hull.Surface.SourceOffsets[facet],
      sources + hull.Surface.SourceOffsets[facet + 1],
      [&](const FacetSource& source)
      { return inside[bodies.OfTriangle[source.Triangle]][cell] != 0; });
  };
}

void AddBodyW(
  const HullMesh& hull, const std::vector<std::string>& names, vtkUnstructuredGrid* grid)
{
  const std::vector<std::vector<double>> single = { hull.WOfBody(0) };
  grid->GetCellData()->AddArray(
    ArrayOfBodies<vtkDoubleArray>("BodyW", names.size() > 1 ? hull.WOfBodies : single, names));
}

void AddBodies(const Bodies& bodies, const std::vector<std::vector<unsigned char>>& inside,
  const BodyRegions& regions, const TetrahedralMesh& mesh, vtkUnstructuredGrid* grid)
{
  grid->GetCellData()->AddArray(
    ArrayOfBodies<vtkUnsignedCharArray>("InBody", inside, bodies.Names));
  std::vector<double> volumes;
  for (const std::vector<unsigned char>& cells : inside)
  {
    volumes.push_back(MeasureMass(mesh, cells).Volume);
  }
  vtkFieldData* fields = grid->GetFieldData();
  fields->AddArray(MakeStrings("BodyNames", bodies.Names));
  fields->AddArray(MakeArray<vtkDoubleArray>("BodyVolume", volumes));
  fields->AddArray(MakeStrings("RegionNames", NamesOfRegions(regions, bodies.Names)));
  fields->AddArray(ArrayOfBodies<vtkUnsignedCharArray>(
    "RegionBodies", RegionsOfBodies(regions.Bodies, bodies.Names.size()), bodies.Names));
}

void AddRegionIds(const RegionBoundaries& boundaries, vtkPolyData* boundary)
{
  const auto size = static_cast<vtkIdType>(boundaries.Regions.size());
  auto regionIds = MakeArray<vtkIntArray>("RegionIds", size, 2);
  regionIds->SetComponentName(0, "behind");
  regionIds->SetComponentName(1, "before");
  for (vtkIdType i = 0; i < size; ++i)
  {
    regionIds->SetTypedTuple(i, boundaries.Regions[i].data());
  }
  boundary->GetCellData()->AddArray(regionIds);
}

void AddRegionTags(const RegionBoundaries& boundaries, const std::vector<std::string>& regionNames,
  const Tags* tags, vtkPolyData* boundary)
{
  const auto size = static_cast<vtkIdType>(boundaries.Regions.size());
  std::vector<std::string> names;
  std::vector<int> tagOf(boundaries.Regions.size(), 0);
  if (tags)
  {
    AddTags(*tags, boundary);
    vtkDataArray* given = boundary->GetCellData()->GetArray("BoundaryTag");
    auto* givenNames =
      vtkStringArray::SafeDownCast(boundary->GetFieldData()->GetAbstractArray("BoundaryTagNames"));
    for (vtkIdType i = 0; i < size; ++i)
    {
      tagOf[i] = static_cast<int>(given->GetComponent(i, 0));
    }
    for (vtkIdType i = 0; i < givenNames->GetNumberOfValues(); ++i)
    {
      names.push_back(givenNames->GetValue(i));
    }
  }
  std::map<std::array<Id, 2>, int> tagOfPair; // in the order of the regions
  for (const std::array<Id, 2>& pair : boundaries.Regions)
  {
    if (!tags || pair[1] != None)
    {
      tagOfPair.insert({ pair, 0 });
    }
  }
  for (auto& [pair, tag] : tagOfPair)
  {
    tag = static_cast<int>(names.size());
    names.push_back(
      regionNames[pair[0]] + "|" + (pair[1] == None ? "outside" : regionNames[pair[1]]));
  }
  for (vtkIdType i = 0; i < size; ++i)
  {
    const auto found = tagOfPair.find(boundaries.Regions[i]);
    tagOf[i] = found == tagOfPair.end() ? tagOf[i] : found->second;
  }
  boundary->GetCellData()->AddArray(MakeArray<vtkIntArray>("BoundaryTag", tagOf));
  boundary->GetFieldData()->AddArray(MakeStrings("BoundaryTagNames", names));
}
} // namespace vtkInsideOut
