// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/floating_descent.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/immersion/floating_position.h"

namespace hull::analysis {
namespace {

constexpr double kFirstReach = 0.2;  // rad: how far derivatives are trusted at the start
constexpr double kGreatestReach = 0.5;
constexpr double kLeastReach = 1e-11;
// Energies are compared to this, over displaced volume times size: rounding is a few 1e-15.
constexpr double kEnergyRounding = 1e-12;
// Residuals that are taken for rest where rounding stops the descent.
constexpr double kRoundedRest = 1e-8;
constexpr int kBlindSteps = 6;  // steps below kEnergyRounding before the descent gives up

double energy(const FloatingTask& task, const Immersion& at) {
  const Vector3d& n = at.water.normal;
  const double c = at.water.offset;
  return task.volume * (n.dot(task.centre_of_gravity) - c) -
         at.volume * (n.dot(at.centre_of_buoyancy) - c);
}

struct Attitude {
  double trim, heel;
  Vector3d normal;
};

Attitude attitude(double trim, double heel) { return {trim, heel, up_direction(trim, heel)}; }

Attitude turned(const Attitude& from, const Turning& turning, Freedom freedom,
                const Eigen::VectorXd& step) {
  if (freedom.trim != freedom.heel) {
    return freedom.trim ? attitude(from.trim + step[0], from.heel)
                        : attitude(from.trim, from.heel + step[0]);
  }
  const double angle = step.norm();
  if (angle == 0.0) return from;
  const Vector3d n =
      (std::cos(angle) * from.normal + std::sin(angle) / angle * (turning.ways * step))
          .normalized();
  // The heel stays on the turn it is on, -180° … 180° or beyond.
  const double heel = std::atan2(n.y(), n.z());
  return {std::asin(std::clamp(n.x(), -1.0, 1.0)),
          from.heel + std::remainder(heel - from.heel, 2.0 * std::numbers::pi), n};
}

// One step of the descent in the axes of the stiffness, and how much energy it should save.
struct Step {
  Eigen::VectorXd turn;
  double sink = 0.0;
  double gain = 0.0;
};

// A minimum of g s + k s²/2 within the reach; downhill to its end where there is none.
double best_step(double g, double k, double reach) {
  if (k * reach <= std::abs(g)) return g > 0.0 ? -reach : reach;
  return -g / k;
}

class Walker {
 public:
  Walker(const HullBody& body, const FloatingTask& task)
      : body_(body), task_(task), size_(body.surface().mesh().size()) {}

  Descent walk(double trim, double heel, double offset) {
    at_ = attitude(trim, heel);
    take(body_.immersion({at_.normal, offset}));
    evaluations_ = 1;
    for (iterations_ = 0; iterations_ < task_.most_iterations; ++iterations_) {
      if (is_rest(task_.tolerance)) return result(Descent::End::kRest);
      if (reach_ < kLeastReach || blind_steps_ > kBlindSteps) {
        return result(is_rest(kRoundedRest) ? Descent::End::kRest : Descent::End::kStuck);
      }
      try_step();
      if (task_.freedom.trim != task_.freedom.heel && std::cos(at_.trim) <= 0.0) {
        return result(Descent::End::kOnEnd);
      }
    }
    return result(is_rest(task_.tolerance) ? Descent::End::kRest : Descent::End::kTooManySteps);
  }

 private:
  void take(Immersion immersion) {
    immersion_ = std::move(immersion);
    energy_ = energy(task_, immersion_);
    turning_ = turning(at_.trim, at_.heel, task_.freedom);
    pivot_ = turning_point(immersion_, task_.centre_of_gravity);
    moment_ = turning_moment(immersion_, pivot_, task_.volume, task_.centre_of_gravity);
    gradient_ = turning_.ways.transpose() * moment_;
  }

  double volume_residual() const { return immersion_.volume / task_.volume - 1.0; }
  double lever_residual() const { return gradient_.norm() / task_.volume; }

  bool is_rest(double tolerance) const {
    return std::abs(volume_residual()) <= tolerance && lever_residual() <= tolerance * size_;
  }

  Step next_step() const {
    Step step;
    const double surplus = immersion_.volume - task_.volume;
    const double area = immersion_.waterplane_area;
    if (std::abs(surplus) > task_.tolerance * task_.volume || area > 0.0) {
      step.sink = best_step(surplus, area, reach_ * size_);
    }
    step.gain = -step.sink * (surplus + 0.5 * area * step.sink);
    const int n = static_cast<int>(gradient_.size());
    step.turn = Eigen::VectorXd::Zero(n);
    if (n == 0) return step;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(
        turning_stiffness(turning_, immersion_, moment_));
    const Eigen::VectorXd slopes = axes.eigenvectors().transpose() * gradient_;
    for (int i = 0; i < n; ++i) {
      const double k = axes.eigenvalues()[i];
      // Rounding does not lead away from a saddle.
      const double least = 0.5 * task_.tolerance * size_ * task_.volume;
      if (k <= 0.0 && std::abs(slopes[i]) <= least) continue;
      const double s = best_step(slopes[i], k, reach_);
      step.turn += s * axes.eigenvectors().col(i);
      step.gain -= s * (slopes[i] + 0.5 * k * s);
    }
    return step;
  }

  void try_step() {
    const Step step = next_step();
    const Attitude to = turned(at_, turning_, task_.freedom, step.turn);
    const double offset = to.normal.dot(pivot_) + step.sink;
    Immersion there = body_.immersion({to.normal, offset});
    ++evaluations_;
    const double scale = task_.volume * size_;
    const bool blind = step.gain < kEnergyRounding * scale;
    const double saved = energy_ - energy(task_, there);
    if (!blind && saved < 0.01 * step.gain) {
      reach_ = 0.25 * std::min(reach_, std::max(step.turn.norm(), std::abs(step.sink) / size_));
      return;
    }
    blind_steps_ += blind;
    if (!blind && saved > 0.75 * step.gain) reach_ = std::min(2.0 * reach_, kGreatestReach);
    at_ = to;
    take(std::move(there));
  }

  Descent result(Descent::End end) {
    Descent d;
    d.end = end;
    d.trim = at_.trim;
    d.heel = at_.heel;
    d.iterations = iterations_;
    d.evaluations = evaluations_;
    d.volume_residual = volume_residual();
    d.lever_residual = lever_residual();
    d.immersion = std::move(immersion_);
    return d;
  }

  const HullBody& body_;
  const FloatingTask& task_;
  double size_;
  double reach_ = kFirstReach;
  int iterations_ = 0, evaluations_ = 0, blind_steps_ = 0;
  Attitude at_{};
  Immersion immersion_;
  double energy_ = 0.0;
  Turning turning_;
  Vector3d pivot_, moment_;
  Eigen::VectorXd gradient_;
};

}  // namespace

Turning turning(double trim, double heel, Freedom freedom) {
  const Vector3d up = up_direction(trim, heel);
  Turning t;
  t.ways.resize(3, freedom.trim + freedom.heel);
  t.curvature = up;
  if (freedom.trim) t.ways.col(0) = forward_direction(trim, heel);
  if (freedom.heel && freedom.trim) t.ways.col(1) = -starboard_direction(trim, heel);
  if (freedom.heel && !freedom.trim) {
    t.ways.col(0) = Vector3d(0.0, up.z(), -up.y());
    t.curvature.x() = 0.0;
  }
  return t;
}

Eigen::MatrixXd turning_stiffness(const Turning& turning, const Immersion& immersion,
                                  const Vector3d& w) {
  const auto n = turning.ways.cols();
  return turning.ways.transpose() * immersion.waterplane_second * turning.ways -
         turning.curvature.dot(w) * Eigen::MatrixXd::Identity(n, n);
}

Vector3d turning_point(const Immersion& immersion, const Vector3d& gravity_centre) {
  // Rounding leaves some area to a body that is wholly under water.
  constexpr double kNone = 1e-10;
  const double length = std::cbrt(immersion.volume);
  if (immersion.waterplane_area > kNone * length * length) return immersion.centre_of_flotation;
  return gravity_centre - immersion.water.height(gravity_centre) * immersion.water.normal;
}

Vector3d turning_moment(const Immersion& immersion, const Vector3d& point, double volume,
                        const Vector3d& gravity_centre) {
  return volume * (gravity_centre - point) -
         immersion.volume * (immersion.centre_of_buoyancy - point);
}

Descent descend(const HullBody& body, const FloatingTask& task, double trim, double heel,
                double offset) {
  return Walker(body, task).walk(trim, heel, offset);
}

Span span_along(const HullBody& body, const Vector3d& direction) {
  Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vector3d& p : body.surface().mesh().points()) {
    for (double side : {1.0, -1.0}) {
      const double h = direction.dot(Vector3d(p.x(), side * p.y(), p.z()));
      span.low = std::min(span.low, h);
      span.high = std::max(span.high, h);
      if (!body.mirrored()) break;
    }
  }
  return span;
}

double greatest_volume(const HullBody& body, const Vector3d& up) {
  const Span span = span_along(body, up);
  const double above = span.high + 0.01 * (span.high - span.low);
  return body.immersion({up, above}).volume;
}

double offset_of_volume(const HullBody& body, const Vector3d& up, double volume,
                        double whole_volume, double tolerance, int& evaluations) {
  Span bracket = span_along(body, up);
  double c = bracket.low + (bracket.high - bracket.low) * volume / whole_volume;
  constexpr int kMost = 100;
  for (int i = 0; i < kMost; ++i) {
    const Immersion at = body.immersion({up, c});
    ++evaluations;
    const double surplus = at.volume - volume;
    if (std::abs(surplus) <= tolerance * std::min(volume, whole_volume - volume)) break;
    (surplus > 0.0 ? bracket.high : bracket.low) = c;
    const double newton = c - surplus / at.waterplane_area;
    const bool inside = newton > bracket.low && newton < bracket.high;
    c = inside ? newton : 0.5 * (bracket.low + bracket.high);
  }
  return c;
}

}  // namespace hull::analysis
