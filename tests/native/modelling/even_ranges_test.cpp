// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/even_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <utility>

namespace hull::modelling::fit_internal {
namespace {

TEST(EvenRanges, AreThoseOfTheCountAlone) {
  for (std::size_t count : {0, 1, 511, 512, 513, 1024, 100000}) {
    std::set<std::pair<std::size_t, std::size_t>> ranges, wanted;
    std::mutex mutex;
    for_even_ranges(count, [&](std::size_t begin, std::size_t end) {
      const std::lock_guard lock(mutex);
      EXPECT_TRUE(ranges.emplace(begin, end).second);
    });
    for (std::size_t begin = 0; begin < count; begin += 512) {
      wanted.emplace(begin, std::min<std::size_t>(begin + 512, count));
    }
    EXPECT_EQ(ranges, wanted) << count;
  }
}

}  // namespace
}  // namespace hull::modelling::fit_internal
