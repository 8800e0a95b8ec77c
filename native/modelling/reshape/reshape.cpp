// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/reshape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/dense_solvers.h"
#include "modelling/reshape/move_energy.h"

namespace hull::modelling {
namespace {

// Each step of refinement leaves rounding and a small part of what the one before left.
constexpr int kMostSteps = 12;
constexpr double kStagnates = 0.3;
// Of the largest move: what is less is lost when it is added.
constexpr double kRounding = std::numeric_limits<double>::epsilon();
// Of conditions' rows of unit length: less is left of one that others, or the limits, make up.
constexpr double kDependent = 1e-12;

void check_count(std::size_t have, std::size_t want, const char* what) {
  if (have == want) return;
  throw std::invalid_argument("There must be " + std::to_string(want) + " " + what + ", not " +
                              std::to_string(have) + ".");
}

std::vector<Vector3d> vectors_of(const Eigen::VectorXd& coordinates) {
  std::vector<Vector3d> vectors;
  vectors.reserve(static_cast<std::size_t>(coordinates.size() / 3));
  for (Eigen::Index i = 0; i < coordinates.size(); i += 3) {
    vectors.emplace_back(coordinates.segment<3>(i));
  }
  return vectors;
}

// The axis of all rows that a basis has; -1 where there are several, or none.
int only_axis_of(const Eigen::SparseMatrix<double>& basis) {
  int axis = -1;
  for (Eigen::Index k = 0; k < basis.nonZeros(); ++k) {
    const int own = basis.innerIndexPtr()[k] % 3;
    if (axis >= 0 && own != axis) return -1;
    axis = own;
  }
  return axis;
}

}  // namespace

Reshape::Reshape(const surface::LimitSurface& surface, const ReshapeOptions& options)
    : points_(surface.mesh().points()),
      places_(surface, options.weights ? options.weights : std::make_shared<PlaceWeights>(surface)),
      space_(options.limits, static_cast<int>(points_.size())),
      only_axis_(only_axis_of(space_.basis())) {
  if (!(places_.total_area() > 0.0)) {
    throw std::invalid_argument("The surface has no area: no shift of it can be wanted.");
  }
  shares_.resize(places_.count());
  for (int k = 0; k < places_.count(); ++k) shares_[k] = places_.area(k) / places_.total_area();
  const auto size = static_cast<Eigen::Index>(points_.size());
  stiff_.resize(size, size);
  if (!(options.stiffness >= 0.0) || !std::isfinite(options.stiffness)) {
    throw std::invalid_argument("The stiffness must be 0 or more.");
  }
  if (options.stiffness > 0.0) add_stiffness(surface, options.stiffness);
  conditions_ = condition_rows(options.conditions, static_cast<int>(points_.size()));
  if (space_.size() == 0 && conditions_.rows() > 0) {
    throw std::invalid_argument("No control point may move, so no condition can be met.");
  }
  if (space_.size() == 0) return;
  equations_ = MoveEquations(space_, places_.weights()->form(shares_) + stiff_);
  if (conditions_.rows() > 0) factor_conditions();
}

void Reshape::add_stiffness(const surface::LimitSurface& surface, double stiffness) {
  const double factor = std::pow(stiffness * surface.mesh().size(), 2);
  stiff_ = thin_plate_form(surface, places_.weights()->forms(), factor);
}

void Reshape::factor_conditions() {
  const Eigen::MatrixXd free = Eigen::MatrixXd(conditions_ * space_.basis());
  // By their length over all points: what is left of a condition on points that hardly move is
  // short then, and is told as dependent.
  const Eigen::VectorXd full = Eigen::MatrixXd(conditions_).rowwise().norm();
  Eigen::MatrixXd unit = free;
  for (Eigen::Index i = 0; i < free.rows(); ++i) unit.row(i) /= full[i] > 0.0 ? full[i] : 1.0;
  if (!mesh::are_independent(unit, kDependent)) {
    throw std::invalid_argument(
        "The conditions depend on one another, or on points that may not move: leave some out.");
  }
  // The Schur complement of the conditions: as many rows as there are conditions.
  conditioned_.resize(free.cols(), free.rows());
  for (Eigen::Index i = 0; i < free.rows(); ++i) {
    conditioned_.col(i) = equations_.solve(free.row(i).transpose());
  }
  condition_factors_.compute(free * conditioned_);
}

Eigen::VectorXd Reshape::descent(const Eigen::VectorXd& moves, const VectorRows& shifts) const {
  // What is wanted along other axes does not count then.
  if (only_axis_ >= 0) return descent_along(only_axis_, moves, shifts);
  const Eigen::Map<const VectorRows> now = as_rows(moves);
  VectorRows left = places_.weights()->at(now);
  // In place: of thousands of irregular points these are megabytes.
  for (Eigen::Index k = 0; k < left.rows(); ++k) {
    left.row(k) = shares_[k] * (shifts.row(k) - left.row(k));
  }
  VectorRows back = places_.weights()->back(left);
  if (stiff_.nonZeros() > 0) back -= stiff_ * now;
  // Row by row, that is x, y and z of each point, as moves are.
  return space_.basis().transpose() * back.reshaped<Eigen::RowMajor>();
}

Eigen::VectorXd Reshape::descent_along(int axis, const Eigen::VectorXd& moves,
                                       const VectorRows& shifts) const {
  // Every third number: the axis of all points.
  const auto own = Eigen::seqN(Eigen::Index{axis}, as_rows(moves).rows(), 3);
  const Eigen::VectorXd now = moves(own);
  Eigen::VectorXd left = shifts.col(axis);
  // The first step mostly starts from no moves at all.
  if (!now.isZero(0.0)) left -= places_.weights()->numbers_at(now);
  left.array() *= shares_.array();
  Eigen::VectorXd back = Eigen::VectorXd::Zero(moves.size());
  back(own) = places_.weights()->numbers_back(left);
  if (stiff_.nonZeros() > 0) back(own) -= stiff_ * now;
  return space_.basis().transpose() * back;
}

Eigen::VectorXd Reshape::step(const Eigen::VectorXd& descent,
                              const Eigen::VectorXd& missing) const {
  Eigen::VectorXd step = equations_.solve(descent);
  if (conditions_.rows() == 0) return step;
  // The free step first; then along the columns of conditioned_, the way that costs least, to what
  // the conditions miss.
  const Eigen::VectorXd met = conditions_ * (space_.basis() * step);
  return step + conditioned_ * condition_factors_.solve(missing - met);
}

Eigen::VectorXd Reshape::least(const VectorRows& shifts, const std::vector<Vector3d>& prescribed,
                               const std::vector<double>& values) const {
  check_count(static_cast<std::size_t>(shifts.rows()), static_cast<std::size_t>(places_.count()),
              "wanted shifts");
  check_count(values.size(), static_cast<std::size_t>(conditions_.rows()), "values of conditions");
  const auto wished = Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
  Eigen::VectorXd moves = space_.particular(prescribed);
  if (!shifts.allFinite() || !wished.allFinite() || !moves.allFinite()) {
    throw std::invalid_argument("A wanted shift is no number.");
  }
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kMostSteps && space_.size() > 0; ++k) {
    // Refinement: right sides are those of the moves as they are, so that the next step takes away
    // what rounding and regularisation left.
    const Eigen::VectorXd missing = wished - conditions_ * moves;
    const Eigen::VectorXd more = space_.basis() * step(descent(moves, shifts), missing);
    const double length = more.cwiseAbs().maxCoeff();
    if (k > 0 && !(length < kStagnates * before)) break;
    moves += more;
    before = length;
    if (length <= kRounding * moves.cwiseAbs().maxCoeff()) break;
  }
  return moves;
}

Reshaped Reshape::solve(const std::vector<Vector3d>& shifts,
                        const std::vector<Vector3d>& prescribed,
                        const std::vector<double>& values) const {
  const VectorRows wanted = rows_of(shifts);
  const Eigen::VectorXd moves = least(wanted, prescribed, values);
  Reshaped result{left_by(moves, wanted), vectors_of(moves), -1};
  std::vector<Vector3d> points = points_;
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += result.moves[i];
  result.folded_place = places_.first_fold(points);
  return result;
}

std::vector<Vector3d> Reshape::moves(const std::vector<Vector3d>& shifts,
                                     const std::vector<Vector3d>& prescribed,
                                     const std::vector<double>& values) const {
  return vectors_of(least(rows_of(shifts), prescribed, values));
}

Residual Reshape::residual(const std::vector<Vector3d>& moves,
                           const std::vector<Vector3d>& shifts) const {
  check_count(moves.size(), points_.size(), "moves");
  check_count(shifts.size(), static_cast<std::size_t>(places_.count()), "wanted shifts");
  return left_by(rows_of(moves).reshaped<Eigen::RowMajor>(), rows_of(shifts));
}

Residual Reshape::left_by(const Eigen::VectorXd& moves, const VectorRows& shifts) const {
  const VectorRows difference = shifts - places_.weights()->at(as_rows(moves));
  const Eigen::VectorXd left = difference.rowwise().norm();
  Residual result;
  result.rms = std::sqrt(shares_.dot(left.cwiseAbs2()));
  Eigen::Index place = -1;
  result.largest = left.maxCoeff(&place);
  result.largest_place = static_cast<int>(place);
  return result;
}

}  // namespace hull::modelling
