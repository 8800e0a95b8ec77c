// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/square_forms.h"

#include <algorithm>

namespace hull::surface {

SquareForms::SquareForms(const LimitSurface& surface) : squares_(surface) {
  find_groups();
  find_pattern();
}

void SquareForms::find_groups() {
  const WeightRows& weights = squares_.weights();
  const int *begin = weights.outerIndexPtr(), *column = weights.innerIndexPtr();
  // By control point: its place within the group at hand, cleared after each group rather than as a
  // whole, which would take a time of all points for each cell.
  std::vector<int> place(weights.cols(), -1);
  for (int square = 0; square < squares_.count();) {
    const int first = square, first_point = static_cast<int>(group_points_.size());
    for (; square < squares_.count() && squares_.cell(square) == squares_.cell(first); ++square) {
      for (int point : squares_.points(square)) {
        for (int k = begin[point]; k < begin[point + 1]; ++k) {
          if (place[column[k]] >= 0) continue;
          place[column[k]] = 0;
          group_points_.push_back(column[k]);
        }
      }
    }
    // Rising, as rows of a column of the sum are: add_group() leans on it.
    std::sort(group_points_.begin() + first_point, group_points_.end());
    const int count = static_cast<int>(group_points_.size()) - first_point;
    for (int i = 0; i < count; ++i) place[group_points_[first_point + i]] = i;
    for (int own = first; own < square; ++own) {
      first_place_.push_back(static_cast<int>(places_.size()));
      for (int point : squares_.points(own)) {
        for (int k = begin[point]; k < begin[point + 1]; ++k) places_.push_back(place[column[k]]);
      }
    }
    for (int i = 0; i < count; ++i) place[group_points_[first_point + i]] = -1;
    groups_.push_back({first, square - first, first_point, count});
  }
}

void SquareForms::find_pattern() {
  const Eigen::Index size = squares_.weights().cols();
  std::vector<std::vector<int>> groups_of(size);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (int i = 0; i < groups_[g].point_count; ++i) {
      groups_of[group_points_[groups_[g].first_point + i]].push_back(static_cast<int>(g));
    }
  }
  // Column by column all points of all groups that hold the column's own; seen_by keeps each from
  // being taken twice without clearing.
  std::vector<int> begins{0}, rows, seen_by(size, -1);
  for (Eigen::Index column = 0; column < size; ++column) {
    for (int g : groups_of[column]) {
      for (int i = 0; i < groups_[g].point_count; ++i) {
        const int point = group_points_[groups_[g].first_point + i];
        if (seen_by[point] == column) continue;
        seen_by[point] = static_cast<int>(column);
        rows.push_back(point);
      }
    }
    std::sort(rows.begin() + begins.back(), rows.end());
    begins.push_back(static_cast<int>(rows.size()));
  }
  const std::vector<double> zeros(rows.size(), 0.0);
  // Explicit zeros: groups are added into places that are there.
  pattern_ = Eigen::Map<const Matrix>(size, size, static_cast<Eigen::Index>(rows.size()),
                                      begins.data(), rows.data(), zeros.data());
}

void SquareForms::add_square(int square, const Eigen::MatrixXd& form,
                             Eigen::MatrixXd& of_group) const {
  const WeightRows& weights = squares_.weights();
  const std::span<const int> points = squares_.points(square);
  // form · Q, then its rows as columns; the forms are symmetric.
  Eigen::MatrixXd half = Eigen::MatrixXd::Zero(form.rows(), of_group.cols());
  const auto each_weight = [&](const auto& visit) {
    const int* place = places_.data() + first_place_[square];
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (WeightRows::InnerIterator w(weights, points[i]); w; ++w) {
        visit(static_cast<Eigen::Index>(i), *place++, w.value());
      }
    }
  };
  each_weight(
      [&](Eigen::Index i, int place, double weight) { half.col(place) += weight * form.col(i); });
  const Eigen::MatrixXd across = half.transpose();
  each_weight([&](Eigen::Index i, int place, double weight) {
    of_group.col(place) += weight * across.col(i);
  });
}

void SquareForms::add_group(const Group& group, const Eigen::MatrixXd& form, Matrix& sum) const {
  const int* points = group_points_.data() + group.first_point;
  for (int j = 0; j < group.point_count; ++j) {
    // Both rise, and the column has all of the group's points.
    int slot = sum.outerIndexPtr()[points[j]];
    for (int i = 0; i < group.point_count; ++i, ++slot) {
      while (sum.innerIndexPtr()[slot] != points[i]) ++slot;
      sum.valuePtr()[slot] += form(i, j);
    }
  }
}

SquareForms::Matrix SquareForms::sum(const Add& add) const {
  Matrix sum = pattern_;
  Eigen::MatrixXd of_square, of_group;
  for (const Group& group : groups_) {
    // Cell by cell: its squares share most of their control points, so the sparse sum is entered
    // but once for all of them.
    of_group.setZero(group.point_count, group.point_count);
    for (int k = 0; k < group.square_count; ++k) {
      const int square = group.first_square + k;
      const auto count = static_cast<Eigen::Index>(squares_.points(square).size());
      of_square.setZero(count, count);
      add(square, of_square);
      if (of_square.isZero(0.0)) continue;
      add_square(square, of_square, of_group);
    }
    add_group(group, of_group, sum);
  }
  return sum;
}

}  // namespace hull::surface
