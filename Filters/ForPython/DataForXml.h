// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Data/VtkClasses.h"

#include <vtkSmartPointer.h>

namespace vtkInsideOut
{
/**
 * The data set, not copied, prepared for VTK's XML writers, so that VTK and others can read the
 * file.
 *
 * The writers do not encode names of components: they are encoded here. meshio refuses a grid that
 * has strings in its field data, or arrays without values. There, names become a vtkIntArray of one
 * tuple: the numbers from 0, each a component of that name. Arrays without values are left out.
 */
vtkSmartPointer<vtkDataSet> DataForXml(vtkDataSet* data);
} // namespace vtkInsideOut
