// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "modelling/transformation/section_shift.h"

namespace hull::modelling {

// Finds the coefficients of a SectionShift for its targets.
//
// While the water is level and control points keep their heights, what is immersed of the surface
// is so whatever the shift: ∇ is linear in the coefficients and its moment quadratic. A quadratic
// model of both, made of a few exact evaluations, therefore gives the start, and what is within
// reach; Broyden's method (1965) does the rest on the exact hydrostatics.
class SectionShift::Solver {
 public:
  // Throws std::invalid_argument where targets are no numbers, or more than the coefficients.
  Solver(SectionShift& shift, const FormTargets& targets);

  // The coefficients; throws std::invalid_argument where there are none.
  std::vector<double> solve();

  int iterations() const { return iterations_; }
  bool converged() const { return converged_; }

 private:
  using Vector = Eigen::VectorXd;

  struct Form {
    double volume, moment;  // m³, m⁴ about x = 0
  };

  void choose_directions();
  std::vector<double> coefficients(const Vector& y) const;
  bool is_sound(const Vector& y) const { return shift_.is_sound(coefficients(y)); }
  Form form_at(const Vector& y);
  Vector missing(const Vector& y);  // of the targets, of order 1

  void make_model();
  double model_volume(const Vector& y) const { return base_.volume + volume_slope_.dot(y); }
  double model_moment(const Vector& y) const {
    return base_.moment + moment_slope_.dot(y) + 0.5 * y.dot(curvature_ * y);
  }
  Eigen::MatrixXd model_slopes(const Vector& y) const;  // of what is missing
  // The y of the model for a volume and a centre of buoyancy, each where it is wanted; none where
  // there is none.
  std::optional<Vector> model_root(double volume, double lcb) const;

  [[noreturn]] void refuse();
  struct Range {
    double low, high;
  };
  // All values around `start` that are sound, on the path y(value).
  template <class Path>
  std::optional<Range> reach(const Path& path, double start, double step) const;
  std::string volume_range(const Range& range) const;
  std::string lcb_range(const Range& range) const;

  SectionShift& shift_;
  FormTargets targets_;
  double wanted_volume_ = 0.0;  // m³; for Cp with the present station amidships
  Eigen::MatrixXd directions_;  // coefficients = directions · y
  Form base_{};
  Vector volume_slope_, moment_slope_;
  Eigen::MatrixXd curvature_;
  int iterations_ = 0;
  bool converged_ = true;
};

}  // namespace hull::modelling
