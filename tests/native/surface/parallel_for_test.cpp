// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace hull::surface {
namespace {

TEST(ParallelFor, DoesEveryIndexOnce) {
  for (std::size_t count : {0u, 1u, 7u, 100u, 12345u}) {
    for (int threads : {0, 1, 2, 9}) {
      std::vector<int> done(count, 0);
      parallel_for(
          count, threads,
          [&](std::size_t begin, std::size_t end) {
            ASSERT_LT(begin, end);
            ASSERT_LE(end, count);
            for (std::size_t i = begin; i < end; ++i) ++done[i];
          },
          3);
      EXPECT_EQ(done, std::vector<int>(count, 1)) << count << " on " << threads;
    }
  }
}

TEST(ParallelFor, ThrowsWhatWasThrown) {
  for (int threads : {1, 4}) {
    std::atomic<int> calls{0};
    EXPECT_THROW(parallel_for(
                     1000, threads,
                     [&](std::size_t, std::size_t) {
                       ++calls;
                       throw std::runtime_error("stopped");
                     },
                     1),
                 std::runtime_error);
    // No further range is begun: at most one a thread.
    EXPECT_LE(calls, threads);
  }
}

TEST(ParallelFor, LeavesLittleWorkToTheCaller) {
  int calls = 0;
  parallel_for(
      199, 8, [&](std::size_t, std::size_t) { ++calls; }, 100);
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace hull::surface
