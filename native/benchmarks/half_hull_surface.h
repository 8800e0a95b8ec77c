// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include "benchmarks/half_hull.h"
#include "surface/limit_surface.h"

namespace hull::benchmarks {

// Of half_hull(), the benchmark's arguments being how fine it is and how many faces are halved; its
// points are counted. Refined once it has 140, three times 1120.
inline surface::LimitSurface half_hull_surface(benchmark::State& state) {
  const auto refine = static_cast<int>(state.range(0)), every = static_cast<int>(state.range(1));
  surface::LimitSurface surface{mesh::ControlMesh(half_hull(refine, every))};
  state.counters["points"] = static_cast<double>(surface.mesh().points().size());
  return surface;
}

}  // namespace hull::benchmarks
