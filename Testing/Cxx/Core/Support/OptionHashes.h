// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Support/StageHashes.h"

/**
 * What options make of a surface: repair, thickening, parts apart, seeds, topology, outputs and
 * refinement; the surface as one of several bodies; its edges as a curve in a plane. Where a stage
 * throws, the hash of its message stands for the rest of the group.
 */
Hashes HashOptions(const insideout::TriangleSoup& soup);

/** The hull by TetGen. Not for surfaces on which it crashes or loops: how differs by build. */
Hashes HashTetGen(const insideout::TriangleSoup& soup);
