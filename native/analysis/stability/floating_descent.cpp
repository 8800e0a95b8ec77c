// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/floating_descent.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/immersion/floating_position.h"

namespace hull::analysis {
namespace {

// Radii of the trust region: rad, and as sinkage over the mesh's size.
constexpr double kFirstRadius = 0.2;
constexpr double kGreatestRadius = 0.5;
constexpr double kLeastRadius = 1e-11;
// Of the saving that the quadratic model foretells: below the first the step is refused, above the
// second the region grows.
constexpr double kLeastShare = 0.01;
constexpr double kGoodShare = 0.75;
// Energies are compared to this, over displaced volume times size: rounding is a few 1e-15.
constexpr double kEnergyRounding = 1e-12;
// Residuals that are taken for equilibrium where rounding stops the descent.
constexpr double kRoundedEquilibrium = 1e-8;
constexpr int kBlindSteps = 6;  // steps below kEnergyRounding before the descent gives up

struct Attitude {
  double trim, heel;
  Vector3d normal;
};

Attitude attitude(double trim, double heel) { return {trim, heel, up_direction(trim, heel)}; }

Attitude turned(const Attitude& from, const NormalDirections& directions, FreeRotations free,
                const Eigen::VectorXd& step) {
  if (free.trim != free.heel) {
    return free.trim ? attitude(from.trim + step[0], from.heel)
                     : attitude(from.trim, from.heel + step[0]);
  }
  const double angle = step.norm();
  if (angle == 0.0) return from;
  // Along the great circle: the normal stays a unit vector however long the step, and no pair of
  // angles is singular on the way.
  const Vector3d n =
      (std::cos(angle) * from.normal + std::sin(angle) / angle * (directions.columns * step))
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

// The minimum of g s + k s²/2 for |s| <= radius; at the end of lower energy where it is not convex.
double bounded_minimum(double g, double k, double radius) {
  if (k * radius <= std::abs(g)) return g > 0.0 ? -radius : radius;
  return -g / k;
}

class TrustRegionNewton {
 public:
  TrustRegionNewton(const HullBody& body, const FloatingTask& task)
      : body_(body), task_(task), size_(body.surface().mesh().size()) {}

  Descent descend(double trim, double heel, double offset) {
    at_ = attitude(trim, heel);
    take(body_.immersion({at_.normal, offset}));
    evaluations_ = 1;
    for (iterations_ = 0; iterations_ < task_.most_iterations; ++iterations_) {
      if (is_equilibrium(task_.tolerance)) return result(Descent::End::kEquilibrium);
      if (radius_ < kLeastRadius || blind_steps_ > kBlindSteps) {
        return result(is_equilibrium(kRoundedEquilibrium) ? Descent::End::kEquilibrium
                                                          : Descent::End::kStuck);
      }
      try_step();
      // With one rotation held the path runs over the pole, where trim and heel lose their meaning.
      if (task_.free.trim != task_.free.heel && std::cos(at_.trim) <= 0.0) {
        return result(Descent::End::kOnEnd);
      }
    }
    return result(is_equilibrium(task_.tolerance) ? Descent::End::kEquilibrium
                                                  : Descent::End::kTooManySteps);
  }

 private:
  void take(Immersion immersion) {
    immersion_ = std::move(immersion);
    energy_ = potential_energy(immersion_, task_.volume, task_.centre_of_gravity);
    directions_ = normal_directions(at_.trim, at_.heel, task_.free);
    centre_ = rotation_centre(immersion_, task_.centre_of_gravity);
    moment_ = rotation_moment(immersion_, centre_, task_.volume, task_.centre_of_gravity);
    gradient_ = directions_.columns.transpose() * moment_;
  }

  double volume_residual() const { return immersion_.volume / task_.volume - 1.0; }
  double lever_residual() const { return gradient_.norm() / task_.volume; }

  bool is_equilibrium(double tolerance) const {
    return std::abs(volume_residual()) <= tolerance && lever_residual() <= tolerance * size_;
  }

  Step next_step() const {
    Step step;
    const double surplus = immersion_.volume - task_.volume;
    const double area = immersion_.waterplane_area;
    // Sinkage and rotation are not mixed by the stiffness: each is minimised by itself. Of a body
    // wholly under water at its volume any depth is as good.
    if (std::abs(surplus) > task_.tolerance * task_.volume || area > 0.0) {
      step.sink = bounded_minimum(surplus, area, radius_ * size_);
    }
    // U by the sinkage s: (V - volume wanted) s + area s² / 2.
    step.gain = -step.sink * (surplus + 0.5 * area * step.sink);
    const int n = static_cast<int>(gradient_.size());
    step.turn = Eigen::VectorXd::Zero(n);
    if (n == 0) return step;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(
        rotation_stiffness(directions_, immersion_, moment_));
    const Eigen::VectorXd slopes = axes.eigenvectors().transpose() * gradient_;
    // In the axes of the stiffness the model falls apart into parabolas, each minimised by itself.
    for (int i = 0; i < n; ++i) {
      const double k = axes.eigenvalues()[i];
      // Rounding does not lead away from a saddle.
      const double least = 0.5 * task_.tolerance * size_ * task_.volume;
      if (k <= 0.0 && std::abs(slopes[i]) <= least) continue;
      const double s = bounded_minimum(slopes[i], k, radius_);
      step.turn += s * axes.eigenvectors().col(i);
      step.gain -= s * (slopes[i] + 0.5 * k * s);
    }
    return step;
  }

  void try_step() {
    const Step step = next_step();
    const Attitude to = turned(at_, directions_, task_.free, step.turn);
    // Turned about the centre of flotation, which leaves the volume to first order, then sunk.
    const double offset = to.normal.dot(centre_) + step.sink;
    Immersion there = body_.immersion({to.normal, offset});
    ++evaluations_;
    const double scale = task_.volume * size_;
    // So near to the minimum rounding hides what is saved: such steps are kept unseen, and counted.
    const bool blind = step.gain < kEnergyRounding * scale;
    const double saved = energy_ - potential_energy(there, task_.volume, task_.centre_of_gravity);
    if (!blind && saved < kLeastShare * step.gain) {
      // By the step, which may have been far shorter than the radius: else some more would be
      // refused alike.
      radius_ = 0.25 * std::min(radius_, std::max(step.turn.norm(), std::abs(step.sink) / size_));
      return;
    }
    blind_steps_ += blind;
    if (!blind && saved > kGoodShare * step.gain)
      radius_ = std::min(2.0 * radius_, kGreatestRadius);
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
  double radius_ = kFirstRadius;
  int iterations_ = 0, evaluations_ = 0, blind_steps_ = 0;
  Attitude at_{};
  // Of the attitude kept last.
  Immersion immersion_;
  double energy_ = 0.0;
  NormalDirections directions_;
  Vector3d centre_, moment_;
  Eigen::VectorXd gradient_;
};

}  // namespace

Descent descend(const HullBody& body, const FloatingTask& task, double trim, double heel,
                double offset) {
  return TrustRegionNewton(body, task).descend(trim, heel, offset);
}

}  // namespace hull::analysis
