// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkConstrainedDelaunay3D.h"

#include "ConstrainedDelaunay.h"
#include "FindIntersections.h"
#include "vtkInsideOutConversion.h"
#include "vtkInsideOutMonitor.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

using namespace insideout;

vtkStandardNewMacro(vtkConstrainedDelaunay3D);

vtkConstrainedDelaunay3D::vtkConstrainedDelaunay3D() = default;

void vtkConstrainedDelaunay3D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
}

int vtkConstrainedDelaunay3D::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

namespace
{
/** TetGen may do anything with facets that cross, so that they have to be found before. */
void CheckThatNothingCrosses(
  const FacetComplex& surface, const vtkInsideOutConversion& conversion, Monitor& monitor)
{
  const auto pairs = FindIntersections(surface.Points, surface.Facets, monitor);
  if (!pairs.empty())
  {
    throw Error(ErrorCode::SelfIntersecting,
      "cells " + std::to_string(conversion.CellOfFacet(surface, pairs.front()[0], +1)) + " and " +
        std::to_string(conversion.CellOfFacet(surface, pairs.front()[1], +1)) +
        " intersect, the first of " + std::to_string(pairs.size()) +
        " pairs: run vtkResolveSelfIntersections before");
  }
}
} // namespace

int vtkConstrainedDelaunay3D::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOutRun(this, outputVector,
    [&]()
    {
      vtkInsideOutMonitor monitor(
        this, { "validating", "finding self-intersections", "tetrahedralizing" });
      vtkInsideOutConversion conversion(input);
      const CountedChain chain =
        CountFacets(conversion.Soup, { this->MergeTolerance, this->CountDuplicates }, monitor);
      CheckThatNothingCrosses(chain.Surface, conversion, monitor);
      const TetrahedralMesh mesh = ConstrainedDelaunay(chain.Surface, monitor);
      output->ShallowCopy(conversion.MakeGrid(chain.Surface, mesh));

      vtkInsideOutWarn(this, chain.Warnings);
      vtkInsideOutWarn(this, conversion.Warnings);
      if (!mesh.LostFacets.empty())
      {
        vtkWarningMacro(<< mesh.LostFacets.size()
                        << " facets are no union of faces, the first of cell "
                        << conversion.CellOfFacet(chain.Surface, mesh.LostFacets.front(), +1));
      }
    });
}
