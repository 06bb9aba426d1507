// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

namespace insideout
{
/** Whether nothing but text is at the beginning of the file. */
bool LooksLikeText(const FileContent& file);

/** Whether the first word is `solid`, or `facet`, comments aside. */
bool BeginsAsStlText(const FileContent& file, Monitor& monitor);

/**
 * Read ascii STL. Text that the format does not have, but can be understood, is read with a
 * warning: comments, text outside of solids and behind `endloop` and `endfacet`, `end solid` and
 * the like, facets without `solid`, solids without `endsolid`. Line ends mean nothing but the end
 * of a name.
 */
PolygonSurface ReadStlText(const FileContent& file, Monitor& monitor);
} // namespace insideout
