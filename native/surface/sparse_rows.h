// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull {

// Weights of new points in old ones, most of them zero: rows of a sparse matrix.
class SparseRows {
 public:
  int count() const { return static_cast<int>(begin_.size()) - 1; }

  // Appends a row; returns its number, or that of an equal row appended before.
  template <class Row>
  int add(const Row& weights) {
    std::vector<int> index;
    std::vector<double> weight;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      if (weights[i] == 0.0) continue;
      index.push_back(static_cast<int>(i));
      weight.push_back(weights[i]);
    }
    return add_entries(index, weight);
  }

  // Calls put(row, value) for every row: value = sum of weights times old points.
  template <class Points, class Put>
  void multiply(const Points& points, const Put& put) const {
    for (int row = 0; row < count(); ++row) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int k = begin_[row]; k < begin_[row + 1]; ++k) sum += weight_[k] * points[index_[k]];
      put(row, sum);
    }
  }

 private:
  int add_entries(const std::vector<int>& index, const std::vector<double>& weight);

  std::vector<int> begin_{0};
  std::vector<int> index_;
  std::vector<double> weight_;
};

}  // namespace hull
