// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace hull::production {

// A side of triangles as they run through it, in one number.
inline std::uint64_t directed_key(int from, int to) {
  return static_cast<std::uint64_t>(from) << 32 | static_cast<unsigned>(to);
}

}  // namespace hull::production
