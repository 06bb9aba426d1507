// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidFile.h"
#include "Files/SurfaceReaders.h"

namespace insideout
{
/** The readers of the solvers' formats, with ReadSolid's errors; call them through ReadSolid. Each
 * file has at least one byte. @{
 */
SolidContent ReadMsh(const FileContent& file, Monitor& monitor);
SolidContent ReadInp(const FileContent& file, Monitor& monitor);
SolidContent ReadMedit(const FileContent& file, Monitor& monitor);
/** @} */
} // namespace insideout
