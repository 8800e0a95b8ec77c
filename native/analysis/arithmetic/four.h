// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

#include "surface/wide_code.h"

namespace hull::analysis {

// Four doubles that are added and multiplied at once, by whatever instructions there are: within
// functions that are HULL_WIDE.
using Four = double __attribute__((vector_size(32)));

inline void load(Four& four, const double* from) { std::memcpy(&four, from, sizeof(Four)); }

inline void store(const Four& four, double* to) { std::memcpy(to, &four, sizeof(Four)); }

inline double total(const Four& four) { return (four[0] + four[1]) + (four[2] + four[3]); }

}  // namespace hull::analysis
