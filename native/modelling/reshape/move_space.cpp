// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/move_space.h"

#include <Eigen/QR>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "mesh/groups.h"
#include "modelling/complement.h"

namespace hull::modelling {
namespace {

// Of the prescribed moves: what contradictory limits leave is never near this.
constexpr double kMet = 1e-10;

void check(const ReshapeLimits& limits, int count) {
  for (int point : limits.prescribed) check_point(point, count, "prescribed");
  for (const TiedPoint& tied : limits.tied) {
    check_point(tied.point, count, "tied");
    check_point(tied.leader, count, "leading");
    if (!tied.direction.allFinite() || tied.direction.isZero(0.0)) {
      throw std::invalid_argument("The tied direction of point " + std::to_string(tied.point) +
                                  " has no length.");
    }
    if (tied.point == tied.leader) {
      throw std::invalid_argument("Point " + std::to_string(tied.point) + " is tied to itself.");
    }
  }
}

// What is asked of the moves of some points, a row each.
class GroupRows {
 public:
  explicit GroupRows(const std::vector<int>& points) {
    for (int point : points) first_.emplace(point, 3 * static_cast<Eigen::Index>(first_.size()));
  }

  // `told`: the coordinate among prescribed moves that is its value; -1: zero.
  void add(int point, const Vector3d& direction, int told = -1) {
    rows_.emplace_back(Eigen::VectorXd::Zero(size()));
    told_.push_back(told);
    add_to_last(point, direction);
  }
  void add_to_last(int point, const Vector3d& direction) {
    rows_.back().segment<3>(first_.at(point)) += direction;
  }

  const std::vector<int>& told() const { return told_; }
  const std::vector<Eigen::VectorXd>& rows() const { return rows_; }
  Eigen::Index size() const { return 3 * static_cast<Eigen::Index>(first_.size()); }
  Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows_.size()), size());
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.row(i) = rows_[i].transpose();
    return matrix;
  }

 private:
  std::map<int, Eigen::Index> first_;  // of the points' columns
  std::vector<Eigen::VectorXd> rows_;
  std::vector<int> told_;
};

}  // namespace

class MoveSpace::Builder {
 public:
  Builder(MoveSpace& space, const ReshapeLimits& limits)
      : space_(space),
        ties_(limits.tied),
        alone_(freedoms_within(limits.limits, space.point_count_)),
        told_(space.point_count_, -1),
        groups_(space.point_count_),
        is_grouped_(space.point_count_, 0) {
    for (std::size_t i = 0; i < limits.prescribed.size(); ++i) {
      told_[limits.prescribed[i]] = static_cast<int>(i);
      is_grouped_[limits.prescribed[i]] = 1;
    }
    for (const TiedPoint& tied : ties_) {
      groups_.join(tied.point, tied.leader);
      is_grouped_[tied.point] = is_grouped_[tied.leader] = 1;
    }
  }

  void build() {
    std::map<int, std::vector<int>> members;
    for (int point = 0; point < space_.point_count_; ++point) {
      if (is_grouped_[point]) {
        members[groups_.find(point)].push_back(point);
      } else {
        add_point(point);
      }
    }
    std::map<int, std::vector<TiedPoint>> ties;
    for (const TiedPoint& tied : ties_) ties[groups_.find(tied.point)].push_back(tied);
    for (const auto& [group, points] : members) add_group(points, ties[group]);
    space_.basis_.resize(3 * static_cast<Eigen::Index>(space_.point_count_), columns_);
    space_.basis_.setFromTriplets(entries_.begin(), entries_.end());
  }

 private:
  void add_point(int point) {
    const Freedom& freedom = alone_[point];
    for (int k = 0; k < freedom.count; ++k, ++columns_) {
      for (int axis = 0; axis < 3; ++axis) {
        add_entry(point, axis, freedom.directions[k][axis]);
      }
    }
  }

  void add_group(const std::vector<int>& points, const std::vector<TiedPoint>& ties) {
    GroupRows rows(points);
    for (int point : points) {
      add_held(point, rows);
      for (int axis = 0; axis < 3 && told_[point] >= 0; ++axis) {
        rows.add(point, Vector3d::Unit(axis), 3 * told_[point] + axis);
      }
    }
    for (const TiedPoint& tied : ties) {
      const Vector3d unit = tied.direction.normalized();
      rows.add(tied.point, unit);
      rows.add_to_last(tied.leader, -unit);
    }
    for (const Eigen::VectorXd& free : complement(rows.rows(), rows.size())) {
      for (Eigen::Index i = 0; i < free.size(); ++i) {
        add_entry(points[i / 3], static_cast<int>(i % 3), free[i]);
      }
      ++columns_;
    }
    if (std::ranges::all_of(rows.told(), [](int c) { return c < 0; })) return;
    const Eigen::MatrixXd matrix = rows.matrix();
    space_.told_groups_.push_back(
        {points, matrix, rows.told(), matrix.completeOrthogonalDecomposition().pseudoInverse()});
  }

  // What a point may not do alone: all that is square to what it may.
  void add_held(int point, GroupRows& rows) const {
    const Freedom& freedom = alone_[point];
    const auto* first = freedom.directions.data();
    for (const Vector3d& held : complement<Vector3d>({first, first + freedom.count}, 3)) {
      rows.add(point, held);
    }
  }

  void add_entry(int point, int axis, double value) {
    if (value != 0.0) entries_.emplace_back(3 * point + axis, columns_, value);
  }

  MoveSpace& space_;
  const std::vector<TiedPoint>& ties_;
  const std::vector<Freedom> alone_;
  std::vector<int> told_;  // index among the prescribed points, or -1
  mesh::Groups groups_;
  std::vector<char> is_grouped_;
  std::vector<Eigen::Triplet<double>> entries_;
  int columns_ = 0;
};

MoveSpace::MoveSpace(const ReshapeLimits& limits, int point_count)
    : prescribed_(limits.prescribed), point_count_(point_count) {
  check(limits, point_count);
  Builder(*this, limits).build();
}

Eigen::VectorXd MoveSpace::particular(const std::vector<Vector3d>& prescribed) const {
  if (prescribed.size() != prescribed_.size()) {
    throw std::invalid_argument("There must be " + std::to_string(prescribed_.size()) +
                                " prescribed moves, not " + std::to_string(prescribed.size()) +
                                ".");
  }
  Eigen::VectorXd moves = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(point_count_));
  for (const Group& group : told_groups_) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(group.rows.rows());
    for (std::size_t i = 0; i < group.told.size(); ++i) {
      const int c = group.told[i];
      if (c >= 0) values[static_cast<Eigen::Index>(i)] = prescribed[c / 3][c % 3];
    }
    const Eigen::VectorXd x = group.inverse * values;
    const double left = (group.rows * x - values).cwiseAbs().maxCoeff();
    if (!(left <= kMet * values.cwiseAbs().maxCoeff())) {
      throw std::invalid_argument("Point " + std::to_string(group.points.front()) +
                                  " cannot move as prescribed: it is locked, held in a plane, or "
                                  "tied to one that is.");
    }
    for (std::size_t k = 0; k < group.points.size(); ++k) {
      moves.segment<3>(3 * static_cast<Eigen::Index>(group.points[k])) =
          x.segment<3>(3 * static_cast<Eigen::Index>(k));
    }
  }
  for (std::size_t i = 0; i < prescribed_.size(); ++i) {
    // Bit by bit, whatever the groups' equations made of it.
    moves.segment<3>(3 * static_cast<Eigen::Index>(prescribed_[i])) = prescribed[i];
  }
  return moves;
}

}  // namespace hull::modelling
