// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

/**
 * From now on TetGen leaves Steiner points on segments and facets, where it put them to recover
 * these. It has no switch for that: with Y0 it does not shift them into the volume, but still tries
 * to remove them by flips, and it is there that version 1.5.0 most often crashes.
 *
 * The function for it, tetgenmesh::removevertexbyflips, stands here once more: the dynamic linker
 * takes a program's functions before those of shared libraries. TetGen is told that a point cannot
 * be removed, which it copes with; unless it is to leave points its own function does the work.
 */
void LeaveSteinerPoints();
