// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "modelling/targets/bounded_dual.h"
#include "modelling/targets/targets.h"

namespace hull::modelling {

// The way to the targets, step by step: reach_targets(). Rows of the quadratic problems are the
// targets, scaled so that their derivatives have the length 1 in the inverse of the cost's form,
// and the factors of the scaling that is free.
class TargetDescent {
 public:
  TargetDescent(const surface::LimitSurface& surface, const std::vector<FormTarget>& targets,
                const TargetOptions& options, const surface::Progress& progress);
  TargetsReached run();

 private:
  struct Step {
    bool is_taken = false, is_settled = false;
    int fold = -1;
  };

  void check_scales() const;
  Eigen::Index scales() const { return static_cast<Eigen::Index>(free_scales_.size()); }
  // Sizes of targets, by which they count as met, and lengths of their derivatives, by which they
  // are made comparable.
  void prepare_rows(const Eigen::VectorXd& before);
  Eigen::MatrixXd inverse_form(const Eigen::MatrixXd& J) const;
  // How far a value is out of its target's bounds, with sign.
  double miss(Eigen::Index i, double value) const;
  bool all_met(const Eigen::VectorXd& values) const;
  double price_limit(Eigen::Index i) const;
  // What is missed, by the prices; less than what counts as met is nothing.
  double total_miss(const Eigen::VectorXd& values) const;
  double cost(const HullChange& change) const;
  void linearise();
  // The step's end where numbers have these values at `from` and vary as linearised: of all changes
  // the one with the least cost, damping times the squared way from here added.
  HullChange step_from(const HullChange& from, const Eigen::VectorXd& values, double damping);
  // Root mean square, with bending.
  double length(const HullChange& a, const HullChange& b) const;
  double promised(const HullChange& to) const;
  // Measures there; false where the hull cannot be measured or is folded.
  bool try_at(const HullChange& to, Eigen::VectorXd& values, int& fold);
  bool is_better(const HullChange& to, const Eigen::VectorXd& values, double promise) const;
  Step take_step();
  // Whether a miss would cost more than is ever paid.
  bool is_priced_out() const;
  void take_outcome(const Eigen::VectorXd& before, TargetsReached& result);

  const std::vector<FormTarget>& targets_;
  const TargetOptions& options_;
  const surface::Progress& progress_;
  double size_;
  MoveFamily family_;
  TargetProblem problem_;
  std::vector<int> free_scales_;
  std::array<double, 3> scale_costs_{};
  Eigen::VectorXd lengths_, met_;

  HullChange now_;
  Eigen::VectorXd values_;
  double damping_ = 0.0;
  // By the moves' coordinates and by the free factors, J H⁻¹, and the dual's matrix.
  Eigen::MatrixXd J_, K_, inverse_, S_;
  DualBounds bounds_;
  Eigen::VectorXd multipliers_;
};

}  // namespace hull::modelling
