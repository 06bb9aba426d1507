// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Carries the input's point and cell data to the outputs.
 */
#pragma once

#include "Common/Edge.h"
#include "Common/FacetComplex.h"
#include "Data/VtkClasses.h"

#include <vtkType.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace vtkInsideOut
{
namespace Attributes
{
/** Whether a data set is an output of this module's filters, by its field data. Arrays with names
 * that such an output adds are then the filter's, not a user's. */
bool AreMadeHere(vtkDataSet* data);

/**
 * Rename an array, as a copy, because others may share it.
 *
 * @return its new name, with a number from 2 on appended if the name was taken
 */
std::string RenameArray(vtkFieldData* data, const std::string& from, const std::string& to);

/**
 * Free the names of arrays that an output adds: arrays of these names made by this module are
 * removed, others are renamed Input_NAME.
 *
 * @param[in,out] warnings gains a line per renamed array
 */
void RenameArrays(vtkFieldData* data, bool areMadeHere, std::initializer_list<const char*> names,
  std::vector<std::string>& warnings);

/**
 * Point data by origin: copied from an input point, interpolated on a facet, and for a point in the
 * volume NaN (0 in integer arrays). Interpolated active normals are normalized. Adds
 * vtkOriginalPointIds: the input point, -1 for a new one.
 *
 * @param[in,out] warnings gains a line per input array that is renamed, or left out because it
 * lacks one tuple per point
 */
void PassPointData(vtkDataSet* input, const std::vector<insideout::PointOrigin>& origins,
  vtkPointData* output, std::vector<std::string>& warnings);

/**
 * Cell data by input cell, NaN (0 in integer arrays) where it is -1. Adds vtkOriginalCellIds.
 *
 * @param[in] added names of further arrays that the output adds: arrays of the input with these
 * names are renamed
 */
void PassCellData(vtkDataSet* input, const std::vector<vtkIdType>& cells,
  std::initializer_list<const char*> added, vtkCellData* output,
  std::vector<std::string>& warnings);

/** Cell data by input cell, all arrays as they are. */
void CopyCellData(vtkDataSet* input, const std::vector<insideout::Id>& cells, vtkCellData* output,
  std::vector<std::string>& warnings);

/** The origin of a point of a refined grid: points of the input. */
struct Mixture
{
  std::array<insideout::Id, 4> Points;
  std::array<double, 4> Weights;
  bool IsNew; ///< otherwise it is the first of them
};

/**
 * Point data of points that are kept, copied, and of new ones, interpolated (0 in integer arrays)
 * with active normals normalized; then of mid-edge nodes between these. Adds vtkOriginalPointIds:
 * its value if the input has it, else the input point; -1 for a new one.
 */
void MixPointData(vtkDataSet* input, const std::vector<Mixture>& mixtures,
  const std::vector<insideout::Edge>& edges, vtkPointData* output,
  std::vector<std::string>& warnings);

/**
 * Point and cell data as they are, for an output that has the input's points and cells.
 *
 * @param[in] added names of cell arrays that the output adds: arrays of the input with these names
 * are renamed
 */
void PassAll(vtkDataSet* input, std::initializer_list<const char*> added, vtkDataSet* output,
  std::vector<std::string>& warnings);

/**
 * Per input point the lowest one that was merged into the same and has bitwise equal active texture
 * coordinates and normals, up to the sign of 0.
 *
 * @param[in] mergedInto per point the point that it was merged with, or itself
 */
std::vector<insideout::Id> AlikePoints(
  vtkDataSet* input, const std::vector<insideout::Id>& mergedInto);

/**
 * The concatenated data of several data sets. A missing array is NaN there (0 in integer arrays,
 * empty in others), except for active normals, which are left out with a warning; numbers of
 * different types become doubles. Arrays of one name that mix strings and numbers, or have
 * different numbers of components, stay separate as DATA/ARRAY. An array is active if it is in the
 * first data set that has it.
 *
 * @param[in] names of the data sets
 * @param[in] first the first tuple of each, and the end
 * @param[in,out] warnings gains a line per array that is renamed or left out, because it lacks one
 * tuple per point or cell
 */
void Append(const std::vector<vtkDataSetAttributes*>& inputs, const std::vector<std::string>& names,
  const std::vector<vtkIdType>& first, vtkDataSetAttributes* output,
  std::vector<std::string>& warnings);
} // namespace Attributes
} // namespace vtkInsideOut
