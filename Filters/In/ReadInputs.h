// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Reads several surfaces, each of which means a body: inputs of a port, or blocks of these.
 */
#pragma once

#include "Boolean/Body.h"
#include "In/ReadSurface.h"
#include "In/TagsOfBodies.h"

class vtkInformationVector;

namespace vtkInsideOut
{
/** A surface on its way to a body; an empty name is none. */
struct NamedSurface
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Data;
};

/** The inputs of a port, in order; of one that is composite its blocks, with their names. */
std::vector<NamedSurface> FindInputs(vtkInformationVector* inputs);

/** Bodies, and all their points and cells as those of one surface, one body after the other. */
struct Inputs
{
  /** Its Input has the point and cell data of all: an array that a body has not is NaN there, 0 in
   * integer arrays, and of tags the body's name. Only the data are there, no geometry. */
  vtkInsideOut::Surface Surface;
  std::vector<SharedTags> Tags; ///< the cell arrays that tag, BoundaryTag the first

  std::vector<insideout::Body> Bodies;
  std::vector<insideout::Id> BodyOfTriangle;
  std::vector<vtkIdType> FirstPoint; ///< of each body, and the end
  std::vector<vtkIdType> FirstCell;  ///< of each body, and the end

  std::vector<std::string> Names() const;
};

/**
 * Read them. A body without a name is called by a letter, A the first, or by its number from the
 * 27th on. A surface without polygons is a body without triangles.
 *
 * @throws insideout::Error that names the body, and the cell or point at fault
 */
Inputs ReadInputs(const std::vector<NamedSurface>& surfaces);
} // namespace vtkInsideOut
