// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/grid_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numeric>
#include <stdexcept>
#include <string>

#include "surface/parallel_for.h"
#include "surface/pieces/pieces.h"
#include "surface/wide_code.h"

namespace hull::surface {
namespace {

// The samples of one direction that lie within a piece: first <= i <= last.
struct SampleRange {
  int first, last;

  // Products are exact, as sides of pieces are dyadic and n is small: a sample on the side between
  // two pieces is written by both, the later one in their order.
  SampleRange(int n, double begin, double size)
      : first(static_cast<int>(std::ceil(begin * n))),
        last(static_cast<int>(std::floor((begin + size) * n))) {}
};

// Basis functions of a span of the given size at `count` parameters t, t + step, …, and their
// derivatives with respect to the cell's parameter.
struct Line {
  double t, step, size;
  int count;
  std::array<std::vector<Basis>, 3> basis;  // by order of the derivative
  // The same for whole rows of points: number b of sample j three times, at (b count + j) 3.
  std::array<std::vector<double>, 3> spread;

  Line(double start, double interval, double length, int samples, int order)
      : t(start), step(interval), size(length), count(samples) {
    constexpr Basis (*kBases[])(double) = {cubic_basis, cubic_basis_d1, cubic_basis_d2};
    double factor = 1.0;
    // The chain rule, once for all samples.
    for (int d = 0; d <= order; ++d, factor /= size) {
      spread[d].resize(12 * static_cast<std::size_t>(count));
      for (int j = 0; j < count; ++j) {
        Basis at = kBases[d](t + j * step);
        for (int b = 0; b < 4; ++b) {
          at[b] *= factor;
          for (int k = 0; k < 3; ++k) spread[d][3 * (b * count + j) + k] = at[b];
        }
        basis[d].push_back(at);
      }
    }
  }
};

// Four points that are to be summed with the same weights for four samples of a row: each is
// repeated four times, so that numbers line up with those of the samples.
using Repeated = std::array<std::array<double, 12>, 4>;

inline void repeat_row(const Basis& w, const double* points, Repeated& row) {
  for (int b = 0; b < 4; ++b) {
    const double* p = points + 12 * b;
    for (int k = 0; k < 3; ++k) {
      const double sum = w[0] * p[k] + w[1] * p[3 + k] + w[2] * p[6 + k] + w[3] * p[9 + k];
      for (int copy = 0; copy < 4; ++copy) row[b][3 * copy + k] = sum;
    }
  }
}

// A row of samples, `n` numbers in all.
inline void fill_row(const double* __restrict__ w, const Repeated& row, int n,
                     double* __restrict__ out) {
  const double* __restrict__ r = row[0].data();
  int begin = 0;
  // Twelve numbers are four samples and whole vectors.
  for (; begin + 12 <= n; begin += 12) {
    for (int k = 0; k < 12; ++k) {
      const double* at = w + begin + k;
      out[begin + k] =
          (at[0] * r[k] + at[n] * r[12 + k]) + (at[2 * n] * r[24 + k] + at[3 * n] * r[36 + k]);
    }
  }
  for (int k = 0; begin + k < n; ++k) {
    const double* at = w + begin + k;
    out[begin + k] =
        (at[0] * r[k] + at[n] * r[12 + k]) + (at[2 * n] * r[24 + k] + at[3 * n] * r[36 + k]);
  }
}

// Where the samples of a piece go: the first one's index, and those along v.
struct Target {
  GridSamples* samples;
  std::size_t first, stride;  // index of sample (0, 0) of the block; between rows of equal i
};

// A block of samples of one bicubic span. First the sums along u, which all samples of a row share.
template <int kOrder>
HULL_WIDE void sample_block(const BicubicPoints& points, const Line& u, const Line& v,
                            const Target& target) {
  const double* numbers = points[0].data();
  GridSamples& out = *target.samples;
  const int n = 3 * v.count;
  Repeated row, row_d1, row_d2;
  for (int i = 0; i < u.count; ++i) {
    const std::size_t begin = target.first + i * target.stride;
    repeat_row(u.basis[0][i], numbers, row);
    fill_row(v.spread[0].data(), row, n, out.points[begin].data());
    if constexpr (kOrder > 0) {
      repeat_row(u.basis[1][i], numbers, row_d1);
      fill_row(v.spread[0].data(), row_d1, n, out.du[begin].data());
      fill_row(v.spread[1].data(), row, n, out.dv[begin].data());
    }
    if constexpr (kOrder > 1) {
      repeat_row(u.basis[2][i], numbers, row_d2);
      fill_row(v.spread[0].data(), row_d2, n, out.duu[begin].data());
      fill_row(v.spread[1].data(), row_d1, n, out.duv[begin].data());
      fill_row(v.spread[2].data(), row, n, out.dvv[begin].data());
    }
  }
}

class GridEvaluator {
 public:
  GridEvaluator(const LimitSurface& surface, int nu, int nv, int order, GridSamples& samples)
      : surface_(surface), nu_(nu), nv_(nv), order_(order), samples_(samples) {}

  // Sample (0, 0) of the cell is to have index `first`.
  void sample(int cell, std::size_t first) {
    first_ = first;
    const SurfaceNode& root = surface_.layout().root(cell);
    if (root.kind == SurfaceNode::Kind::kLeaf) {
      sample_piece({cell, 0.0, 0.0, 1.0, surface_.leaf(root.index)});
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

  // Few different ones are needed: pieces are of a few sizes, at a few distances from samples.
  const Line& line(int n, double begin, double size, const SampleRange& range) {
    const double t = (static_cast<double>(range.first) / n - begin) / size, step = 1.0 / (n * size);
    const int count = range.last - range.first + 1;
    for (const Line& known : lines_) {
      // To the last bit: where rounding differs there is one line more, no worse.
      if (known.count == count && known.t == t && known.step == step && known.size == size) {
        return known;
      }
    }
    return lines_.emplace_back(t, step, size, count, order_);
  }

  void sample_piece(const SurfacePiece& piece) {
    const SampleRange i(nu_, piece.u, piece.size), j(nv_, piece.v, piece.size);
    if (i.first > i.last || j.first > j.last) return;
    const Line& u = line(nu_, piece.u, piece.size, i);
    const Line& v = line(nv_, piece.v, piece.size, j);
    const Target to = target(i.first, j.first);
    if (order_ == 0) return sample_block<0>(piece.points, u, v, to);
    if (order_ == 1) return sample_block<1>(piece.points, u, v, to);
    sample_block<2>(piece.points, u, v, to);
  }

  // The irregular knot is a corner of the cell, and of the square that is left.
  void sample_knot(const CornerSquare& square) {
    // A square that does not begin at 0 ends at 1.
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
  std::deque<Line> lines_;
};

void make_room(GridSamples& samples, std::size_t count, int order) {
  samples.points.resize(count);
  for (auto* first : {&samples.du, &samples.dv}) first->resize(order > 0 ? count : 0);
  for (auto* second : {&samples.duu, &samples.duv, &samples.dvv}) {
    second->resize(order > 1 ? count : 0);
  }
}

}  // namespace

void evaluate_grid(const LimitSurface& surface, int n, int order, GridSamples& samples,
                   int threads) {
  std::vector<int> cells(surface.cell_count());
  std::iota(cells.begin(), cells.end(), 0);
  evaluate_cells(surface, cells, n, order, samples, threads);
}

void evaluate_cells(const LimitSurface& surface, const std::vector<int>& cells, int n, int order,
                    GridSamples& samples, int threads) {
  if (n < 1 || n > 256) {
    throw std::invalid_argument("Cells can be divided into 1 to 256 parts a side, not " +
                                std::to_string(n) + ".");
  }
  if (order < 0 || order > 2) {
    throw std::invalid_argument("Derivatives are to be had of order 0, 1 or 2, not " +
                                std::to_string(order) + ".");
  }
  samples.n = n;
  make_room(samples, samples.index(static_cast<int>(cells.size()), 0, 0), order);
  const auto work = [&](std::size_t begin, std::size_t end) {
    // One for each range, whose lines are its own: threads share nothing that they write.
    GridEvaluator evaluator(surface, n, n, order, samples);
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      evaluator.sample(cells[k], samples.index(k, 0, 0));
    }
  };
  constexpr std::size_t kSamplesPerRange = 16384;
  parallel_for(cells.size(), threads, work, kSamplesPerRange / ((n + 1) * (n + 1)) + 1);
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

}  // namespace hull::surface
