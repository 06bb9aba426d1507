// SPDX-License-Identifier: GPL-3.0-or-later
// From a surface file to the tetrahedra of its solid: tetrahedralize SURFACE OUTPUT.vtu
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRobustTetrahedralize.h>
#include <vtkSurfaceReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: tetrahedralize SURFACE OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkSurfaceReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkRobustTetrahedralize> tetrahedralize;
  tetrahedralize->SetInputConnection(reader->GetOutputPort());
  tetrahedralize->Update();
  vtkUnstructuredGrid* solid = tetrahedralize->GetOutput();
  if (solid->GetNumberOfCells() == 0)
  {
    return EXIT_FAILURE; // VTK has shown the error or the warning that says why
  }

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(argv[2]);
  writer->SetDataModeToBinary(); // the default mode cannot be read back with some versions of expat
  writer->SetInputData(solid);
  if (!writer->Write())
  {
    return EXIT_FAILURE;
  }
  std::cout << solid->GetNumberOfCells() << " tetrahedra, "
            << tetrahedralize->GetBoundary()->GetNumberOfCells() << " boundary faces, "
            << tetrahedralize->GetOutliers()->GetNumberOfCells() << " outliers\n";
  return EXIT_SUCCESS;
}
