// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/OutputFile.h"
#include "Files/SurfaceFile.h"

/** What the writers of the surface formats share; WriteSurface is the way in. */
namespace insideout
{
/** The writers. Offsets and corners of the surface fit each other, and attributes what they belong
 * to. @{ */
void WriteObj(OutputFile& file, const PolygonSurface& surface);
void WriteOff(OutputFile& file, const PolygonSurface& surface);
void WritePly(OutputFile& file, const PolygonSurface& surface);
void WriteStl(OutputFile& file, const PolygonSurface& surface);
/** @} */

/** @throws Error InvalidParameter where STL cannot hold the surface */
void CheckForStl(const PolygonSurface& surface);

/** How many numbers the attribute has. */
std::size_t LengthOf(const Attribute& attribute);

/** Whether it is what the formats have words for. @{ */
bool IsColor(const Attribute& attribute);
bool IsNormal(const Attribute& attribute);
bool IsTCoord(const Attribute& attribute);
/** @} */

/** The number of corners of a polygon. */
inline Id CornersOf(const PolygonSurface& surface, std::size_t polygon)
{
  return surface.Offsets[polygon + 1] - surface.Offsets[polygon];
}
} // namespace insideout
