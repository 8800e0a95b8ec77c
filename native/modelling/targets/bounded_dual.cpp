// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/targets/bounded_dual.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace hull::modelling {
namespace {

// Of S's diagonal, added to it: rows that depend on one another.
constexpr double kRegularisation = 1e-13;
// Of what a row's own terms are: rounding.
constexpr double kRounding = 1e-12;
constexpr int kMostRoundsPerRow = 60;

// One-sided rows with multipliers in a box: ½ x'Ax + b'x is to be least.
struct BoxProblem {
  std::vector<int> row;  // of S
  Eigen::MatrixXd A;
  Eigen::VectorXd b, low, high;
};

BoxProblem box_problem(const Eigen::MatrixXd& S, const Eigen::VectorXd& start,
                       const DualBounds& bounds) {
  BoxProblem box;
  std::vector<double> b, low, high;
  const auto add = [&](Eigen::Index i, double wanted, double least, double most) {
    box.row.push_back(static_cast<int>(i));
    b.push_back(start[i] - wanted);
    low.push_back(least);
    high.push_back(most);
  };
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const double most = bounds.most[i];
    // A value is one row with a multiplier of either sign; each finite side of a range is a row of
    // its own, whose multiplier has one sign.
    if (bounds.low[i] == bounds.high[i]) {
      add(i, bounds.low[i], -most, most);
      continue;
    }
    if (std::isfinite(bounds.low[i])) add(i, bounds.low[i], 0.0, most);
    if (std::isfinite(bounds.high[i])) add(i, bounds.high[i], -most, 0.0);
  }
  const auto n = static_cast<Eigen::Index>(box.row.size());
  box.A.resize(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) box.A(i, j) = S(box.row[i], box.row[j]);
    box.A(i, i) *= 1.0 + kRegularisation;
  }
  box.b = Eigen::VectorXd::Map(b.data(), n);
  box.low = Eigen::VectorXd::Map(low.data(), n);
  box.high = Eigen::VectorXd::Map(high.data(), n);
  return box;
}

class BoxSolver {
 public:
  explicit BoxSolver(const BoxProblem& box)
      : box_(box), x_(Eigen::VectorXd::Zero(box.b.size())), free_(box.b.size(), 0) {
    for (Eigen::Index i = 0; i < x_.size(); ++i) x_[i] = std::clamp(0.0, box.low[i], box.high[i]);
  }

  const Eigen::VectorXd& solve() {
    const auto n = static_cast<int>(x_.size());
    // The function falls from round to round, so that no set of free rows comes twice; the most
    // rounds are for what rounding may do.
    for (int round = 0; round < kMostRoundsPerRow * (n + 1); ++round) {
      const int entering = worst();
      if (entering < 0) break;
      free_[entering] = 1;
      settle();
    }
    return x_;
  }

 private:
  // The row at a bound that would gain most by leaving it, or -1.
  int worst() const {
    const Eigen::VectorXd slope = box_.A * x_ + box_.b;
    int found = -1;
    double most = 0.0;
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      if (free_[i]) continue;
      const double terms =
          std::abs(box_.b[i]) + box_.A.row(i).cwiseAbs().dot(x_.cwiseAbs().transpose());
      double gain = 0.0;
      if (x_[i] < box_.high[i]) gain = std::max(gain, -slope[i]);
      if (x_[i] > box_.low[i]) gain = std::max(gain, slope[i]);
      if (gain <= kRounding * terms) continue;
      // Alone, the row would gain slope² / (2 A_ii): the root of that ranks rows whatever their
      // units.
      gain /= std::sqrt(std::max(box_.A(i, i), 1e-300));
      if (gain > most) {
        most = gain;
        found = static_cast<int>(i);
      }
    }
    return found;
  }

  // To the least over the free rows; those that come to a bound on the way stay there.
  void settle() {
    while (true) {
      std::vector<int> set;
      for (Eigen::Index i = 0; i < x_.size(); ++i) {
        if (free_[i]) set.push_back(static_cast<int>(i));
      }
      if (set.empty()) return;
      const auto n = static_cast<Eigen::Index>(set.size());
      Eigen::MatrixXd A(n, n);
      Eigen::VectorXd slope(n);
      // Rows at bounds have their say in the slope, but do not move.
      const Eigen::VectorXd all = box_.A * x_ + box_.b;
      for (Eigen::Index i = 0; i < n; ++i) {
        slope[i] = all[set[i]];
        for (Eigen::Index j = 0; j < n; ++j) A(i, j) = box_.A(set[i], set[j]);
      }
      const Eigen::VectorXd step = A.ldlt().solve(-slope);
      double share = 1.0;
      int stops = -1;
      for (Eigen::Index i = 0; i < n; ++i) {
        const int row = set[i];
        const double bound = step[i] > 0.0 ? box_.high[row] : box_.low[row];
        const double way = bound - x_[row];
        // As a product: an infinite bound, or one far beyond a tiny step, divides nothing.
        if (step[i] != 0.0 && std::abs(step[i]) * share > std::abs(way)) {
          share = way / step[i];
          stops = row;
        }
      }
      for (Eigen::Index i = 0; i < n; ++i) x_[set[i]] += share * step[i];
      if (stops < 0) return;
      const auto nearer =
          std::abs(x_[stops] - box_.low[stops]) < std::abs(x_[stops] - box_.high[stops]);
      // To the bit, so that the row is at its bound when others are weighed.
      x_[stops] = nearer ? box_.low[stops] : box_.high[stops];
      free_[stops] = 0;
    }
  }

  const BoxProblem& box_;
  Eigen::VectorXd x_;
  std::vector<char> free_;
};

}  // namespace

Eigen::VectorXd bounded_dual(const Eigen::MatrixXd& S, const Eigen::VectorXd& start,
                             const DualBounds& bounds) {
  const BoxProblem box = box_problem(S, start, bounds);
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(start.size());
  const Eigen::VectorXd x = BoxSolver(box).solve();
  for (std::size_t i = 0; i < box.row.size(); ++i) {
    multipliers[box.row[i]] += x[static_cast<Eigen::Index>(i)];
  }
  return multipliers;
}

}  // namespace hull::modelling
