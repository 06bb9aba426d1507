// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

namespace insideout
{
/** Whether the file begins with text only. */
bool LooksLikeText(const FileContent& file);

/** Whether the first word is `solid`, or `facet`, comments aside. */
bool BeginsAsStlText(const FileContent& file, Monitor& monitor);

/**
 * Read ascii STL. Harmless deviations from the format are accepted with a warning: comments, text
 * outside of solids and after `endloop` and `endfacet`, `end solid` and the like, facets without
 * `solid`, solids without `endsolid`. Line ends matter only as the end of a name.
 */
PolygonSurface ReadStlText(const FileContent& file, Monitor& monitor);
} // namespace insideout
