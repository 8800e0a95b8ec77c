// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/tridiagonal.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>
#include <vector>

namespace hull::analysis {
namespace {

TEST(Tridiagonal, SolvesAsADenseMatrixDoes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (const int n : {3, 4, 9, 40}) {
    Tridiagonal rows;
    std::vector<Vector3d> right;
    Eigen::MatrixXd open = Eigen::MatrixXd::Zero(n, n), cyclic = open;
    for (int i = 0; i < n; ++i) {
      rows.below.push_back(number(random));
      rows.above.push_back(number(random));
      rows.diagonal.push_back(2.5 + number(random));
      right.emplace_back(number(random), number(random), number(random));
      cyclic(i, (i + n - 1) % n) += rows.below[i];
      cyclic(i, i) += rows.diagonal[i];
      cyclic(i, (i + 1) % n) += rows.above[i];
    }
    open = cyclic;
    open(0, n - 1) -= rows.below[0];
    open(n - 1, 0) -= rows.above[n - 1];
    const std::vector<Vector3d> x = rows.solve(right), y = rows.solve_cyclic(right);
    for (int i = 0; i < n; ++i) {
      Vector3d left = Vector3d::Zero(), around = left;
      for (int j = 0; j < n; ++j) {
        left += open(i, j) * x[j];
        around += cyclic(i, j) * y[j];
      }
      EXPECT_LT((left - right[i]).norm(), 1e-14);
      EXPECT_LT((around - right[i]).norm(), 1e-13);
    }
  }
}

}  // namespace
}  // namespace hull::analysis
