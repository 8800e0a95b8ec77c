// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::surface {

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

  // new_points[row] = sum of the row's weights times old points.
  void multiply(const Eigen::Vector3d* old_points, Eigen::Vector3d* new_points) const;
  // The other way: adds to what is known by the old points what is known by the new ones. `columns`
  // numbers a point, point after point.
  void add_back(const double* by_new, int columns, double* by_old) const;

 private:
  int add_entries(const std::vector<int>& index, const std::vector<double>& weight);

  std::vector<int> begin_{0};
  std::vector<int> index_;
  std::vector<double> weight_;
};

}  // namespace hull::surface
