// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/**
 * Thread-local variables of a library get memory when a thread first touches one, and the C library
 * ends the program if there is none. So they are touched early, when the error can still be
 * reported.
 */
namespace insideout
{
/** For callers of stages: all variables, above all CGAL's. @throws std::bad_alloc */
void AllocateThreadLocals();

/** For a thread of a team, which touches none of CGAL's. @return false without memory for them */
bool AllocateThreadLocalsOfTeam();
} // namespace insideout
