// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"

namespace hull::surface {

// The surface on the grid (u, v) = (i/n, j/n) of every cell. Sample (i, j) of cell c has index
// (c (n + 1) + i) (n + 1) + j. Derivatives are with respect to the cell's (u, v), and zero at
// irregular knots, where they do not exist; what was not asked for is empty.
struct GridSamples {
  int n = 0;
  std::vector<Vector3d> points;
  std::vector<Vector3d> du, dv;         // order >= 1
  std::vector<Vector3d> duu, duv, dvv;  // order 2

  std::size_t index(int cell, int i, int j) const {
    return (static_cast<std::size_t>(cell) * (n + 1) + i) * (n + 1) + j;
  }
};

// Throws std::invalid_argument unless 1 <= n <= 256 and order is 0, 1 or 2.
GridSamples evaluate_grid(const LimitSurface& surface, int n, int order);

// The same into samples whose memory is used again, on up to `threads` threads (0: one for each
// processor). The number of threads does not change the results.
void evaluate_grid(const LimitSurface& surface, int n, int order, GridSamples& samples,
                   int threads = 1);

// The same of some cells only: sample (i, j) of cells[k] has index samples.index(k, i, j).
void evaluate_cells(const LimitSurface& surface, const std::vector<int>& cells, int n, int order,
                    GridSamples& samples, int threads = 1);

// One cell on the grid (i/nu, j/nv): sample (i, j) has index i (nv + 1) + j, and samples.n no
// meaning. REQUIRES: nu, nv >= 1, order 0, 1 or 2.
void evaluate_cell_grid(const LimitSurface& surface, int cell, int nu, int nv, int order,
                        GridSamples& samples);

}  // namespace hull::surface
