// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <cstdint>
#include <map>
#include <string>

/** A hash of what a stage makes of a surface, bit by bit, by the stage's name. */
using Hashes = std::map<std::string, std::uint64_t>;

/** What every stage makes of a surface. */
Hashes HashStages(const insideout::TriangleSoup& soup);
