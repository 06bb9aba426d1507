// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/OutputFile.h"
#include "Files/SurfaceFile.h"

/** Shared by the writers of the surface formats; call them through WriteSurface. */
namespace insideout
{
/** The writers. Offsets, corners and attributes of the surface are consistent. @{ */
void WriteObj(OutputFile& file, const PolygonSurface& surface);
void WriteOff(OutputFile& file, const PolygonSurface& surface);
void WritePly(OutputFile& file, const PolygonSurface& surface);
void WriteStl(OutputFile& file, const PolygonSurface& surface);
/** @} */

/** @throws Error InvalidParameter if STL cannot hold the surface */
void CheckForStl(const PolygonSurface& surface);

/** The number of values of the attribute. */
std::size_t LengthOf(const Attribute& attribute);

/** Whether it is an attribute that the formats have words for. @{ */
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
