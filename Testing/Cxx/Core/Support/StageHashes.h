// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <cstdint>
#include <map>
#include <string>

/** Hashes by what they are of, bit by bit. Times and memory are left out. */
using Hashes = std::map<std::string, std::uint64_t>;

/** What every stage makes of a surface with default parameters, without TetGen. */
Hashes HashStages(const insideout::TriangleSoup& soup);
