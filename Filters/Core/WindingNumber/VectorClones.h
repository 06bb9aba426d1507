// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/**
 * INSIDEOUT_VECTOR_CLONES: compile a function for the wider vectors of newer processors too. All
 * versions give the same bits, provided that its file never contracts multiplications and additions
 * (CMakeLists.txt).
 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
  !defined(__SANITIZE_ADDRESS__)
#define INSIDEOUT_VECTOR_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define INSIDEOUT_VECTOR_CLONES
#endif

/** Functions that such a function calls must be inlined, to be compiled for the same processor. */
#if defined(__GNUC__)
#define INSIDEOUT_ALWAYS_INLINE __attribute__((always_inline)) inline
#else
#define INSIDEOUT_ALWAYS_INLINE inline
#endif
