// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/lengthening.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "modelling/transformation/smooth_step.h"

namespace hull::modelling {
namespace {

// Of a normal along the ship: below, the surface is parallel there.
constexpr double kParallel = 1e-9;

// Of a control point in a place of the surface: rounding.
constexpr double kNoWeight = 1e-12;

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g m", value);
  return text;
}

using Place = int;

// Along the ship: what surface each control point has a share in.
struct Reach {
  double from = INFINITY, to = -INFINITY;
  void take(double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

template <class Filter>
std::vector<Reach> reaches(const SurfacePlaces& places, std::size_t count, const Filter& filter) {
  std::vector<Reach> result(count);
  const PlaceWeights& weights = *places.weights();
  for (int square = 0; square < weights.forms().squares().count(); ++square) {
    const PlaceWeights::SquareRows own = weights.rows(square);
    for (Eigen::Index i = 0; i < own.rows.rows(); ++i) {
      const Place k = own.first + static_cast<Place>(i);
      if (!filter(k)) continue;
      for (std::size_t j = 0; j < own.points.size(); ++j) {
        if (std::abs(own.rows(i, static_cast<Eigen::Index>(j))) > kNoWeight) {
          result[own.points[j]].take(places.position(k).x());
        }
      }
    }
  }
  return result;
}

// Cells that reach below the water: all of such a cell must be parallel, as the water may cut it
// anywhere.
std::vector<char> wet_cells(const SurfacePlaces& places, int cells, const analysis::Plane& water) {
  std::vector<char> result(cells, 0);
  for (Place k = 0; k < places.count(); ++k) {
    if (water.height(places.position(k)) < 0.0) result[places.cell(k)] = 1;
  }
  return result;
}

void check_length(double length) {
  if (length != 0.0 && std::isfinite(length)) return;
  throw std::invalid_argument("Give a length to be inserted or, below zero, to be taken out.");
}

class Insertion {
 public:
  Insertion(WorkingHull& hull, double place, double length)
      : hull_(hull), places_(hull.surface()), place_(place), length_(length) {
    const std::vector<char> wet = wet_cells(places_, hull.surface().cell_count(), hull.water());
    const auto is_formed = [&](Place k) {
      return wet[places_.cell(k)] && std::abs(places_.normal(k).x()) > kParallel;
    };
    // The parallel part about the place: up to the nearest surface on either side that is not.
    range_ = {-INFINITY, INFINITY};
    for (Place k = 0; k < places_.count(); ++k) {
      if (!is_formed(k)) continue;
      const double x = places_.position(k).x();
      (x < place ? range_.aft : range_.forward) =
          x < place ? std::max(range_.aft, x) : std::min(range_.forward, x);
    }
    formed_ = reaches(places_, hull.points().size(), is_formed);
  }

  const HullRange& range() const { return range_; }

  std::vector<Vector3d> moves() const {
    if (!std::isfinite(range_.aft) || !std::isfinite(range_.forward)) {
      throw std::invalid_argument("There is no hull on both sides of x = " + metres(place_) +
                                  ": give a place within it.");
    }
    const double room = range_.forward - range_.aft;
    if (!(length_ > -room)) {
      throw std::invalid_argument("Only " + metres(room) +
                                  " of parallel middle body can be taken "
                                  "out at x = " +
                                  metres(place_) + ".");
    }
    std::vector<Vector3d> moves(hull_.points().size(), Vector3d::Zero());
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i].x() = length_ * share(i);
    return moves;
  }

 private:
  double share(std::size_t point) const {
    const bool is_aft = formed_[point].from < place_, is_fore = formed_[point].to >= place_;
    if (is_aft && is_fore) {
      throw std::invalid_argument(
          "The body is not parallel at x = " + metres(place_) +
          ", or in too few rows of control points: subdivide the mesh once, or stretch a range.");
    }
    // What shapes the surface outside moves with that, however far into the parallel part it lies.
    if (is_aft || is_fore) return is_fore ? 1.0 : 0.0;
    // All others shape surface that is parallel, or above the water: there any shift along the ship
    // will do, and in proportion none overtakes another.
    const double x = hull_.points()[point].x();
    return std::clamp((x - range_.aft) / (range_.forward - range_.aft), 0.0, 1.0);
  }

  const WorkingHull& hull_;
  const SurfacePlaces places_;
  double place_, length_;
  HullRange range_{};
  std::vector<Reach> formed_;
};

void refuse_moved(const std::vector<Vector3d>& moves, const TransformLimits& limits,
                  double length) {
  for (int point : limits.limits.locked) {
    check_point(point, static_cast<int>(moves.size()), "locked");
    if (moves[point].x() == 0.0) continue;
    throw std::invalid_argument("The control point " + std::to_string(point) +
                                " is locked, but what is ahead of the place moves: unlock it.");
  }
  for (const std::vector<int>& group : limits.rigid) {
    for (int point : group) {
      check_point(point, static_cast<int>(moves.size()), "rigid");
      // To the bit: what moves as one has a share of 0 or 1.
      if (moves[point].x() == moves[group.front()].x()) continue;
      throw std::invalid_argument("The control points " + std::to_string(group.front()) + " and " +
                                  std::to_string(point) +
                                  " are to move as one: give another place than between them.");
    }
  }
  for (const HeldDirection& held : limits.limits.held) {
    check_point(held.point, static_cast<int>(moves.size()), "held");
    // The plane goes with what is ahead, or stays: only between would the point leave it.
    const double x = moves[held.point].x();
    if (std::abs(held.normal.normalized().x()) <= kParallel || x == 0.0 || x == length) continue;
    throw std::invalid_argument("The control point " + std::to_string(held.point) +
                                " is held in a plane that is raked where the hull is stretched: "
                                "give another place.");
  }
}

// All that lies outside the range moves as one, or stays.
TransformLimits with_ends(const SurfacePlaces& places, std::size_t count, const HullRange& range,
                          TransformLimits limits) {
  const std::vector<Reach> all = reaches(places, count, [](Place) { return true; });
  std::vector<int> aft, fore;
  for (std::size_t i = 0; i < count; ++i) {
    // By the surface that they shape, not by where they are themselves.
    if (all[i].to <= range.aft) aft.push_back(static_cast<int>(i));
    if (all[i].from >= range.forward) fore.push_back(static_cast<int>(i));
  }
  std::vector<HeldDirection> held;
  for (const HeldDirection& one : limits.limits.held) {
    // Planes go with what is ahead.
    const bool goes = std::abs(one.normal.normalized().x()) > kParallel &&
                      std::ranges::binary_search(fore, one.point);
    if (!goes) held.push_back(one);
  }
  limits.limits.held = held;
  for (int point : limits.limits.locked) {
    if (!std::ranges::binary_search(fore, point)) continue;
    throw std::invalid_argument("The control point " + std::to_string(point) +
                                " is locked, but what is ahead of the range moves: unlock it.");
  }
  // First, so that groups of the caller's that lie there go with them.
  if (!aft.empty()) limits.rigid.insert(limits.rigid.begin(), aft);
  if (!fore.empty()) limits.rigid.insert(limits.rigid.begin(), fore);
  return limits;
}

void check_stretched(const HullRange& range, double length) {
  if (!(range.aft < range.forward) || !std::isfinite(range.forward - range.aft)) {
    throw std::invalid_argument("The stretched range runs from aft forward.");
  }
  // The step's steepest slope, length * kSteepestStep over the range, must stay above -1.
  const double least = -kSteepestStep * length;
  if (range.forward - range.aft > least) return;
  throw std::invalid_argument("To take out " + metres(-length) + " the range must be longer than " +
                              metres(least) + ": sections would overtake one another.");
}

}  // namespace

Lengthened lengthen(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                    double place, double length, const std::optional<HullRange>& stretched,
                    const TransformLimits& limits) {
  check_length(length);
  if (!std::isfinite(place)) throw std::invalid_argument("The place to lengthen at is no number.");
  WorkingHull hull(body, position);
  Lengthened result{};
  result.area = hull.section_area(place);
  if (stretched) {
    check_stretched(*stretched, length);
    result.range = *stretched;
    const LongitudinalReshape reshape(
        hull.surface(),
        with_ends(SurfacePlaces(hull.surface()), hull.points().size(), *stretched, limits));
    const Reshaped reshaped = reshape.solve([&](double x) {
      return length * smooth_step((x - stretched->aft) / (stretched->forward - stretched->aft));
    });
    if (reshaped.folded_place >= 0) {
      const Vector3d& at = reshape.places().position(reshaped.folded_place);
      throw std::invalid_argument("The surface would fold at x = " + metres(at.x()) +
                                  ": take a longer range.");
    }
    result.moves = reshaped.moves;
    result.rms = reshaped.rms;
    result.largest = reshaped.largest;
  } else {
    const Insertion insertion(hull, place, length);
    result.moves = insertion.moves();
    result.range = insertion.range();
    result.is_parallel = true;
    refuse_moved(result.moves, limits, length);
  }
  const double before = hull.volume();
  hull.move(result.moves);
  result.volume_change = hull.immersion().volume - before;
  return result;
}

}  // namespace hull::modelling
