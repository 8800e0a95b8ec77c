// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions marked HULL_WIDE are compiled twice, for any x86-64 and for AVX2, and the loader picks
// what the machine has. Results are the same: no multiplications and additions are fused.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(HULL_SANITIZED)
#define HULL_WIDE __attribute__((target_clones("default", "avx2")))
#else
#define HULL_WIDE
#endif
