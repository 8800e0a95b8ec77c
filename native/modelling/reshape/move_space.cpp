// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/move_space.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/dense_solvers.h"
#include "mesh/groups.h"
#include "modelling/complement.h"

namespace hull::modelling {
namespace {

// Of the prescribed moves: what contradictory limits leave is never near this.
constexpr double kMet = 1e-10;
// Of what is left at most: less is left of moves that contradict nothing.
constexpr double kInnocent = 1e-3;

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
  for (std::size_t i = 0; i < limits.kept.size(); ++i) {
    check_condition(limits.kept[i], count, ("Kept sum " + std::to_string(i)).c_str());
  }
}

[[noreturn]] void refuse_prescribed(const std::set<int>& points) {
  std::string names;
  for (int point : points) names += (names.empty() ? "" : ", ") + std::to_string(point);
  if (points.size() == 1) {
    throw std::invalid_argument("Point " + names +
                                " cannot move as prescribed: it is locked, held in a plane, or "
                                "tied to one that is.");
  }
  throw std::invalid_argument("Points " + names +
                              " cannot all move as prescribed: some of them are locked, held in a "
                              "plane, or tied to one that is, or they are tied to one another.");
}

}  // namespace

void check_condition(const MoveCondition& condition, int point_count, const char* name) {
  if (condition.slopes.size() != condition.points.size()) {
    throw std::invalid_argument(std::string(name) + " has " +
                                std::to_string(condition.points.size()) + " points, but " +
                                std::to_string(condition.slopes.size()) + " slopes.");
  }
  for (std::size_t k = 0; k < condition.points.size(); ++k) {
    const int point = condition.points[k];
    if (point < 0 || point >= point_count) {
      throw std::invalid_argument(std::string(name) + " has the control point " +
                                  std::to_string(point) + ", but these are 0 to " +
                                  std::to_string(point_count - 1) + ".");
    }
    if (!condition.slopes[k].allFinite()) {
      throw std::invalid_argument(std::string(name) + " has a slope that is no number.");
    }
  }
}

ConditionRows condition_rows(const std::vector<MoveCondition>& conditions, int point_count) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const MoveCondition& condition = conditions[i];
    check_condition(condition, point_count, ("Condition " + std::to_string(i)).c_str());
    for (std::size_t k = 0; k < condition.points.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        entries.emplace_back(static_cast<int>(i), 3 * condition.points[k] + axis,
                             condition.slopes[k][axis]);
      }
    }
  }
  ConditionRows rows(static_cast<Eigen::Index>(conditions.size()), 3 * point_count);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

class MoveSpace::Builder {
 public:
  Builder(MoveSpace& space, const ReshapeLimits& limits)
      : space_(space), groups_(3 * space.point_count_) {
    const std::vector<Freedom> alone = freedoms_within(limits.limits, space.point_count_);
    for (int point = 0; point < space.point_count_; ++point) {
      // What a point may not do alone: all that is square to what it may.
      const auto* first = alone[point].directions.data();
      if (alone[point].count == 3) continue;
      for (const Vector3d& held : complement<Vector3d>({first, first + alone[point].count}, 3)) {
        add_row({{point}, {held}});
      }
    }
    for (std::size_t i = 0; i < limits.prescribed.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        // All three axes, so that the point is told and nothing of it is left in the basis.
        add_row({{limits.prescribed[i]}, {Vector3d::Unit(axis)}}, 3 * static_cast<int>(i) + axis);
      }
    }
    for (const TiedPoint& tied : limits.tied) {
      const Vector3d unit = tied.direction.normalized();
      add_row({{tied.point, tied.leader}, {unit, -unit}});
    }
    for (const MoveCondition& sum : limits.kept) add_row(sum);
  }

  void build() {
    std::map<int, std::vector<int>> members, own_rows;
    for (int c = 0; c < 3 * space_.point_count_; ++c) members[groups_.find(c)].push_back(c);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      own_rows[groups_.find(rows_[i].front().first)].push_back(static_cast<int>(i));
    }
    // By rising number, so that columns have the same order from run to run.
    for (const auto& [group, coordinates] : members) {
      const auto own = own_rows.find(group);
      if (own == own_rows.end()) {
        // Nothing is asked of it, and so it is alone in its group.
        entries_.emplace_back(coordinates.front(), columns_++, 1.0);
      } else {
        add_group(coordinates, own->second);
      }
    }
    space_.basis_.resize(3 * static_cast<Eigen::Index>(space_.point_count_), columns_);
    space_.basis_.setFromTriplets(entries_.begin(), entries_.end());
  }

 private:
  using Row = std::vector<std::pair<int, double>>;  // coordinates and their slopes, none zero

  // What is asked of moves. `told`: the coordinate among prescribed moves that is its value; -1:
  // zero.
  void add_row(const MoveCondition& sum, int told = -1) {
    Row row;
    for (std::size_t k = 0; k < sum.points.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        if (sum.slopes[k][axis] != 0.0) {
          row.emplace_back(3 * sum.points[k] + axis, sum.slopes[k][axis]);
        }
      }
    }
    // Nothing but zeros is no limit; a slope of zero would join coordinates that have nothing to do
    // with one another.
    if (row.empty()) return;
    for (const auto& [coordinate, slope] : row) groups_.join(row.front().first, coordinate);
    rows_.push_back(std::move(row));
    told_.push_back(told);
  }

  void add_group(const std::vector<int>& coordinates, const std::vector<int>& own_rows) {
    const auto size = static_cast<Eigen::Index>(coordinates.size());
    Eigen::MatrixXd matrix =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(own_rows.size()), size);
    std::vector<Eigen::VectorXd> rows;
    std::vector<int> told;
    for (int index : own_rows) {
      const auto i = static_cast<Eigen::Index>(rows.size());
      for (const auto& [coordinate, slope] : rows_[index]) {
        // Coordinates rise, as they were collected. A row may name one twice: its slopes add up.
        matrix(i, std::ranges::lower_bound(coordinates, coordinate) - coordinates.begin()) += slope;
      }
      rows.emplace_back(matrix.row(i).transpose());
      told.push_back(told_[index]);
    }
    // Rows of prescribed points are among these: the basis leaves them where particular() puts
    // them. Dense, as groups mostly are small: a point and its ties, or a stretch of a keel.
    for (const Eigen::VectorXd& free : complement(rows, size)) {
      for (Eigen::Index i = 0; i < size; ++i) {
        if (free[i] != 0.0) entries_.emplace_back(coordinates[i], columns_, free[i]);
      }
      ++columns_;
    }
    // Where nothing is told the shortest move is none.
    if (std::ranges::all_of(told, [](int c) { return c < 0; })) return;
    Eigen::MatrixXd inverse = mesh::pseudo_inverse(matrix);
    space_.told_groups_.push_back({coordinates, std::move(matrix), told, std::move(inverse)});
  }

  MoveSpace& space_;
  mesh::Groups groups_;  // of coordinates
  std::vector<Row> rows_;
  std::vector<int> told_;
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
    // The pseudo-inverse answers in any case; that rows contradict one another only their residual
    // tells.
    const Eigen::VectorXd left = (group.rows * x - values).cwiseAbs();
    if (!(left.maxCoeff() <= kMet * values.cwiseAbs().maxCoeff())) {
      std::set<int> contradicting;
      for (std::size_t i = 0; i < group.told.size(); ++i) {
        const bool is_met = left[static_cast<Eigen::Index>(i)] <= kInnocent * left.maxCoeff();
        if (group.told[i] >= 0 && !is_met) contradicting.insert(prescribed_[group.told[i] / 3]);
      }
      refuse_prescribed(contradicting);
    }
    for (std::size_t k = 0; k < group.coordinates.size(); ++k) {
      moves[group.coordinates[k]] = x[static_cast<Eigen::Index>(k)];
    }
  }
  for (std::size_t i = 0; i < prescribed_.size(); ++i) {
    // Bit by bit, whatever the groups' equations made of it.
    moves.segment<3>(3 * static_cast<Eigen::Index>(prescribed_[i])) = prescribed[i];
  }
  return moves;
}

}  // namespace hull::modelling
