// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace hull::modelling::fit_internal {

// As surface::parallel_for() with all processors, but by ranges that `count` alone tells, whatever
// the number of processors: where an index's result may depend on those before it in its range it
// is the same on all machines.
void for_even_ranges(std::size_t count,
                     const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace hull::modelling::fit_internal
