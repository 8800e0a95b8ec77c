// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/targets/target_problem.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hull::modelling {
namespace {

void check(const std::vector<FormTarget>& targets) {
  if (targets.empty()) throw std::invalid_argument("No target is given: at least one is needed.");
  for (const FormTarget& target : targets) {
    const bool is_sound = target.low <= target.high && target.weight > 0.0 &&
                          std::isfinite(target.weight) && std::isfinite(target.station) &&
                          (std::isfinite(target.low) || std::isfinite(target.high));
    if (is_sound) continue;
    const std::string name = target.is_section ? "section_area" : analysis::name_of(target.number);
    throw std::invalid_argument("The target of " + name +
                                " is none: a wanted value must be a number, a tolerance 0 or "
                                "more, and a weight positive.");
  }
}

}  // namespace

TargetProblem::TargetProblem(const surface::LimitSurface& surface, const TargetWater& water,
                             const std::vector<FormTarget>& targets, const MoveFamily& family)
    : surface_(surface),
      water_(water),
      targets_(targets),
      family_(family),
      start_(surface.mesh().points()),
      body_(surface_, water.mirrored, water.openings),
      derivatives_(body_) {
  check(targets);
  numbers_.emplace(derivatives_, water_.position, water_.project, water_.density);
}

void TargetProblem::place(const HullChange& change) {
  const Eigen::VectorXd moves = family_.moves(change.y);
  std::vector<Vector3d> points = start_;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] += moves.segment<3>(3 * static_cast<Eigen::Index>(i));
    points[i] = points[i].cwiseProduct(change.scale);
  }
  surface_.set_points(std::move(points));
  body_.update();
  scale_ = change.scale;
  analysis::FloatingPosition position = water_.position;
  position.draft *= scale_.z();
  position.draft_at *= scale_.x();
  const analysis::ProjectDimensions project{water_.project.length_pp * scale_.x(),
                                            water_.project.beam * scale_.y(),
                                            water_.project.draft * scale_.z()};
  by_moves_.reset();
  numbers_.emplace(derivatives_, position, project, water_.density);
}

int TargetProblem::first_fold() const {
  std::vector<Vector3d> points = surface_.mesh().points();
  for (Vector3d& p : points) p = p.cwiseQuotient(scale_);
  return family_.places().first_fold(points);
}

Eigen::VectorXd TargetProblem::values() {
  Eigen::VectorXd values(static_cast<Eigen::Index>(targets_.size()));
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const FormTarget& target = targets_[i];
    values[static_cast<Eigen::Index>(i)] = target.is_section
                                               ? numbers_->section_area(target.station * scale_.x())
                                               : numbers_->value(target.number);
  }
  return values;
}

void TargetProblem::differentiate() {
  const auto rows = static_cast<Eigen::Index>(targets_.size());
  Eigen::MatrixXd gradients(3 * static_cast<Eigen::Index>(start_.size()), rows);
  by_scale_.setZero(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const FormTarget& target = targets_[i];
    const double station = target.station * scale_.x();
    const analysis::Gradient gradient = target.is_section ? numbers_->section_area_gradient(station)
                                                          : numbers_->gradient(target.number);
    if (water_.position.trim == 0.0) {
      const Vector3d by_logarithm = target.is_section
                                        ? numbers_->section_area_scaling(station, gradient)
                                        : numbers_->scaling(target.number, gradient);
      by_scale_.row(i) = by_logarithm.cwiseQuotient(scale_).transpose();
    }
    for (Eigen::Index k = 0; k < gradient.rows(); ++k) {
      gradients.block<3, 1>(3 * k, i) = gradient.row(k).transpose().cwiseProduct(scale_);
    }
  }
  by_moves_ = family_.by_freedoms(gradients).transpose();
}

Eigen::MatrixXd TargetProblem::by_moves() {
  if (!by_moves_) differentiate();
  return *by_moves_;
}

Eigen::MatrixX3d TargetProblem::by_scale() {
  if (!by_moves_) differentiate();
  return by_scale_;
}

}  // namespace hull::modelling
