// SPDX-License-Identifier: GPL-3.0-or-later
// vtkSolidReader as an algorithm. What it reads stands in Testing/Python/TestReadSolid.py.
#include "vtkSolidReader.h"

#include "Listener.h"
#include "Support/TemporaryFile.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

namespace
{
/** Two tetrahedra in groups 4 and 2, and a triangle in none. */
const char* const TwoCells =
  "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 7 7 7\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 0 0 1\n"
  "6 1 1 1\n$EndNodes\n$Elements\n3\n1 4 2 4 1 2 3 4 5\n2 4 2 2 1 6 4 3 5\n3 2 2 0 0 3 5 6\n"
  "$EndElements\n";
} // namespace

TEST(vtkSolidReader, GivesTetrahedraAndTheirBoundaryWithGroups)
{
  const testfiles::TemporaryFile file("a.MSH", TwoCells);
  vtkNew<vtkSolidReader> reader;
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  vtkUnstructuredGrid* solid = reader->GetOutput();
  EXPECT_EQ(solid->GetNumberOfPoints(), 6);
  ASSERT_EQ(solid->GetNumberOfCells(), 2);
  EXPECT_EQ(solid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(solid->GetCellData()->GetArray("RegionId")->GetComponent(0, 0), 3);
  EXPECT_EQ(solid->GetCellData()->GetArray("RegionId")->GetComponent(1, 0), 1);
  EXPECT_EQ(reader->GetBoundary()->GetNumberOfPoints(), 3);
  ASSERT_EQ(reader->GetBoundary()->GetNumberOfCells(), 1);
  EXPECT_EQ(reader->GetBoundary()->GetCellData()->GetArray("BoundaryTag")->GetComponent(0, 0), 0);
}

TEST(vtkSolidReader, EmptiesBothOutputsWhereAFileIsDamaged)
{
  const testfiles::TemporaryFile file("a.msh", TwoCells);
  vtkNew<vtkSolidReader> reader;
  const Listener errors(reader, vtkCommand::ErrorEvent);
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  file.Write(std::string(TwoCells).replace(100, 1, "x"));
  reader->Modified();
  reader->Update();
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_TRUE(errors.Heard(file.Name + ", line "));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(reader->GetBoundary()->GetNumberOfCells(), 0);
}

TEST(vtkSolidReader, GivesNothingAndNoErrorWhenItIsStopped)
{
  const testfiles::TemporaryFile file("a.msh", TwoCells);
  vtkNew<vtkSolidReader> reader;
  const Listener errors(reader, vtkCommand::ErrorEvent);
  reader->SetFileName(file.Path.c_str());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* algorithm, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(algorithm)->SetAbortExecute(1); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Update();
  EXPECT_TRUE(errors.Texts.empty());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
}
