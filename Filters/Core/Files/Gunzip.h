// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

namespace insideout
{
/** Whether a file begins like one compressed by gzip. */
bool IsGzip(const FileContent& file);

/**
 * The content of such a file, of all its members. It is decompressed twice: first to check it and
 * find its length, then into memory.
 * @param most limit of its bytes
 * @throws Error FileMalformed, TooLarge, Stopped
 */
FileContent Gunzip(const FileContent& file, double most, Monitor& monitor);
} // namespace insideout
