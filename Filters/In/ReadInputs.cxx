// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadInputs.h"

#include "Data/Attributes.h"
#include "In/Blocks.h"
#include "In/Partitions.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <initializer_list>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;
using insideout::Id;

std::vector<NamedSurface> FindInputs(vtkInformationVector* inputs)
{
  std::vector<NamedSurface> surfaces;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkDataObject* data = inputs->GetInformationObject(i)->Get(vtkDataObject::DATA_OBJECT());
    VisitBlocks(data,
      [&](vtkDataObject* block, const std::string& name)
      {
        const std::string words =
          "input " + std::to_string(i + 1) + (name.empty() ? "" : ", block " + name);
        const auto surface = JoinPartitions(block, words + ", ");
        if (surface)
        {
          surfaces.push_back({ name, surface });
        }
        else if (!PartitionsOf(block).empty())
        {
          throw Error(ErrorCode::InvalidParameter,
            words + " is a " + block->GetClassName() + ", and no vtkPolyData");
        }
      });
  }
  return surfaces;
}

namespace
{
std::string NameOf(const NamedSurface& surface, std::size_t index)
{
  if (!surface.Name.empty())
  {
    return surface.Name;
  }
  return index < 26 ? std::string(1, static_cast<char>('A' + index)) : std::to_string(index + 1);
}

/** Its triangles; none without polygons. */
Surface ReadBody(vtkPolyData* data, const std::string& name)
{
  try
  {
    return ReadSurface(data);
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::EmptySurface)
    {
      throw Error(error.Code, "body " + name + ": " + error.what());
    }
    return { data, {}, {} };
  }
}

void Append(const Surface& body, Inputs& bodies)
{
  insideout::TriangleSoup& all = bodies.Surface.Soup;
  const Id firstPoint = static_cast<Id>(bodies.FirstPoint.back());
  all.Points.insert(all.Points.end(), body.Soup.Points.begin(), body.Soup.Points.end());
  all.Points.resize(firstPoint + body.Input->GetNumberOfPoints());
  for (const insideout::Triangle& t : body.Soup.Triangles)
  {
    all.Triangles.push_back({ { t[0] + firstPoint, t[1] + firstPoint, t[2] + firstPoint } });
  }
  for (const vtkIdType cell : body.CellOfTriangle)
  {
    bodies.Surface.CellOfTriangle.push_back(bodies.FirstCell.back() + cell);
  }
  bodies.BodyOfTriangle.resize(all.Triangles.size(), static_cast<Id>(bodies.Bodies.size()));
  bodies.FirstPoint.push_back(bodies.FirstPoint.back() + body.Input->GetNumberOfPoints());
  bodies.FirstCell.push_back(bodies.FirstCell.back() + body.Input->GetNumberOfCells());
}

/**
 * A surface with the same data, without arrays that the result adds. Those of an earlier result
 * describe other bodies and are dropped; a user's are renamed.
 */
vtkSmartPointer<vtkPolyData> CopyOwnData(vtkPolyData* surface, std::vector<std::string>& warnings)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  const bool isMadeHere = Attributes::AreMadeHere(surface);
  for (vtkDataSetAttributes* data :
    std::initializer_list<vtkDataSetAttributes*>{ copy->GetPointData(), copy->GetCellData() })
  {
    const bool areCells = data == copy->GetCellData();
    const char* ids = areCells ? "vtkOriginalCellIds" : "vtkOriginalPointIds";
    if (isMadeHere)
    {
      data->RemoveArray(ids);
    }
    Attributes::RenameArrays(data, isMadeHere, { ids, "BodyId" }, warnings);
    if (areCells)
    {
      Attributes::RenameArrays(data, isMadeHere, { "Turned", "FacetMultiplicity" }, warnings);
    }
  }
  return copy;
}

/** A data set with the bodies' point and cell data, with as many points and cells, but without
 * geometry. */
vtkSmartPointer<vtkPolyData> DataOf(const std::vector<NamedSurface>& surfaces, Inputs& bodies)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(bodies.FirstPoint.back());
  data->SetPoints(points);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(bodies.FirstCell.back() + 1);
  offsets->FillValue(0);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, vtkNew<vtkIdTypeArray>());
  data->SetPolys(cells);
  std::vector<std::string>& warnings = bodies.Surface.Warnings;
  std::vector<vtkSmartPointer<vtkPolyData>> copies;
  for (const NamedSurface& surface : surfaces)
  {
    copies.push_back(CopyOwnData(surface.Data, warnings));
  }
  const std::vector<std::string> names = bodies.Names();
  bodies.Tags = ShareTags(names, copies, warnings);
  std::vector<vtkDataSetAttributes*> pointData;
  std::vector<vtkDataSetAttributes*> cellData;
  for (vtkPolyData* copy : copies)
  {
    pointData.push_back(copy->GetPointData());
    cellData.push_back(copy->GetCellData());
  }
  Attributes::Append(pointData, names, bodies.FirstPoint, data->GetPointData(), warnings);
  Attributes::Append(cellData, names, bodies.FirstCell, data->GetCellData(), warnings);
  return data;
}
} // namespace

std::vector<std::string> Inputs::Names() const
{
  std::vector<std::string> names;
  for (const insideout::Body& body : this->Bodies)
  {
    names.push_back(body.Name);
  }
  return names;
}

Inputs ReadInputs(const std::vector<NamedSurface>& surfaces)
{
  Inputs bodies;
  bodies.FirstPoint = { 0 };
  bodies.FirstCell = { 0 };
  for (const NamedSurface& surface : surfaces)
  {
    const std::string name = NameOf(surface, bodies.Bodies.size());
    Surface body = ReadBody(surface.Data, name);
    for (const std::string& warning : body.Warnings)
    {
      bodies.Surface.Warnings.push_back("body " + name + ": " + warning);
    }
    const Id firstTriangle = static_cast<Id>(bodies.Surface.Soup.Triangles.size());
    const Id firstPoint = static_cast<Id>(bodies.FirstPoint.back());
    Append(body, bodies);
    bodies.Bodies.push_back(
      insideout::MakeBody(name, std::move(body.Soup), firstPoint, firstTriangle));
  }
  bodies.Surface.Input = DataOf(surfaces, bodies);
  return bodies;
}
} // namespace vtkInsideOut
