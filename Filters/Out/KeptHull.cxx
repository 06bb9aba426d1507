// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/KeptHull.h"

#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <utility>

namespace vtkInsideOut
{
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

KeptHull::KeptHull(vtkPolyData* input, const HullArrays& names)
  : Surface(ReadSurface(ShallowCopyOf(input), names.NonParticipating))
  , Bodies(ReadBodies(this->Surface, names.Bodies))
  , Outputs(this->Surface)
{
}

void KeptHull::Resolve(const HullMeshParameters& parameters, Monitor& monitor)
{
  this->Hull = ResolveHull(this->Bodies.AreNamed()
      ? SplitBodies(this->Surface.Soup, this->Bodies.OfTriangle, this->Bodies.Names)
      : OneBody(this->Surface.Soup),
    parameters, monitor);
}

void KeptHull::Fill(const HullMeshParameters& parameters, Monitor& monitor)
{
  if (!this->IsFilled)
  {
    HullMesh filled = this->Hull;
    MeshResolvedHull(parameters, filled, monitor);
    this->Hull = std::move(filled);
    this->IsFilled = true;
  }
}

void KeptHull::MakeGrid()
{
  if (this->Grid)
  {
    return;
  }
  this->Grid = this->Outputs.MakeGrid(this->Hull);
  if (this->Bodies.AreNamed())
  {
    AddBodyW(this->Hull, this->Bodies.Names, this->Grid);
  }
}
} // namespace vtkInsideOut
