// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/derivatives/body_derivatives.h"
#include "modelling/targets/form_target.h"
#include "modelling/targets/move_family.h"

namespace hull::modelling {

// How a hull lies in the water while targets are measured.
struct TargetWater {
  bool mirrored = true;
  analysis::Openings openings = analysis::Openings::kClosed;
  analysis::FloatingPosition position;  // without heel
  analysis::ProjectDimensions project;
  double density = analysis::kSeaWaterDensity;
};

// Where a hull is: the coordinates of its moves in their family, and the factors by which it is
// scaled after them, along x, y and z.
struct HullChange {
  Eigen::VectorXd y;
  Vector3d scale = Vector3d::Ones();
};

// A hull of its own that is put where it is told, and measured there. Its points are D (P + Δ), Δ
// the family's moves and D the scaling, which water and project dimensions take part in.
class TargetProblem {
 public:
  // `family` must outlive the problem. Throws std::invalid_argument as FormNumbers does, and where
  // targets or water are none.
  TargetProblem(const surface::LimitSurface& surface, const TargetWater& water,
                const std::vector<FormTarget>& targets, const MoveFamily& family);

  // Throws std::invalid_argument where the hull cannot be measured as it is then: it floods, or is
  // turned inwards.
  void place(const HullChange& change);

  std::vector<Vector3d> points() const { return surface_.mesh().points(); }
  const std::vector<Vector3d>& start() const { return start_; }
  // The first of the family's places where the surface, scaled back, is turned over; -1: none.
  int first_fold() const;

  // Of the targets, a row each.
  Eigen::VectorXd values();
  // Their derivatives by y, and by the three factors.
  Eigen::MatrixXd by_moves();
  Eigen::MatrixX3d by_scale();

 private:
  double value(std::size_t row);
  double wave_resistance(std::size_t row);
  // By the logarithms of factors, as FormNumbers::scaling(): what counts is where points are to the
  // water, which goes along in height. REQUIRES: no trim.
  Vector3d wave_scaling(const analysis::Gradient& gradient) const;
  // Of a row by control points that are not scaled yet; its scaling is noted in by_scale_.
  Eigen::VectorXd gradient(Eigen::Index row);
  void differentiate();

  surface::LimitSurface surface_;
  TargetWater water_;
  const std::vector<FormTarget>& targets_;
  const MoveFamily& family_;
  std::vector<Vector3d> start_;
  analysis::HullBody body_;
  analysis::BodyDerivatives derivatives_;
  Vector3d scale_ = Vector3d::Ones();
  analysis::FloatingPosition position_;  // as the hull is now
  std::optional<analysis::FormNumbers> numbers_;
  // Of each target the shortest wave that counts in its resistance: the same for all forms.
  std::vector<double> shortest_;
  std::optional<Eigen::MatrixXd> by_moves_;
  Eigen::MatrixX3d by_scale_;
};

}  // namespace hull::modelling
