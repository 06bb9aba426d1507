// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Reads tetrahedra and their boundary for a solver's file.
 */
#pragma once

#include "Files/SolidFile.h"
#include "Quality/SolverFitness.h"

class vtkDataObject;
class vtkPolyData;

namespace vtkInsideOut
{
/**
 * The solid with its regions and tags, as vtkSolidWriter describes them.
 *
 * @param[in] input a vtkUnstructuredGrid; or a composite data set with one, and at most one surface
 * @param[in] boundary what to take for the boundary; nullptr for that of the composite data set,
 * and where there is none for the faces of one cell
 * @throws insideout::Error that names the cell, triangle or array at fault
 */
insideout::SolidMesh ReadSolid(vtkDataObject* input, vtkPolyData* boundary);

/** What has been done for the cells of such an input, by its statistics. */
insideout::CellTreatment TreatmentOf(vtkDataObject* input);
} // namespace vtkInsideOut
