// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

class vtkDataSet;

namespace vtkInsideOut
{
/**
 * The data set, not copied, as VTK's XML writers put it into a file that VTK and others read.
 *
 * The writers write names of components as they are: here they are encoded for XML. meshio refuses
 * a grid that has strings in its field data, or arrays without values. There, names become a
 * vtkIntArray of one tuple: the numbers from 0, each a component of that name. Arrays without
 * values are left out.
 */
vtkSmartPointer<vtkDataSet> DataForXml(vtkDataSet* data);
} // namespace vtkInsideOut
