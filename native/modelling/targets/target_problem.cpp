// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/targets/target_problem.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "resistance/michell_integral.h"

namespace hull::modelling {
namespace {

std::string name_of(const FormTarget& target) {
  if (target.coordinate) return "coordinate";
  if (target.wave_speed) return "wave_resistance";
  return target.is_section ? "section_area" : analysis::name_of(target.number);
}

bool is_sound(const std::optional<FormTarget::Coordinate>& coordinate, int cells) {
  if (!coordinate) return true;
  const Eigen::Vector2d& uv = coordinate->uv;
  return coordinate->cell >= 0 && coordinate->cell < cells && uv.minCoeff() >= 0.0 &&
         uv.maxCoeff() <= 1.0 && coordinate->direction.allFinite();
}

void check(const std::vector<FormTarget>& targets, int cells) {
  if (targets.empty()) throw std::invalid_argument("No target is given: at least one is needed.");
  for (const FormTarget& target : targets) {
    if (!is_sound(target.coordinate, cells)) {
      throw std::invalid_argument("A coordinate is wanted of no place: a surface of " +
                                  std::to_string(cells) +
                                  " cells has their numbers from 0 on, with u and v from 0 to 1.");
    }
    const bool is_bounded = target.low <= target.high && target.weight > 0.0 &&
                            std::isfinite(target.weight) && std::isfinite(target.station) &&
                            (std::isfinite(target.low) || std::isfinite(target.high));
    if (is_bounded) continue;
    throw std::invalid_argument("The target of " + name_of(target) +
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
      derivatives_(body_),
      position_(water.position),
      shortest_(targets.size(), 0.0) {
  check(targets, surface.cell_count());
  numbers_.emplace(derivatives_, water_.position, water_.project, water_.density);
}

void TargetProblem::place(const HullChange& change) {
  const Eigen::VectorXd moves = family_.moves(change.y);
  std::vector<Vector3d> points = start_;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] += moves.segment<3>(3 * static_cast<Eigen::Index>(i));
    // About the origin: the after perpendicular, the centre plane and the base line.
    points[i] = points[i].cwiseProduct(change.scale);
  }
  surface_.set_points(std::move(points));
  body_.update();
  scale_ = change.scale;
  // Water and dimensions go along: scaling alone leaves coefficients as they are.
  analysis::FloatingPosition position = water_.position;
  position.draft *= scale_.z();
  position.draft_at *= scale_.x();
  const analysis::ProjectDimensions project{water_.project.length_pp * scale_.x(),
                                            water_.project.beam * scale_.y(),
                                            water_.project.draft * scale_.z()};
  // Derivatives are made when they are asked for: a step that is refused needs values alone.
  by_moves_.reset();
  position_ = position;
  numbers_.emplace(derivatives_, position, project, water_.density);
}

int TargetProblem::first_fold() const {
  // The family compares with the start, which is not scaled.
  std::vector<Vector3d> points = surface_.mesh().points();
  for (Vector3d& p : points) p = p.cwiseQuotient(scale_);
  return family_.places().first_fold(points);
}

Eigen::VectorXd TargetProblem::values() {
  Eigen::VectorXd values(static_cast<Eigen::Index>(targets_.size()));
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = value(i);
  }
  return values;
}

double TargetProblem::wave_resistance(std::size_t row) {
  const resistance::MichellIntegral integral(body_, position_, water_.density);
  const double speed = *targets_[row].wave_speed;
  // Found anew for each form it would jump between steps, and the resistance with it.
  if (shortest_[row] == 0.0) shortest_[row] = integral.resistance({speed})[0].shortest;
  return integral.resistance_to(speed, shortest_[row]).resistance;
}

double TargetProblem::value(std::size_t row) {
  const FormTarget& target = targets_[row];
  if (target.wave_speed) return wave_resistance(row);
  if (target.coordinate) {
    const auto& [cell, uv, direction] = *target.coordinate;
    // Of the surface scaled back, as its bound is one of the hull before scaling.
    return direction.dot(surface_.position(cell, uv[0], uv[1]).cwiseQuotient(scale_));
  }
  if (target.is_section) return numbers_->section_area(target.station * scale_.x());
  return numbers_->value(target.number);
}

Vector3d TargetProblem::wave_scaling(const analysis::Gradient& gradient) const {
  Vector3d sum = Vector3d::Zero();
  const std::vector<Vector3d>& points = surface_.mesh().points();
  for (Eigen::Index k = 0; k < gradient.rows(); ++k) {
    // By the logarithm of a factor a point moves by its own coordinate, in height from the water.
    const Vector3d p = points[static_cast<std::size_t>(k)] - Vector3d(0.0, 0.0, position_.draft);
    sum += gradient.row(k).transpose().cwiseProduct(p);
  }
  return sum;
}

Eigen::VectorXd TargetProblem::gradient(Eigen::Index row) {
  const FormTarget& target = targets_[row];
  const double station = target.station * scale_.x();
  Vector3d scale = scale_;
  analysis::Gradient by_points;
  if (target.coordinate) {
    const auto& [cell, uv, direction] = *target.coordinate;
    by_points = derivatives_.adjoint().at(cell, uv, direction);
    scale.setOnes();  // it is wanted of the hull before scaling
  } else if (target.wave_speed) {
    by_points = resistance::MichellIntegral(body_, position_, water_.density)
                    .gradient_to(derivatives_, *target.wave_speed, shortest_[row]);
  } else if (target.is_section) {
    by_points = numbers_->section_area_gradient(station);
  } else {
    by_points = numbers_->gradient(target.number);
  }
  // With trim no dimension is free (TargetDescent::check_scales), and a coordinate does not depend
  // on the factors.
  if (water_.position.trim == 0.0 && !target.coordinate) {
    const Vector3d by_logarithm = target.wave_speed ? wave_scaling(by_points)
                                  : target.is_section
                                      ? numbers_->section_area_scaling(station, by_points)
                                      : numbers_->scaling(target.number, by_points);
    // d/ds = (1 / s) d/d(log s).
    by_scale_.row(row) = by_logarithm.cwiseQuotient(scale_).transpose();
  }
  Eigen::VectorXd found(3 * by_points.rows());
  for (Eigen::Index k = 0; k < by_points.rows(); ++k) {
    // The chain rule: the points are those of the moves, times the factors.
    found.segment<3>(3 * k) = by_points.row(k).transpose().cwiseProduct(scale);
  }
  return found;
}

void TargetProblem::differentiate() {
  const auto rows = static_cast<Eigen::Index>(targets_.size());
  Eigen::MatrixXd gradients(3 * static_cast<Eigen::Index>(start_.size()), rows);
  by_scale_.setZero(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) gradients.col(i) = gradient(i);
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
