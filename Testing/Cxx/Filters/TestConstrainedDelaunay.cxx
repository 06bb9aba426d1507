// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boxes.h"
#include "Listener.h"
#include "vtkConstrainedDelaunay3D.h"
#include "vtkResolveSelfIntersections.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

TEST(vtkConstrainedDelaunay3D, RefusesFacetsThatCrossAndNamesTheirCells)
{
  vtkNew<vtkConstrainedDelaunay3D> filter;
  Listener errors(filter, vtkCommand::ErrorEvent);
  filter->SetInputData(TwoBoxes());
  filter->Update();
  EXPECT_TRUE(errors.Heard("intersect")) << errors.Texts.size();
  EXPECT_TRUE(errors.Heard("vtkResolveSelfIntersections"));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(vtkConstrainedDelaunay3D, TakesWhatTheResolverGivesWithItsMultiplicities)
{
  auto surface = EmptySurface();
  AddBox(surface, 0, 1);
  AddBox(surface, 0, 1); // every face twice, which counts once
  vtkNew<vtkResolveSelfIntersections> resolve;
  resolve->SetInputData(surface);
  vtkNew<vtkConstrainedDelaunay3D> mesh;
  Listener warnings(mesh, vtkCommand::WarningEvent);
  mesh->SetInputConnection(resolve->GetOutputPort());
  mesh->Update();
  vtkUnstructuredGrid* grid = mesh->GetOutput();
  EXPECT_NEAR(Volume(grid), 1, 1e-15);
  vtkDataArray* multiplicity = grid->GetCellData()->GetArray("FacetMultiplicity");
  vtkDataArray* facets = grid->GetCellData()->GetArray("FacetIds");
  ASSERT_EQ(multiplicity->GetNumberOfComponents(), 4);
  int onFacets = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const bool onFacet = facets->GetComponent(c, k) >= 0;
      EXPECT_EQ(multiplicity->GetComponent(c, k), onFacet ? 1 : 0);
      onFacets += onFacet;
    }
  }
  EXPECT_EQ(onFacets, 12);
}
