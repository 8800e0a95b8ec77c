// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace hull::surface {

// As a number of threads: one for each processor.
inline constexpr int kAllProcessors = 0;

// Calls work(begin, end) for ranges that together are [0, count), on up to `threads` threads, the
// caller's among them. Which thread does which range is left to
// chance, so results are the same from run to run only if an index's results depend on the index
// alone. Returns when all is done; throws what `work` has thrown first.
//
// Starting threads costs some 20 microseconds: less than two times `grain` indices are done by the
// caller alone.
void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& work,
                  std::size_t grain = 2048);

}  // namespace hull::surface
