// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Reads tetrahedra and their boundary for a solver's file.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "Files/SolidFile.h"
#include "Quality/SolverFitness.h"

namespace vtkInsideOut
{
/**
 * The solid with its regions and tags, as vtkSolidWriter describes them.
 *
 * @param[in] input a vtkUnstructuredGrid; or a composite data set with one, and at most one surface
 * @param[in] boundary the boundary to use; nullptr for that of the composite data set, or else the
 * faces of one cell
 * @throws insideout::Error that names the invalid cell, triangle or array
 */
insideout::SolidMesh ReadSolid(vtkDataObject* input, vtkPolyData* boundary);

/** The remedies taken for such an input, by its statistics. */
insideout::CellTreatment TreatmentOf(vtkDataObject* input);

/** Whether the options that it was made with allow another treatment of its surface. */
bool MayBeRemeshed(vtkDataObject* input);
} // namespace vtkInsideOut
