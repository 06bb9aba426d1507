// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Several data sets as one: the partitions of a partitioned data set, which are one surface or one
 * grid, and the blocks of a second input: a surface to probe, seeds, a background or a solid.
 *
 * Points and cells are numbered one data set after the other; of surfaces first the vertices of
 * all, then the lines, the polygons and the strips, as vtkPolyData numbers cells. There are the
 * arrays that all have, the field data of the first, and no ghost cells.
 */
#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkAlgorithm;
class vtkDataObject;
class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace vtkInsideOut
{
/**
 * The surface of a block: itself, or its partitions.
 *
 * @param[in] label what messages begin with
 * @return null where it, or a partition, is none
 * @throws insideout::Error that names the partition, and the cell or point at fault, for to join
 * surfaces hides that one refers to points that it does not have
 */
vtkSmartPointer<vtkPolyData> JoinPartitions(
  vtkDataObject* block, const std::string& label = std::string());

///@{
/** The same of the block that an algorithm works on as its first input, or of any.
 * @throws insideout::Error InvalidParameter where it is no surface, too */
vtkSmartPointer<vtkPolyData> InputSurface(vtkAlgorithm* algorithm);
vtkSmartPointer<vtkPolyData> SurfaceOfBlock(
  vtkDataObject* block, const std::string& label = std::string());
///@}

/** The grid that an algorithm's first input is; partitions share the points that they have in
 * common. @throws insideout::Error InvalidParameter where it is no grid */
vtkSmartPointer<vtkUnstructuredGrid> InputGrid(vtkAlgorithm* algorithm);

/**
 * All blocks of a composite data set as one surface; what is not composite is the only one.
 *
 * @throws insideout::Error that names the block at fault
 */
vtkSmartPointer<vtkPolyData> JoinSurfaces(vtkDataObject* blocks);

/**
 * Join data sets of any type into a grid; one that is no block is returned as it is. Null if there
 * is none.
 *
 * @param[in] array of points or cells that all blocks need if one has it; others stay if all have
 * them
 * @throws insideout::Error InvalidParameter that names a block without the array
 */
vtkSmartPointer<vtkDataSet> JoinDataSets(vtkDataObject* blocks, const std::string& array);
} // namespace vtkInsideOut
