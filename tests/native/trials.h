// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::testing {

// How many random meshes a test makes: a quarter of them under the address sanitizer, where each
// takes some fifteen times as long.
#if defined(__SANITIZE_ADDRESS__)
constexpr int trials(int count) { return (count + 3) / 4; }
#else
constexpr int trials(int count) { return count; }
#endif

}  // namespace hull::testing
