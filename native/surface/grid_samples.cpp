// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/grid_samples.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "surface/pieces.h"
#include "surface/wide_code.h"

namespace hull {
namespace {

// Basis functions and their derivatives along one direction, at one parameter each.
struct Line {
  std::vector<Basis> value, d1, d2;

  void add(double t, int order) {
    value.push_back(cubic_basis(t));
    if (order > 0) d1.push_back(cubic_basis_d1(t));
    if (order > 1) d2.push_back(cubic_basis_d2(t));
  }
};

// Points padded to four numbers, so that sums over them are whole vector operations.
struct alignas(32) Padded {
  double lane[4];
};

inline Padded combine(const Basis& w, const Padded* p, int stride) {
  Padded sum;
  for (int k = 0; k < 4; ++k) {
    sum.lane[k] = w[0] * p[0].lane[k] + w[1] * p[stride].lane[k] + w[2] * p[2 * stride].lane[k] +
                  w[3] * p[3 * stride].lane[k];
  }
  return sum;
}

inline void store(const Padded& p, double factor, Vector3d& out) {
  out = Vector3d(p.lane[0] * factor, p.lane[1] * factor, p.lane[2] * factor);
}

// Where the samples of a piece go: the first one's index, and those along v.
struct Target {
  GridSamples* samples;
  std::size_t first, stride;  // index of sample (0, 0) of the block; between rows of equal i
};

// A block of samples of one bicubic span. First the sums along u, which all samples of a row share.
template <int kOrder>
HULL_WIDE void sample_block(const BicubicPoints& points, const Line& u, const Line& v, double scale,
                            const Target& target) {
  Padded padded[16];
  for (int k = 0; k < 16; ++k) {
    padded[k] = {{points[k].x(), points[k].y(), points[k].z(), 0.0}};
  }
  GridSamples& out = *target.samples;
  const std::size_t columns = v.value.size();
  for (std::size_t i = 0; i < u.value.size(); ++i) {
    Padded row[4], row_d1[4], row_d2[4];
    for (int b = 0; b < 4; ++b) {
      row[b] = combine(u.value[i], padded + 4 * b, 1);
      if constexpr (kOrder > 0) row_d1[b] = combine(u.d1[i], padded + 4 * b, 1);
      if constexpr (kOrder > 1) row_d2[b] = combine(u.d2[i], padded + 4 * b, 1);
    }
    const std::size_t begin = target.first + i * target.stride;
    for (std::size_t j = 0; j < columns; ++j) {
      store(combine(v.value[j], row, 1), 1.0, out.points[begin + j]);
      if constexpr (kOrder > 0) {
        store(combine(v.value[j], row_d1, 1), scale, out.du[begin + j]);
        store(combine(v.d1[j], row, 1), scale, out.dv[begin + j]);
      }
      if constexpr (kOrder > 1) {
        store(combine(v.value[j], row_d2, 1), scale * scale, out.duu[begin + j]);
        store(combine(v.d1[j], row_d1, 1), scale * scale, out.duv[begin + j]);
        store(combine(v.d2[j], row, 1), scale * scale, out.dvv[begin + j]);
      }
    }
  }
}

void sample_block(int order, const BicubicPoints& points, const Line& u, const Line& v,
                  double scale, const Target& target) {
  if (order == 0) return sample_block<0>(points, u, v, scale, target);
  if (order == 1) return sample_block<1>(points, u, v, scale, target);
  sample_block<2>(points, u, v, scale, target);
}

// The samples i with begin <= i/n <= begin + size, as parameters of the span over that interval.
struct Range {
  int first, last;
  Line line;

  Range(int n, double begin, double size, int order)
      : first(static_cast<int>(std::ceil(begin * n))),
        last(static_cast<int>(std::floor((begin + size) * n))) {
    for (int i = first; i <= last; ++i) {
      line.add((static_cast<double>(i) / n - begin) / size, order);
    }
  }
};

class GridEvaluator {
 public:
  GridEvaluator(const LimitSurface& surface, int nu, int nv, int order, GridSamples& samples)
      : surface_(surface),
        nu_(nu),
        nv_(nv),
        order_(order),
        samples_(samples),
        whole_u_(nu, 0.0, 1.0, order),
        whole_v_(nv, 0.0, 1.0, order) {}

  // Sample (0, 0) of the cell is to have index `first`.
  void sample(int cell, std::size_t first) {
    first_ = first;
    const SurfaceNode& root = surface_.layout().root(cell);
    if (root.kind == SurfaceNode::Kind::kLeaf) {
      sample_block(order_, surface_.leaf(root.index), whole_u_.line, whole_v_.line, 1.0,
                   target(0, 0));
      return;
    }
    const double finest = 1.0 / std::max(nu_, nv_);
    for_each_piece(
        surface_, cell,
        [&](const CornerSquare& square) {
          // The knot itself is the only sample in squares smaller than the grid's.
          if (square.size >= finest) return true;
          sample_knot(square);
          return false;
        },
        [&](const SurfacePiece& piece) { sample_piece(piece); });
  }

 private:
  Target target(int i, int j) const {
    const auto stride = static_cast<std::size_t>(nv_ + 1);
    return {&samples_, first_ + i * stride + j, stride};
  }

  void sample_piece(const SurfacePiece& piece) {
    const Range u(nu_, piece.u, piece.size, order_), v(nv_, piece.v, piece.size, order_);
    if (u.first > u.last || v.first > v.last) return;
    sample_block(order_, piece.points, u.line, v.line, 1.0 / piece.size, target(u.first, v.first));
  }

  // The irregular knot is a corner of the cell, and of the square that is left.
  void sample_knot(const CornerSquare& square) {
    const std::size_t knot = target(square.u > 0.0 ? nu_ : 0, square.v > 0.0 ? nv_ : 0).first;
    samples_.points[knot] = square.ring.limit();
    for (auto* derivative :
         {&samples_.du, &samples_.dv, &samples_.duu, &samples_.duv, &samples_.dvv}) {
      if (!derivative->empty()) (*derivative)[knot].setZero();
    }
  }

  const LimitSurface& surface_;
  int nu_, nv_, order_;
  GridSamples& samples_;
  std::size_t first_ = 0;
  Range whole_u_, whole_v_;
};

void make_room(GridSamples& samples, std::size_t count, int order) {
  samples.points.resize(count);
  for (auto* first : {&samples.du, &samples.dv}) first->resize(order > 0 ? count : 0);
  for (auto* second : {&samples.duu, &samples.duv, &samples.dvv}) {
    second->resize(order > 1 ? count : 0);
  }
}

}  // namespace

void evaluate_grid(const LimitSurface& surface, int n, int order, GridSamples& samples) {
  if (n < 1 || n > 256) {
    throw std::invalid_argument("Cells can be divided into 1 to 256 parts a side, not " +
                                std::to_string(n) + ".");
  }
  if (order < 0 || order > 2) {
    throw std::invalid_argument("Derivatives are to be had of order 0, 1 or 2, not " +
                                std::to_string(order) + ".");
  }
  samples.n = n;
  make_room(samples, samples.index(surface.cell_count(), 0, 0), order);
  GridEvaluator evaluator(surface, n, n, order, samples);
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    evaluator.sample(cell, samples.index(cell, 0, 0));
  }
}

void evaluate_cell_grid(const LimitSurface& surface, int cell, int nu, int nv, int order,
                        GridSamples& samples) {
  make_room(samples, (nu + std::size_t{1}) * (nv + std::size_t{1}), order);
  GridEvaluator(surface, nu, nv, order, samples).sample(cell, 0);
}

GridSamples evaluate_grid(const LimitSurface& surface, int n, int order) {
  GridSamples samples;
  evaluate_grid(surface, n, order, samples);
  return samples;
}

}  // namespace hull
