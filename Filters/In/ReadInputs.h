// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Reads several surfaces, each a body: the inputs of a port, or their blocks. */
#pragma once

#include "Boolean/Body.h"
#include "Data/VtkClasses.h"
#include "In/ReadSurface.h"
#include "In/TagsOfBodies.h"

namespace vtkInsideOut
{
/** A surface before it is read as a body; an empty name is no name. */
struct NamedSurface
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Data;
};

/** The inputs of a port, in order; for a composite input its blocks, with their names. */
std::vector<NamedSurface> FindInputs(vtkInformationVector* inputs);

/** Bodies, with all their points and cells as those of one surface, body by body. */
struct Inputs
{
  /** Its Input has the point and cell data of all: an array missing in a body is NaN there, 0 in
   * integer arrays, and the body's name in tags. It has no geometry. */
  vtkInsideOut::Surface Surface;
  std::vector<SharedTags> Tags; ///< the cell arrays that tag, BoundaryTag the first

  std::vector<insideout::Body> Bodies;
  std::vector<insideout::Id> BodyOfTriangle;
  std::vector<vtkIdType> FirstPoint; ///< start per body, and the end
  std::vector<vtkIdType> FirstCell;  ///< start per body, and the end

  std::vector<std::string> Names() const;
};

/**
 * Read them. Unnamed bodies are named by letters from A on, or by their numbers from the 27th on. A
 * surface without polygons is a body without triangles.
 *
 * @throws insideout::Error that names the body, and the invalid cell or point
 */
Inputs ReadInputs(const std::vector<NamedSurface>& surfaces);
} // namespace vtkInsideOut
