// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutSegmentation.h"

#include "Common/Error.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>

using insideout::Error;
using insideout::ErrorCode;
using insideout::Id;

std::vector<insideout::Seed> vtkInsideOutReadSeeds(vtkPointSet* points)
{
  std::vector<insideout::Seed> seeds;
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return seeds;
  }
  vtkDataArray* inside = points->GetPointData()->GetArray("Inside");
  if (!inside || inside->GetNumberOfComponents() != 1 ||
    inside->GetNumberOfTuples() != points->GetNumberOfPoints())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the seeds have no point array Inside of one value per point: 1 for inside, 0 for outside");
  }
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    insideout::Seed seed;
    points->GetPoint(p, seed.Position.data());
    seed.Inside = inside->GetComponent(p, 0) != 0;
    seeds.push_back(seed);
  }
  return seeds;
}

std::vector<unsigned char> vtkInsideOutChosenFacets(vtkPolyData* input, const std::string& name,
  const insideout::FacetComplex& surface, const std::vector<vtkIdType>& cellOfTriangle)
{
  std::vector<unsigned char> chosen;
  if (name.empty())
  {
    return chosen;
  }
  vtkDataArray* array = input->GetCellData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != input->GetNumberOfCells())
  {
    throw Error(ErrorCode::InvalidParameter,
      "the surface has no cell array " + name +
        " of one value per cell, which is to choose facets");
  }
  chosen.assign(surface.Facets.size(), 0);
  for (Id facet = 0; facet < surface.NumberOfFacets(); ++facet)
  {
    for (Id s = surface.SourceOffsets[facet]; s < surface.SourceOffsets[facet + 1]; ++s)
    {
      const vtkIdType cell = cellOfTriangle[surface.Sources[s].Triangle];
      chosen[facet] = chosen[facet] || array->GetComponent(cell, 0) != 0;
    }
  }
  return chosen;
}
