// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/sparse_rows.h"

#include <algorithm>

#include "surface/wide_code.h"

namespace hull::surface {
namespace {

// A row of numbers each.
HULL_WIDE void add_rows_back(const int* begin, const int* index, const double* weight, int rows,
                             const double* __restrict by_new, std::ptrdiff_t columns,
                             double* __restrict by_old) {
  for (int row = 0; row < rows; ++row, by_new += columns) {
    for (int k = begin[row]; k < begin[row + 1]; ++k) {
      double* __restrict to = by_old + index[k] * columns;
      for (std::ptrdiff_t c = 0; c < columns; ++c) to[c] += weight[k] * by_new[c];
    }
  }
}

}  // namespace

void SparseRows::multiply(const Eigen::Vector3d* old_points, Eigen::Vector3d* new_points) const {
  for (int row = 0; row < count(); ++row) {
    double x = 0.0, y = 0.0, z = 0.0;
    for (int k = begin_[row]; k < begin_[row + 1]; ++k) {
      const Eigen::Vector3d& p = old_points[index_[k]];
      x += weight_[k] * p.x();
      y += weight_[k] * p.y();
      z += weight_[k] * p.z();
    }
    new_points[row] = {x, y, z};
  }
}

void SparseRows::add_back(const double* by_new, int columns, double* by_old) const {
  add_rows_back(begin_.data(), index_.data(), weight_.data(), count(), by_new, columns, by_old);
}

int SparseRows::add_entries(const std::vector<int>& index, const std::vector<double>& weight) {
  // To the last bit, as the same point comes by the same sums from whichever segment asks for it.
  // One by one: rows are some tens, and looked for once a basis.
  for (int row = 0; row < count(); ++row) {
    const int begin = begin_[row], end = begin_[row + 1];
    if (std::equal(index_.begin() + begin, index_.begin() + end, index.begin(), index.end()) &&
        std::equal(weight_.begin() + begin, weight_.begin() + end, weight.begin(), weight.end())) {
      return row;
    }
  }
  index_.insert(index_.end(), index.begin(), index.end());
  weight_.insert(weight_.end(), weight.begin(), weight.end());
  begin_.push_back(static_cast<int>(index_.size()));
  return count() - 1;
}

}  // namespace hull::surface
