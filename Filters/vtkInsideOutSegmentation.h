// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutSegmentation
 * @brief   What the filters that segment read from VTK's data: seeds, and which facets to keep.
 */
#ifndef vtkInsideOutSegmentation_h
#define vtkInsideOutSegmentation_h

#include "Common/FacetComplex.h"
#include "GraphCut/Seeds.h"

#include <vtkType.h>

#include <string>
#include <vector>

class vtkPointSet;
class vtkPolyData;

/**
 * The points as seeds, by their array Inside: 0 is outside, everything else inside. None if there
 * is no data set.
 *
 * @throws insideout::Error when there are points, but no such array
 */
std::vector<insideout::Seed> vtkInsideOutReadSeeds(vtkPointSet* points);

/**
 * For each facet 1 where it is a piece of an input cell whose value in a cell array is not 0, else
 * 0; empty where the array's name is.
 *
 * @param[in] cellOfTriangle the input cell that each source of a facet is a part of
 * @throws insideout::Error when the input has no such array
 */
std::vector<unsigned char> vtkInsideOutChosenFacets(vtkPolyData* input, const std::string& name,
  const insideout::FacetComplex& surface, const std::vector<vtkIdType>& cellOfTriangle);

#endif
