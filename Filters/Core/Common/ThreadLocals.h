// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/**
 * Thread-local variables of a library get memory when a thread first touches one, and the C library
 * ends the program where there is none. So they are touched early, when it can still be said.
 */
namespace insideout
{
/** For whoever calls the stages: all, CGAL's above all. @throws std::bad_alloc */
void AllocateThreadLocals();

/** For a thread of a team, which touches none of CGAL's. @return false without memory for them */
bool AllocateThreadLocalsOfTeam();
} // namespace insideout
