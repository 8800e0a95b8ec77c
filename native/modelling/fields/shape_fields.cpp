// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/shape_fields.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/tolerances.h"
#include "modelling/fields/field_blend.h"
#include "surface/parallel_for.h"

namespace hull::modelling {
namespace {

// Of the extent: a base so near the centre plane is meant to be in it, and its own image. Two
// images so near would shift points twice as far as one does. Of the extent and not of the hull,
// since only against that is it next to nothing; the single precision in which bases are drawn
// leaves 1e-7 of the hull, more of short extents.
constexpr double kOwnImage = kNearCentrePlane;
// What varies along a base is looked at in so many places between two of its values.
constexpr int kLooked = 32;
// Feet are found up to so many extents, so that they need not be found anew when it grows a little.
constexpr double kAhead = 1.5;

void check_all(const AlongBase<double>& along, const std::function<bool(double)>& is_good,
               const std::string& message) {
  for (double value : along.values()) {
    if (!is_good(value)) throw std::invalid_argument(message);
  }
  const std::vector<double>& at = along.lengths();
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    for (int k = 1; k < kLooked; ++k) {
      // The spline may overshoot between values that are good.
      const double length = at[i] + (at[i + 1] - at[i]) * k / kLooked;
      if (!is_good(along.at(length).value)) {
        throw std::invalid_argument(message + " It is not so between two of the values given.");
      }
    }
  }
}

// work(begin, end) for ranges, on all processors.
void for_ranges(std::size_t count,
                const std::function<void(std::size_t begin, std::size_t end)>& work) {
  constexpr std::size_t kGrain = 256;
  surface::parallel_for(count, surface::kAllProcessors, work, kGrain);
}

}  // namespace

ShapeFields::ShapeFields(std::vector<ShapeField> fields, bool mirrored, FieldBlend blend)
    : fields_(std::move(fields)), blend_(blend) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    ShapeField& field = fields_[i];
    const std::string name = "Field " + std::to_string(i);
    if (field.change && !field.base) field.base = curve_base(field.change->curve());
    if (!field.base) throw std::invalid_argument(name + " has no base.");
    check_all(
        field.extent, [](double v) { return v > 0.0 && std::isfinite(v); },
        name + ": the extent must be positive.");
    check_all(
        field.kappa, [](double v) { return v >= 0.0 && v <= 1.0; },
        name + ": the falloff must be from 0 to 1.");
    for (const Vector3d& shift : field.shift.values()) {
      if (!shift.allFinite()) throw std::invalid_argument(name + ": the shift is no number.");
    }
    // Where the extent varies its least value decides.
    const double extent = *std::ranges::min_element(field.extent.values());
    const bool is_in_plane = mirrored && field.base->is_in_centre_plane(kOwnImage * extent);
    // The image of a base in the plane would be there twice, and shift twice as far.
    sides_.push_back({i, is_in_plane ? FieldSide::kBoth : FieldSide::kOwn});
    if (mirrored && !is_in_plane) sides_.push_back({i, FieldSide::kImage});
  }
}

// Memory for one point after the other.
struct ShapeFields::Scratch {
  std::vector<BaseFoot> feet;
  std::vector<Share> shares;
  std::vector<const Share*> working;
};

bool ShapeFields::may_move(const std::vector<BaseFoot>& feet) const {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const ShapeField& field = fields_[sides_[i].field];
    // What protects moves nothing by itself: far from all that moves the blend is not asked.
    if (field.protects) continue;
    if (feet[i].distance < reach_of(field)) return true;
  }
  return false;
}

FieldShift ShapeFields::blended(const Vector3d& p, Scratch& scratch) const {
  FieldShift result{Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  if (!may_move(scratch.feet)) return result;
  scratch.shares.clear();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const auto [field, side] = sides_[i];
    scratch.shares.push_back(share_of(fields_[field], scratch.feet[i], p, side));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Blended found = blend_along(scratch.shares, axis, blend_, scratch.working);
    result.shift[axis] = found.value;
    result.gradient.row(axis) = found.slope.transpose();
  }
  return result;
}

FieldShift ShapeFields::at(const Vector3d& p) const { return at(std::vector<Vector3d>{p}).front(); }

std::vector<FieldShift> ShapeFields::at(const std::vector<Vector3d>& points) const {
  std::vector<FieldShift> result(points.size());
  for_ranges(points.size(), [&](std::size_t begin, std::size_t end) {
    Scratch scratch;
    for (std::size_t i = begin; i < end; ++i) {
      scratch.feet.clear();
      for (const auto& [field, side] : sides_) {
        const ShapeField& own = fields_[field];
        scratch.feet.push_back(foot_of(own, points[i], side, reach_of(own)));
      }
      result[i] = blended(points[i], scratch);
    }
  });
  return result;
}

std::shared_ptr<FieldPlaces::Feet> FieldPlaces::found(const FieldBase& base, FieldSide side,
                                                      bool with_length, double within) const {
  const auto known = std::ranges::find_if(known_, [&](const auto& feet) {
    return feet->side == side && feet->with_length >= with_length && feet->within >= within &&
           feet->base->is_same(base);
  });
  return known == known_.end() ? nullptr : *known;
}

std::vector<BaseFoot> FieldPlaces::forget_all_but(const std::vector<std::shared_ptr<Feet>>& kept) {
  const auto is_kept = [&](const auto& feet) {
    return std::ranges::find(kept, feet) != kept.end();
  };
  const auto spare = std::ranges::find_if_not(known_, is_kept);
  if (spare == known_.end()) return {};
  std::vector<BaseFoot> memory = std::move((*spare)->feet);
  known_.erase(spare);
  return memory;
}

std::vector<FieldShift> ShapeFields::at(FieldPlaces& places) const {
  std::vector<std::shared_ptr<FieldPlaces::Feet>> own;
  for (const auto& [index, side] : sides_) {
    const ShapeField& field = fields_[index];
    // All that is known first: what follows forgets the rest.
    own.push_back(places.found(*field.base, side, varies(field), reach_of(field)));
  }
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (own[k]) continue;
    const auto [index, side] = sides_[k];
    const ShapeField& field = fields_[index];
    const double within = kAhead * reach_of(field);
    auto feet = std::make_shared<FieldPlaces::Feet>(
        // The memory of a base that is no longer asked for: as a base is dragged none is allocated.
        FieldPlaces::Feet{field.base, side, varies(field), within, places.forget_all_but(own)});
    feet->feet.resize(places.points_.size());
    for_ranges(places.points_.size(), [&, which = side](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        feet->feet[i] = foot_of(field, places.points_[i], which, within);
      }
    });
    own[k] = std::move(feet);
  }
  std::vector<FieldShift> result(places.points_.size());
  for_ranges(result.size(), [&](std::size_t begin, std::size_t end) {
    Scratch scratch;
    for (std::size_t i = begin; i < end; ++i) {
      scratch.feet.clear();
      for (const auto& of_side : own) scratch.feet.push_back(of_side->feet[i]);
      result[i] = blended(places.points_[i], scratch);
    }
  });
  places.known_ = std::move(own);
  return result;
}

double ShapeFields::delta(int field, const Vector3d& p) const {
  const ShapeField& own = fields_[field];
  double least = surface::kInfinity;
  for (const Side& side : sides_) {
    if (static_cast<int>(side.field) != field) continue;
    const BaseFoot foot = foot_of(own, p, side.side, surface::kInfinity);
    least = std::min(least, foot.distance / own.extent.at(foot.length).value);
  }
  return least;
}

}  // namespace hull::modelling
