// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Several data sets as one: the partitions of a partitioned data set, which are one surface or one
 * grid, and the blocks of a second input: a surface to probe, seeds, a background or a solid.
 *
 * Points and cells are numbered data set by data set; for surfaces first all vertices, then all
 * lines, polygons and strips, as vtkPolyData numbers cells. The result has the common arrays, the
 * field data of the first, and no ghost cells.
 */
#pragma once

#include "Data/VtkClasses.h"

#include <vtkSmartPointer.h>

#include <string>

namespace vtkInsideOut
{
/**
 * The surface of a block: itself, or its partitions.
 *
 * @param[in] label prefix of messages
 * @return null if it, or a partition, is not a surface
 * @throws insideout::Error that names the partition, and the invalid cell or point: joining
 * surfaces would hide a reference to missing points
 */
vtkSmartPointer<vtkPolyData> JoinPartitions(
  vtkDataObject* block, const std::string& label = std::string());

///@{
/** The same of the block that an algorithm works on as its first input, or of any.
 * @throws insideout::Error also InvalidParameter if it is not a surface
 */
vtkSmartPointer<vtkPolyData> InputSurface(vtkAlgorithm* algorithm);
vtkSmartPointer<vtkPolyData> SurfaceOfBlock(
  vtkDataObject* block, const std::string& label = std::string());
///@}

/** The grid of an algorithm's first input, with common points of partitions merged. @throws
 * insideout::Error InvalidParameter if it is not a grid
 */
vtkSmartPointer<vtkUnstructuredGrid> InputGrid(vtkAlgorithm* algorithm);

/**
 * All blocks of a composite data set as one surface; other data are their only block.
 *
 * @throws insideout::Error that names the invalid block
 */
vtkSmartPointer<vtkPolyData> JoinSurfaces(vtkDataObject* blocks);

/**
 * Join blocks of any type to a grid; a data set that is not composite is returned unchanged. Null
 * without blocks.
 *
 * @param[in] array of points or cells that all blocks need if one has it; other arrays are kept if
 * all blocks have them
 * @throws insideout::Error InvalidParameter that names a block without the array
 */
vtkSmartPointer<vtkDataSet> JoinDataSets(vtkDataObject* blocks, const std::string& array);
} // namespace vtkInsideOut
