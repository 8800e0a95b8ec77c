// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/even_ranges.h"

#include <algorithm>

#include "surface/parallel_for.h"

namespace hull::modelling::fit_internal {
namespace {

constexpr std::size_t kRange = 512;

}  // namespace

void for_even_ranges(std::size_t count,
                     const std::function<void(std::size_t begin, std::size_t end)>& work) {
  surface::parallel_for((count + kRange - 1) / kRange, surface::kAllProcessors,
                        [&](std::size_t first, std::size_t last) {
                          for (std::size_t k = first; k < last; ++k) {
                            work(k * kRange, std::min((k + 1) * kRange, count));
                          }
                        },
                        1);
}

}  // namespace hull::modelling::fit_internal
