// SPDX-License-Identifier: GPL-3.0-or-later
/** @file VTK's classes that the rooms' headers only name, in VTK's ABI namespace. */
#pragma once

#include "vtkInsideOutVersions.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkAlgorithm;
class vtkCellData;
class vtkDataArray;
class vtkDataObject;
class vtkDataObjectTree;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkDoubleArray;
class vtkFieldData;
class vtkGeneralizedWindingNumber;
class vtkGraphCutSegmentation;
class vtkInformation;
class vtkInformationRequestKey;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkObject;
class vtkPointData;
class vtkPointSet;
class vtkPolyData;
class vtkRefineTetrahedra;
class vtkStringArray;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END
