// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/sheet_splines.h"

#include <algorithm>
#include <cmath>

#include "mesh/dense_solvers.h"

namespace hull::production {

using Eigen::Vector2i;

namespace {

constexpr int kMostCells = 120;  // along either side, before they are halved

struct CubicValues {
  std::array<double, 4> value, slope;
};

// The four uniform cubic B-splines that are not zero in an interval.
CubicValues cubic_values(double t) {
  const double s = 1.0 - t;
  return {{s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
           (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, t * t * t / 6.0},
          {-0.5 * s * s, 1.5 * t * t - 2.0 * t, -1.5 * s * s + 2.0 * s, 0.5 * t * t}};
}

}  // namespace

SheetSplines::SheetSplines(const Eigen::AlignedBox2d& box, int across) {
  const Vector2d sizes = box.sizes();
  // Slender plates: the longer side decides, as cells over it would be too many.
  const double cell = std::max(sizes.minCoeff() / across, sizes.maxCoeff() / kMostCells);
  for (int k = 0; k < 2; ++k) {
    cells_[k] = std::max(2, static_cast<int>(std::ceil(sizes[k] / cell)));
    step_[k] = sizes[k] / cells_[k];
  }
  origin_ = box.min();
  // Three functions more than cells along either side.
  numbers_.assign((cells_.x() + 3) * (cells_.y() + 3), -1);
}

SheetSplines SheetSplines::halved() const {
  // Over the same box: so each function of this grid is a sum of the finer one's.
  SheetSplines finer;
  finer.origin_ = origin_;
  finer.step_ = 0.5 * step_;
  finer.cells_ = 2 * cells_;
  finer.numbers_.assign((finer.cells_.x() + 3) * (finer.cells_.y() + 3), -1);
  return finer;
}

SheetSplines::Where SheetSplines::where(const Vector2d& point) const {
  Where w;
  for (int k = 0; k < 2; ++k) {
    const double at = (point[k] - origin_[k]) / step_[k];
    // Beyond the box, too, the polynomials of the last cell go on.
    w.cell[k] = std::clamp(static_cast<int>(std::floor(at)), 0, cells_[k] - 1);
    w.within[k] = at - w.cell[k];
  }
  return w;
}

int SheetSplines::number(int i, int j) const {
  if (i < 0 || j < 0 || i >= cells_.x() + 3 || j >= cells_.y() + 3) return -1;
  return numbers_[index(i, j)];
}

void SheetSplines::use(const Vector2d& point) {
  for (const Vector2d& aside : {Vector2d(-1.0, -1.0), {1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}}) {
    const Vector2i cell = where(point + kAround * aside.cwiseProduct(step_)).cell;
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) {
        int& number = numbers_[index(cell.x() + i, cell.y() + j)];
        if (number >= 0) continue;
        // In the order of use: a function at no point is no unknown.
        number = count();
        used_.emplace_back(cell.x() + i, cell.y() + j);
      }
    }
  }
}

SheetSplines::Values SheetSplines::at(const Vector2d& point) const {
  const Where w = where(point);
  const CubicValues u = cubic_values(w.within.x()), v = cubic_values(w.within.y());
  Values values;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const int k = 4 * j + i;
      values.functions[k] = numbers_[index(w.cell.x() + i, w.cell.y() + j)];
      values.values[k] = u.value[i] * v.value[j];
      values.slopes(k, 0) = u.slope[i] * v.value[j] / step_.x();
      values.slopes(k, 1) = u.value[i] * v.slope[j] / step_.y();
    }
  }
  return values;
}

std::vector<Vector2d> SheetSplines::identity() const {
  std::vector<Vector2d> coefficients;
  for (const Vector2i& f : used_) {
    // A function's middle: so B-splines have linear functions (Greville's abscissas).
    coefficients.push_back(origin_ + (f.cast<double>() - Vector2d::Ones()).cwiseProduct(step_));
  }
  return coefficients;
}

std::vector<Vector2d> SheetSplines::refined(const SheetSplines& finer,
                                            const std::vector<Vector2d>& coefficients) const {
  Eigen::MatrixX3d places(count(), 3);
  Eigen::MatrixX2d values(count(), 2);
  for (int k = 0; k < count(); ++k) {
    places.row(k) << 1.0, used_[k].x(), used_[k].y();
    values.row(k) = coefficients[k].transpose();
  }
  const Eigen::Matrix<double, 3, 2> affine = mesh::least_norm_solutions(places, values);
  const auto coefficient = [&](int i, int j) -> Vector2d {
    const int n = number(i, j);
    if (n >= 0) return coefficients[n];
    return (Eigen::RowVector3d(1.0, i, j) * affine).transpose();
  };
  // Function i of the finer grid is centred at (i - 1) / 2 of this one's cells: with odd i on
  // function (i + 1) / 2 of this one (two-scale relation of cubic B-splines).
  const auto parents = [](int i) {
    std::vector<std::pair<int, double>> list;
    if (i % 2 != 0) {
      const int k = (i + 1) / 2;
      list = {{k - 1, 0.125}, {k, 0.75}, {k + 1, 0.125}};
    } else {
      list = {{i / 2, 0.5}, {i / 2 + 1, 0.5}};
    }
    return list;
  };
  std::vector<Vector2d> result;
  for (const Vector2i& f : finer.used_) {
    Vector2d sum = Vector2d::Zero();
    for (const auto& [i, wi] : parents(f.x())) {
      for (const auto& [j, wj] : parents(f.y())) sum += wi * wj * coefficient(i, j);
    }
    result.push_back(sum);
  }
  return result;
}

std::vector<std::array<int, 4>> SheetSplines::runs() const {
  std::vector<std::array<int, 4>> runs;
  for (const Vector2i& f : used_) {
    for (const Vector2i& way : {Vector2i(1, 0), Vector2i(0, 1)}) {
      std::array<int, 4> run{};
      for (int k = 0; k < 4; ++k) run[k] = number(f.x() + k * way.x(), f.y() + k * way.y());
      if (*std::min_element(run.begin(), run.end()) >= 0) runs.push_back(run);
    }
  }
  return runs;
}

}  // namespace hull::production
