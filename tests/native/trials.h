// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::testing {

// How many meshes a test makes, or up to which valence it goes: a quarter under
// sanitizers, where all takes some fifteen times as long.
#if defined(HULL_SANITIZED)
constexpr int trials(int count) { return (count + 3) / 4; }
#else
constexpr int trials(int count) { return count; }
#endif

}  // namespace hull::testing
