// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

/**
 * Make TetGen leave Steiner points on segments and facets where it inserted them to recover these.
 * It has no switch for that: with Y0 it does not move them into the volume, but still tries to
 * remove them by flips, where version 1.5.0 most often crashes.
 *
 * The function tetgenmesh::removevertexbyflips is redefined here: the dynamic linker prefers a
 * program's functions to those of shared libraries. It reports that a point cannot be removed,
 * which TetGen handles; unless points are to be left, it calls TetGen's own function.
 */
void LeaveSteinerPoints();
