// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/heeling_path.h"

#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "analysis/arithmetic/gauss.h"
#include "analysis/immersion/floating_position.h"
#include "analysis/stability/water_at_volume.h"

namespace hull::analysis {
namespace {

// Neighbours farther apart than this say nothing of one another, rad.
constexpr double kFarthestNeighbour = 0.6;

struct Sample {
  double at, value, slope;
};

// The cubic through two values with their slopes, between and beyond.
double hermite(const Sample& a, const Sample& b, double x) {
  const double h = b.at - a.at, t = (x - a.at) / h;
  const double rise = b.value - a.value;
  const double left = a.slope * h - rise, right = rise - b.slope * h;
  return a.value + t * rise + t * (1.0 - t) * (left * (1.0 - t) + right * t);
}

Sample trim_of(const HeeledState& s) { return {s.heel, s.trim, s.trim_slope}; }
Sample depth_of(const HeeledState& s) { return {s.heel, s.depth, s.depth_slope}; }

}  // namespace

HeelingPath::HeelingPath(const HullBody& body, double volume, double whole_volume,
                         const Vector3d& centre_of_gravity, TrimMode mode, double trim)
    : body_(body), stamp_(body), whole_volume_(whole_volume), first_trim_(trim) {
  task_.volume = volume;
  task_.centre_of_gravity = centre_of_gravity;
  task_.free = {mode == TrimMode::kFree, false};
  // The middle of the body's box.
  for (int i = 0; i < 3; ++i) {
    const HeightRange range = height_range(body, Vector3d::Unit(i));
    middle_[i] = 0.5 * (range.low + range.high);
  }
}

const HeeledState* HeelingPath::find(double heel) {
  stamp_.require_current("The heeling path");
  const auto found = states_.find(heel);
  if (found != states_.end()) return &found->second;
  std::optional<HeeledState> state = solve(heel);
  return state ? &states_.emplace(heel, *std::move(state)).first->second : nullptr;
}

const HeeledState& HeelingPath::at(double heel) {
  if (const HeeledState* state = find(heel)) return *state;
  std::ostringstream words;
  words
      << "There is no righting lever at a heel of " << heel * 180.0 / std::numbers::pi
      << "°: the ship stands on end, or does not settle. Hold the trim, or ask for smaller heels.";
  throw std::invalid_argument(words.str());
}

HeelingPath::Guess HeelingPath::first_guess(double heel, double trim) {
  constexpr double kRoughly = 1e-2;
  return {trim, offset_of_volume(body_, up_direction(trim, heel), task_.volume, whole_volume_,
                                 kRoughly, evaluations_)};
}

HeelingPath::Guess HeelingPath::guess(double heel) {
  if (states_.empty()) return first_guess(heel, first_trim_);
  // The nearest of the states solved, and the next beside it: on its other side, or behind it where
  // the heel is beyond all of them.
  const auto above = states_.lower_bound(heel);
  const HeeledState* nearest = above == states_.end() ? nullptr : &above->second;
  const HeeledState* next = nullptr;
  if (above == states_.begin()) {
    next = std::next(above) == states_.end() ? nullptr : &std::next(above)->second;
  } else {
    const auto below = std::prev(above);
    if (nearest) {
      next = &below->second;
      if (heel - next->heel < nearest->heel - heel) std::swap(nearest, next);
    } else {
      nearest = &below->second;
      next = below == states_.begin() ? nullptr : &std::prev(below)->second;
    }
  }
  const double gap = heel - nearest->heel;
  if (std::abs(gap) > kFarthestNeighbour) return first_guess(heel, nearest->trim);
  // Beyond both neighbours the cubic holds for about as far as they are apart.
  double trim = nearest->trim + gap * nearest->trim_slope;
  double depth = nearest->depth + gap * nearest->depth_slope;
  const double apart = next ? std::abs(next->heel - nearest->heel) : 0.0;
  if (next && apart < 2.0 * kFarthestNeighbour && std::abs(gap) <= 1.5 * apart) {
    trim = hermite(trim_of(*nearest), trim_of(*next), heel);
    depth = hermite(depth_of(*nearest), depth_of(*next), heel);
  }
  return {trim, up_direction(trim, heel).dot(middle_) + depth};
}

std::optional<HeeledState> HeelingPath::solve(double heel) {
  const int before = evaluations_;
  const Guess start = guess(heel);
  Descent found = descend(body_, task_, start.trim, heel, start.offset);
  evaluations_ += found.evaluations;
  if (found.end != Descent::End::kEquilibrium) return std::nullopt;
  HeeledState state;
  state.heel = heel;
  state.trim = found.trim;
  state.immersion = std::move(found.immersion);
  add_slopes(state);
  state.evaluations = evaluations_ - before;
  return state;
}

// With U the energy, ∇ GZ cos θ = ∂U/∂φ at the water that keeps volume and trimming moment; its
// total derivative by φ follows from U's second derivatives, taken by trim θ and heel φ.
void HeelingPath::add_slopes(HeeledState& state) const {
  const Immersion& at = state.immersion;
  const double volume = task_.volume;
  const Vector3d& g = task_.centre_of_gravity;
  const double cos_trim = std::cos(state.trim), sin_trim = std::sin(state.trim);
  const Vector3d starboard = starboard_direction(state.trim, state.heel);
  const Vector3d forward = forward_direction(state.trim, state.heel);
  // Of the normal; heel about the ship's own axis moves it cos(trim) as far.
  const Vector3d by_heel = -cos_trim * starboard;
  const Vector3d& up = at.water.normal;
  const Vector3d point = rotation_centre(at, g);
  const Vector3d w = rotation_moment(at, point, volume, g);
  const Eigen::Matrix3d& second = at.waterplane_second;

  state.righting_lever = (at.centre_of_buoyancy - g).dot(starboard);
  if (task_.free.trim) {
    // With n the normal: dn/dθ = forward, d²n/dθ² = -n, and d²n/dθdφ = sin θ starboard; ∂²U = dnᵀ S
    // dn + d²n·w (potential_energy.h).
    const double trim_trim = forward.dot(second * forward) - up.dot(w);
    const double trim_heel = forward.dot(second * by_heel) + sin_trim * starboard.dot(w);
    // The trim follows so that the trimming moment stays zero. Where the ship is not stable
    // lengthwise it would run away: no guess is to be had of that.
    state.trim_slope = trim_trim > 0.0 ? -trim_heel / trim_trim : 0.0;
  }
  const Vector3d up_slope = by_heel + state.trim_slope * forward;
  // d²n/dφ² = -(0, n_y, n_z); where the trim follows, the mixed derivatives times its slope come
  // in.
  const double heel_heel = by_heel.dot(second * up_slope) - Vector3d(0.0, up.y(), up.z()).dot(w) +
                           state.trim_slope * sin_trim * starboard.dot(w);
  // Of GZ alone: the product rule for ∇ GZ cos θ taken back.
  state.slope =
      (heel_heel / volume + state.righting_lever * sin_trim * state.trim_slope) / cos_trim;
  // Depths of the ship's middle, not offsets: these change with the heel for an origin far off.
  state.depth = at.water.offset - up.dot(middle_);
  // The water turns about the centre of flotation as the volume stays.
  state.depth_slope = up_slope.dot(point - middle_);
}

namespace {

double gauss_sum(HeelingPath& path, double from, double to) {
  static const GaussRule rule = gauss_rule(5);
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    sum += rule.weights[i] * path.at(from + rule.nodes[i] * (to - from)).righting_lever;
  }
  return sum * (to - from);
}

// The difference of the two sums is the error of the coarse one: the fine one's is far smaller.
double refined(HeelingPath& path, double from, double to, double coarse, double tolerance) {
  const double middle = 0.5 * (from + to);
  const double left = gauss_sum(path, from, middle), right = gauss_sum(path, middle, to);
  // At a jump of the slope, where a deck edge dips, halving alone would not come to an end.
  constexpr double kNarrowest = 1e-5;
  if (std::abs(left + right - coarse) <= tolerance || std::abs(to - from) < kNarrowest) {
    return left + right;
  }
  return refined(path, from, middle, left, 0.5 * tolerance) +
         refined(path, middle, to, right, 0.5 * tolerance);
}

}  // namespace

double lever_area(HeelingPath& path, double from, double to, double tolerance) {
  if (from == to) return 0.0;
  return refined(path, from, to, gauss_sum(path, from, to), tolerance);
}

}  // namespace hull::analysis
