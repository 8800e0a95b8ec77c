// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "modelling/fit/fit_bounds.h"
#include "modelling/fit/fit_checks.h"
#include "modelling/fit/fit_curves.h"
#include "modelling/fit/fit_feet.h"
#include "modelling/fit/fit_places.h"
#include "modelling/thin_plate.h"

namespace hull::modelling {
namespace {

using fit_internal::CurvePulls;
using fit_internal::Feet;
using fit_internal::PlacePulls;

// Damping: of the mean of the equations' diagonal.
constexpr double kFirstDamping = 1e-3, kLeastDamping = 1e-13, kMostDamping = 1e6;
// Of the cost: steps that gain less, this many in a row, end the fit.
constexpr double kNoGain = 1e-7;
constexpr int kIdleSteps = 3;

// How far a sum is from its rest.
Vector3d off_rest(const FitSum& sum, const std::vector<Vector3d>& points) {
  Vector3d off = -sum.rest;
  for (std::size_t k = 0; k < sum.points.size(); ++k) off += sum.weights[k] * points[sum.points[k]];
  return off;
}

void add_sums(const std::vector<FitSum>& sums, const std::vector<Vector3d>& points,
              FitEquations& equations) {
  for (const FitSum& sum : sums) {
    const auto size = static_cast<Eigen::Index>(sum.weights.size());
    const Eigen::VectorXd weights = Eigen::VectorXd::Map(sum.weights.data(), size);
    // Half of the square, as in all terms of the equations: the 2 of every slope is left out.
    equations.add_scalar(sum.points, weights * weights.transpose(),
                         -weights * off_rest(sum, points).transpose());
  }
}

std::vector<Vector3d> moved(const surface::LimitSurface& surface,
                            const std::vector<Vector3d>& moves) {
  std::vector<Vector3d> points = surface.mesh().points();
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += moves[i];
  return points;
}

// The form of the moves' bending, which is the same for all steps.
Eigen::SparseMatrix<double> bending_of_moves(const surface::LimitSurface& surface,
                                             const surface::PieceWeights& pieces,
                                             const FitOptions& options) {
  if (!(options.stiffness > 0.0)) return {};
  const surface::LimitSurface& metric = options.metric ? *options.metric : surface;
  return thin_plate_matrix(metric, pieces);
}

// The surface at some step, and all that its cost is made of.
struct State {
  surface::LimitSurface surface;
  surface::SurfaceTree tree;
  Feet feet;
  CurvePulls curves;
  PlacePulls places;
  double energy = 0.0;       // of the surface
  double move_energy = 0.0;  // of the moves
  double sums = 0.0;         // their squares
};

class Fitting {
 public:
  Fitting(const surface::LimitSurface& surface, const FitTarget& target,
          const std::vector<FitCurve>& curves, const FitOptions& options)
      : target_(target),
        curves_(curves),
        options_(options),
        pieces_(surface),
        space_(options.limits, surface.mesh().topology().vertex_count()),
        bounds_(options.bounds, space_),
        size_(surface.mesh().size()),
        start_(surface),
        bending_(bending_of_moves(surface, pieces_, options)),
        state_{surface, surface::SurfaceTree(surface), {}, {}, {}} {
    if (target.shape) shape_tree_.emplace(*target.shape);
    // Before the first measure, so that no step is compared with a place that bounds forbid.
    // Stiffness counts moves from the start as it was given all the same.
    if (const auto within = bounds_.moves_within(surface.mesh().points())) {
      state_.surface.set_points(moved(state_.surface, *within));
      state_.tree.refit(state_.surface);
    }
    measure(state_);
    if (!target.points.empty() && state_.feet.weight <= 0.0) {
      throw std::invalid_argument(
          "No target counts: none lies within reach of the surface, on a side where normals agree. "
          "Move surface and target to one place, allow a greater reach, or turn the normals.");
    }
  }

  Fit run() {
    int step = 0, idle = 0;
    bool settled = false;
    for (; step < options_.most_steps && !settled; ++step) {
      surface::tell(options_.progress, step, options_.most_steps);
      const double before = cost(state_);
      const double move = advance();
      const double gain = before - cost(state_);
      idle = gain > kNoGain * before ? 0 : idle + 1;
      settled = move <= options_.least_move * size_ || idle >= kIdleSteps;
    }
    surface::tell(options_.progress, 1.0, 1.0);
    // No steps asked for: the surface is measured as it is, and nothing is left to settle.
    return report(step, settled || options_.most_steps == 0);
  }

 private:
  // In m²: what the fit makes least.
  double cost(const State& state) const {
    return state.feet.mean_square + state.places.mean_square +
           options_.curve_weight * state.curves.mean_square + state.sums +
           factor(options_.fairness) * state.energy +
           factor(options_.stiffness) * state.move_energy;
  }
  double factor(double share) const { return share * share * size_ * size_; }

  void measure(State& state) const {
    state.feet = fit_internal::find_feet(state.surface, state.tree, target_, options_);
    state.curves = fit_internal::find_curve_pulls(state.surface, curves_, options_);
    if (shape_tree_) {
      state.places = fit_internal::find_place_pulls(state.surface, *target_.shape, *shape_tree_);
    }
    state.sums = 0.0;
    for (const FitSum& sum : options_.sums) {
      state.sums += off_rest(sum, state.surface.mesh().points()).squaredNorm();
    }
    if (options_.fairness > 0.0) state.energy = energy_of(state.surface);
    if (options_.stiffness > 0.0) {
      const Moves moves = moves_of(state);
      // Σ moveᵀ · form · move of x, y and z: the trace, without the rest of the product.
      state.move_energy = moves.cwiseProduct(bending_ * moves).sum();
    }
  }

  double energy_of(const surface::LimitSurface& surface) const {
    return thin_plate_energy(surface, pieces_, surface.mesh().points());
  }

  using Moves = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  Moves moves_of(const State& state) const {
    const std::vector<Vector3d>&now = state.surface.mesh().points(),
          &start = start_.mesh().points();
    Moves moves(static_cast<Eigen::Index>(now.size()), 3);
    for (std::size_t i = 0; i < now.size(); ++i) {
      moves.row(static_cast<Eigen::Index>(i)) = (now[i] - start[i]).transpose();
    }
    return moves;
  }

  FitEquations equations() const {
    FitEquations equations(state_.surface.mesh().topology().vertex_count());
    fit_internal::add_feet(state_.feet, target_, state_.surface, pieces_, equations);
    // A copy: the cost weighs the curves' mean square itself.
    std::vector<fit_internal::FitRow> rows = state_.curves.rows;
    for (fit_internal::FitRow& row : rows) row.weight *= options_.curve_weight;
    fit_internal::add_rows(rows, state_.surface, pieces_, equations);
    fit_internal::add_rows(state_.places.rows, state_.surface, pieces_, equations);
    add_sums(options_.sums, state_.surface.mesh().points(), equations);
    if (options_.fairness > 0.0) {
      add_thin_plate(state_.surface, pieces_, state_.surface.mesh().points(),
                     factor(options_.fairness), equations);
    }
    if (options_.stiffness > 0.0) {
      const double weight = factor(options_.stiffness);
      equations.add_scalar(weight * bending_, -weight * (bending_ * moves_of(state_)));
    }
    return equations;
  }

  // One step that lowers the cost: the largest move of a control point; 0 where there is none.
  double advance() {
    // The equations stay while the damping grows; closest points are found anew for every trial, so
    // that what is compared is the cost itself, not its model.
    const FitEquations system = equations();
    const double before = cost(state_);
    for (; damping_ <= kMostDamping; damping_ *= 10.0) {
      const auto moves =
          system.solve(space_, damping_, bounds_, bounds_.gaps(state_.surface.mesh().points()));
      if (!moves) continue;
      double largest = 0.0;
      for (const Vector3d& move : *moves) largest = std::max(largest, move.norm());
      // Equations that hardly tell of some points throw these beyond the hull.
      if (!(largest < size_)) continue;
      // The tree is copied and refitted, as sorting its boxes again costs more.
      State next{state_.surface, state_.tree, {}, {}, {}};
      next.surface.set_points(moved(state_.surface, *moves));
      next.tree.refit(next.surface);
      measure(next);
      if (cost(next) > before) {
        // More damping would make it shorter still.
        if (largest <= options_.least_move * size_) return 0.0;
        continue;
      }
      state_ = std::move(next);
      // Less with each success: near the end the steps are Gauss and Newton's.
      damping_ = std::max(kLeastDamping, 0.1 * damping_);
      return largest;
    }
    damping_ = kFirstDamping;
    return 0.0;
  }

  Fit report(int steps, bool settled) const;

  const FitTarget& target_;
  const std::vector<FitCurve>& curves_;
  const FitOptions& options_;
  surface::PieceWeights pieces_;
  MoveSpace space_;
  MoveBounds bounds_;
  double size_;
  const surface::LimitSurface& start_;
  const Eigen::SparseMatrix<double> bending_;  // of moves
  std::optional<surface::SurfaceTree> shape_tree_;
  State state_;
  double damping_ = kFirstDamping;
};

Fit Fitting::report(int steps, bool settled) const {
  Fit fit{};
  fit.points = state_.surface.mesh().points();
  fit.largest_target = -1;
  fit.largest_place.setZero();
  double sum = 0.0;
  for (std::size_t i = 0; i < state_.feet.all.size(); ++i) {
    const fit_internal::Foot& foot = state_.feet.all[i];
    fit.distances.push_back(foot.cell < 0 ? std::nan("") : foot.distance);
    if (foot.cell < 0) continue;
    ++fit.counted;
    sum += foot.distance * foot.distance;
    if (std::abs(foot.distance) <= fit.largest && fit.largest_target >= 0) continue;
    fit.largest = std::abs(foot.distance);
    fit.largest_target = static_cast<int>(i);
    fit.largest_place = foot.point;
  }
  fit.rms = fit.counted > 0 ? std::sqrt(sum / fit.counted) : 0.0;
  fit.curve_distances = state_.curves.distances;
  double curve_sum = 0.0;
  int curve_count = 0;
  for (double distance : fit.curve_distances) {
    if (std::isnan(distance)) continue;
    ++curve_count;
    curve_sum += distance * distance;
    fit.curve_largest = std::max(fit.curve_largest, distance);
  }
  fit.curve_rms = curve_count > 0 ? std::sqrt(curve_sum / curve_count) : 0.0;
  fit.energy = energy_of(state_.surface);
  fit.steps = steps;
  fit.settled = settled;
  return fit;
}

}  // namespace

Fit fit(const surface::LimitSurface& surface, const FitTarget& target,
        const std::vector<FitCurve>& curves, const FitOptions& options) {
  fit_internal::check_fit(surface, target, curves, options);
  return Fitting(surface, target, curves, options).run();
}

}  // namespace hull::modelling
