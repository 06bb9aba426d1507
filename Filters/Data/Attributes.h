// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Carries the input's point and cell data to the outputs.
 */
#pragma once

#include "Common/Edge.h"
#include "Common/FacetComplex.h"

#include <vtkType.h>

#include <initializer_list>
#include <string>
#include <vector>

class vtkCellData;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkFieldData;
class vtkPointData;

namespace vtkInsideOut
{
namespace Attributes
{
/** Whether a data set is an output of this module's filters, by its field data: its arrays with
 * names that such an output adds are then theirs, and not a user's. */
bool AreMadeHere(vtkDataSet* data);

/**
 * Call an array otherwise: by a copy, for others may have it, too.
 *
 * @return the name that it has now, with a number from 2 on behind it where another has that name
 */
std::string RenameArray(vtkFieldData* data, const std::string& from, const std::string& to);

/**
 * Make way for arrays that an output adds: those of their names are removed where they were made
 * here, and else get another name, Input_NAME.
 *
 * @param[in,out] warnings gains a line per array that gets another name
 */
void RenameArrays(vtkFieldData* data, bool areMadeHere, std::initializer_list<const char*> names,
  std::vector<std::string>& warnings);

/**
 * Point data by origin: copied from an input point, interpolated on a facet, and for a point in the
 * volume NaN (0 in integer arrays). Interpolated active normals are normalized. Adds
 * vtkOriginalPointIds: the input point, -1 for a new one.
 *
 * @param[in,out] warnings gains a line per input array that had to be renamed, or that is left out
 *                because it has not one tuple per point
 */
void PassPointData(vtkDataSet* input, const std::vector<insideout::PointOrigin>& origins,
  vtkPointData* output, std::vector<std::string>& warnings);

/**
 * Cell data by input cell, NaN (0 in integer arrays) where it is -1. Adds vtkOriginalCellIds.
 *
 * @param[in] added names of further arrays that the output adds: the input's are renamed
 */
void PassCellData(vtkDataSet* input, const std::vector<vtkIdType>& cells,
  std::initializer_list<const char*> added, vtkCellData* output,
  std::vector<std::string>& warnings);

/** Cell data by input cell, all arrays as they are. */
void CopyCellData(vtkDataSet* input, const std::vector<insideout::Id>& cells, vtkCellData* output,
  std::vector<std::string>& warnings);

/** The sources of a point of a refined grid: points of the input. */
struct Mixture
{
  std::array<insideout::Id, 4> Points;
  std::array<double, 4> Weights;
  bool IsNew; ///< else it is the first of them
};

/**
 * Point data of points that are kept, copied, and of new ones, interpolated (0 in integer arrays)
 * with active normals normalized; then of points amid edges between these. Adds
 * vtkOriginalPointIds: where the input has it its value, else the input point; -1 for a new one.
 */
void MixPointData(vtkDataSet* input, const std::vector<Mixture>& mixtures,
  const std::vector<insideout::Edge>& edges, vtkPointData* output,
  std::vector<std::string>& warnings);

/**
 * Point and cell data as they are, for an output that has the input's points and cells.
 *
 * @param[in] added names of cell arrays that the output adds: the input's are renamed
 */
void PassAll(vtkDataSet* input, std::initializer_list<const char*> added, vtkDataSet* output,
  std::vector<std::string>& warnings);

/**
 * Per input point the lowest one that was merged into the same and has the same active texture
 * coordinates and normals, to the bit but for the sign of 0.
 *
 * @param[in] mergedInto per point the one that it became, or itself
 */
std::vector<insideout::Id> AlikePoints(
  vtkDataSet* input, const std::vector<insideout::Id>& mergedInto);

/**
 * The data of several data sets, one behind the other. An array that one of them has not is NaN
 * there (0 in integer arrays, empty in others), except for active normals, which are left out
 * with a warning; numbers of different types become doubles. Arrays of one name that are of strings
 * and numbers, or have different numbers of components, stay apart as DATA/ARRAY. An array that is
 * active in the first that has it is active.
 *
 * @param[in] names of the data sets
 * @param[in] first the first tuple of each, and the end
 * @param[in,out] warnings gains a line per array that is called otherwise or left out: it has not
 * one tuple per point or cell
 */
void Append(const std::vector<vtkDataSetAttributes*>& inputs, const std::vector<std::string>& names,
  const std::vector<vtkIdType>& first, vtkDataSetAttributes* output,
  std::vector<std::string>& warnings);
} // namespace Attributes
} // namespace vtkInsideOut
