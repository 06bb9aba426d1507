// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutHull.h"

#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <utility>

using namespace insideout;

namespace
{
vtkSmartPointer<vtkPolyData> ShallowCopyOf(vtkPolyData* input)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(input);
  return copy;
}
} // namespace

vtkInsideOutHull::vtkInsideOutHull(vtkPolyData* input, const vtkInsideOutHullArrays& names)
  : Surface(vtkInsideOutReadSurface(ShallowCopyOf(input), names.NonParticipating))
  , Outputs(this->Surface)
  , Bodies(vtkInsideOutReadBodies(this->Surface, names.Bodies))
{
}

void vtkInsideOutHull::Resolve(const HullMeshParameters& parameters, Monitor& monitor)
{
  this->Hull = ResolveHull(this->Bodies.AreNamed()
      ? SplitBodies(this->Surface.Soup, this->Bodies.OfTriangle, this->Bodies.Names)
      : OneBody(this->Surface.Soup),
    parameters, monitor);
}

void vtkInsideOutHull::Fill(const HullMeshParameters& parameters, Monitor& monitor)
{
  if (!this->IsFilled)
  {
    HullMesh filled = this->Hull;
    MeshResolvedHull(parameters, filled, monitor);
    this->Hull = std::move(filled);
    this->IsFilled = true;
  }
}

void vtkInsideOutHull::MakeGrid()
{
  if (this->Grid)
  {
    return;
  }
  this->Grid = this->Outputs.MakeGrid(this->Hull);
  if (this->Bodies.AreNamed())
  {
    vtkInsideOutAddBodyW(this->Hull, this->Bodies.Names, this->Grid);
  }
}
