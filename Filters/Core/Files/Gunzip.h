// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

namespace insideout
{
/** Whether a file begins as those that gzip has compressed do. */
bool IsGzip(const FileContent& file);

/**
 * The content of such a file, of all of its members. It is decompressed twice: first to see
 * that it is whole and how long it is, and only then into memory.
 * @param most as many bytes may be in it
 * @throws Error FileMalformed, TooLarge, Stopped
 */
FileContent Gunzip(const FileContent& file, double most, Monitor& monitor);
} // namespace insideout
