// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/equilibrium.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "analysis/stability/floating_descent.h"
#include "analysis/stability/water_at_volume.h"
#include "analysis/stability/weathertight.h"

namespace hull::analysis {
namespace {

// The descent finds the draft anyhow: the start has only to be near enough for it.
constexpr double kStartVolume = 1e-2;  // relative error of the start's displacement
constexpr double kPush = 0.02;         // rad, away from an unstable equilibrium
constexpr double kNeutral = 1e-9;      // metacentric height over size that counts as none

double degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

void check_start(const FloatingPosition& start) {
  if (!std::isfinite(start.trim) || !std::isfinite(start.heel) || !std::isfinite(start.draft_at)) {
    throw std::invalid_argument("Trim, heel and the place of the draft must be finite numbers.");
  }
  if (std::abs(start.trim) >= 0.5 * std::numbers::pi) {
    std::ostringstream words;
    words << "The trim must be below 90°, not " << degrees(start.trim) << "°.";
    throw std::invalid_argument(words.str());
  }
}

// The stiffness of an equilibrium by rotations, as metacentric heights.
struct Stability {
  double transverse = 0.0, longitudinal = 0.0;  // m
  double least = 0.0;                           // over all rotations that are free
  Eigen::VectorXd weakest;                      // the step of `least`, of unit length
  bool by_heel = true;                          // that it turns about the ship's length, mostly
};

Stability stability_of(const Descent& found, const FloatingTask& task) {
  const Vector3d& gravity = task.centre_of_gravity;
  const Immersion& immersion = found.immersion;
  const Vector3d moment =
      rotation_moment(immersion, rotation_centre(immersion, gravity), task.volume, gravity);
  const auto heights = [&](FreeRotations free) -> Eigen::MatrixXd {
    const NormalDirections directions = normal_directions(found.trim, found.heel, free);
    // Energy is counted over density and gravity: over the volume its second derivatives are
    // lengths.
    return rotation_stiffness(directions, immersion, moment) / task.volume;
  };
  const Eigen::MatrixXd both = heights({});
  // The first direction is that of trim, the second that of heel.
  Stability s{both(1, 1), both(0, 0), 0.0, {}, true};
  const FreeRotations& free = task.free;
  if (!free.trim && !free.heel) return s;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(heights(free));
  s.least = axes.eigenvalues()[0];
  s.weakest = axes.eigenvectors().col(0);
  if (free.trim && free.heel) {
    s.by_heel = std::abs(s.weakest[1]) >= std::abs(s.weakest[0]);
    // An eigenvector has no sign of its own: which side is pushed down must not be left to the
    // solver.
    if (s.weakest[s.by_heel ? 1 : 0] < 0.0) s.weakest *= -1.0;
  } else {
    s.by_heel = free.heel;
  }
  return s;
}

std::string unstable_message(const Stability& s) {
  std::ostringstream words;
  words << "Unstable equilibrium: " << (s.by_heel ? "the transverse" : "the longitudinal")
        << " metacentric height is " << s.least << " m.";
  return words.str();
}

std::string why_not(const Descent& end) {
  std::ostringstream words;
  if (end.end == Descent::End::kOnEnd) {
    words << "The ship stands on end: no equilibrium with less than 90° of trim at a heel of "
          << degrees(end.heel) << "°.";
    return words.str();
  }
  words << (end.end == Descent::End::kStuck
                ? "No step lowers the ship's energy any more, yet she is not in equilibrium: "
                : "No equilibrium after all steps allowed: ")
        << "displacement off by " << end.volume_residual << " of it, lever " << end.lever_residual
        << " m.";
  if (end.immersion.waterplane_area <= 0.0) words << " There is no waterplane.";
  return words.str();
}

class Balance {
 public:
  Balance(const HullBody& body, double whole_volume, const LoadCase& load,
          const EquilibriumOptions& options)
      : body_(body), whole_volume_(whole_volume), options_(options) {
    task_.volume = load.displaced_volume();
    task_.centre_of_gravity = load.centre_of_gravity;
    task_.free = {options.free_trim, options.free_heel};
    density_ = load.water_density;
    result_.whole_volume = whole_volume;
  }

  Equilibrium find() {
    if (task_.volume >= whole_volume_) return sinks();
    const double trim = options_.start.trim, heel = options_.start.heel;
    const double offset = offset_of_volume(body_, up_direction(trim, heel), task_.volume,
                                           whole_volume_, kStartVolume, result_.evaluations);
    Descent found = descend_from(trim, heel, offset);
    if (options_.leave_unstable) leave_if_unstable(found);
    finish(found);
    return std::move(result_);
  }

 private:
  Equilibrium sinks() {
    result_.status = EquilibriumStatus::kSinks;
    std::ostringstream words;
    words << "Sinks: weighs " << task_.volume * density_ << " t, but the whole body displaces only "
          << whole_volume_ * density_ << " t.";
    result_.message = words.str();
    return std::move(result_);
  }

  Descent descend_from(double trim, double heel, double offset) {
    Descent d = descend(body_, task_, trim, heel, offset);
    result_.iterations += d.iterations;
    result_.evaluations += d.evaluations;
    return d;
  }

  double neutral() const { return kNeutral * body_.surface().mesh().size(); }

  FloatingPosition position_of(const Descent& found) const {
    const double at = options_.start.draft_at;
    return {draft_in(found.immersion.water, at), found.trim, found.heel, at};
  }

  void leave_if_unstable(Descent& found) {
    // What the push leads to lies lower each time; more than a few saddles in a row there are not.
    for (int i = 0; i < 4 && found.end == Descent::End::kEquilibrium; ++i) {
      const Stability s = stability_of(found, task_);
      if (s.weakest.size() == 0 || s.least >= -neutral()) return;
      // The first one left is the one that is told of.
      if (!result_.left) {
        result_.left = UnstableEquilibrium{position_of(found), s.transverse, s.longitudinal};
      }
      const NormalDirections directions = normal_directions(found.trim, found.heel, task_.free);
      const Vector3d up =
          (up_direction(found.trim, found.heel) + kPush * (directions.columns * s.weakest))
              .normalized();
      // Turned about the centre of flotation the volume stays to first order.
      const Vector3d about = rotation_centre(found.immersion, task_.centre_of_gravity);
      // up_direction() read backwards.
      const double heel = task_.free.heel ? std::atan2(up.y(), up.z()) : found.heel;
      const double trim = task_.free.trim ? std::asin(up.x()) : found.trim;
      found = descend_from(trim, heel, up.dot(about));
    }
  }

  void finish(Descent& found) {
    const Stability s = stability_of(found, task_);
    result_.position = position_of(found);
    result_.gm_transverse = s.transverse;
    result_.gm_longitudinal = s.longitudinal;
    result_.volume_residual = found.volume_residual;
    result_.lever_residual = found.lever_residual;
    result_.immersion = std::move(found.immersion);
    if (found.end != Descent::End::kEquilibrium) {
      result_.message = why_not(found);
    } else if (s.weakest.size() > 0 && s.least < -neutral()) {
      result_.status = EquilibriumStatus::kUnstable;
      result_.message = unstable_message(s);
    } else if (s.weakest.size() > 0 && s.least <= neutral()) {
      result_.status = EquilibriumStatus::kNeutral;
      result_.message =
          std::string("Equilibrium, neutral against ") + (s.by_heel ? "heeling." : "trimming.");
    } else {
      result_.status = EquilibriumStatus::kStable;
      result_.message = result_.left ? "Stable equilibrium, after leaving an unstable one."
                                     : "Stable equilibrium.";
    }
  }

  const HullBody& body_;
  double whole_volume_;
  const EquilibriumOptions& options_;
  FloatingTask task_;
  double density_ = 1.0;
  Equilibrium result_;
};

}  // namespace

Equilibrium equilibrium(const HullBody& body, const LoadCase& load,
                        const EquilibriumOptions& options) {
  return std::move(equilibria(body, {load}, options).front());
}

namespace {

void refuse_flooding(const HullBody& body, Equilibrium& e) {
  if (e.status == EquilibriumStatus::kSinks || e.status == EquilibriumStatus::kNotConverged) return;
  const DownfloodingPoint lowest = body.downflooding_point(e.immersion.water.normal);
  if (lowest.height > e.immersion.water.offset) return;
  e.status = EquilibriumStatus::kFloods;
  std::ostringstream words;
  words << "Floods at x = " << lowest.point.x() << " m, y = " << lowest.point.y()
        << " m, z = " << lowest.point.z() << " m, which is "
        << e.immersion.water.offset - lowest.height << " m under water where she would float.";
  e.message = words.str();
}

}  // namespace

std::vector<Equilibrium> equilibria(const HullBody& body, const std::vector<LoadCase>& loads,
                                    const EquilibriumOptions& options) {
  check_start(options.start);
  // A load that is none is refused before any is computed.
  for (const LoadCase& load : loads) load.displaced_volume();
  if (loads.empty()) return {};
  const Weathertight closed(body);
  // Once for all loads: wholly under water the volume is the same in any direction.
  const double whole = greatest_volume(closed.body(), Vector3d::UnitZ());
  std::vector<Equilibrium> results;
  for (const LoadCase& load : loads) {
    results.push_back(Balance(closed.body(), whole, load, options).find());
    // The descent was that of the closed body; where she floods the body itself tells.
    refuse_flooding(body, results.back());
  }
  return results;
}

}  // namespace hull::analysis
